#include "tools/expect/expectation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/runtime/overloaded.h"
#include "interpreter/source/latin_1.h"

namespace g31::expect {
namespace {

using runtime::Cell;
using runtime::Overloaded;
using runtime::ShownValue;

constexpr std::string_view kVacant = "vacant";
constexpr std::string_view kNothing = "cannot be read";

/// A text for people: in quotes, line breaks as \n, at most this long.
std::string in_quotes(std::string_view whole) {
  constexpr std::size_t kShown = 100;
  std::string text = "\"";
  for (const char c : whole.substr(0, kShown)) {
    text += c == '\n' ? std::string("\\n") : c == '\r' ? std::string("\\r") : std::string(1, c);
  }
  return text + (whole.size() > kShown ? "...\"" : "\"");
}

std::string shown(const ShownValue& value) {
  return std::visit(
      Overloaded{
          [](Cell cell) {
            return cell.is_vacant() ? std::string(kVacant) : fmt::format("{}", cell.raw());
          },
          [](const std::string& text) { return in_quotes(source::text_as_utf8(text)); },
      },
      value);
}

std::string shown(const Within& within) {
  return within.tolerance > 0.0 ? fmt::format("{} +- {}", within.value, within.tolerance)
                                : fmt::format("{}", within.value);
}

/// A number without a tolerance is met by the last digits, too: 1.5 inches are 38.099999999999994.
bool is_within(double number, const Within& within) {
  constexpr double kLastDigits = 4.0 * std::numeric_limits<double>::epsilon();
  return std::abs(number - within.value) <=
         within.tolerance * (1.0 + kLimitSlack) + kLastDigits * std::abs(within.value);
}

bool agrees(const ShownValue& got, const ExpectedValue& expected) {
  return std::visit(
      Overloaded{
          [&](const Within& within) {
            const auto* const cell = std::get_if<Cell>(&got);
            return cell != nullptr && !cell->is_vacant() && is_within(cell->raw(), within);
          },
          [&](const ShownValue& value) {
            const auto* const cell = std::get_if<Cell>(&got);
            const auto* const text = std::get_if<std::string>(&value);
            return text != nullptr ? std::get_if<std::string>(&got) != nullptr &&
                                         source::text_as_utf8(std::get<std::string>(got)) == *text
                                   : cell != nullptr && cell->is_vacant();
          },
      },
      expected);
}

std::string words_for(const ExpectedValue& expected) {
  return std::visit([](const auto& value) { return shown(value); }, expected);
}

Judged of_count(std::string name, std::size_t expected, std::size_t got) {
  return {std::move(name), std::to_string(expected), std::to_string(got), expected == got, {}};
}

Judged of_text(std::string name, std::string_view expected, std::string_view got) {
  return {std::move(name), in_quotes(expected), in_quotes(got), expected == got, {}};
}

/// @pre it has limits
Judged judged_limits(const MeasuredCharacteristic& row) {
  const Characteristic& what = row.what;
  const std::string unit = what.unit.name == "none" ? "" : fmt::format(" {}", what.unit.name);
  return {fmt::format("{} ({})", what.name, what.variable),
          fmt::format("{} {:+} {:+}{}", *what.nominal, what.tolerance->lower, what.tolerance->upper,
                      unit),
          row.actual ? fmt::format("{}{}", *row.actual, unit) : std::string("no number"),
          row.verdict() == CharacteristicVerdict::Good,
          what.place,
          row.actual ? "the part is out, or what measures it: --report shows which where the true "
                       "size is known; where both are right, change nominal or tolerance"
                     : fmt::format("the run has written no number to {}: see how it ended, or "
                                   "which block is to write it",
                                   what.variable)};
}

/// Looks at one of each kind.
struct Judge {
  const Actual& actual;

  Judged operator()(const Status& expected) const {
    return {"status", expected.name, actual.status, expected.name == actual.status, {}};
  }
  Judged operator()(const Alarm& expected) const {
    return {"alarm",
            std::to_string(expected.number),
            actual.alarm ? std::to_string(*actual.alarm) : actual.status,
            actual.alarm == expected.number,
            {}};
  }
  Judged operator()(const Variable& expected) const {
    const auto got = actual.variable(expected.name);
    return {expected.name,
            words_for(expected.value),
            got ? shown(*got) : std::string(kNothing),
            got && agrees(*got, expected.value),
            {}};
  }
  Judged operator()(const WorkOffset& expected) const {
    const auto got = actual.work_offset(expected.name, expected.axis);
    return {fmt::format("work_offsets.{}.{}", expected.name, expected.axis),
            shown(expected.value),
            got ? fmt::format("{}", *got) : std::string(kNothing),
            got && is_within(*got, expected.value),
            {}};
  }
  Judged operator()(const Output& expected) const {
    return of_text("output", expected.text, actual.output);
  }
  Judged operator()(const OutputPart& expected) const {
    const bool holds = actual.output.find(expected.text) != std::string::npos;
    return {"output_contains", in_quotes(expected.text), in_quotes(actual.output), holds, {}};
  }
  Judged operator()(const OutputFile& expected) const {
    const auto text = actual.file(expected.path);
    if (text) {
      return of_text("output_file", *text, actual.output);
    }
    return {"output_file",
            fmt::format("{}, which cannot be read", expected.path),
            in_quotes(actual.output),
            false,
            {},
            "correct the name of the file, or make it"};
  }
  Judged operator()(const Touches& expected) const {
    return of_count("touches", expected.count, actual.touches);
  }
  Judged operator()(const Findings& expected) const {
    return of_count("findings", expected.count, actual.findings);
  }
  Judged operator()(const MachineTime& expected) const {
    const double got = actual.machine_time_s;
    return {"machine_time_s",
            fmt::format("{} to {} s", expected.seconds.from, expected.seconds.to),
            fmt::format("{:.6g} s", got),
            expected.seconds.from <= got && got <= expected.seconds.to,
            {}};
  }
};

std::optional<double> number_in(std::string_view text) {
  double number = 0.0;
  const bool has_sign = text.starts_with('+');
  const char* const first = text.data() + (has_sign ? 1 : 0);
  const char* const last = text.data() + text.size();
  const auto end = std::from_chars(first, last, number);
  return end.ec == std::errc() && end.ptr == last && std::isfinite(number) ? std::optional(number)
                                                                           : std::nullopt;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t end = text.find_last_not_of(' ');
  return end == std::string_view::npos ? std::string_view() : text.substr(begin, end - begin + 1);
}

/// What --expect writes behind the sign; nullopt: it is none of what there is.
std::optional<ExpectedValue> expected_value(std::string_view written) {
  if (written == kVacant) {
    return ShownValue(Cell());
  }
  if (written.size() > 1 && written.starts_with('"') && written.ends_with('"')) {
    return ShownValue(std::string(written.substr(1, written.size() - 2)));
  }
  const std::size_t sign = written.find("+-");
  const auto number = number_in(trimmed(written.substr(0, sign)));
  const auto tolerance = sign == std::string_view::npos
                             ? std::optional(0.0)
                             : number_in(trimmed(written.substr(sign + 2)));
  const bool is_number = number && tolerance && *tolerance >= 0.0;
  return is_number ? std::optional<ExpectedValue>(Within{*number, *tolerance}) : std::nullopt;
}

}  // namespace

bool Expectations::names_an_ending() const {
  return has<Status>() || has<Alarm>();
}

bool Expectations::need_output() const {
  return has<Output>() || has<OutputPart>() || has<OutputFile>();
}

std::vector<MeasuredCharacteristic> measured(const Expectations& expectations,
                                             const Actual& actual) {
  std::vector<MeasuredCharacteristic> all;
  for (const Characteristic& what : expectations.characteristics) {
    const auto value = actual.result(what.variable);
    const auto* const cell = value ? std::get_if<Cell>(&*value) : nullptr;
    all.push_back(
        {what, cell != nullptr && !cell->is_vacant() ? std::optional(cell->raw()) : std::nullopt});
  }
  return all;
}

std::vector<Judged> judge(const Expectations& expectations, const Actual& actual) {
  std::vector<Judged> all;
  std::vector<Judged> limited;
  for (const MeasuredCharacteristic& row : measured(expectations, actual)) {
    if (row.what.tolerance) {
      limited.push_back(judged_limits(row));
    }
  }
  if (!(expectations.rows.empty() && limited.empty()) && !expectations.names_an_ending()) {
    all.push_back(Judge{actual}(Status{"completed"}));
    if (expectations.rows.empty()) {
      all.back().remedy = "what a program measures counts when it completes; [expect] may say more";
    } else {
      all.back().place = expectations.rows.front().place;
    }
  }
  for (const Expectation& row : expectations.rows) {
    all.push_back(std::visit(Judge{actual}, row.what));
    all.back().place = row.place;
  }
  std::ranges::move(limited, std::back_inserter(all));
  return all;
}

Result<Expectation, std::string> parse_expectation(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string_view name = trimmed(std::string_view(text).substr(0, equals));
  if (equals == std::string::npos || name.empty()) {
    return std::string("write NAME=VALUE+-TOLERANCE, for example #160=19.998+-0.001");
  }
  const std::string_view written = trimmed(std::string_view(text).substr(equals + 1));
  const auto value = expected_value(written);
  if (!value) {
    return fmt::format(
        "{} is not a number and a tolerance of 0 or more, such as 19.998+-0.001, nor a text in "
        "quotes, such as \"OK\", nor vacant",
        written);
  }
  return Expectation{Variable{std::string(name), *value}, {"--expect " + text, 0, 0, {}}};
}

}  // namespace g31::expect

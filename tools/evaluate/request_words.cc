#include "tools/evaluate/request_words.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/nearest_name.h"
#include "tools/evaluate/data_field.h"
#include "tools/evaluate/option_values.h"

namespace g31::evaluate {
namespace {

/// What is wrong; nullopt: nothing.
using Wrong = WrongValue;

struct UnitRow {
  std::string_view name;
  double mm;
};

constexpr UnitRow kUnits[] = {
    {"mm", 1.0}, {"um", 1e-3}, {"nm", 1e-6}, {"m", 1e3}, {"inch", 25.4},
};

Wrong take_kind(const std::string& word, Request& request) {
  std::vector<std::string_view> words;
  for (const KindRow& row : kinds()) {
    if (row.word == word) {
      request.kind = row.kind;
      return std::nullopt;
    }
    words.push_back(row.word);
  }
  const auto nearest = nearest_name(word, words);
  return fmt::format("there is nothing called {} to evaluate{}; g31 evaluate --help lists what",
                     word, nearest ? fmt::format(", did you mean {}?", *nearest) : "");
}

Wrong take_columns(const std::vector<std::string>& columns, Request& request) {
  for (const std::string& list : columns) {
    for (const std::string_view text : fields_of(list, ',')) {
      const std::size_t equals = text.find('=');
      if (equals == text.npos || equals == 0 || equals + 1 == text.size()) {
        return fmt::format(
            "--columns {}: write NAME=COLUMN, for example X=x_act; a name with a comma: "
            R"('"X=X, mm"')",
            text);
      }
      request.columns.names[std::string(text.substr(0, equals))] = text.substr(equals + 1);
    }
  }
  return std::nullopt;
}

Wrong take_unit(const std::string& unit, Request& request) {
  if (unit.empty()) {
    return std::nullopt;
  }
  const auto* const found = std::ranges::find(kUnits, unit, &UnitRow::name);
  if (found == std::end(kUnits)) {
    return fmt::format("--unit {}: units are {}", unit, fmt::join(unit_names(), ", "));
  }
  request.columns.mm_per_unit = found->mm;
  return std::nullopt;
}

Wrong take_magnify(const std::string& text, Request& request) {
  if (text.empty()) {
    return std::nullopt;
  }
  if (request.kind != Kind::Circle && request.kind != Kind::Square) {
    return fmt::format("--magnify is of circle and square, not of {}", info(request.kind).word);
  }
  const auto magnify = option_number(text);
  if (!magnify || *magnify <= 0.0) {
    return fmt::format("--magnify {}: this is not a number above 0 and up to 1e6", text);
  }
  request.magnify = *magnify;
  return std::nullopt;
}

Wrong take_given(const RequestWords& words, Request& request) {
  for (const OptionRow& row : options()) {
    const auto given = words.given.find(row.id);
    if (given == words.given.end()) {
      continue;
    }
    if (!belongs_to(row, request.kind)) {
      return fmt::format("{} is of {}, not of {}", row.option, row.kinds, words.kind);
    }
    if (const Wrong wrong = take_value(row.id, given->second, request)) {
      return fmt::format("{} {}: {}", row.option, given->second, *wrong);
    }
  }
  return std::nullopt;
}

/// What a kind cannot do without.
Wrong missing_option(const RequestWords& words, const Request& request) {
  if (request.kind == Kind::Diagonal && !request.target) {
    return "diagonal needs --target X,Y: where the move should have ended";
  }
  const bool steps = request.kind == Kind::Straightness || request.kind == Kind::Cylindricity;
  if (steps && !request.step) {
    return fmt::format("{} needs --step L: the distance from one row to the next",
                       info(request.kind).word);
  }
  if (request.kind == Kind::Cylindricity && !words.given.contains(OptionId::Diameters)) {
    return "cylindricity needs --diameters FILE: the diameters at both ends";
  }
  return std::nullopt;
}

/// Puts one option of a line where it belongs.
Wrong take_option(const std::string& option, const std::string& value, RequestWords& words) {
  if (option == "--magnify") {
    words.magnify = value;
    return std::nullopt;
  }
  if (option == "--columns") {
    words.columns.push_back(value);
    return std::nullopt;
  }
  std::vector<std::string_view> names = {"--magnify", "--columns"};
  for (const OptionRow& row : options()) {
    if (row.option == option) {
      words.given[row.id] = value;
      return std::nullopt;
    }
    names.push_back(row.option);
  }
  const auto nearest = nearest_name(option, names);
  return fmt::format("there is no option {} of an evaluation{}", option,
                     nearest ? fmt::format(", did you mean {}?", *nearest) : "");
}

}  // namespace

std::vector<std::string> unit_names() {
  std::vector<std::string> names;
  for (const UnitRow& row : kUnits) {
    names.emplace_back(row.name);
  }
  return names;
}

Result<Request, std::string> request_of(const RequestWords& words) {
  Request request;
  Wrong wrong = take_kind(words.kind, request);
  if (!wrong) {
    wrong = take_columns(words.columns, request);
  }
  if (!wrong) {
    wrong = take_unit(words.unit, request);
  }
  if (!wrong) {
    wrong = take_given(words, request);
  }
  if (!wrong) {
    wrong = take_magnify(words.magnify, request);
  }
  if (!wrong) {
    wrong = missing_option(words, request);
  }
  return wrong ? Result<Request, std::string>(*wrong) : Result<Request, std::string>(request);
}

Result<RequestWords, std::string> request_words(const std::string& kind, std::string_view line) {
  RequestWords words;
  words.kind = kind;
  std::istringstream rest{std::string(line)};
  for (std::string option; rest >> option;) {
    std::string value;
    if (!(rest >> value)) {
      return fmt::format("{} has no value", option);
    }
    if (const Wrong wrong = take_option(option, value, words)) {
      return *wrong;
    }
  }
  return words;
}

}  // namespace g31::evaluate

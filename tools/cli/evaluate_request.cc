#include "tools/cli/evaluate_request.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "machine/base/nearest_name.h"
#include "tools/evaluate/compensation.h"
#include "tools/setup/duration.h"

namespace g31::cli {
namespace {

using evaluate::OptionId;
using evaluate::OptionRow;
using evaluate::Request;
/// What is wrong; nullopt: nothing.
using Wrong = std::optional<std::string>;

constexpr double kLargest = 1e6;  // mm: a kilometre

std::optional<double> number_in(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool is_one = error == std::errc{} && stop == end && std::abs(number) <= kLargest;
  return is_one ? std::optional(number) : std::nullopt;
}

Wrong take_positive(std::string_view text, std::optional<double>& value) {
  value = number_in(text);
  return value && *value > 0.0 ? std::nullopt
                               : Wrong("this is not a length above 0 and up to 1e6 mm");
}

Wrong take_pair(std::string_view text, std::optional<evaluate::Pair>& value) {
  const std::size_t comma = text.find(',');
  const auto first = number_in(text.substr(0, comma));
  const auto second =
      comma == std::string_view::npos ? std::nullopt : number_in(text.substr(comma + 1));
  if (!first || !second) {
    return "write two lengths separated by a comma, for example 50,50";
  }
  value = evaluate::Pair{*first, *second};
  return std::nullopt;
}

Wrong take_detail(std::string_view text, std::optional<std::array<double, 3>>& value) {
  const std::size_t comma = text.rfind(',');
  std::optional<evaluate::Pair> middle;
  std::optional<double> width;
  if (comma == std::string_view::npos || take_pair(text.substr(0, comma), middle) ||
      take_positive(text.substr(comma + 1), width)) {
    return "write the middle and a width above 0, for example 49,49,4";
  }
  value = {(*middle)[0], (*middle)[1], *width};
  return std::nullopt;
}

Wrong take_interval(const std::string& text, std::optional<double>& value) {
  const auto seconds = setup::parse_duration(text);
  if (!seconds) {
    return seconds.error();
  }
  value = seconds.value();
  return std::nullopt;
}

Wrong take_plane(std::string_view text, std::array<std::string, 2>& plane) {
  const auto is_axis = [](char c) { return c == 'X' || c == 'Y' || c == 'Z'; };
  if (text.size() != 2 || !std::ranges::all_of(text, is_axis) || text[0] == text[1]) {
    return "a plane is XY, YZ, ZX, YX, ZY or XZ";
  }
  plane = {std::string(1, text[0]), std::string(1, text[1])};
  return std::nullopt;
}

Wrong take_sense(std::string_view text, evaluate::Sense& sense) {
  sense = text == "gap" ? evaluate::Sense::Gap : evaluate::Sense::Travel;
  return text == "gap" || text == "travel" ? std::nullopt : Wrong("a sense is travel or gap");
}

/// A straightness: an error along one axis when another one moves.
Wrong check_error_name(std::string_view text) {
  const auto is_axis = [](char c) { return c == 'X' || c == 'Y' || c == 'Z'; };
  const bool is_one = text.size() == 3 && text[0] == 'E' && is_axis(text[1]) && is_axis(text[2]) &&
                      text[1] != text[2];
  return is_one ? std::nullopt : Wrong("a straightness is EYX, EZX, EXY, EZY, EXZ or EYZ");
}

Wrong take(OptionId id, const std::string& text, Request& request) {
  switch (id) {
    case OptionId::Interval:
      return take_interval(text, request.interval_s);
    case OptionId::Plane:
      return take_plane(text, request.plane);
    case OptionId::Radius:
      return take_positive(text, request.radius);
    case OptionId::Centre:
      return take_pair(text, request.centre);
    case OptionId::Detail:
      return take_detail(text, request.detail);
    case OptionId::Side:
      return take_positive(text, request.side);
    case OptionId::Target:
      return take_pair(text, request.target);
    case OptionId::On:
      return take_positive(text, request.on);
    case OptionId::Step:
      return take_positive(text, request.step);
    case OptionId::Sense:
      return take_sense(text, request.sense);
    case OptionId::From:
      request.from = number_in(text);
      return request.from ? std::nullopt : Wrong("this is not a length");
    case OptionId::Axis:
      request.axis = text;
      return std::nullopt;
    case OptionId::Error:
      request.error = text;
      return check_error_name(text);
    case OptionId::CompensationFormat:
      return evaluate::compensation_format(text) ? std::nullopt
                                                 : Wrong(evaluate::compensation_formats_in_words());
    case OptionId::Compensation:
    case OptionId::Diameters:
      return std::nullopt;  // files: the command opens them
  }
  return std::nullopt;
}

Wrong take_kind(const std::string& word, Request& request) {
  std::vector<std::string_view> words;
  for (const evaluate::KindRow& row : evaluate::kinds()) {
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
  for (const std::string& text : columns) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == text.size()) {
      return fmt::format("--columns {}: write NAME=COLUMN, for example X=x_act", text);
    }
    request.columns.names[text.substr(0, equals)] = text.substr(equals + 1);
  }
  return std::nullopt;
}

Wrong take_unit(const std::string& unit, Request& request) {
  struct LengthName {
    std::string_view name;
    double mm;
  };
  constexpr LengthName kUnits[] = {{"", 1.0},    {"mm", 1.0}, {"um", 1e-3},
                                   {"nm", 1e-6}, {"m", 1e3},  {"inch", 25.4}};
  const auto found = std::ranges::find(kUnits, unit, &LengthName::name);
  if (found == std::end(kUnits)) {
    return fmt::format("--unit {}: units are mm, um, nm, m and inch", unit);
  }
  request.columns.mm_per_unit = found->mm;
  return std::nullopt;
}

Wrong take_drawing(const EvaluateOptions& options, Request& request) {
  request.wants_curves = options.has_curves;
  request.wants_drawing = !options.svg.empty();
  if (options.magnify.empty()) {
    return std::nullopt;
  }
  const auto magnify = number_in(options.magnify);
  if (!magnify || *magnify <= 0.0) {
    return fmt::format("--magnify {}: this is not a number above 0 and up to 1e6", options.magnify);
  }
  request.magnify = *magnify;
  return std::nullopt;
}

Wrong take_given(const EvaluateOptions& options, Request& request) {
  for (const OptionRow& row : evaluate::options()) {
    const auto given = options.given.find(row.id);
    if (given == options.given.end()) {
      continue;
    }
    if (!evaluate::belongs_to(row, request.kind)) {
      return fmt::format("{} is of {}, not of {}", row.option, row.kinds, options.kind);
    }
    if (const Wrong wrong = take(row.id, given->second, request)) {
      return fmt::format("{} {}: {}", row.option, given->second, *wrong);
    }
  }
  return std::nullopt;
}

/// What a kind cannot do without.
Wrong missing_option(const EvaluateOptions& options, const Request& request) {
  if (request.kind == evaluate::Kind::Diagonal && !request.target) {
    return "diagonal needs --target X,Y: where the move should have ended";
  }
  const bool steps =
      request.kind == evaluate::Kind::Straightness || request.kind == evaluate::Kind::Cylindricity;
  if (steps && !request.step) {
    return fmt::format("{} needs --step L: the distance from one row to the next",
                       evaluate::info(request.kind).word);
  }
  if (request.kind == evaluate::Kind::Cylindricity &&
      !options.given.contains(OptionId::Diameters)) {
    return "cylindricity needs --diameters FILE: the diameters at both ends";
  }
  return std::nullopt;
}

}  // namespace

Result<Request, session::Refusal> evaluate_request(const EvaluateOptions& options) {
  Request request;
  Wrong wrong = take_kind(options.kind, request);
  if (!wrong) {
    wrong = take_columns(options.columns, request);
  }
  if (!wrong) {
    wrong = take_unit(options.unit, request);
  }
  if (!wrong) {
    wrong = take_given(options, request);
  }
  if (!wrong) {
    wrong = take_drawing(options, request);
  }
  if (!wrong) {
    wrong = missing_option(options, request);
  }
  if (wrong) {
    return session::bad_input(*wrong);
  }
  return request;
}

}  // namespace g31::cli

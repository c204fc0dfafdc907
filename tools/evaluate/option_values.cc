#include "tools/evaluate/option_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "tools/evaluate/compensation.h"
#include "tools/setup/duration.h"

namespace g31::evaluate {
namespace {

/// What is wrong; nullopt: nothing.
using Wrong = WrongValue;

constexpr double kLargest = 1e6;  // mm: a kilometre
// mm: the finest scales have periods of some tenths of a micrometre.
constexpr double kLeastPitch = 1e-4;

Wrong take_positive(std::string_view text, std::optional<double>& value) {
  value = option_number(text);
  return value && *value > 0.0 ? std::nullopt
                               : Wrong("this is not a length above 0 and up to 1e6 mm");
}

Wrong take_pair(std::string_view text, std::optional<Pair>& value) {
  const std::size_t comma = text.find(',');
  const auto first = option_number(text.substr(0, comma));
  const auto second =
      comma == std::string_view::npos ? std::nullopt : option_number(text.substr(comma + 1));
  if (!first || !second) {
    return "write two lengths separated by a comma, for example 50,50";
  }
  value = Pair{*first, *second};
  return std::nullopt;
}

/// One pitch for both axes, or one of each and 0 for an axis without one.
Wrong take_pitches(const std::string& text, std::array<std::optional<double>, 2>& pitches) {
  std::optional<Pair> both;
  if (const auto one = option_number(text)) {
    both = {*one, *one};
  } else if (take_pair(text, both)) {
    both.reset();
  }
  const auto fits = [](double pitch) { return pitch == 0.0 || pitch >= kLeastPitch; };
  if (!both || !std::ranges::all_of(*both, fits) || std::ranges::max(*both) == 0.0) {
    return "write a pitch of 0.0001 mm at least, for example 10, or one of each axis, for example "
           "10,12";
  }
  for (const std::size_t axis : {0U, 1U}) {
    if (both->at(axis) > 0.0) {
      pitches.at(axis) = both->at(axis);
    }
  }
  return std::nullopt;
}

Wrong take_detail(std::string_view text, std::optional<std::array<double, 3>>& value) {
  const std::size_t comma = text.rfind(',');
  std::optional<Pair> middle;
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

struct SenseRow {
  Sense sense;
  std::string_view word;
};

constexpr std::array kSenses = {SenseRow{Sense::Travel, "travel"}, SenseRow{Sense::Gap, "gap"}};

Wrong take_sense(std::string_view text, Sense& sense) {
  for (const SenseRow& row : kSenses) {
    if (row.word == text) {
      sense = row.sense;
      return std::nullopt;
    }
  }
  return fmt::format("a sense is {}", fmt::join(sense_names(), " or "));
}

/// A straightness: an error along one axis when another one moves.
Wrong check_error_name(std::string_view text) {
  const auto is_axis = [](char c) { return c == 'X' || c == 'Y' || c == 'Z'; };
  const bool is_one = text.size() == 3 && text[0] == 'E' && is_axis(text[1]) && is_axis(text[2]) &&
                      text[1] != text[2];
  return is_one ? std::nullopt : Wrong("a straightness is EYX, EZX, EXY, EZY, EXZ or EYZ");
}

Wrong check_compensation_format(std::string_view text) {
  if (compensation_format(text)) {
    return std::nullopt;
  }
  return fmt::format("a format is {}", fmt::join(compensation_format_names(), ", "));
}

}  // namespace

std::optional<double> option_number(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool is_one = error == std::errc{} && stop == end && std::abs(number) <= kLargest;
  return is_one ? std::optional(number) : std::nullopt;
}

std::vector<std::string> sense_names() {
  std::vector<std::string> names;
  for (const SenseRow& row : kSenses) {
    names.emplace_back(row.word);
  }
  return names;
}

WrongValue take_value(OptionId id, const std::string& text, Request& request) {
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
    case OptionId::Pitch:
      return take_pitches(text, request.pitches);
    case OptionId::Side:
      return take_positive(text, request.side);
    case OptionId::Target:
      return take_pair(text, request.target);
    case OptionId::On:
      return take_positive(text, request.on);
    case OptionId::Step:
      return take_positive(text, request.step);
    case OptionId::Uncertainty:
      return take_positive(text, request.uncertainty);
    case OptionId::Sense:
      return take_sense(text, request.sense);
    case OptionId::From:
      request.from = option_number(text);
      return request.from ? std::nullopt : Wrong("this is not a length");
    case OptionId::Axis:
      request.axis = text;
      return std::nullopt;
    case OptionId::Error:
      request.error = text;
      return check_error_name(text);
    case OptionId::CompensationFormat:
      return check_compensation_format(text);
    case OptionId::Compensation:
    case OptionId::Diameters:
      return std::nullopt;  // files: the command opens them
  }
  return std::nullopt;
}

}  // namespace g31::evaluate

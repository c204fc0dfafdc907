#include "tools/setup/assignment.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "tools/setup/variable_name.h"

namespace g31::setup {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// A finite decimal number that is the whole text.
std::optional<double> number_from(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) {
    text.remove_prefix(1);  // from_chars takes no plus sign
  }
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool whole = error == std::errc{} && stop == end && std::isfinite(number);
  return whole ? std::optional(number) : std::nullopt;
}

}  // namespace

Result<Assignment, std::string> parse_assignment(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) {
    return fmt::format("{} has no = : write NAME=VALUE, for example #500=1.5", text);
  }
  const std::string_view name = trimmed(text.substr(0, equals));
  const std::optional<std::string> normal = normal_variable_name(name);
  if (!normal) {
    return fmt::format("\"{}\" is not the name of a variable: write #500, R1 or _OVR[0]", name);
  }
  const std::string_view value = trimmed(text.substr(equals + 1));
  if (value.empty()) {
    return Assignment{*normal, std::nullopt};
  }
  const std::optional<double> number = number_from(value);
  if (!number) {
    return fmt::format("\"{}\" is not a number: write {}=1.5, or {}= for null", value, *normal,
                       *normal);
  }
  return Assignment{*normal, number};
}

}  // namespace g31::setup

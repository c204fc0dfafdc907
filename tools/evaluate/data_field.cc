#include "tools/evaluate/data_field.h"

#include <charconv>
#include <cstdlib>
#include <string>

namespace g31::evaluate {
namespace {

/// What lies beyond the numbers of the machine: infinity, or 0 where it is that small.
double number_beyond(std::string_view field) {
  return std::strtod(std::string(field).c_str(), nullptr);
}

}  // namespace

std::string_view bare(std::string_view field) {
  constexpr std::string_view kBlanks = " \t\r";
  const auto trim = [&] {
    const std::size_t first = field.find_first_not_of(kBlanks);
    field = first == std::string_view::npos
                ? std::string_view()
                : field.substr(first, field.find_last_not_of(kBlanks) - first + 1);
  };
  trim();
  if (field.size() >= 2 && field.front() == '"' && field.back() == '"') {
    field = field.substr(1, field.size() - 2);
    trim();
  }
  return field;
}

std::optional<double> number_in(std::string_view field) {
  if (!field.empty() && field.front() == '+' && field.size() > 1 && field[1] != '-') {
    field.remove_prefix(1);
  }
  double number = 0.0;
  const char* const end = field.data() + field.size();
  const auto [stop, error] = std::from_chars(field.data(), end, number);
  const bool whole = (error == std::errc{} || error == std::errc::result_out_of_range) &&
                     stop == end && !field.empty();
  if (!whole) {
    return std::nullopt;
  }
  return error == std::errc{} ? number : number_beyond(field);
}

std::optional<double> number_with_comma_in(std::string_view field) {
  const std::size_t comma = field.find(',');
  if (comma == std::string_view::npos || field.find('.') != std::string_view::npos) {
    return number_in(field);
  }
  std::string with_point(field);
  with_point[comma] = '.';
  return number_in(with_point);
}

}  // namespace g31::evaluate

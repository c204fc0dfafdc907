#include "tools/evaluate/data_field.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

namespace g31::evaluate {
namespace {

/// What lies beyond the numbers of the machine: infinity, or 0 where it is that small.
double number_beyond(std::string_view field) {
  return std::strtod(std::string(field).c_str(), nullptr);
}

std::string_view without_blanks(std::string_view field) {
  constexpr std::string_view kBlanks = " \t\r";
  const std::size_t first = field.find_first_not_of(kBlanks);
  return first == field.npos ? std::string_view()
                             : field.substr(first, field.find_last_not_of(kBlanks) - first + 1);
}

bool has_quotes_around(std::string_view text) {
  return text.size() >= 2 && text.front() == '"' && text.back() == '"';
}

}  // namespace

bool is_quoted(std::string_view field) {
  return has_quotes_around(without_blanks(field));
}

std::string_view bare(std::string_view field) {
  field = without_blanks(field);
  return has_quotes_around(field) ? without_blanks(field.substr(1, field.size() - 2)) : field;
}

std::size_t field_end(std::string_view line, std::size_t begin, char separator) {
  std::size_t from = std::min(begin, line.size());
  while (from < line.size() && line[from] == ' ') {
    ++from;
  }
  if (from < line.size() && line[from] == '"') {
    // A quote that nothing closes is part of the text.
    const std::size_t close = line.find('"', from + 1);
    from = close == line.npos ? from : close + 1;
  }
  const void* const found =
      from < line.size() ? std::memchr(line.data() + from, separator, line.size() - from) : nullptr;
  return found == nullptr ? line.size()
                          : static_cast<std::size_t>(static_cast<const char*>(found) - line.data());
}

std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  std::vector<std::string_view> fields;
  for (std::size_t at = 0;;) {
    const std::size_t end = field_end(line, at, separator);
    fields.push_back(bare(line.substr(at, end - at)));
    if (end == line.size()) {
      return fields;
    }
    at = end + 1;
  }
}

std::string as_field(std::string_view text, char separator) {
  return text.find(separator) == text.npos ? std::string(text) : fmt::format("\"{}\"", text);
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

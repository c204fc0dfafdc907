#include "interpreter/dialects/fanuc/vocabulary/program_key.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace g31::fanuc {

std::string to_text(const ProgramKey& key) {
  return key.number != 0     ? fmt::format("O{:04}", key.number)
         : !key.name.empty() ? fmt::format("<{}>", key.name)
                             : std::string();
}

std::string missing_program(const ProgramKey& key) {
  return key.name.empty() && key.number <= 0
             ? fmt::format("{} is no number of a program", key.number)
             : fmt::format("{} is in none of the files and folders", to_text(key));
}

ProgramKey key_of_name(std::string_view name) {
  constexpr std::size_t kMostDigits = 8;
  const std::string_view digits = name.starts_with('O') ? name.substr(1) : "";
  int number = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool is_number = end.ec == std::errc() && end.ptr == digits.data() + digits.size() &&
                         digits.size() <= kMostDigits && number > 0;
  return is_number ? ProgramKey{number, {}} : ProgramKey{0, std::string(name)};
}

std::string_view between_angles(std::string_view text, syntax::ShortSpan name) {
  const std::string_view whole = text.substr(name.begin, name.end - name.begin);
  const bool is_name = whole.size() >= 2 && whole.front() == '<';
  return is_name ? whole.substr(1, whole.size() - 2) : std::string_view();
}

ProgramKey key_between_angles(std::string_view text, syntax::ShortSpan name) {
  return key_of_name(between_angles(text, name));
}

bool is_program_name(std::string_view name) {
  constexpr std::size_t kLongest = 32;
  const auto may_stand = [](char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '+' || c == '_' || c == '.';
  };
  return !name.empty() && name.size() <= kLongest && name != "." && name != ".." &&
         std::ranges::all_of(name, may_stand);
}

}  // namespace g31::fanuc

#include "tools/plan/printed_line.h"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <system_error>

#include "tools/plan/measures.h"

namespace g31::plan {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kBetween = " \t=";

std::string_view without_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(kBlanks), text.size()));
}

/// Takes the word that a text begins with; empty: none does.
std::string_view take_word(std::string_view& text) {
  const std::string_view word = text.substr(0, text.find_first_of(kBetween));
  text.remove_prefix(word.size());
  return word;
}

/// Takes the number that a text begins with.
std::optional<double> take_number(std::string_view& text) {
  const bool is_signed = text.starts_with('-') || text.starts_with('+');
  const bool is_negative = text.starts_with('-');
  if (is_signed) {
    text = without_blanks(text.substr(1));
  }
  const std::string_view word = take_word(text);
  const auto is_of_number = [](char c) { return c == '.' || (c >= '0' && c <= '9'); };
  if (!std::ranges::all_of(word, is_of_number)) {
    return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(word.data(), word.data() + word.size(), value, std::chars_format::fixed);
  if (error != std::errc() || end != word.data() + word.size() || value > kLongestMm) {
    return std::nullopt;
  }
  return is_negative ? -value : value;
}

}  // namespace

bool is_passed_over(std::string_view line) {
  const std::string_view text = without_blanks(line);
  return text.empty() || text.front() == '%' || text.front() == ';';
}

std::optional<std::vector<PrintedValue>> printed_values(std::string_view line) {
  std::vector<PrintedValue> values;
  std::string_view rest = without_blanks(line);
  while (!rest.empty()) {
    const std::string_view name = take_word(rest);
    rest = without_blanks(rest);
    if (rest.starts_with('=')) {
      rest = without_blanks(rest.substr(1));
    }
    const auto value = take_number(rest);
    if (name.empty() || !value || rest.starts_with('=')) {
      return std::nullopt;
    }
    values.push_back({name, *value});
    rest = without_blanks(rest);
  }
  return values;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(kBetween);
  while (begin < line.size()) {
    const std::size_t end = std::min(line.find_first_of(kBetween, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBetween, end);
  }
  return words;
}

}  // namespace g31::plan

#pragma once

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace g31::parts {

/// Whether a character stands between two words of a mesh file.
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

/// The first word of a text, which loses it; "" where there is none.
inline std::string_view take_word(std::string_view& text) {
  std::size_t first = 0;
  while (first < text.size() && is_blank(text[first])) {
    ++first;
  }
  std::size_t end = first;
  while (end < text.size() && !is_blank(text[end])) {
    ++end;
  }
  const std::string_view word = text.substr(first, end - first);
  text.remove_prefix(end);
  return word;
}

/// The whole word as a number, wherever g31 runs: "1.5", "-2e3", "+7"; nan and inf are numbers too.
template <typename Number>
std::optional<Number> number_in(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') {
    word.remove_prefix(1);
  }
  Number number{};
  const auto end = std::from_chars(word.data(), word.data() + word.size(), number);
  const bool is_whole = end.ec == std::errc() && end.ptr == word.data() + word.size();
  return is_whole && !word.empty() ? std::optional(number) : std::nullopt;
}

/// The lines of a text, with their numbers.
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}

  /// The next line without its end (\n, \r\n or \r); nullopt behind the last one.
  std::optional<std::string_view> next() {
    if (rest_.empty()) {
      return std::nullopt;
    }
    const std::size_t end = rest_.find_first_of("\r\n");
    const std::string_view line = rest_.substr(0, end);
    const bool is_pair = end != std::string_view::npos && rest_.substr(end, 2) == "\r\n";
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + (is_pair ? 2 : 1));
    ++number_;
    return line;
  }

  /// Of the line that was given last; 0 before the first.
  [[nodiscard]] std::size_t number() const { return number_; }

  /// What follows.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

}  // namespace g31::parts

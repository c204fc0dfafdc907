#include "interpreter/source/printable.h"

#include <algorithm>

#include <fmt/format.h>

namespace g31::source {
namespace {

constexpr unsigned byte_of(char c) {
  return static_cast<unsigned char>(c);
}

constexpr bool is_continuation(char c) {
  return (byte_of(c) & 0xC0U) == 0x80U;
}

constexpr bool is_printable_ascii(char c) {
  return byte_of(c) >= 0x20 && byte_of(c) < 0x7F;
}

/// Bytes of the character beyond ASCII that begins the text; 0 when none does.
std::size_t utf8_length(std::string_view text) {
  const unsigned lead = byte_of(text[0]);
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) {
    return 0;
  }
  const std::string_view rest = text.substr(1, length - 1);
  if (!std::all_of(rest.begin(), rest.end(), is_continuation)) {
    return 0;
  }
  const unsigned second = byte_of(text[1]);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool surrogate = lead == 0xED && second >= 0xA0;
  const bool beyond = lead == 0xF4 && second >= 0x90;
  const bool control = lead == 0xC2 && second < 0xA0;  // C1: some terminals obey it
  return overlong || surrogate || beyond || control ? 0 : length;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    std::size_t length = 1;
    if (is_printable_ascii(text[0])) {
      shown.push_back(text[0]);
    } else if (const std::size_t bytes = utf8_length(text); bytes > 0) {
      length = bytes;
      shown.append(text.substr(0, length));
    } else {
      shown.push_back(text[0] == '\t' ? ' ' : '?');
    }
    text.remove_prefix(length);
  }
  return shown;
}

std::size_t character_count(std::string_view text) {
  return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, is_continuation));
}

std::string quoted(char c) {
  return is_printable_ascii(c) ? fmt::format("'{}'", c)
                               : fmt::format("the byte 0x{:02X}", byte_of(c));
}

}  // namespace g31::source

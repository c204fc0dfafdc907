#include "interpreter/source/printable.h"

#include <fmt/format.h>

#include "machine/base/utf_8.h"

namespace g31::source {
namespace {

constexpr unsigned byte_of(char c) {
  return static_cast<unsigned char>(c);
}

constexpr bool is_printable_ascii(char c) {
  return byte_of(c) >= 0x20 && byte_of(c) < 0x7F;
}

/// Bytes of the character beyond ASCII that begins the text and that a terminal may have; 0: none.
std::size_t length_beyond_ascii(std::string_view text) {
  const auto [length, is_character] = utf_8_piece(text);
  const bool is_control = text.size() > 1 && byte_of(text[0]) == 0xC2 && byte_of(text[1]) < 0xA0;
  return is_character && length > 1 && !is_control ? length : 0;  // C1: some terminals obey it
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    std::size_t length = 1;
    if (is_printable_ascii(text[0])) {
      shown.push_back(text[0]);
    } else if (const std::size_t bytes = length_beyond_ascii(text); bytes > 0) {
      length = bytes;
      shown.append(text.substr(0, length));
    } else {
      shown.push_back(text[0] == '\t' ? ' ' : '?');
    }
    text.remove_prefix(length);
  }
  return shown;
}

std::string quoted(char c) {
  return is_printable_ascii(c) ? fmt::format("'{}'", c)
                               : fmt::format("the byte 0x{:02X}", byte_of(c));
}

}  // namespace g31::source

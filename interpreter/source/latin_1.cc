#include "interpreter/source/latin_1.h"

#include <algorithm>

#include "machine/base/utf_8.h"

namespace g31::source {

std::string one_byte_each(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
    const bool is_pair = (lead == 0xC2 || lead == 0xC3) && (next & 0xC0U) == 0x80U;
    if (is_pair) {
      bytes.push_back(static_cast<char>(((lead & 0x03U) << 6U) | (next & 0x3FU)));
      ++i;
    } else {
      bytes.push_back(text[i]);
    }
  }
  return bytes;
}

namespace {

void append(unsigned char byte, std::string& text) {
  if (byte < 0x80U) {
    text.push_back(static_cast<char>(byte));
  } else {
    text.push_back(static_cast<char>(0xC0U | (byte >> 6U)));
    text.push_back(static_cast<char>(0x80U | (byte & 0x3FU)));
  }
}

/// The bytes of the character of UTF-8 that begins here and that Latin-1 has not; 0: none.
/// REQUIRES: there is at least one byte.
std::size_t foreign_character(std::string_view bytes) {
  constexpr unsigned kFirstForeign = 0xC4;    // U+0100
  constexpr unsigned kFirstAmbiguous = 0xD7;  // the multiplication sign, then O with a stroke
  constexpr unsigned kFirstOfThree = 0xE0;
  const auto lead = static_cast<unsigned char>(bytes.front());
  if (lead < kFirstForeign || (lead >= kFirstAmbiguous && lead < kFirstOfThree)) {
    return 0;
  }
  const auto [length, is_character] = utf_8_piece(bytes);
  return is_character ? length : 0;
}

}  // namespace

std::string as_utf8(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    append(static_cast<unsigned char>(c), text);
  }
  return text;
}

std::string text_as_utf8(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const std::size_t length = foreign_character(bytes);
    if (length > 0) {
      text += bytes.substr(0, length);
    } else {
      append(static_cast<unsigned char>(bytes.front()), text);
    }
    bytes.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return text;
}

}  // namespace g31::source

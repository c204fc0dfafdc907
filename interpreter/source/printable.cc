#include "interpreter/source/printable.h"

#include <algorithm>

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

struct WideRange {
  char32_t first;
  char32_t last;
};
/// Scripts and signs of East Asia, and pictures.
constexpr WideRange kWide[] = {
    {0x1100, 0x115F},   {0x2E80, 0x303E},   {0x3041, 0xA4CF},   {0xA960, 0xA97C},
    {0xAC00, 0xD7A3},   {0xF900, 0xFAFF},   {0xFE30, 0xFE6F},   {0xFF01, 0xFF60},
    {0xFFE0, 0xFFE6},   {0x1F300, 0x1F64F}, {0x1F680, 0x1F6FF}, {0x1F900, 0x1F9FF},
    {0x20000, 0x3FFFD},
};

bool is_wide(char32_t character) {
  return std::ranges::any_of(kWide, [character](const WideRange& range) {
    return range.first <= character && character <= range.last;
  });
}

/// Of one character in UTF-8.
char32_t code_point(std::string_view bytes) {
  constexpr std::size_t kBitsBehindLead = 6;
  const unsigned lead_bits = bytes.size() == 1 ? 0x7FU : 0x7FU >> bytes.size();
  char32_t point = byte_of(bytes[0]) & lead_bits;
  for (const char next : bytes.substr(1)) {
    point = point << kBitsBehindLead | (byte_of(next) & 0x3FU);
  }
  return point;
}

}  // namespace

std::size_t cell_count(std::string_view printable) {
  std::size_t cells = 0;
  while (!printable.empty()) {
    const std::size_t length = utf_8_piece(printable).length;
    cells += is_wide(code_point(printable.substr(0, length))) ? 2U : 1U;
    printable.remove_prefix(length);
  }
  return cells;
}

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

std::string printable_lines(std::string_view text) {
  std::string shown;
  for (std::size_t end = text.find('\n'); end != text.npos; end = text.find('\n')) {
    shown += printable(text.substr(0, end)) + '\n';
    text.remove_prefix(end + 1);
  }
  return shown + printable(text);
}

std::string quoted(char c) {
  return is_printable_ascii(c) ? fmt::format("'{}'", c)
                               : fmt::format("the byte 0x{:02X}", byte_of(c));
}

}  // namespace g31::source

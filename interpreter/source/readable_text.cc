#include "interpreter/source/readable_text.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "interpreter/source/latin_1.h"
#include "machine/base/utf_8.h"

namespace g31::source {
namespace {

using Byte = unsigned char;

constexpr std::size_t kTrails = 188;
constexpr char16_t kNone = u'\uFFFD';

struct ShiftJisRow {
  Byte lead;
  std::u16string_view characters;
};
constexpr auto kRows = std::to_array<ShiftJisRow>({
#define SHIFT_JIS_ROW(lead, characters) {lead, characters},
#include "interpreter/source/shift_jis.def"
#undef SHIFT_JIS_ROW
});
static_assert(std::ranges::all_of(kRows, [](const ShiftJisRow& row) {
  return row.characters.size() == kTrails;
}));

bool is_half_width_katakana(Byte byte) {
  return byte >= 0xA1 && byte <= 0xDF;
}

/// Of U+0080 to U+FFFF.
void append(char16_t character, std::string& text) {
  if (character < 0x800) {
    text.push_back(static_cast<char>(0xC0U | (character >> 6U)));
  } else {
    text.push_back(static_cast<char>(0xE0U | (character >> 12U)));
    text.push_back(static_cast<char>(0x80U | ((character >> 6U) & 0x3FU)));
  }
  text.push_back(static_cast<char>(0x80U | (character & 0x3FU)));
}

/// kNone: there is no such character.
char16_t character_of(Byte lead, Byte trail) {
  const auto* const row = std::ranges::find(kRows, lead, &ShiftJisRow::lead);
  if (row == kRows.end() || trail < 0x40 || trail == 0x7F || trail > 0xFC) {
    return kNone;
  }
  return row->characters[trail < 0x7F ? trail - 0x40U : trail - 0x41U];
}

/// nullopt: it is no Shift-JIS, or nothing speaks for it.
std::optional<std::string> from_shift_jis(std::string_view bytes) {
  constexpr char16_t kFirstKatakana = 0xFF61;  // of byte 0xA1
  std::string text;
  bool is_likely = false;
  bool is_behind_katakana = false;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = static_cast<Byte>(bytes[i]);
    if (byte < 0x80) {
      text.push_back(bytes[i]);
    } else if (is_half_width_katakana(byte)) {
      is_likely = is_likely || is_behind_katakana;
      append(static_cast<char16_t>(kFirstKatakana + (byte - 0xA1)), text);
    } else {
      const char16_t character =
          i + 1 < bytes.size() ? character_of(byte, static_cast<Byte>(bytes[i + 1])) : kNone;
      if (character == kNone) {
        return std::nullopt;
      }
      is_likely = is_likely || byte <= 0x9F;
      append(character, text);
      ++i;
    }
    is_behind_katakana = is_half_width_katakana(byte);
  }
  return is_likely ? std::optional(std::move(text)) : std::nullopt;
}

bool is_utf_8(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto [length, is_character] = utf_8_piece(bytes);
    if (!is_character) {
      return false;
    }
    bytes.remove_prefix(length);
  }
  return true;
}

std::string readable_line(std::string_view bytes) {
  if (is_utf_8(bytes)) {
    return std::string(bytes);
  }
  auto text = from_shift_jis(bytes);
  return text ? *std::move(text) : as_utf8(bytes);
}

}  // namespace

std::string readable_text(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    text += readable_line(bytes.substr(0, end));
    text += end < bytes.size() ? "\n" : "";
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return text;
}

}  // namespace g31::source

#include "interpreter/source/readable_text.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "interpreter/source/latin_1.h"
#include "machine/base/contract.h"
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

struct ShiftJisPiece {
  std::size_t length;  ///< bytes, 1 or 2
  char16_t character;  ///< kNone: the byte is none, nor does it begin one
};

/// REQUIRES: there is at least one byte.
ShiftJisPiece shift_jis_piece(std::string_view bytes) {
  constexpr char16_t kFirstKatakana = 0xFF61;  // of byte 0xA1
  const auto byte = static_cast<Byte>(bytes.front());
  if (byte < 0x80) {
    return {1, byte};
  }
  if (is_half_width_katakana(byte)) {
    return {1, static_cast<char16_t>(kFirstKatakana + (byte - 0xA1))};
  }
  const char16_t character =
      bytes.size() > 1 ? character_of(byte, static_cast<Byte>(bytes[1])) : kNone;
  return {character == kNone ? std::size_t{1} : std::size_t{2}, character};
}

/// Whether it can be Shift-JIS, and something speaks for it.
bool is_shift_jis(std::string_view bytes) {
  bool is_likely = false;
  bool is_behind_katakana = false;
  while (!bytes.empty()) {
    const auto [length, character] = shift_jis_piece(bytes);
    if (character == kNone) {
      return false;
    }
    const auto byte = static_cast<Byte>(bytes.front());
    const bool is_katakana = is_half_width_katakana(byte);
    is_likely = is_likely || (length == 2 && byte <= 0x9F) || (is_katakana && is_behind_katakana);
    is_behind_katakana = is_katakana;
    bytes.remove_prefix(length);
  }
  return is_likely;
}

std::string from_shift_jis(std::string_view bytes) {
  std::string text;
  while (!bytes.empty()) {
    const auto [length, character] = shift_jis_piece(bytes);
    if (character < 0x80) {
      text.push_back(static_cast<char>(character));
    } else {
      append(character, text);
    }
    bytes.remove_prefix(length);
  }
  return text;
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

}  // namespace

Writing writing_of(std::string_view line) {
  return is_utf_8(line) ? Writing::Utf8 : is_shift_jis(line) ? Writing::ShiftJis : Writing::Latin1;
}

std::string read_as(Writing writing, std::string_view bytes) {
  switch (writing) {
    case Writing::Utf8:
      return std::string(bytes);
    case Writing::ShiftJis:
      return from_shift_jis(bytes);
    case Writing::Latin1:
      return as_utf8(bytes);
  }
  contract_violated("every Writing is read", __FILE__, __LINE__);
}

int column_in(std::string_view line, std::size_t bytes) {
  std::string_view rest = line.substr(0, bytes);
  if (writing_of(line) != Writing::ShiftJis) {
    return column_behind(rest);
  }
  int column = 1;
  for (; !rest.empty(); ++column) {
    rest.remove_prefix(shift_jis_piece(rest).length);
  }
  return column;
}

std::size_t bytes_in_front(std::string_view line, int column) {
  const auto characters = static_cast<std::size_t>(std::max(column, 1) - 1);
  if (writing_of(line) != Writing::ShiftJis) {
    return bytes_of_characters(line, characters);
  }
  std::string_view rest = line;
  for (std::size_t i = 0; i < characters && !rest.empty(); ++i) {
    rest.remove_prefix(shift_jis_piece(rest).length);
  }
  return line.size() - rest.size();
}

std::string readable_text(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view line = bytes.substr(0, end);
    text += read_as(writing_of(line), line);
    text += end < bytes.size() ? "\n" : "";
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  return text;
}

bool is_no_text(std::string_view text) {
  constexpr std::size_t kOneIn = 50;
  constexpr std::size_t kFew = 3;  // in a short text, too
  const std::size_t first = std::min(text.find_first_not_of('\0'), text.size());
  const std::size_t last = text.find_last_not_of('\0');
  const std::string_view inner =
      last == text.npos ? std::string_view() : text.substr(first, last + 1 - first);
  const auto controls = std::ranges::count_if(inner, [](char c) {
    return c >= '\0' && c < ' ' && std::string_view("\t\n\r\f").find(c) == std::string_view::npos;
  });
  return static_cast<std::size_t>(controls) > std::max(inner.size() / kOneIn, kFew);
}

}  // namespace g31::source

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace g31 {

/// What some editors begin a file with; no part of its text.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// What a text of UTF-8 begins with.
struct Utf8Piece {
  std::size_t length;  ///< bytes, at least 1
  /// Otherwise it is a byte that no character begins with, or a beginning that nothing completes.
  bool is_character;
};

/// Overlong forms, surrogates and what lies beyond U+10FFFF are no characters.
/// REQUIRES: there is at least one byte.
Utf8Piece utf_8_piece(std::string_view bytes);

/// How many characters a text has; of what is none, each byte counts as one.
std::size_t character_count(std::string_view bytes);

/// The column of what stands behind a text in its line, from 1, in such characters.
int column_behind(std::string_view text);

/// How many bytes so many characters have at its beginning, as character_count() counts them; of a
/// text that has fewer, all.
std::size_t bytes_of_characters(std::string_view bytes, std::size_t characters);

/// The text with U+FFFD in place of each piece that is no character, as our JSON documents have it:
/// what a file is called may be any bytes.
std::string as_valid_utf_8(std::string_view bytes);

}  // namespace g31

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace g31::source {

/// What the characters of a line are written in.
enum class Writing { Utf8, ShiftJis, Latin1 };

/// Nothing says what a program's comments are written in, so each line is judged by itself: valid
/// UTF-8 is that; what reads as Shift-JIS as a whole, and has a character of two bytes that begins
/// with 0x81 to 0x9F or two half-width katakana in a row, is Shift-JIS; all else is Latin-1.
Writing writing_of(std::string_view line);

/// A piece of such a line in UTF-8; U+FFFD where Shift-JIS has no such character.
std::string read_as(Writing writing, std::string_view bytes);

/// The column of what stands behind so many bytes of a line, from 1, in characters of its writing.
int column_in(std::string_view line, std::size_t bytes);

/// The way back: how many bytes stand in front of a column; all where the line is shorter.
std::size_t bytes_in_front(std::string_view line, int column);

/// Bytes of a program as people read them, in UTF-8, each line by itself.
/// @returns as many lines
std::string readable_text(std::string_view bytes);

/// Pictures, meshes and archives have control characters all over; a text has line ends, and one
/// that came over a line perhaps NUL at both ends and a few DC codes.
bool is_no_text(std::string_view text);

}  // namespace g31::source

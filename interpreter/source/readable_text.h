#pragma once

#include <string>
#include <string_view>

namespace g31::source {

/// Bytes of a program as people read them, in UTF-8.  Nothing says what a program's comments are
/// written in, so each line is judged by itself: valid UTF-8 stays; what reads as Shift-JIS as a
/// whole, and has a character of two bytes that begins with 0x81 to 0x9F or two half-width katakana
/// in a row, is Shift-JIS; all else is Latin-1.
/// @returns as many lines
std::string readable_text(std::string_view bytes);

}  // namespace g31::source

#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace g31::source {

/// A text as a terminal may have it: UTF-8 stays, a tab becomes a blank; control characters and
/// bytes that are no UTF-8 (comments in Shift-JIS or Latin-1) become `?`, one for each byte.
std::string printable(std::string_view text);

/// The same of each line of a text.
std::string printable_lines(std::string_view text);

/// How many cells of a terminal a printable text takes: characters of East Asia that are wide or of
/// full width have two (Unicode Standard Annex 11), all others one.
std::size_t cell_count(std::string_view printable);

/// A character for a message: 'A', or its byte where it cannot be shown.
std::string quoted(char c);

}  // namespace g31::source

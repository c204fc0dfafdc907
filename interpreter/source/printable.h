#pragma once

#include <string>
#include <string_view>

namespace g31::source {

/// A text as a terminal may have it: UTF-8 stays, a tab becomes a blank; control characters and
/// bytes that are no UTF-8 (comments in Shift-JIS or Latin-1) become `?`, one for each byte.
std::string printable(std::string_view text);

/// A character for a message: 'A', or its byte where it cannot be shown.
std::string quoted(char c);

}  // namespace g31::source

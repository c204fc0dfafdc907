#pragma once

#include <string>
#include <string_view>

namespace g31::source {

/// A text of Latin-1 characters, whether a file has it in Latin-1 or in UTF-8: controls count
/// characters, and keep them in one byte each.
std::string one_byte_each(std::string_view text);

/// The way back, for people: each byte is the code point of its value.
std::string as_utf8(std::string_view bytes);

/// The same of a text: characters that Latin-1 has not, which a control keeps in the bytes of
/// UTF-8, are what they are.  Where the bytes could as well be two characters of Latin-1 that stand
/// beside each other in texts ("\xD8\xB1": a diameter and a sign of tolerance), they are these two;
/// so it is with alphabets from Hebrew to N'Ko.
std::string text_as_utf8(std::string_view bytes);

/// One of the two, or readable_text().
using AsUtf8 = std::string (*)(std::string_view bytes);

}  // namespace g31::source

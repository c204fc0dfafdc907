#include "machine/base/xml_text.h"

#include "machine/base/utf_8.h"

namespace g31 {
namespace {

/// U+FFFE and U+FFFF, in UTF-8.
constexpr std::string_view kNoCharacters[] = {"\xEF\xBF\xBE", "\xEF\xBF\xBF"};

std::string_view sign_of(const char& c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return static_cast<unsigned char>(c) < 0x20 ? "?" : std::string_view(&c, 1);
  }
}

}  // namespace

std::string xml_escaped(std::string_view words) {
  std::string text;
  for (const char& c : as_valid_utf_8(words)) {
    text += sign_of(c);
  }
  for (const std::string_view none : kNoCharacters) {
    for (std::size_t at = text.find(none); at != text.npos; at = text.find(none, at)) {
      text.replace(at, none.size(), "?");
    }
  }
  return text;
}

}  // namespace g31

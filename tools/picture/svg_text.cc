#include "tools/picture/svg_text.h"

#include "machine/base/utf_8.h"

namespace g31::picture {

std::string xml_escaped(std::string_view words) {
  std::string text;
  for (const char c : as_valid_utf_8(words)) {
    switch (c) {
      case '&':
        text += "&amp;";
        break;
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
    }
  }
  return text;
}

}  // namespace g31::picture

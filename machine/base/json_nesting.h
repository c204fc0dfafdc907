#pragma once

#include <cstddef>
#include <string_view>

namespace g31 {

/// How deep lists and objects of a JSON text that g31 reads may stand inside one another: its own
/// documents need ten, and what copies or writes a value goes down as deep.
inline constexpr std::size_t kDeepestJson = 100;

/// Whether brackets and braces stand deeper than that inside one another, texts apart.
/// @param text  valid JSON or not
constexpr bool nests_too_deep(std::string_view text) {
  std::size_t depth = 0;
  bool in_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_text) {
      i += c == '\\' ? 1 : 0;
      in_text = c != '"';
    } else if (c == '"') {
      in_text = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepestJson) {
        return true;
      }
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
  return false;
}

}  // namespace g31

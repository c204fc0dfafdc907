#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "machine/base/letters.h"

namespace g31::sinumerik {

constexpr char upper(char c) {
  return capital_letter(c);
}

/// Names do not mind case: all tables are in upper case.
inline std::string upper(std::string_view text) {
  return in_capitals(text);
}

constexpr bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// Lets a map be asked with a string_view.
struct NameHash {
  using is_transparent = void;
  std::size_t operator()(std::string_view name) const {
    return std::hash<std::string_view>()(name);
  }
};
template <typename Value>
using NameMap = std::unordered_map<std::string, Value, NameHash, std::equal_to<>>;

}  // namespace g31::sinumerik

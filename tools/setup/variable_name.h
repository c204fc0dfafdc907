#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace g31::setup {

inline bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// The one spelling of the name of an NC variable as sheets, `--set` and `--print` take it, or
/// nullopt when it is none.
///
/// `#` and a number of at most 9 digits or a name, or a name that begins with a letter, `_` or `$`;
/// both may end with indices in square brackets.  Numbers of `#`, of `R` and of indices lose their
/// leading zeros (`#0100` is `#100`), spaces go.  Letters stay as they are: which dialect knows the
/// name is not decided here.
std::optional<std::string> normal_variable_name(std::string_view text);

/// The name as controls know it, which tell no small letters from capitals.
std::string in_capitals(std::string_view name);

/// Orders names that differ in small letters and capitals alone as the same.
struct InAnyCase {
  using is_transparent = void;
  bool operator()(std::string_view a, std::string_view b) const {
    return in_capitals(a) < in_capitals(b);
  }
};

}  // namespace g31::setup

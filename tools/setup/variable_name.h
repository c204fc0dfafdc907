#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "machine/base/letters.h"

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

/// Orders names that differ in small letters and capitals alone as the same, as controls know them.
struct InAnyCase {
  using is_transparent = void;
  bool operator()(std::string_view a, std::string_view b) const {
    return std::ranges::lexicographical_compare(a, b, {}, capital_letter, capital_letter);
  }
};

}  // namespace g31::setup

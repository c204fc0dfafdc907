#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

/// Argument specification I (MB-191): the local variable of an address, 0 for none.
constexpr int argument_variable(char letter) {
  constexpr std::array<std::uint8_t, syntax::kLetterCount> kVariables = {
      // A B C  D  E  F  G  H   I  J  K  L  M   N  O  P  Q   R   S   T   U   V   W   X   Y   Z
      1, 2, 3,  7,  8,  9,  0,  11, 4,  5,  6,  0,  13, 0,
      0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 0,  0};
  return kVariables.at(static_cast<std::size_t>(letter - 'A'));
}

/// Letters whose plain integer argument means least increments (MB-196).
inline constexpr std::string_view kIncrementArguments = "ABCIJKQRUVWXYZ";

}  // namespace g31::fanuc

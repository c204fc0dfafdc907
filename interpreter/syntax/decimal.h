#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace g31::syntax {

/// Up to this many digits mantissa and power of ten are exact, so one division rounds once.
inline constexpr int kExactDigits = 15;

/// Steps over the digits that stand at `at`, which go on with a number.
/// @param mantissa  of no use beyond kExactDigits digits
inline void take_digits(std::string_view text, std::size_t& at, std::uint64_t& mantissa) {
  for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at) {
    mantissa = mantissa * 10 + static_cast<unsigned char>(text[at] - '0');
  }
}

/// How many characters take_few_digits() may look at.
inline constexpr int kFewDigits = kExactDigits + 1;

/// take_digits() of a text that goes on for kFewDigits characters: ends behind as many digits, too.
/// Each place has its own branch, which says when it is likely to be the last one.
///
/// @returns how many there are
inline std::size_t take_few_digits(const char* text, std::uint64_t& mantissa) {
#pragma GCC unroll 16
  for (std::size_t count = 0; count < kFewDigits; ++count) {
    const auto digit = static_cast<unsigned char>(text[count] - '0');
    if (digit > 9) {
      return count;
    }
    mantissa = mantissa * 10 + digit;
  }
  return kFewDigits;
}

inline constexpr double kPowersOfTen[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// mantissa / 10^places, rightly rounded.
///
/// @param mantissa  of kExactDigits digits at most, leading zeros included
/// @param places    0 to kExactDigits
constexpr double decimal(std::uint64_t mantissa, int places) {
  // With a sign: that is one instruction.
  const auto whole = static_cast<double>(static_cast<std::int64_t>(mantissa));
  return places == 0 ? whole : whole / kPowersOfTen[places];
}

}  // namespace g31::syntax

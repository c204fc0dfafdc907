#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "interpreter/syntax/decimal.h"

namespace g31::sinumerik {

/// Digits and points that follow each other in a text.
struct Digits {
  std::uint64_t mantissa = 0;  ///< of no use beyond kExactDigits digits
  std::size_t points = 0;
  std::size_t behind_point = 0;  ///< where the last point's places begin
  std::size_t end = 0;           ///< behind them

  /// Whether they are one number, and short enough for value().
  [[nodiscard]] bool are_exact(std::size_t begin) const {
    return points <= 1 && end - begin - points <= syntax::kExactDigits;
  }
  /// Rightly rounded.
  [[nodiscard]] double value() const {
    return syntax::decimal(mantissa, points == 0 ? 0 : static_cast<int>(end - behind_point));
  }
};

inline Digits digits_at(std::string_view text, std::size_t begin) {
  Digits digits;
  std::size_t at = begin;
  syntax::take_digits(text, at, digits.mantissa);
  while (at < text.size() && text[at] == '.') {
    ++digits.points;
    digits.behind_point = ++at;
    syntax::take_digits(text, at, digits.mantissa);
  }
  digits.end = at;
  return digits;
}

}  // namespace g31::sinumerik

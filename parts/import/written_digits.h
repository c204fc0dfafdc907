#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "parts/import/text_lines.h"

namespace g31::parts {

/// With how many digits the coordinates of a text are written: so far they may be rounded.
class WrittenDigits {
 public:
  /// @param number  as it is written: "12.3450", "-1.2345e+01"
  void take(std::string_view number) {
    int digits = 0;  // so far; places of digits count from 1
    int point = -1;
    int first = 0;  // the first and the last that is not 0
    int last = 0;
    int exponent = 0;
    for (std::size_t i = 0; i < number.size(); ++i) {
      const char c = number[i];
      if (c >= '0' && c <= '9') {
        ++digits;
        last = c != '0' ? digits : last;
        first = first == 0 ? last : first;
      } else if (c == '.') {
        point = digits;
      } else if (c == 'e' || c == 'E') {
        exponent = number_in<int>(number.substr(i + 1)).value_or(0);
        break;
      }
    }
    if (first > 0) {
      significant_ = std::max(significant_, last - first + 1);
      decimals_ = std::max(decimals_, last - (point < 0 ? digits : point) - exponent);
    }
  }

  /// Half a unit of the last place at the coordinate that is furthest out; 0: of so few digits that
  /// they are more likely those of a drawing.
  /// @param furthest  > 0 and finite, the magnitude of that coordinate
  [[nodiscard]] double rounding_at(double furthest) const {
    constexpr int kLeastSignificant = 6;  // as many as %g writes
    constexpr int kLeastDecimals = 4;
    if (significant_ < kLeastSignificant || decimals_ < kLeastDecimals) {
      return 0.0;
    }
    const int before_point = static_cast<int>(std::floor(std::log10(furthest))) + 1;
    const int places = std::min(decimals_, significant_ - before_point);
    return 0.5 * std::pow(10.0, -places);
  }

 private:
  int significant_ = 0;  // at most, without zeros at both ends
  int decimals_ = 0;     // behind the point, at most
};

}  // namespace g31::parts

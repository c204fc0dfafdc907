#pragma once

#include <limits>

namespace g31::runtime {

/// What a numeric variable holds: a number, or vacant (never set, or set from #0).
///
/// The lean form of a value for loops that run millions of times: eight bytes, vacant is the one
/// NaN that is ever stored.  Arithmetic cannot produce another: every NaN is an alarm first.
class Cell {
 public:
  constexpr Cell() = default;  ///< vacant
  constexpr explicit Cell(double number) : number_(number) {}

  [[nodiscard]] constexpr bool is_vacant() const { return number_ != number_; }

  /// The number that arithmetic sees: vacant counts as 0.
  [[nodiscard]] constexpr double or_zero() const { return is_vacant() ? 0.0 : number_; }

  /// The number as kept; NaN when vacant.
  [[nodiscard]] constexpr double raw() const { return number_; }

  /// EQ of Custom Macro B: vacant equals only vacant (MB-086).
  [[nodiscard]] friend constexpr bool equal(Cell a, Cell b) {
    return a.is_vacant() || b.is_vacant() ? a.is_vacant() && b.is_vacant() : a.number_ == b.number_;
  }
  /// As values that are kept: the same.
  friend constexpr bool operator==(Cell a, Cell b) { return equal(a, b); }

 private:
  double number_ = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace g31::runtime

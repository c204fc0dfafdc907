#include "interpreter/dialects/fanuc/text/word_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "machine/base/rounding.h"

namespace g31::fanuc {
namespace {

constexpr double kPlainPowers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5};

/// Whether a number of so many decimals is on the grid of 1/counts, a power of ten.
bool is_on_grid(std::size_t decimals, double counts) {
  return decimals < std::size(kPlainPowers) && kPlainPowers[decimals] <= counts;
}

/// How far a decimal fraction may stand off its count: a few ulp of the scaled number.
double guard(double scaled) {
  return std::max(1.0, std::abs(scaled)) * 8.0 * std::numeric_limits<double>::epsilon();
}

/// A little farther from zero, by the guard.
double guarded(double scaled) {
  return scaled + std::copysign(guard(scaled), scaled);
}

}  // namespace

double round_to_counts(double value, double counts) {
  const double scaled = value * counts;
  return rounded(guarded(scaled)) / counts;
}

int nearest_integer(double value) {
  return static_cast<int>(rounded(std::clamp(value, -2e9, 2e9)));
}

void WordScale::set_increment_system(std::string_view name) {
  const double factor = name == "IS-A" ? 0.1 : name == "IS-C" ? 10.0 : 1.0;
  counts_per_mm = 1000.0 * factor;
  counts_per_inch = 10000.0 * factor;
  counts_per_degree = 1000.0 * factor;
}

double WordScale::scaled(const EvaluatedWord& word, double counts) const {
  switch (word.form) {
    case syntax::ValueForm::Integer:
      return calculator_point ? word.number : word.number / counts;
    case syntax::ValueForm::Decimal: {
      if (is_on_grid(word.decimals, counts)) {
        return word.number;
      }
      const double far = guarded(word.number * counts);
      return (excess_decimals == ExcessDecimals::Round ? rounded(far) : truncated(far)) / counts;
    }
    case syntax::ValueForm::Computed:
    case syntax::ValueForm::None:
    case syntax::ValueForm::Name:
      break;
  }
  return round_to_counts(word.number, counts);
}

}  // namespace g31::fanuc

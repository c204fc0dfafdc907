#include "interpreter/dialects/fanuc/text/word_values.h"

#include <algorithm>
#include <cmath>

namespace g31::fanuc {

double round_to_counts(double value, double counts) {
  const double scaled = value * counts;
  return rounded(detail::guarded(scaled)) / counts;
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

double WordScale::scaled_other(const EvaluatedWord& word, double counts) const {
  if (word.form == syntax::ValueForm::Integer) {
    return calculator_point ? word.number : word.number / counts;
  }
  return round_to_counts(word.number, counts);
}

}  // namespace g31::fanuc

#include "tools/study/statistics.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"
#include "tools/study/student_t.h"

namespace g31::study {
namespace {

/// A sum that keeps what each addition rounds off (Neumaier 1974).
class CompensatedSum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::fabs(sum_) >= std::fabs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0.0;
  double lost_ = 0.0;
};

}  // namespace

Summary summarise(std::span<const double> readings, double level, std::optional<double> expected) {
  G31_EXPECTS(level > 0.0 && level < 1.0);
  Summary summary;
  summary.n = readings.size();
  if (readings.empty()) {
    return summary;
  }
  const auto n = static_cast<double>(readings.size());
  // The mean as a step from the first reading: what all readings share does not cost digits.
  const double first = readings.front();
  CompensatedSum steps;
  for (const double reading : readings) {
    steps.add(reading - first);
  }
  const double mean_step = steps.value() / n;
  const double mean = first + mean_step;
  if (!std::isfinite(mean)) {
    return summary;  // readings so far apart that their differences are no numbers
  }
  summary.mean = mean;
  summary.min = *std::ranges::min_element(readings);
  summary.max = *std::ranges::max_element(readings);
  if (expected) {
    summary.bias = mean - *expected;
  }
  if (readings.size() < 2) {
    return summary;
  }
  CompensatedSum squares;
  for (const double reading : readings) {
    const double off = (reading - first) - mean_step;
    squares.add(off * off);
  }
  const double deviation = std::sqrt(squares.value() / (n - 1.0));
  if (!std::isfinite(deviation)) {
    return summary;  // the same of their squares
  }
  const double reach =
      student_t_quantile(0.5 + 0.5 * level, readings.size() - 1) * deviation / std::sqrt(n);
  summary.standard_deviation = deviation;
  summary.mean_confidence = Interval{mean - reach, mean + reach};
  summary.expanded_uncertainty =
      kCoverageFactor * deviation + std::fabs(summary.bias.value_or(0.0));
  return summary;
}

std::optional<double> z_score(double value, const Summary& readings) {
  const double deviation = readings.standard_deviation.value_or(0.0);
  return readings.mean && deviation > 0.0 ? std::optional((value - *readings.mean) / deviation)
                                          : std::nullopt;
}

}  // namespace g31::study

#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace g31::study {

/// k of an expanded uncertainty: about 95 % of a normal distribution.
inline constexpr double kCoverageFactor = 2.0;

struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// What the readings of one result say.
struct Summary {
  std::size_t n = 0;
  std::optional<double> mean;                ///< from one reading
  std::optional<double> standard_deviation;  ///< of one reading, n - 1; from two readings
  std::optional<Interval> mean_confidence;   ///< Student t; from two readings
  std::optional<double> min;
  std::optional<double> max;
  std::optional<double> bias;  ///< mean less the known value, where there is one
  /// Of one reading, k = 2: 2 s, and where a value is known |bias| on top of it, since nobody
  /// corrects it (as ISO 15530-3 adds it).  Contains the repeatability of the simulated probe and
  /// what the study varies; not the uncertainty of the known value, nor what stands still in the
  /// sheet.
  std::optional<double> expanded_uncertainty;
};

/// How many standard deviations of a reading a value lies from the mean of the readings; nullopt
/// where they do not scatter.
std::optional<double> z_score(double value, const Summary& readings);

/// @param level     of the confidence interval, above 0, below 1
/// @param expected  the known value
///
/// Sums run in the order of the readings and are compensated (Neumaier).  Accuracy: mean and
/// standard deviation within 4 units of the last place of a long double computation for readings
/// whose deviation is not below 1e-10 of the mean.
Summary summarise(std::span<const double> readings, double level, std::optional<double> expected);

}  // namespace g31::study

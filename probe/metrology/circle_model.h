#pragma once

#include <optional>
#include <span>
#include <vector>

#include "probe/metrology/circle_errors.h"
#include "probe/metrology/circle_residual.h"
#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// The errors that fit a record best, with their uncertainties.
struct CircleFit {
  CircleErrors errors;
  CircleErrors u;  ///< standard uncertainty of each
  bool has_mismatch = false;
  double noise = 0.0;  ///< standard deviation of the residuals, mm
  /// The same times what it is larger by where residuals hang together, mm.
  double scatter = 0.0;
  CircleErrors by_scatter;  ///< uncertainties by scatter, for 1 mm of it
  CircleErrors hidden;      ///< uncertainties by the resolution of the record
};

/// What is to be fitted.
struct CircleTask {
  std::optional<double> radius;  ///< the commanded one, mm
  CircleErrors start;            ///< near what is sought; of axes with a pitch, cyclic errors, too
  double resolution = 0.0;       ///< of the record, mm
  std::size_t stride = 1;        ///< every so many-th sample
  bool has_lobes = false;        ///< whether lobes of the form are fitted, too
};

/// Which samples are fitted: the half-open ranges of each turn.
struct FittedRange {
  std::size_t turn = 0;  ///< index into the turns
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Least squares over the ranges.  nullopt: they do not determine the errors, because too little of
/// the circle is in them.
///
/// Uncertainties take residuals that hang together into account: the variance of their sums over
/// pieces of 3 and 15 degrees is compared with that of single ones, and the larger ratio, if above
/// 1, counts.  What the resolution hides does not average out: its standard deviation is part of
/// every uncertainty.
/// Accuracy: Gauss-Newton to a step below 1e-12 of the radius.
std::optional<CircleFit> fit_circle(const PlaneSamples& samples,
                                    const std::vector<CircleTurn>& turns,
                                    std::span<const FittedRange> ranges, const CircleTask& task);

/// Takes the angular speed of each turn from the samples of its ranges with the errors taken away,
/// by least squares: errors bend the angle of a sample.  Every range may begin at any time, so that
/// a pause between two of them does not count.
void refine_speeds(const PlaneSamples& samples, std::span<const FittedRange> ranges,
                   const CircleErrors& errors, std::vector<CircleTurn>& turns);

}  // namespace g31::metrology

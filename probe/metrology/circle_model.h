#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// What makes a circular path what it is.  Index 0 is the first axis of the plane, 1 the second.
struct CircleErrors {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();  ///< mm
  double radius = 0.0;                               ///< mm
  std::array<double, 2> scale = {};                  ///< error by way
  double squareness = 0.0;  ///< rad; positive: the angle between the positive axes is under 90 deg
  double mismatch = 0.0;    ///< s: lag of the first axis less that of the second
  std::array<double, 2> backlash = {};  ///< mm; positive: the axis stays behind
};

/// The parameters of the model in the order of its covariance.
enum class CircleTerm {
  CentreX,
  CentreY,
  Size,   ///< of the radius; with a given radius, of the scale of the first axis
  Shape,  ///< half the difference of the scales; with a given radius, the second axis' scale
  Squareness,
  BacklashX,
  BacklashY,
  Mismatch,  ///< only where both directions were recorded
};

/// The errors that fit a record best, with their uncertainties.
struct CircleFit {
  CircleErrors errors;
  CircleErrors u;  ///< standard uncertainty of each
  bool has_mismatch = false;
  double noise = 0.0;  ///< standard deviation of the residuals, mm
};

/// What is to be fitted.
struct CircleTask {
  std::optional<double> radius;  ///< the commanded one, mm
  CircleErrors start;            ///< near what is sought
  double resolution = 0.0;       ///< of the record, mm
  std::size_t stride = 1;        ///< every so many-th sample
};

/// How far the errors leave a sample from the circle, mm.
///
/// The model: the command runs on the circle; the axes follow with lags tau_X and tau_Y, are too
/// long by their scales, turned by the squareness beta, and half the backlash stays behind on
/// either side:
///
///   x = cx + (1 + s_X) X + beta Y + B_X/2 dir sgn(Y),   X = R cos(phi - omega tau/2)
///   y = cy + (1 + s_Y) Y          - B_Y/2 dir sgn(X),   Y = R sin(phi + omega tau/2)
///
/// with tau = tau_X - tau_Y.  The residual takes this back exactly, to all orders, so that what the
/// model describes leaves nothing.  To first order it is the model of Delta r(theta) that books on
/// circular tests give; what the speed takes from the radius counts as scale.
class CircleResidual {
 public:
  CircleResidual(const CircleErrors& errors, const CircleTurn& turn);

  /// The sample with all errors but that of the radius taken away, from the centre.
  [[nodiscard]] Eigen::Vector2d corrected(const Eigen::Vector2d& p) const;
  [[nodiscard]] double at(const Eigen::Vector2d& p) const { return corrected(p).norm() - radius_; }
  [[nodiscard]] double direction() const { return direction_; }

 private:
  Eigen::Vector2d centre_;
  double radius_;
  double direction_;
  Eigen::Vector2d half_backlash_;
  Eigen::Matrix2d back_;  // from the encoders to a point on the circle
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
/// Uncertainties take residuals that hang together (a form error of the way) into account: the
/// variance of their sums over pieces of 3 and 15 degrees is compared with that of single ones, and
/// the larger ratio, if above 1, counts.  What the resolution hides does not average out: its
/// standard deviation is part of every uncertainty.
/// Accuracy: Gauss-Newton to a step below 1e-12 of the radius.
std::optional<CircleFit> fit_circle(const PlaneSamples& samples,
                                    const std::vector<CircleTurn>& turns,
                                    std::span<const FittedRange> ranges, const CircleTask& task);

}  // namespace g31::metrology

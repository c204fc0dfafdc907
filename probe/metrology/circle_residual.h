#pragma once

#include <array>

#include <Eigen/Core>

#include "probe/metrology/circle_errors.h"
#include "probe/metrology/circle_turns.h"

namespace g31::metrology {

/// How far the errors leave a sample from the circle, mm.
///
/// The model: the command runs on the circle; the axes follow with lags tau_X and tau_Y, are too
/// long by their scales, stand askew by the squareness beta, waver with the turns of their screws,
/// and half the backlash stays behind on either side:
///
///   y = cy + (1 + s_Y) Y - B_Y/2 dir sgn(X) + c_Y(y),            Y = R sin(phi + omega tau/2)
///   x = cx + (1 + s_X) X + B_X/2 dir sgn(Y) + c_X(x) + beta (1 + s_Y) Y,
///                                                               X = R cos(phi - omega tau/2)
///
/// with tau = tau_X - tau_Y and x, y in c_X and c_Y where the screws stand.  A screw is where the
/// axis is recorded when it has come from below, and half the backlash below the middle of both
/// ways: so backlash counts in set-up sheets, too.  Scales do not move it: they hold what the speed
/// takes from the radius, which is no error of a scale.  The residual takes this back, to all
/// orders but for the products of cyclic errors with scales, so that what the model describes
/// leaves nothing.  To first order it is the model of Delta r(theta) that books on circular tests
/// give; what the speed takes from the radius counts as scale.  beta is by the way that Y truly
/// goes, so that speed does not change it.
class CircleResidual {
 public:
  CircleResidual(const CircleErrors& errors, const CircleTurn& turn);

  /// The sample with all errors but those of the radius taken away, from the centre.
  [[nodiscard]] Eigen::Vector2d corrected(const Eigen::Vector2d& p) const;
  /// Where the screws of the axes stand at a sample, but for the errors of their scales.
  [[nodiscard]] Eigen::Vector2d axes_at(const Eigen::Vector2d& p) const;
  /// How far such a point lies outside the circle.
  [[nodiscard]] double outside(const Eigen::Vector2d& corrected) const;
  [[nodiscard]] double at(const Eigen::Vector2d& p) const { return outside(corrected(p)); }

 private:
  [[nodiscard]] Eigen::Vector2d without_play(const Eigen::Vector2d& p) const;
  /// @param q  from the centre, without play
  [[nodiscard]] Eigen::Vector2d screws_at(const Eigen::Vector2d& q) const;
  [[nodiscard]] double cyclic_at(std::size_t axis, double screw) const;

  CircleErrors errors_;
  std::array<double, 2> turns_per_mm_;  // of the screws; 0: none
  Eigen::Vector2d half_backlash_;
  Eigen::Matrix2d axes_;  // from the path to what the axes have gone from the centre
  Eigen::Matrix2d lag_;   // from there to the command
  bool has_cyclic_;
  bool has_lobes_;
};

}  // namespace g31::metrology

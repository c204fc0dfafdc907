#include "probe/metrology/circle_residual.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/LU>

namespace g31::metrology {
namespace {

bool is_there(const CyclicError& error) {
  return error.sine != 0.0 || error.cosine != 0.0;
}

}  // namespace

CircleResidual::CircleResidual(const CircleErrors& errors, const CircleTurn& turn)
    : errors_(errors),
      turns_per_mm_{},
      half_backlash_(0.5 * turn.direction * errors.backlash[0],
                     -0.5 * turn.direction * errors.backlash[1]),
      has_cyclic_(std::ranges::any_of(errors.cyclic, is_there)),
      has_lobes_(std::ranges::any_of(errors.lobes, is_there)) {
  for (const std::size_t axis : {0U, 1U}) {
    const auto& pitch = errors.pitches.at(axis);
    turns_per_mm_.at(axis) = pitch ? 1.0 / *pitch : 0.0;
  }
  const double half = 0.5 * turn.omega * errors.mismatch;
  Eigen::Matrix2d lag;
  lag << std::cos(half), std::sin(half), std::sin(half), std::cos(half);
  const double along_y = 1.0 + errors.scale[1];
  Eigen::Matrix2d axes;
  axes << 1.0 + errors.scale[0], errors.squareness * along_y, 0.0, along_y;
  axes_ = axes.inverse();
  lag_ = lag.inverse();
}

Eigen::Vector2d CircleResidual::without_play(const Eigen::Vector2d& p) const {
  const Eigen::Vector2d q = p - errors_.centre;
  return {q.x() - half_backlash_.x() * sign_of(q.y()), q.y() - half_backlash_.y() * sign_of(q.x())};
}

double CircleResidual::cyclic_at(std::size_t axis, double screw) const {
  const double turned = 2.0 * std::numbers::pi * turns_per_mm_.at(axis) * screw;
  return errors_.cyclic.at(axis).sine * std::sin(turned) +
         errors_.cyclic.at(axis).cosine * std::cos(turned);
}

Eigen::Vector2d CircleResidual::screws_at(const Eigen::Vector2d& q) const {
  // What the scales take or give is partly what the speed takes from the radius: where the table is
  // recorded the screw has truly been.
  Eigen::Vector2d at = errors_.centre + q;
  at.x() -= errors_.squareness * q.y();
  for (const std::size_t axis : {0U, 1U}) {
    const auto i = static_cast<Eigen::Index>(axis);
    at[i] -= 0.5 * errors_.backlash.at(axis);
    if (has_cyclic_) {
      at[i] -= cyclic_at(axis, at[i]);  // the table is so much further than the screw
    }
  }
  return at;
}

Eigen::Vector2d CircleResidual::axes_at(const Eigen::Vector2d& p) const {
  return screws_at(without_play(p));
}

Eigen::Vector2d CircleResidual::corrected(const Eigen::Vector2d& p) const {
  Eigen::Vector2d q = without_play(p);
  if (has_cyclic_) {
    const Eigen::Vector2d at = screws_at(q);
    for (const std::size_t axis : {0U, 1U}) {
      q[static_cast<Eigen::Index>(axis)] -= cyclic_at(axis, at[static_cast<Eigen::Index>(axis)]);
    }
  }
  return lag_ * (axes_ * q);
}

double CircleResidual::outside(const Eigen::Vector2d& corrected) const {
  const double r = corrected.norm();
  double off = r - errors_.radius;
  if (has_lobes_) {
    const std::complex<double> once(corrected.x() / r, corrected.y() / r);
    std::complex<double> lobe = once * once * once;
    static_assert(kFirstLobe == 3);
    for (const CyclicError& part : errors_.lobes) {
      off -= part.cosine * lobe.real() + part.sine * lobe.imag();
      lobe *= once;
    }
  }
  return off;
}

}  // namespace g31::metrology

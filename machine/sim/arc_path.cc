#include "machine/sim/arc_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

constexpr double kQuarterRad = 0.5 * std::numbers::pi;
constexpr double kFullRad = 2.0 * std::numbers::pi;

/// From a direction to another, turning one way: in (0, 2 pi] or [-2 pi, 0).
double turn_between(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Turn turn) {
  const double shorter = std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
  if (turn == Turn::Counterclockwise) {
    return shorter > 0.0 ? shorter : shorter + kFullRad;
  }
  return shorter < 0.0 ? shorter : shorter - kFullRad;
}

}  // namespace

[[gnu::hot]] ArcPath::ArcPath(const AxisPositions& q_M_from, const ArcMove& arc)
    : q_M_from_(q_M_from),
      q_M_to_(arc.q_M_end),
      displacement_(arc.q_M_end - q_M_from),
      first_axis_(arc.first_axis),
      second_axis_(arc.second_axis),
      centre_first_(arc.centre_first),
      centre_second_(arc.centre_second) {
  G31_EXPECTS(is_linear_axis(first_axis_) && is_linear_axis(second_axis_));
  G31_EXPECTS(first_axis_ != second_axis_);
  const Eigen::Vector2d centre(centre_first_, centre_second_);
  const Eigen::Vector2d from =
      Eigen::Vector2d(q_M_from[first_axis_], q_M_from[second_axis_]) - centre;
  const Eigen::Vector2d to = Eigen::Vector2d(q_M_to_[first_axis_], q_M_to_[second_axis_]) - centre;
  radius_from_ = from.norm();
  radius_to_ = to.norm();
  const bool is_full = (to - from).squaredNorm() < kFullCircleGapMm * kFullCircleGapMm;
  if (is_full) {
    turned_rad_ = arc.turn == Turn::Counterclockwise ? kFullRad : -kFullRad;
  } else {
    turned_rad_ = turn_between(from, to, arc.turn);
  }
  direction_from_ =
      radius_from_ > 0.0 ? Eigen::Vector2d(from / radius_from_) : Eigen::Vector2d(1.0, 0.0);
  direction_to_ = radius_to_ > 0.0 ? Eigen::Vector2d(to / radius_to_) : turned(turned_rad_);
  const double around = radius() * turned_rad_;
  const double outwards = radius_to_ - radius_from_;
  length_ = std::sqrt(around * around + outwards * outwards);
}

AxisPositions ArcPath::at(double fraction) const {
  G31_EXPECTS(fraction >= 0.0);
  if (fraction >= 1.0) {
    return q_M_to_;
  }
  if (fraction == 0.0) {
    return q_M_from_;
  }
  AxisPositions q_M = q_M_from_ + fraction * displacement_;
  const double radius = radius_from_ + fraction * (radius_to_ - radius_from_);
  const Eigen::Vector2d direction = turned(fraction * turned_rad_);
  q_M[first_axis_] = centre_first_ + radius * direction.x();
  q_M[second_axis_] = centre_second_ + radius * direction.y();
  return q_M;
}

[[gnu::hot]] AxisPositions ArcPath::slope_at(double fraction) const {
  const double outwards = radius_to_ - radius_from_;
  const double radius = radius_from_ + fraction * outwards;
  // Both ends are asked of each arc.
  const Eigen::Vector2d direction = fraction == 0.0   ? direction_from_
                                    : fraction == 1.0 ? direction_to_
                                                      : turned(fraction * turned_rad_);
  const double around = radius * turned_rad_;
  return with_two(displacement_, first_axis_, outwards * direction.x() - around * direction.y(),
                  second_axis_, outwards * direction.y() + around * direction.x());
}

Eigen::Vector2d ArcPath::turned(double angle_rad) const {
  const double cosine = std::cos(angle_rad);
  const double sine = std::sin(angle_rad);
  return {direction_from_.x() * cosine - direction_from_.y() * sine,
          direction_from_.x() * sine + direction_from_.y() * cosine};
}

AxisBox ArcPath::bounds() const {
  AxisBox box{q_M_from_.cwiseMin(q_M_to_), q_M_from_.cwiseMax(q_M_to_)};
  const double angle_from_rad = std::atan2(direction_from_.y(), direction_from_.x());
  const double low_rad = std::min(angle_from_rad, angle_from_rad + turned_rad_);
  const double high_rad = std::max(angle_from_rad, angle_from_rad + turned_rad_);
  const int first_quarter = static_cast<int>(std::ceil(low_rad / kQuarterRad));
  for (int quarter = first_quarter; quarter * kQuarterRad < high_rad; ++quarter) {
    const double fraction = (quarter * kQuarterRad - angle_from_rad) / turned_rad_;
    const double radius = radius_from_ + fraction * (radius_to_ - radius_from_) - kFullCircleGapMm;
    // Multiples of a right angle have exact directions; cos and sin would round them.
    const int direction = (quarter % 4 + 4) % 4;
    const int axis = direction % 2 == 0 ? first_axis_ : second_axis_;
    const double centre = direction % 2 == 0 ? centre_first_ : centre_second_;
    if (direction < 2) {
      box.q_M_max[axis] = std::max(box.q_M_max[axis], centre + radius);
    } else {
      box.q_M_min[axis] = std::min(box.q_M_min[axis], centre - radius);
    }
  }
  return box;
}

double ArcPath::bend() const {
  return std::abs(turned_rad_) *
         (largest_radius() * std::abs(turned_rad_) + 2.0 * std::abs(radius_to_ - radius_from_));
}

int ArcPath::chord_count() const {
  // A chord over the angle t is r (1 - cos(t / 2)) from its arc, at most r t^2 / 8.
  const double chords = std::abs(turned_rad_) * std::sqrt(largest_radius() / (8.0 * kChordErrorMm));
  return static_cast<int>(std::clamp(std::ceil(chords), 4.0, double{kMostChords}));
}

}  // namespace g31::machine

#include "machine/kinematics/orientation.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <Eigen/Geometry>

#include "machine/kinematics/plane_rotation.h"

namespace g31::machine {
namespace {

/// Squares of sines below this count as 0.
constexpr double kNoSineSquared = 1e-12;
/// Directions whose scalar products differ by less are as far from the axis.
constexpr double kSameHeight = 1e-6;
/// Angles that differ by less are equal where two motions are compared, deg.
constexpr double kSameAngle = 1e-9;

bool are_parallel(const Point& a, const Point& b) {
  return a.cross(b).squaredNorm() < kNoSineSquared;
}

RotaryTravel widened(const RotaryTravel& travel) {
  return {travel.lower - kSameAngle, travel.upper + kSameAngle};
}

/// Rounded so that what counts as equal compares equal.
double coarse(double deg) {
  return std::nearbyint(std::abs(deg) / kSameAngle) * kSameAngle;
}

}  // namespace

OrientationAxes::OrientationAxes(KinematicType type, const std::array<int, 2>& axes,
                                 const std::array<Point, 2>& direction)
    : type_(type), axes_(axes), direction_(direction) {
  for (Point& u : direction_) {
    u.normalize();
  }
}

std::optional<OrientationAxes> OrientationAxes::of(const AxisChainSetup& chain) {
  std::array<int, 2> axes = {-1, -1};
  std::array<Point, 2> direction = {Point::UnitZ(), Point::UnitZ()};
  std::size_t count = 0;
  const auto take = [&](char letter) {
    const int axis = axis_index(letter);
    if (is_rotary_axis(axis)) {
      if (count < 2) {
        axes[count] = axis;
        direction[count] =
            chain.rotary.at(static_cast<std::size_t>(axis - kLinearAxisCount)).axis_M;
      }
      ++count;
    }
  };
  std::ranges::for_each(chain.tool_side, take);
  const std::size_t in_head = count;
  // From the bed to the part, as the tool's side goes from the bed to the tool.
  std::for_each(chain.table_side.rbegin(), chain.table_side.rend(), take);
  if (count == 0 || count > 2 ||
      (count == 2 && are_parallel(direction[0].normalized(), direction[1].normalized()))) {
    return std::nullopt;
  }
  const KinematicType type = in_head == count ? KinematicType::Tool
                             : in_head == 0   ? KinematicType::Part
                                              : KinematicType::Mixed;
  return OrientationAxes(type, axes, direction);
}

Eigen::Matrix3d OrientationAxes::turn(const std::array<double, 2>& deg) const {
  const Eigen::Matrix3d first = turn_about(direction_[0], deg[0]);
  if (count() == 1) {
    return first;
  }
  const Eigen::Matrix3d second = turn_about(direction_[1], deg[1]);
  return type_ == KinematicType::Tool ? Eigen::Matrix3d(first * second) : second * first;
}

RotaryPairs OrientationAxes::pairs_for(const Point& d_P, const Point& d_T) const {
  const Point d = d_P.normalized();
  const Point s = d_T.normalized();
  if (count() == 1) {
    return single(0, d, s);
  }
  // Seen from the part the outer axis comes first: t = R(u, outer) R(w, inner) s.
  const std::size_t outer = type_ == KinematicType::Tool ? 0 : 1;
  const std::size_t inner = 1 - outer;
  const Point& u = direction_[outer];
  const Point& w = direction_[inner];
  if (are_parallel(s, w)) {
    return single(outer, d, s);
  }
  const double k = u.dot(w);
  const double span = 1.0 - k * k;
  const double a = (u.dot(d) - k * w.dot(s)) / span;
  const double b = (w.dot(s) - k * u.dot(d)) / span;
  const double g_squared = (1.0 - a * a - b * b - 2.0 * a * b * k) / span;
  if (g_squared < -kNoSineSquared) {
    return {};
  }
  RotaryPairs pairs;
  pairs.count = g_squared <= kNoSineSquared ? 1 : 2;
  const double g = pairs.count == 1 ? 0.0 : std::sqrt(g_squared);
  for (std::size_t i = 0; i < pairs.count; ++i) {
    const Point v = a * u + b * w + (i == 0 ? g : -g) * u.cross(w);
    RotaryPair& pair = pairs.all.at(i);
    pair.deg[inner] = angle_about(w, s, v);
    pair.is_free[outer] = are_parallel(d, u);
    pair.deg[outer] = pair.is_free[outer] ? 0.0 : angle_about(u, v, d);
  }
  return pairs;
}

RotaryPairs OrientationAxes::single(std::size_t axis, const Point& d_P, const Point& d_T) const {
  const Point& u = direction_[axis];
  RotaryPairs pairs;
  if (std::abs(u.dot(d_P) - u.dot(d_T)) > kSameHeight) {
    return pairs;
  }
  pairs.count = 1;
  RotaryPair& pair = pairs.all[0];
  pair.is_free[axis] = are_parallel(u, d_T);
  pair.is_free[1 - axis] = count() == 2;
  pair.deg[axis] = pair.is_free[axis] ? 0.0 : angle_about(u, d_T, d_P);
  return pairs;
}

std::optional<double> turn_within(double angle, double from, const RotaryTravel& travel) {
  const RotaryTravel wide = widened(travel);
  const double least = std::ceil((wide.lower - angle) / 360.0);
  const double most = std::floor((wide.upper - angle) / 360.0);
  if (!(least <= most)) {
    return std::nullopt;
  }
  const double turns = std::clamp(std::floor((from - angle) / 360.0), least, most);
  const double below = angle + 360.0 * turns;
  const double above = angle + 360.0 * std::min(turns + 1.0, most);
  const auto rank = [&](double at) { return std::tuple(coarse(at - from), std::abs(at)); };
  return std::clamp(rank(above) < rank(below) ? above : below, travel.lower, travel.upper);
}

std::optional<RotaryPair> least_motion(const RotaryPairs& pairs, const std::array<double, 2>& from,
                                       const std::array<RotaryTravel, 2>& travel,
                                       std::size_t first) {
  const std::size_t second = 1 - first;
  std::optional<RotaryPair> best;
  const auto rank = [&](const RotaryPair& pair) {
    return std::tuple(
        coarse(pair.deg[first] - from[first]), coarse(pair.deg[second] - from[second]),
        coarse(within_half_turn(pair.deg[first])), coarse(within_half_turn(pair.deg[second])));
  };
  for (RotaryPair pair : pairs) {
    bool is_reached = true;
    for (std::size_t i = 0; i < 2; ++i) {
      const std::optional<double> at =
          pair.is_free[i] ? from[i] : turn_within(pair.deg[i], from[i], travel[i]);
      is_reached = is_reached && at.has_value();
      pair.deg[i] = at.value_or(0.0);
    }
    if (is_reached && (!best || rank(pair) < rank(*best))) {
      best = pair;
    }
  }
  return best;
}

double on_tooth(double angle, double offset, double pitch) {
  return pitch > 0.0 ? offset + pitch * std::nearbyint((angle - offset) / pitch) : angle;
}

}  // namespace g31::machine

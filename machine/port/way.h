#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"

namespace g31::machine {

/// A point of the way of a tool.
///
/// Where rotary axes turn tool and part against each other, it is told in the frame of the part:
/// the linear axes bring the tool tip where it is, the tilt says how the tool is turned about the
/// tip.
struct Waypoint {
  double fraction = 0.0;  ///< 0..1, rising from 0 to 1: what the answers speak of
  AxisPositions q_M;      ///< true position; equal to the one before where an axis sticks
  /// How the tool is turned there, against the part; where no rotary axis is, not at all.
  Eigen::Quaterniond tilt = Eigen::Quaterniond::Identity();
  /// By which angular errors turn it about the tip beyond that, rad; of the first order.
  Point lean_rad = Point::Zero();
};

/// A straight piece between two points.
struct Sweep {
  AxisPositions q_M_from;
  AxisPositions q_M_to;  ///< not equal to q_M_from, unless the tilt changes
  Eigen::Quaterniond tilt_from = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond tilt_to = Eigen::Quaterniond::Identity();
  Point lean_from_rad = Point::Zero();
  Point lean_to_rad = Point::Zero();
};

/// A curve, like an arc; the tool does not turn on it.
struct CurvedWay {
  std::function<AxisPositions(double)> q_M_at;  ///< at a fraction 0..1
  /// mm: the second derivative of the linear axes by the fraction is nowhere longer.  So the linear
  /// axes are never farther than bend h^2 / 8 from the chord over a fraction h.
  double bend = 0.0;
  int chords = 1;  ///< into how many equal pieces to cut it for a world of straight pieces, >= 1
};

/// The way of the tool in one move: points with straight pieces between them, or a curve.  Owns
/// neither; a way lives as long as the question about it.
class Way {
 public:
  /// @param points  two or more, fractions rising from 0
  explicit Way(std::span<const Waypoint> points) : points_(points) {
    G31_EXPECTS(points.size() >= 2);
  }
  explicit Way(const CurvedWay& curve) : curve_(&curve) {}

  /// Null: the way is one of points.
  [[nodiscard]] const CurvedWay* curve() const { return curve_; }

  /// @pre no curve
  [[nodiscard]] std::span<const Waypoint> points() const {
    G31_EXPECTS(curve_ == nullptr);
    return points_;
  }

 private:
  std::span<const Waypoint> points_;
  const CurvedWay* curve_ = nullptr;
};

/// Whether anything changes between two points.
inline bool differ(const Waypoint& a, const Waypoint& b) {
  return a.q_M != b.q_M || a.tilt.coeffs() != b.tilt.coeffs() || a.lean_rad != b.lean_rad;
}

inline Sweep sweep_between(const Waypoint& from, const Waypoint& to) {
  return {from.q_M, to.q_M, from.tilt, to.tilt, from.lean_rad, to.lean_rad};
}

inline Waypoint start_of(const Sweep& sweep) {
  return {0.0, sweep.q_M_from, sweep.tilt_from, sweep.lean_from_rad};
}
inline Waypoint end_of(const Sweep& sweep) {
  return {1.0, sweep.q_M_to, sweep.tilt_to, sweep.lean_to_rad};
}

/// The fraction of the way after a share 0..1 of the piece between two points of it.
inline double fraction_between(const Waypoint& from, const Waypoint& to, double share) {
  return from.fraction + share * (to.fraction - from.fraction);
}

/// The points of a way; of a curve those where its chords meet.
inline std::vector<Waypoint> points_of(const Way& way) {
  if (way.curve() == nullptr) {
    return {way.points().begin(), way.points().end()};
  }
  const CurvedWay& curve = *way.curve();
  std::vector<Waypoint> points;
  for (int i = 0; i <= curve.chords; ++i) {
    const double fraction = static_cast<double>(i) / curve.chords;
    points.push_back({fraction, curve.q_M_at(fraction)});
  }
  return points;
}

/// How far apart two positions are, mm, linear axes only.
inline double distance_mm(const AxisPositions& q_from, const AxisPositions& q_to) {
  return (linear_axes(q_to) - linear_axes(q_from)).norm();
}

/// The length of a way of straight pieces, mm.
inline double length_of(std::span<const Waypoint> way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length += distance_mm(way[i - 1].q_M, way[i].q_M);
  }
  return length;
}

/// The fraction of a way after some of its length, mm; before the way 0, behind it 1.
inline double fraction_after(std::span<const Waypoint> way, double length) {
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double piece = distance_mm(way[i - 1].q_M, way[i].q_M);
    if (length <= piece && piece > 0.0) {
      return fraction_between(way[i - 1], way[i], std::max(0.0, length) / piece);
    }
    length -= piece;
  }
  return 1.0;
}

/// The fraction of a way of straight pieces after a share 0..1 of its length.
inline double fraction_at_share(std::span<const Waypoint> way, double share) {
  return way.size() == 2 ? fraction_between(way.front(), way.back(), share)
                         : fraction_after(way, share * length_of(way));
}

}  // namespace g31::machine

#include "interpreter/path/corner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace g31::path {
namespace {

PlanePoint left_of(const PlanePoint& direction) {
  return {-direction.y(), direction.x()};
}

/// A corner as its tangents show it; all that outside corners need.
struct Tangents {
  explicit Tangents(const Corner& corner)
      : p(corner.before.to),
        before(direction_at_end(corner.before)),
        behind(direction_at_start(corner.behind)),
        offset(corner.offset_before) {}

  /// The ways go on in the same direction, so far as the tool is concerned.
  [[nodiscard]] bool are_smooth() const {
    return before.dot(behind) > 0.0 && std::abs(offset) * (behind - before).norm() < kOnePointMm;
  }
  /// The tool is on the outside of the turn.  To turn back counts as outside.
  [[nodiscard]] bool turn_outside() const {
    const double turn = cross(before, behind);
    const bool back = before.dot(behind) < 0.0 && std::abs(turn) < 1e-12;
    return back || turn * offset < 0.0;
  }
  /// Where the two tangents, offset, meet.
  [[nodiscard]] PlanePoint intersection() const {
    return p + left_of(before + behind) * (offset / (1.0 + before.dot(behind)));
  }

  PlanePoint p;
  PlanePoint before;
  PlanePoint behind;
  double offset;
};

/// The points around an outside corner, without those beside the corner itself.
CornerPoints around(const Tangents& at, OutsideCorner outside) {
  if (at.before.dot(at.behind) >= -1e-12 || outside == OutsideCorner::Intersection) {
    return {at.intersection()};
  }
  const double radius = std::abs(at.offset);
  return {at.p + at.offset * left_of(at.before) + radius * at.before,
          at.p + at.offset * left_of(at.behind) - radius * at.behind};
}

bool minute(const PlanePoint& a, const PlanePoint& b, double limit) {
  return (a - b).cwiseAbs().maxCoeff() <= limit;
}

/// Which ends of a list of points belong to an arc and cannot be left out.
struct Fixed {
  bool first;
  bool last;
};

/// Leaves out points that a minute distance makes of no account.
CornerPoints without_minute(const CornerPoints& points, double limit_mm, Fixed fixed) {
  const double limit = std::max(limit_mm, kOnePointMm);
  CornerPoints kept{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const bool must_stay = fixed.last && i + 1 == points.size();
    if (!minute(kept.back(), points[i], limit)) {
      kept.push_back(points[i]);
    } else if (must_stay && !(fixed.first && kept.size() == 1)) {
      kept.back() = points[i];
    } else if (must_stay && !minute(kept.back(), points[i], kOnePointMm)) {
      kept.push_back(points[i]);
    }
  }
  return kept;
}

/// The tool goes round an outside corner along an arc.
bool is_round(const Corner& corner, const Tangents& at) {
  static const double kSharpest = std::cos(kSharpestDeg * std::numbers::pi / 180.0);
  return corner.outside == OutsideCorner::Arc ||
         (corner.outside == OutsideCorner::Intersection && at.before.dot(at.behind) < kSharpest);
}

/// Where a tangent from a point touches the circle about the corner; nullopt: the point is within.
/// @param side  1: the centre lies to the right of the way from the point to the circle
std::optional<PlanePoint> tangent_point(const Tangents& at, const PlanePoint& from, double side) {
  const PlanePoint to_centre = at.p - from;
  const double square = to_centre.squaredNorm();
  const double radius = std::abs(at.offset);
  if (square <= radius * radius) {
    return std::nullopt;
  }
  const double along = std::sqrt(square - radius * radius);
  return from + (along * to_centre + side * radius * left_of(to_centre)) * (along / square);
}

CornerPoints outside_points(const Corner& corner, const Tangents& at) {
  if (is_round(corner, at)) {
    return {beside_end(corner.before, at.offset), beside_start(corner.behind, at.offset)};
  }
  CornerPoints points = around(at, corner.outside);
  const Fixed fixed{corner.before.arc.has_value(), corner.behind.arc.has_value()};
  if (fixed.first) {
    points.insert(points.begin(), beside_end(corner.before, at.offset));
  }
  if (fixed.last) {
    points.push_back(beside_start(corner.behind, at.offset));
  }
  return without_minute(points, corner.minute_mm, fixed);
}

/// An offset way, endless: a straight line through p along `direction`, or a circle.
struct Curve {
  PlanePoint p;          ///< a point of the line, or the centre
  PlanePoint direction;  ///< of the line
  double radius = 0.0;   ///< of the circle; 0: a line
};

Curve curve_of(const PlaneWay& way, const PlanePoint& at, double offset) {
  if (way.arc) {
    return {way.arc->centre, PlanePoint::Zero(), offset_radius(*way.arc, at, offset)};
  }
  const PlanePoint direction = direction_at_start(way);
  return {at + offset * left_of(direction), direction, 0.0};
}

/// Half the chord that a line at a distance from the centre cuts out of a circle.
std::optional<double> half_chord(double radius, double distance) {
  // (r - d)(r + d) keeps the digits that r^2 - d^2 loses where the line nearly touches the circle.
  const double square = (radius - distance) * (radius + distance);
  if (square < 0.0) {
    return distance - radius < kOnePointMm ? std::optional(0.0) : std::nullopt;
  }
  return std::sqrt(square);
}

using TwoPoints = std::optional<std::array<PlanePoint, 2>>;

TwoPoints line_and_circle(const Curve& line, const Curve& circle) {
  const PlanePoint foot = line.p + line.direction * line.direction.dot(circle.p - line.p);
  const auto half = half_chord(circle.radius, (foot - circle.p).norm());
  if (!half) {
    return std::nullopt;
  }
  return {{foot - *half * line.direction, foot + *half * line.direction}};
}

TwoPoints two_circles(const Curve& a, const Curve& b) {
  const double distance = (b.p - a.p).norm();
  if (distance < kOnePointMm) {
    return std::nullopt;
  }
  const PlanePoint axis = (b.p - a.p) / distance;
  const double along = (distance + (a.radius - b.radius) * (a.radius + b.radius) / distance) / 2.0;
  const auto half = half_chord(a.radius, std::abs(along));
  if (!half) {
    return std::nullopt;
  }
  const PlanePoint foot = a.p + along * axis;
  return {{foot - *half * left_of(axis), foot + *half * left_of(axis)}};
}

/// The intersection of the two offset ways next to the corner.
std::optional<PlanePoint> inside_point(const Corner& corner, const Tangents& at) {
  const Curve a = curve_of(corner.before, at.p, at.offset);
  const Curve b = curve_of(corner.behind, at.p, at.offset);
  if (!corner.before.arc && !corner.behind.arc) {
    return at.intersection();
  }
  const TwoPoints found = !corner.before.arc   ? line_and_circle(a, b)
                          : !corner.behind.arc ? line_and_circle(b, a)
                                               : two_circles(a, b);
  if (!found) {
    return std::nullopt;
  }
  const auto& [one, other] = *found;
  return (one - at.p).norm() <= (other - at.p).norm() ? one : other;
}

/// The tool changes the side: where the two offset lines meet, if both blocks reach so far; else
/// beside the start of the second block.
CornerPoints crossing_points(const Corner& corner, const Tangents& at) {
  const PlanePoint beside = beside_start(corner.behind, corner.offset_behind);
  if (corner.before.arc) {
    return {beside_end(corner.before, corner.offset_before), beside};
  }
  const double turn = cross(at.before, at.behind);
  if (corner.behind.arc || std::abs(turn) < 1e-12) {
    return {beside};
  }
  // Both lines are met the same way in front of or behind the corner.
  const double way = at.offset * (1.0 + at.before.dot(at.behind)) / turn;
  const bool reached = way < (corner.behind.to - corner.behind.from).norm() &&
                       -way < (corner.before.to - corner.before.from).norm();
  return reached ? CornerPoints{at.p + at.offset * left_of(at.before) + way * at.before}
                 : CornerPoints{beside};
}

}  // namespace

PlanePoint beside_start(const PlaneWay& way, double offset) {
  return way.from + offset * left_of(direction_at_start(way));
}

PlanePoint beside_end(const PlaneWay& way, double offset) {
  return way.to + offset * left_of(direction_at_end(way));
}

double offset_radius(const ArcShape& arc, const PlanePoint& p, double offset) {
  const double inwards = arc.turn == machine::Turn::Counterclockwise ? offset : -offset;
  return (p - arc.centre).norm() - inwards;
}

std::optional<CornerPoints> corner_points(const Corner& corner) {
  const Tangents at(corner);
  if (corner.offset_before != corner.offset_behind) {
    return crossing_points(corner, at);
  }
  if (at.are_smooth()) {
    return CornerPoints{beside_end(corner.before, at.offset)};
  }
  if (at.turn_outside()) {
    return outside_points(corner, at);
  }
  const auto inside = inside_point(corner, at);
  return inside ? std::optional(CornerPoints{*inside}) : std::nullopt;
}

std::optional<ArcShape> corner_arc(const Corner& corner) {
  const Tangents at(corner);
  if (corner.offset_before != corner.offset_behind || at.are_smooth() || !at.turn_outside() ||
      !is_round(corner, at)) {
    return std::nullopt;
  }
  return ArcShape{at.p,
                  at.offset > 0.0 ? machine::Turn::Clockwise : machine::Turn::Counterclockwise};
}

CornerPoints start_up_points(const Corner& corner, StartUp type) {
  const Tangents at(corner);
  const PlanePoint beside = beside_start(corner.behind, at.offset);
  if (type == StartUp::TypeA || at.are_smooth() || !at.turn_outside()) {
    return {beside};
  }
  if (is_round(corner, at)) {
    const auto tangent = tangent_point(at, corner.before.from, std::copysign(1.0, at.offset));
    return tangent ? CornerPoints{*tangent, beside} : CornerPoints{};
  }
  CornerPoints points = around(at, corner.outside);
  points.insert(points.begin(), beside_end(corner.before, at.offset));
  const Fixed fixed{false, corner.behind.arc.has_value()};
  if (fixed.last) {
    points.push_back(beside);
  }
  return without_minute(points, corner.minute_mm, fixed);
}

CornerPoints cancel_points(const Corner& corner, StartUp type) {
  const Tangents at(corner);
  const PlanePoint beside = beside_end(corner.before, at.offset);
  if (type == StartUp::TypeA || at.are_smooth() || !at.turn_outside()) {
    return {beside};
  }
  if (is_round(corner, at)) {
    const auto tangent = tangent_point(at, corner.behind.to, -std::copysign(1.0, at.offset));
    return tangent ? CornerPoints{beside, *tangent} : CornerPoints{};
  }
  CornerPoints points = around(at, corner.outside);
  const Fixed fixed{corner.before.arc.has_value(), false};
  if (fixed.first) {
    points.insert(points.begin(), beside);
  }
  points.push_back(beside_start(corner.behind, at.offset));
  return without_minute(points, corner.minute_mm, fixed);
}

}  // namespace g31::path

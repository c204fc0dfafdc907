#include "probe/tooling/turning_teeth.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/base/contract.h"
#include "probe/tooling/spindle.h"
#include "probe/tooling/tool_shape.h"

namespace g31::probe {
namespace {

/// One tooth against the tangent plane.
class PassingTooth {
 public:
  PassingTooth(const Tooth& tooth, const Blade& blade, const OutlineTouch& touch,
               const Turning& turning)
      : tooth_(tooth), blade_(blade), touch_(touch), turning_(turning) {
    if (const double across = touch.n_T.head<2>().norm(); across > 0.0) {
      blade_.direction = -touch.n_T.head<2>() / across;
    }
    p_T_furthest_ = furthest_of(blade_, -touch.n_T);
    inwards_mm_s_ = -turning.speed_mm_s * touch.n_T.dot(touch.way_T);
  }

  /// How far it reaches towards the target where it faces it.
  [[nodiscard]] double furthest() const { return -touch_.n_T.dot(p_T_furthest_); }

  /// Seconds after it is deep enough to touch, where the spindle has brought it.
  /// @param from_s  when it is so, after the touch of the outline
  [[nodiscard]] std::optional<double> wait_s(double from_s) const {
    // Of the normal, across the tool's axis: on an edge of the target anything between.
    const double across = touch_.n_T.head<2>().norm();
    constexpr double kFromAbove = 0.01;
    constexpr double kFromTheSide = 0.99;
    if (across <= kFromAbove) {
      return wait_above_s(from_s);
    }
    const bool passes_above = across > kFromTheSide && -tooth_.length_mm >= touch_.z_T_top;
    return passes_above ? std::nullopt : std::optional(wait_at_side_s(from_s, across));
  }

 private:
  [[nodiscard]] double angle_deg(double time_s) const {
    return turning_.angle_deg + tooth_.angle_deg + turning_.rate_deg_s * time_s;
  }

  /// Degrees, 0 to 360, that the spindle turns until the tooth points in a direction.
  [[nodiscard]] double degrees_to(double direction_deg, double from_s) const {
    const double gap = direction_deg - angle_deg(from_s);
    const double ahead = turning_.rate_deg_s > 0.0 ? gap : -gap;
    return ahead - kFullTurnDeg * std::floor(ahead / kFullTurnDeg);
  }

  /// Just before it points to the face: as the feed deepens its circle, it meets the face earlier.
  [[nodiscard]] double wait_at_side_s(double from_s, double across) const {
    const double facing_deg = std::atan2(-touch_.n_T.y(), -touch_.n_T.x()) / kRadPerDeg;
    const double rate = std::abs(turning_.rate_deg_s);
    const double passes_s = degrees_to(facing_deg, from_s) / rate;
    // How long before it faces the plate a shallow cut begins; a deep one may take half the turn.
    const double turn = kRadPerDeg * rate;
    const double radius = p_T_furthest_.head<2>().norm();
    const double shallow_s = std::sqrt(2.0 * inwards_mm_s_ * passes_s / (radius * across)) / turn;
    constexpr double kMargin = 1.5;
    constexpr double kShallow = 2.0;  // rad: 1 - cos is a third of the square at least
    const bool is_shallow = kMargin * shallow_s * turn < kShallow;
    const double before_s = is_shallow ? kMargin * shallow_s : 0.5 * kFullTurnDeg / rate;
    double early = std::max(0.0, passes_s - before_s);
    double late = passes_s;
    const int halvings = is_shallow ? 30 : 50;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (early + late);
      const double missing = radius * across * (1.0 - std::cos(turn * (passes_s - middle)));
      (inwards_mm_s_ * middle < missing ? early : late) = middle;
    }
    return late;
  }

  /// Until its lowest point, or as much of its edge as is deep enough by then, is above the face.
  [[nodiscard]] std::optional<double> wait_above_s(double from_s) const {
    constexpr int kSteps = 360;
    const double turn_s = kFullTurnDeg / std::abs(turning_.rate_deg_s);
    std::optional<double> first;
    for (int i = 0; i < kSteps && (!first || i * turn_s < *first * kSteps); ++i) {
      const double comes_s = i * turn_s / kSteps;
      if (const auto rise = rise_above_face(angle_deg(from_s + comes_s))) {
        const double late_s = std::max(0.0, *rise / inwards_mm_s_ - comes_s);
        const double wait_s = comes_s + turn_s * std::ceil(late_s / turn_s);
        first = first ? std::min(*first, wait_s) : wait_s;
      }
    }
    return first;
  }

  /// How much higher than its lowest point the edge is where it is above the face; nullopt:
  /// nowhere.
  [[nodiscard]] std::optional<double> rise_above_face(double degrees) const {
    const Eigen::Vector2d along(std::cos(kRadPerDeg * degrees), std::sin(kRadPerDeg * degrees));
    const auto [near, far] = across_face(along);
    if (near > far) {
      return std::nullopt;
    }
    const double rounding = blade_.rounded_radius;
    const double cone = blade_.rounded_centre.y() - rounding + tooth_.length_mm;
    const double lowest = cone > 0.0 ? 0.0 : blade_.rounded_centre.x();
    if (far < lowest) {
      return (lowest - far) * std::tan(kRadPerDeg * kDishDeg);
    }
    const double off = std::max(0.0, near - lowest);
    return cone > 0.0 ? cone * off / tooth_.radius_mm
                      : rounding - std::sqrt(std::max(0.0, rounding * rounding - off * off));
  }

  /// From where to where a ray from the axis is above the face, mm within the tool's radius; from
  /// behind to: nowhere.
  [[nodiscard]] std::pair<double, double> across_face(const Eigen::Vector2d& along) const {
    double near = 0.0;
    double far = tooth_.radius_mm;
    const auto clip = [&](double low, double high) {
      near = std::max(near, low);
      far = std::min(far, high);
    };
    const Eigen::Vector2d& p = touch_.p_T_face;
    if (touch_.is_face_round) {
      const double ahead = along.dot(p);
      const double squared =
          ahead * ahead - p.squaredNorm() + touch_.face_half.x() * touch_.face_half.x();
      const double half = std::sqrt(std::max(0.0, squared));
      return squared < 0.0 ? std::pair(1.0, 0.0)
                           : (clip(ahead - half, ahead + half), std::pair(near, far));
    }
    const Eigen::Vector2d other(-touch_.face_side.y(), touch_.face_side.x());
    for (const auto& [side, half] : {std::pair(touch_.face_side, touch_.face_half.x()),
                                     std::pair(other, touch_.face_half.y())}) {
      const double rate = along.dot(side);
      const double middle = p.dot(side);
      if (rate == 0.0) {
        if (std::abs(middle) > half) {
          return {1.0, 0.0};
        }
        continue;
      }
      const double reach = half / std::abs(rate);
      clip(middle / rate - reach, middle / rate + reach);
    }
    return {near, far};
  }

  const Tooth& tooth_;
  Blade blade_;  // as it faces the target
  const OutlineTouch& touch_;
  const Turning& turning_;
  Point p_T_furthest_ = Point::Zero();
  double inwards_mm_s_ = 0.0;
};

}  // namespace

std::optional<double> way_to_first_tooth(const ToolSetup& tool, const OutlineTouch& touch,
                                         const Turning& turning) {
  G31_EXPECTS(turning.rate_deg_s != 0.0 && turning.speed_mm_s > 0.0);
  const double inwards = -touch.n_T.dot(touch.way_T);
  const Tooth widest = outline_of(tool);
  const double outline = PassingTooth(widest, blade_of(widest, tool), touch, turning).furthest();
  std::optional<double> first;
  for (const Tooth& tooth : tool.teeth) {
    const PassingTooth passing(tooth, blade_of(tooth, tool), touch, turning);
    const double deep_enough = (outline - passing.furthest()) / inwards;
    if (first && deep_enough >= *first) {
      continue;
    }
    const double from_s = deep_enough / turning.speed_mm_s;
    if (const auto wait = passing.wait_s(from_s)) {
      const double way = turning.speed_mm_s * (from_s + *wait);
      first = first ? std::min(*first, way) : way;
    }
  }
  return first;
}

}  // namespace g31::probe

#include "probe/tooling/turning_teeth.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"
#include "probe/tooling/spindle.h"
#include "probe/tooling/tool_shape.h"

namespace g31::probe {
namespace {

/// One tooth against the tangent plane.
class PassingTooth {
 public:
  PassingTooth(const Tooth& tooth, const OutlineTouch& touch, const Turning& turning)
      : tooth_(tooth), touch_(touch), turning_(turning) {
    inwards_mm_s_ = -turning.speed_mm_s * touch.n_T.dot(touch.way_T);
  }

  /// Seconds after it is deep enough to touch, where the spindle has brought it.
  /// @param from_s  when it is so, after the touch of the outline
  [[nodiscard]] std::optional<double> wait_s(double from_s) const {
    const double across = touch_.n_T.head<2>().norm();
    constexpr double kFromTheSide = 0.5;
    if (across <= kFromTheSide) {
      return wait_above_s(from_s);
    }
    const bool passes_above = -tooth_.length_mm >= touch_.z_T_top;
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
    const double shallow_s =
        std::sqrt(2.0 * inwards_mm_s_ * passes_s / (tooth_.radius_mm * across)) / turn;
    constexpr double kMargin = 1.5;
    constexpr double kShallow = 2.0;  // rad: 1 - cos is a third of the square at least
    const bool is_shallow = kMargin * shallow_s * turn < kShallow;
    const double before_s = is_shallow ? kMargin * shallow_s : 0.5 * kFullTurnDeg / rate;
    double early = std::max(0.0, passes_s - before_s);
    double late = passes_s;
    const int halvings = is_shallow ? 30 : 50;
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (early + late);
      const double missing =
          tooth_.radius_mm * across * (1.0 - std::cos(turn * (passes_s - middle)));
      (inwards_mm_s_ * middle < missing ? early : late) = middle;
    }
    return late;
  }

  /// Until its corner is above the face.
  [[nodiscard]] std::optional<double> wait_above_s(double from_s) const {
    constexpr double kStepDeg = 1.0;
    const double step_s = kStepDeg / std::abs(turning_.rate_deg_s);
    for (int i = 0; i < static_cast<int>(kFullTurnDeg / kStepDeg); ++i) {
      if (is_above_face(angle_deg(from_s + i * step_s))) {
        return i * step_s;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] bool is_above_face(double degrees) const {
    const Eigen::Vector2d corner =
        tooth_.radius_mm *
        Eigen::Vector2d(std::cos(kRadPerDeg * degrees), std::sin(kRadPerDeg * degrees));
    const Eigen::Vector2d from_middle = corner - touch_.p_T_face;
    if (touch_.is_face_round) {
      return from_middle.norm() <= touch_.face_half.x();
    }
    const Eigen::Vector2d other(-touch_.face_side.y(), touch_.face_side.x());
    return std::abs(from_middle.dot(touch_.face_side)) <= touch_.face_half.x() &&
           std::abs(from_middle.dot(other)) <= touch_.face_half.y();
  }

  const Tooth& tooth_;
  const OutlineTouch& touch_;
  const Turning& turning_;
  double inwards_mm_s_ = 0.0;
};

}  // namespace

std::optional<double> way_to_first_tooth(const ToolSetup& tool, const OutlineTouch& touch,
                                         const Turning& turning) {
  G31_EXPECTS(turning.rate_deg_s != 0.0 && turning.speed_mm_s > 0.0);
  const auto furthest_to = [&](const Tooth& tooth) {
    return -touch.n_T.dot(furthest_of(envelope_of(tooth, tool), -touch.n_T));
  };
  const double inwards = -touch.n_T.dot(touch.way_T);
  const double outline = furthest_to(outline_of(tool));
  std::optional<double> first;
  for (const Tooth& tooth : tool.teeth) {
    const double deep_enough = (outline - furthest_to(tooth)) / inwards;
    if (first && deep_enough >= *first) {
      continue;
    }
    const double from_s = deep_enough / turning.speed_mm_s;
    const PassingTooth passing(tooth, touch, turning);
    if (const auto wait = passing.wait_s(from_s)) {
      const double way = turning.speed_mm_s * (from_s + *wait);
      first = first ? std::min(*first, way) : way;
    }
  }
  return first;
}

}  // namespace g31::probe

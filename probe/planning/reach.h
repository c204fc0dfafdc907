#pragma once

#include <limits>
#include <optional>
#include <string>

#include "machine/port/surroundings.h"
#include "machine/units/point.h"
#include "probe/planning/inspection_plan.h"

namespace g31::probe {

/// How a probe goes to a touch.
struct ProbeWay {
  Point p_M_product = Point::Zero();  ///< machine frame: the origin of the product frame P
  Point p_S_ball = Point::Zero();     ///< the ball's centre from the gauge point
  double ball_radius_mm = 3.0;        ///< > 0
  double clear_z_P = 0.0;             ///< of the ball's centre: it travels freely at this height
  double overtravel_mm = 3.0;         ///< >= 0: how far behind the surface a touch ends
  /// Machine coordinates that X, Y and Z can have.
  Point q_M_least = Point::Constant(-std::numeric_limits<double>::infinity());
  Point q_M_most = Point::Constant(std::numeric_limits<double>::infinity());
};

/// Asks the world of a run whether a probe gets to a touch with all that it carries.
class Reach {
 public:
  /// @param world  outlives it: a probe among the product and its fixtures
  Reach(machine::Surroundings& world, const ProbeWay& way) : world_(world), way_(way) {}

  [[nodiscard]] const ProbeWay& way() const { return way_; }

  /// From the clear height straight down to the start, from there against the normal to the touch.
  /// @param surface_error_mm  how far facets may be from the surface that they stand for
  /// @returns why it does not get there, or touches something else than the point
  std::optional<std::string> problem(const PlannedPoint& point, double surface_error_mm);

  /// @returns what is in the way of the ball's centre between two places, product frame
  std::optional<std::string> obstacle(const Point& p_P_from, const Point& p_P_to,
                                      machine::Travel travel);

 private:
  [[nodiscard]] AxisPositions axes_at(const Point& p_P_ball) const;
  /// @returns which axis cannot take the ball's centre there
  [[nodiscard]] std::optional<std::string> beyond_travel(const Point& p_P_ball) const;

  machine::Surroundings& world_;
  ProbeWay way_;
};

}  // namespace g31::probe

#include "probe/sensor/carrier_view.h"

#include <algorithm>
#include <utility>

#include "machine/base/contract.h"
#include "probe/sensor/release.h"

namespace g31::probe {
namespace {

/// Of one piece; as those of the machine's own way.
constexpr int kMostCarrierHalvings = 24;

machine::Waypoint waypoint_at(const machine::Way& way, double fraction) {
  if (way.curve() != nullptr) {
    return {fraction, way.curve()->q_M_at(fraction)};
  }
  const auto points = way.points();
  const auto after = std::ranges::upper_bound(points, fraction, {}, &machine::Waypoint::fraction);
  if (after == points.begin() || after == points.end()) {
    return after == points.end() ? points.back() : points.front();
  }
  const machine::Waypoint& before = *(after - 1);
  return between(before, *after,
                 (fraction - before.fraction) / (after->fraction - before.fraction));
}

/// rad; exactly 0 between equals.
double turn_of(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return a.coeffs() == b.coeffs() ? 0.0 : a.angularDistance(b);
}

}  // namespace

Eigen::Isometry3d part_from(const Carrier& carrier, const AxisPositions& q_M) {
  return carrier.link ? carrier.chain.part_from_link(*carrier.link, q_M)
                      : carrier.chain.part_from_machine(q_M);
}

void CarrierView::take_tool(const Point& p_T_tip, double reach_mm) {
  p_T_tip_ = p_T_tip;
  reach_mm_ = reach_mm;
  if (carrier_) {
    carrier_->chain.take_tool(p_T_tip);
  }
}

bool CarrierView::only_shifts() const {
  return !carrier_ || !carrier_->chain.has_rotary_axes();
}

std::optional<Eigen::Isometry3d> CarrierView::part_from_carrier(const machine::Waypoint& at) const {
  if (!carrier_) {
    return std::nullopt;
  }
  const machine::AxisChain& chain = carrier_->chain;
  const Point p_P_tip = linear_axes(at.q_M) + p_T_tip_;
  if (!carrier_->link && !chain.is_turned(at.q_M)) {
    return std::nullopt;
  }
  return part_from(*carrier_, chain.axes_near(p_P_tip, at.q_M));
}

machine::Waypoint CarrierView::from_carrier(const machine::Waypoint& at) const {
  const auto part_from_here = part_from_carrier(at);
  if (!part_from_here) {
    return at;
  }
  machine::Waypoint seen = at;
  if (!carrier_->chain.is_turned(at.q_M)) {
    seen.q_M.head<kLinearAxisCount>() -= part_from_here->translation();
    return seen;
  }
  const Eigen::Isometry3d here_from_part = part_from_here->inverse();
  seen.q_M.head<kLinearAxisCount>() = here_from_part * (linear_axes(at.q_M) + p_T_tip_) - p_T_tip_;
  seen.tilt = Eigen::Quaterniond(here_from_part.linear()) * at.tilt;
  seen.lean_rad = here_from_part.linear() * at.lean_rad;
  return seen;
}

std::vector<machine::Waypoint> CarrierView::from_carrier(const machine::Way& way) const {
  std::vector<machine::Waypoint> points = machine::points_of(way);
  if (!carrier_) {
    return points;
  }
  std::vector<machine::Waypoint> seen = {from_carrier(points.front())};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Piece piece{points[i - 1], points[i], seen.back(), from_carrier(points[i])};
    const bool turns = rotary_axes(piece.from.q_M) != rotary_axes(piece.to.q_M);
    add(piece, turns ? kMostCarrierHalvings : 0, seen);
  }
  return seen;
}

bool CarrierView::is_straight(const Piece& piece) const {
  constexpr double kMost = 0.5 * kCarrierWayErrorMm;
  const double turned_rad = turn_of(piece.seen_from.tilt, piece.seen_to.tilt);
  if (reach_mm_ * turned_rad * turned_rad / 8.0 > kMost) {
    return false;
  }
  for (const double share : {0.25, 0.5, 0.75}) {
    const machine::Waypoint seen = from_carrier(between(piece.from, piece.to, share));
    const machine::Waypoint told = between(piece.seen_from, piece.seen_to, share);
    if (machine::distance_mm(seen.q_M, told.q_M) > kMost ||
        reach_mm_ * turn_of(seen.tilt, told.tilt) > kMost) {
      return false;
    }
  }
  return true;
}

void CarrierView::add(const Piece& piece, int halvings,
                      std::vector<machine::Waypoint>& seen) const {
  if (halvings == 0 || is_straight(piece)) {
    seen.push_back(piece.seen_to);
    return;
  }
  const machine::Waypoint middle = between(piece.from, piece.to, 0.5);
  const machine::Waypoint seen_middle = from_carrier(middle);
  add({piece.from, middle, piece.seen_from, seen_middle}, halvings - 1, seen);
  add({middle, piece.to, seen_middle, piece.seen_to}, halvings - 1, seen);
}

machine::Contact CarrierView::for_part(const machine::Contact& contact, const machine::Way& way,
                                       double fraction) const {
  if (!carrier_) {
    return contact;
  }
  const auto part_from_here = part_from_carrier(waypoint_at(way, fraction));
  return part_from_here ? machine::Contact{*part_from_here * contact.p_M_point,
                                           part_from_here->linear() * contact.n_M, contact.part}
                        : contact;
}

CarriedObstacles::CarriedObstacles(std::unique_ptr<machine::Surroundings> inner, const Place& place)
    : inner_(std::move(inner)),
      view_(place.carrier),
      reach_mm_(place.reach_mm),
      p_T_led_(place.p_T_led) {
  G31_EXPECTS(inner_ != nullptr && place.reach_mm >= 0.0);
}

std::optional<machine::SkipTrigger> CarriedObstacles::first_signal(
    const machine::Way& /*way*/, const machine::Listening& /*to*/) {
  return std::nullopt;
}

std::optional<machine::Obstacle> CarriedObstacles::seen_obstacle(const machine::Way& way,
                                                                 machine::Travel travel) {
  if (way.curve() != nullptr && view_.only_shifts()) {
    machine::CurvedWay seen = *way.curve();
    seen.q_M_at = [this, curve = way.curve()](double fraction) {
      return view_.from_carrier(machine::Waypoint{fraction, curve->q_M_at(fraction)}).q_M;
    };
    return inner_->first_obstacle(machine::Way(seen), travel);
  }
  const std::vector<machine::Waypoint> points = view_.from_carrier(way);
  return inner_->first_obstacle(machine::Way(points), travel);
}

std::optional<machine::Obstacle> CarriedObstacles::first_obstacle(const machine::Way& way,
                                                                  machine::Travel travel) {
  const machine::ToolExtent extent = inner_->tool_extent();
  const auto p_T_tip = p_T_led_ ? p_T_led_ : extent.p_T_tip;
  if (!p_T_tip) {
    return std::nullopt;  // what could meet them is not in place
  }
  view_.take_tool(*p_T_tip, extent.body_mm);
  auto obstacle = seen_obstacle(way, travel);
  if (obstacle) {
    obstacle->contact = view_.for_part(obstacle->contact, way, obstacle->fraction);
  }
  return obstacle;
}

bool CarriedObstacles::signals_at(const machine::Waypoint& /*at*/,
                                  const machine::Listening& /*to*/) const {
  return false;
}

std::optional<machine::SensorState> CarriedObstacles::sensor_state(int /*input*/) const {
  return std::nullopt;
}

machine::ToolExtent CarriedObstacles::tool_extent() const {
  machine::ToolExtent extent = inner_->tool_extent();
  extent.body_mm = std::max(extent.body_mm, reach_mm_);
  return extent;
}

void CarriedObstacles::take(const machine::MachineEvent& event) {
  inner_->take(event);
}

void CarriedObstacles::time_is(double now_s) {
  inner_->time_is(now_s);
}

}  // namespace g31::probe

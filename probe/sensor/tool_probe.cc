#include "probe/sensor/tool_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "machine/base/contract.h"
#include "machine/base/random.h"
#include "machine/units/turn_from_z.h"
#include "parts/geometry/placement.h"
#include "probe/sensor/cutting_tool.h"
#include "probe/sensor/release.h"
#include "probe/tooling/turning_teeth.h"

namespace g31::probe {
namespace {

/// The random stream of the first tool probe; the next ones follow.
constexpr std::uint32_t kFirstToolProbeStream = 0x544F4F4CU;

/// The plate about its own middle.
ConvexShape plate_of(const ToolProbeSetup& setup) {
  const auto& [first, second, third] = setup.size_mm;
  if (setup.shape == ToolProbeShape::Cube) {
    return Box{0.5 * Point(first, second, third)};
  }
  ProbeSection round;
  const bool is_disc = setup.shape == ToolProbeShape::Disc;
  const double length = is_disc ? second : first;
  round.radius_bottom = round.radius_top = 0.5 * (is_disc ? first : second);
  round.z_bottom = -0.5 * length;
  round.z_top = 0.5 * length;
  if (!is_disc) {
    round.turn_S = turn_from_z(Point::UnitX());
  }
  return round;
}

/// What part of the way a shape needs at least to come behind the plane that bounds the target in
/// the direction n.
double earliest_touch(const PlacedShape& target, const PlacedShape& moving, const Point& way,
                      const Point& n) {
  const double closing = -n.dot(way);
  const double gap = n.dot(moving.furthest(-n) - target.furthest(n));
  return closing > 0.0 ? gap / closing : 0.0;
}

}  // namespace

ToolProbe::ToolProbe(const ToolProbeSetup& setup, std::shared_ptr<const ToolRack> rack,
                     std::uint64_t seed, std::uint32_t index, ToolProbePlace place)
    : setup_(setup),
      rack_(std::move(rack)),
      plate_(plate_of(setup)),
      R_MT_(parts::rotation_to_machine({Point::Zero(), setup.rotate_deg})),
      is_round_(setup.shape != ToolProbeShape::Cube),
      chips_(std::move(place.chips)),
      bed_(std::move(place.carrier)),
      seed_(seed),
      stream_(kFirstToolProbeStream + index),
      spindle_(seed) {
  G31_EXPECTS(rack_ != nullptr);
  for (const double size : setup.size_mm) {
    plate_reach_mm_ += size;  // more than half the diagonal
  }
  p_M_middle_ = setup.p_M_at - 0.5 * extent_mm(setup).z() * R_MT_.col(2);
  if (setup.shape == ToolProbeShape::Cube) {
    for (const int axis : {0, 1}) {
      normals_M_.emplace_back(R_MT_.col(axis));
      normals_M_.emplace_back(-R_MT_.col(axis));
    }
  }
  if (setup.shape != ToolProbeShape::Laser) {
    normals_M_.emplace_back(R_MT_.col(2));
    normals_M_.emplace_back(-R_MT_.col(2));
  }
}

bool ToolProbe::is_wired(int input) const {
  return input == machine::kAnyInput || input == setup_.input;
}

std::optional<machine::SensorState> ToolProbe::sensor_state(int input) const {
  if (!is_wired(input)) {
    return std::nullopt;
  }
  machine::SensorState state;
  state.in_place = held_ != nullptr;
  state.delay_s = setup_.delay_s;
  return state;
}

machine::ToolExtent ToolProbe::tool_extent() const {
  machine::ToolExtent extent;
  if (held_ != nullptr) {
    extent.p_T_tip = held_->shape.p_T_tip;
    extent.signal_mm = extent.body_mm = held_->shape.reach_mm;
  }
  return extent;
}

void ToolProbe::take(const machine::MachineEvent& event) {
  if (const auto* const change = std::get_if<machine::ToolChange>(&event)) {
    if (change->spindle == kToolSpindle) {
      held_ = rack_->called(change->tool);
      if (held_ != nullptr) {
        bed_.take_tool(held_->shape.p_T_tip, held_->shape.reach_mm);
      }
    }
  } else if (const auto* const turn = std::get_if<machine::SpindleTurn>(&event)) {
    spindle_.take(*turn, now_s_);
  }
}

const ToolProbe::Pieces& ToolProbe::pieces() const {
  return spindle_.turns() ? held_->shape.envelope : held_->shape.still;
}

PlacedShape ToolProbe::placed(const ConvexShape& piece, const machine::Waypoint& at) const {
  const Point& p_T_tip = held_->shape.p_T_tip;
  PlacedShape there{&piece, at.tilt.toRotationMatrix(), linear_axes(at.q_M)};
  if (at.tilt.coeffs() != Eigen::Quaterniond::Identity().coeffs()) {
    there.p += p_T_tip - there.turn * p_T_tip;
  }
  const bool is_turned = held_->setup.kind != ToolKind::Turning && !spindle_.turns();
  if (is_turned && spindle_.angle_deg(now_s_) != 0.0) {
    there.turn *=
        parts::rotation_to_machine({Point::Zero(), {0.0, 0.0, spindle_.angle_deg(now_s_)}});
  }
  return there;
}

std::optional<ToolProbe::Touch> ToolProbe::first_touch(const Pieces& pieces,
                                                       const machine::Waypoint& from,
                                                       const machine::Waypoint& to) const {
  const Point way = linear_axes(to.q_M) - linear_axes(from.q_M);
  if (pieces.empty() || way.isZero(0.0)) {
    return std::nullopt;
  }
  const auto turned_as_at = [&](double share) {
    machine::Waypoint turned = from;
    turned.tilt = turn_between(from.tilt, to.tilt, share);
    return turned;
  };
  auto touch = first_touch_as_turned(pieces, from, way);
  if (from.tilt.coeffs() == to.tilt.coeffs()) {
    return touch;
  }
  touch = touch ? touch : first_touch_as_turned(pieces, turned_as_at(1.0), way);
  // The tool turns on the way: it touches as it is turned there.  Pieces turn so little that each
  // step leaves the square of what was off before.
  constexpr int kSteps = 3;
  for (int i = 0; i < kSteps && touch; ++i) {
    const auto nearer = first_touch_as_turned(pieces, turned_as_at(touch->fraction), way);
    if (!nearer) {
      break;
    }
    touch = nearer;
  }
  return touch;
}

std::optional<ToolProbe::Touch> ToolProbe::first_touch_as_turned(const Pieces& pieces,
                                                                 const machine::Waypoint& from,
                                                                 const Point& way) const {
  PlacedShape there = placed(pieces.front(), from);
  const PlacedShape plate = target();
  std::optional<Touch> first;
  const auto take = [&](const ConvexShape& piece) {
    there.shape = &piece;
    if (first && earliest_touch(plate, there, way, first->n_M) >= first->fraction) {
      return;
    }
    const CastHit hit = convex_cast(plate, there, way);
    if (hit.status == CastStatus::Contact && (!first || hit.fraction < first->fraction)) {
      first = Touch{hit.fraction, hit.n, hit.p_point};
    }
  };
  // The one that goes ahead, for most of the others then cannot be first.
  const Point ahead = there.turn.transpose() * way;
  const auto& leading = *std::ranges::max_element(
      pieces, {}, [&](const ConvexShape& piece) { return furthest_of(piece, ahead).dot(ahead); });
  take(leading);
  for (const ConvexShape& piece : pieces) {
    if (&piece != &leading) {
      take(piece);
    }
  }
  return first;
}

std::optional<ToolProbe::Touch> ToolProbe::chip_touch(const machine::Waypoint& from,
                                                      const machine::Waypoint& to) const {
  if (chips_.empty()) {
    return std::nullopt;
  }
  const Point& p_T_tip = held_->shape.p_T_tip;
  const auto sections = round_sections_of(held_->shape.envelope, p_T_tip);
  const auto met =
      probe::first_touch(sections, chips_, way_of_tip(p_T_tip, machine::sweep_between(from, to)));
  return met ? std::optional(Touch{met->touch.fraction, met->touch.n_M, met->touch.p_M_point})
             : std::nullopt;
}

/// Chuck and shank break a beam of light as well; into a plate they must not go.
ToolProbe::Depth ToolProbe::depth_at(const machine::Waypoint& at) const {
  const Depth depth = depth_of(pieces(), at);
  if (setup_.shape != ToolProbeShape::Laser) {
    return depth;
  }
  const Depth of_holder = depth_of(held_->shape.bodies, at);
  return of_holder.mm > depth.mm ? of_holder : depth;
}

/// Of plate or chip, pushed so far that the signal is there.  A chip lies on the upper face: what
/// it hands on goes down.
std::optional<ToolProbe::Touch> ToolProbe::touch_at(const machine::Waypoint& at) const {
  if (const Depth depth = depth_at(at); depth.mm >= setup_.pre_travel_mm - kCastErrorMm) {
    return Touch{0.0, depth.n_M, target().furthest(depth.n_M)};
  }
  machine::Waypoint raised = at;
  raised.q_M.head<kLinearAxisCount>() += setup_.pre_travel_mm * R_MT_.col(2);
  return chip_touch(raised, raised);
}

bool ToolProbe::is_on(const machine::Waypoint& at) const {
  return held_ != nullptr && touch_at(at).has_value();
}

bool ToolProbe::signals_at(const machine::Waypoint& at, const machine::Listening& to) const {
  return is_wired(to.input) && held_ != nullptr && is_on(bed_.from_carrier(at));
}

double ToolProbe::trigger_shift(std::uint64_t event) const {
  return setup_.repeatability_mm > 0.0
             ? setup_.repeatability_mm * standard_normal({seed_, stream_}, event)
             : 0.0;
}

machine::Contact ToolProbe::contact_of(const Touch& touch) const {
  return {touch.p_M, touch.n_M, setup_.name};
}

std::optional<machine::SkipTrigger> ToolProbe::first_signal(const machine::Way& way,
                                                            const machine::Listening& to) {
  if (!is_wired(to.input)) {
    return std::nullopt;
  }
  const bool rises = to.edge == machine::SignalEdge::Rising;
  if (held_ == nullptr) {
    return rises ? std::nullopt : std::optional(machine::SkipTrigger{0.0, true, 0.0, std::nullopt});
  }
  const std::vector<machine::Waypoint> points = bed_.from_carrier(way);
  auto trigger = rises ? first_touch_along(points, to) : first_release_along(points);
  if (trigger && trigger->contact) {
    trigger->contact = bed_.for_part(*trigger->contact, way, trigger->fraction);
  }
  return trigger;
}

std::optional<machine::SkipTrigger> ToolProbe::first_touch_along(Points way,
                                                                 const machine::Listening& to) {
  const std::uint64_t event = triggers_asked_++;
  if (const auto touch = touch_at(way.front())) {
    return machine::SkipTrigger{0.0, true, 0.0, contact_of(*touch)};
  }
  double gone = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const machine::Sweep sweep = machine::sweep_between(way[i - 1], way[i]);
    const double piece = machine::distance_mm(sweep.q_M_from, sweep.q_M_to);
    if (const auto push = first_push(way[i - 1], way[i])) {
      const double at_outline = gone + push->touch.fraction * piece;
      double teeth = 0.0;
      if (push->of_plate && turns_teeth() && to.speed_mm_s > 0.0) {
        const double reached_s = to.time_s_at
                                     ? to.time_s_at(machine::fraction_after(way, at_outline))
                                     : at_outline / to.speed_mm_s;
        teeth = way_of_turning(push->touch, sweep, {reached_s, to.speed_mm_s});
      }
      const double distance = at_outline + push->to_signal_mm + teeth;
      if (!(distance <= machine::length_of(way))) {
        return std::nullopt;
      }
      machine::SkipTrigger trigger;
      trigger.contact = contact_of(push->touch);
      trigger.delay_s = setup_.delay_s + setup_.filter_s;
      trigger.fraction = machine::fraction_after(way, distance + trigger_shift(event));
      return trigger;
    }
    gone += piece;
  }
  return std::nullopt;
}

/// The first touch of plate or chip that the way goes on into; also one in which it begins, less
/// deep than the signal needs.
std::optional<ToolProbe::Push> ToolProbe::first_push(const machine::Waypoint& from,
                                                     const machine::Waypoint& to) const {
  const Point along = (linear_axes(to.q_M) - linear_axes(from.q_M)).normalized();
  if (const Depth depth = depth_at(from); depth.mm >= -kCastErrorMm) {
    const double inwards = -depth.n_M.dot(along);
    if (inwards <= 0.0) {
      return std::nullopt;  // it leaves, and comes back to nothing that is convex
    }
    const Touch here{0.0, depth.n_M, target().furthest(depth.n_M)};
    return Push{here, (setup_.pre_travel_mm - std::max(0.0, depth.mm)) / inwards, false};
  }
  const auto plate = first_touch(pieces(), from, to);
  const bool is_beam = setup_.shape == ToolProbeShape::Laser;
  const auto other = is_beam ? first_touch(held_->shape.bodies, from, to) : chip_touch(from, to);
  const bool is_other = other && (!plate || other->fraction < plate->fraction);
  const auto& touch = is_other ? other : plate;
  const double inwards = touch ? -touch->n_M.dot(along) : 0.0;
  return inwards > 0.0 ? std::optional(Push{*touch, setup_.pre_travel_mm / inwards, !is_other})
                       : std::nullopt;
}

bool ToolProbe::turns_teeth() const {
  return !held_->setup.teeth.empty() && held_->setup.kind != ToolKind::Turning &&
         spindle_.rate_deg_s() != 0.0;
}

double ToolProbe::way_of_turning(const Touch& touch, const machine::Sweep& sweep,
                                 const Approach& approach) const {
  const machine::Waypoint start = start_of(sweep);
  const PlacedShape tool = placed(held_->shape.envelope.front(), start);
  const Point along = linear_axes(sweep.q_M_to) - linear_axes(sweep.q_M_from);
  const Point p_M_tool = tool.p + touch.fraction * along;
  const auto in_tool = [&](const Point& p_M) {
    return Point(tool.turn.transpose() * (p_M - p_M_tool));
  };
  OutlineTouch outline;
  outline.n_T = tool.turn.transpose() * touch.n_M;
  outline.way_T = tool.turn.transpose() * along.normalized();
  outline.z_T_top = in_tool(target().furthest(tool.turn.col(2))).z();
  outline.p_T_face = in_tool(p_M_middle_).head<2>();
  outline.face_side = (tool.turn.transpose() * R_MT_.col(0)).head<2>();
  outline.is_face_round = setup_.shape == ToolProbeShape::Disc;
  outline.face_half = 0.5 * Eigen::Vector2d(setup_.size_mm[0], setup_.size_mm[1]);
  const Turning turning{spindle_.angle_deg(now_s_ + approach.reached_s), spindle_.rate_deg_s(),
                        approach.speed_mm_s};
  return way_to_first_tooth(held_->setup.teeth, held_->shape.profiles, outline, turning)
      .value_or(std::numeric_limits<double>::infinity());
}

std::optional<machine::SkipTrigger> ToolProbe::first_release_along(Points way) {
  const std::uint64_t event = triggers_asked_++;
  if (!is_on(way.front())) {
    return machine::SkipTrigger{0.0, true, 0.0, std::nullopt};
  }
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double piece = machine::distance_mm(way[i - 1].q_M, way[i].q_M);
    if (is_on(way[i])) {
      length += piece;
      continue;
    }
    const double off = share_to_release(way[i - 1], way[i],
                                        [this](const machine::Waypoint& at) { return is_on(at); });
    machine::SkipTrigger trigger;
    trigger.delay_s = setup_.delay_s;
    trigger.fraction = machine::fraction_after(way, length + off * piece + trigger_shift(event));
    return trigger;
  }
  return std::nullopt;
}

}  // namespace g31::probe

#include "probe/sensor/touch_probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "machine/base/contract.h"
#include "machine/base/random.h"
#include "machine/port/passed_time.h"
#include "parts/geometry/placement.h"
#include "probe/contact/smooth_normal.h"
#include "probe/sensor/pre_travel.h"
#include "probe/sensor/touch_events.h"

namespace g31::probe {
namespace {

/// The random stream of the trigger's repeatability; other models take other numbers.
constexpr std::uint32_t kRepeatabilityStream = 1;

/// A signal that could come earlier by no more than this is not looked for.
constexpr double kSoonMm = 1e-6;

}  // namespace

TouchProbe::TouchProbe(const ProbeSetup& setup, const std::vector<ProbedPart>& parts,
                       std::uint64_t seed)
    : TouchProbe(std::make_shared<const TouchableParts>(setup, parts), setup, seed) {}

TouchProbe::TouchProbe(std::shared_ptr<const TouchableParts> parts, const ProbeSetup& setup,
                       std::uint64_t seed)
    : setup_(setup), parts_(std::move(parts)), seed_(seed), spindle_(seed) {
  G31_EXPECTS(setup.trigger_delay_s >= 0.0);
  G31_EXPECTS(setup.repeatability_mm >= 0.0);
  if (setup.switching.on) {
    ready_at_s_.reset();
  }
  for (const ToolBody& body : bodies_of(setup)) {
    add(body);
  }
}

void TouchProbe::add(const ToolBody& body) {
  if (const auto* const ball = std::get_if<Ball>(&body.shape)) {
    balls_.push_back({ball->p_S_centre, ball->radius_mm, parts_->size_of(ball->radius_mm)});
  } else {
    (body.gives_way ? stem_ : rigid_).push_back(std::get<ProbeSection>(body.shape));
  }
}

bool TouchProbe::is_silent() const {
  return !is_in_place_ || !is_on() || setup_.state == ProbeState::Dead;
}

std::optional<machine::SensorState> TouchProbe::sensor_state(int input) const {
  if (!is_wired(input)) {
    return std::nullopt;
  }
  machine::SensorState state;
  state.in_place = is_in_place_;
  state.switched_on = is_on();
  const bool may_turn = setup_.switching.may_turn;
  // A sheet that leaves the probe's switching out may leave the tool's spindle out, too.
  const bool tool_stands = !spindle_.turns() || !setup_.switching.is_up_to_program();
  state.stands = may_turn || (tool_stands && turning_parts_.empty());
  state.angle_known = is_round() || (spindle_.turns() ? may_turn : spindle_.is_angle_known());
  state.ball_radius_mm = balls_.front().radius;
  state.delay_s = setup_.trigger_delay_s;
  state.calibrated_feed_mm_min = setup_.calibrated_feed_mm_min;
  state.works = setup_.state != ProbeState::Dead;
  return state;
}

bool TouchProbe::is_wired(int input) const {
  return input == machine::kAnyInput || setup_.input == machine::kAnyInput || input == setup_.input;
}

std::optional<machine::SkipTrigger> TouchProbe::first_signal(const machine::Way& way,
                                                             const machine::Listening& to) {
  if (!is_wired(to.input)) {
    return std::nullopt;
  }
  if (is_silent()) {
    return to.edge == machine::SignalEdge::Rising
               ? std::nullopt
               : std::optional(machine::SkipTrigger{0.0, true, 0.0, std::nullopt});
  }
  const std::vector<machine::Waypoint> chords =
      way.curve() != nullptr ? machine::points_of(way) : std::vector<machine::Waypoint>();
  const Points points = way.curve() != nullptr ? Points(chords) : way.points();
  return to.edge == machine::SignalEdge::Rising ? first_touch_along(points)
                                                : first_release_along(points);
}

std::optional<machine::SkipTrigger> TouchProbe::first_touch_along(Points way) {
  const std::uint64_t event = triggers_asked_++;
  std::optional<machine::SkipTrigger> first;
  for (const Tip& ball : balls_) {
    const auto signal = first_signal(ball, way, first ? first->fraction : 1.0);
    if (!signal) {
      continue;
    }
    machine::SkipTrigger trigger = trigger_of(signal->touch);
    trigger.on_at_start = signal->on_at_start;
    if (trigger.on_at_start) {
      return trigger;
    }
    trigger.delay_s = setup_.trigger_delay_s;
    trigger.fraction =
        machine::fraction_after(way_of(ball, way), signal->distance + trigger_shift(event));
    if (!first || trigger.fraction < first->fraction) {
      first = std::move(trigger);
    }
  }
  return first;
}

std::optional<TouchProbe::Signal> TouchProbe::first_signal(const Tip& ball, Points way,
                                                           double until) const {
  Search search{ball, 0.0, std::nullopt};
  for (std::size_t i = 1; i < way.size() && way[i - 1].fraction <= until; ++i) {
    if (!machine::differ(way[i - 1], way[i])) {
      continue;
    }
    look_on(search, machine::sweep_between(way[i - 1], way[i]));
    if (search.first && search.first->distance <= search.gone) {
      return search.first;
    }
  }
  return std::nullopt;
}

void TouchProbe::look_on(Search& search, const machine::Sweep& sweep) const {
  const BallWay way = way_of(search.ball, sweep);
  const auto pressed = look_on_planes(search, sweep, way);
  if (!pressed) {
    search.first.reset();  // it was of a plane behind the end of its surface
  } else if (way.length > 0.0) {
    settle(search, sweep, *pressed);
  }
}

std::optional<Pressed> TouchProbe::look_on_planes(Search& search, const machine::Sweep& sweep,
                                                  const BallWay& way) const {
  const double begin = search.gone;
  search.gone += way.length;
  std::optional<Pressed> met;
  PressedSurfaces surfaces = surfaces_on(search.ball, way);
  std::optional<Signal>& first = search.first;
  double until = first ? first->distance - begin : std::numeric_limits<double>::infinity();
  while (const auto surface = surfaces.next(until)) {
    met = met ? met : surface;
    if (first && first->touch.part == surface->part &&
        first->touch.hit.n_M.dot(surface->hit.n_M) >= PressedSurfaces::kToldCosine) {
      continue;  // what the signal comes from
    }
    const auto more = way_to_signal(*surface, way, sweep.tilt_from);
    const double at = surface->s + std::max(0.0, more.value_or(0.0));
    if (more && (at < until || !first)) {
      const bool on_at_start = *more < 0.0 && begin + surface->s == 0.0;
      first = Signal{{surface->hit, surface->part, &search.ball, way}, begin + at, on_at_start};
      until = at;
    }
    // From a free start no deflection is longer than the way since the first touch.
    if (surface->is_from_free && until - surface->s <= setup_.at_switch.pre_travel_mm + kSoonMm) {
      break;
    }
  }
  return met;
}

PressedSurfaces TouchProbe::surfaces_on(const Tip& ball, const BallWay& way) const {
  return {parts_->parts(), {ball.radius, ball.size}, way.p_M_from, way.p_M_to};
}

machine::SkipTrigger TouchProbe::trigger_of(const PartHit& touch) const {
  machine::SkipTrigger trigger;
  trigger.contact = contact_of(touch.hit, touch.part->name);
  trigger.contact->n_M_smooth = smooth_normal(*touch.part->mesh, touch.hit);
  trigger.signals = setup_.state == ProbeState::DoubleTrigger ? 2 : 1;
  return trigger;
}

double TouchProbe::trigger_shift(std::uint64_t event) const {
  return setup_.repeatability_mm > 0.0
             ? setup_.repeatability_mm * standard_normal({seed_, kRepeatabilityStream}, event)
             : 0.0;
}

void TouchProbe::take(const machine::MachineEvent& event) {
  std::visit([this](const auto& one) { note(one); }, event);
}

void TouchProbe::note(const machine::ToolChange& change) {
  if (change.spindle != kToolSpindle) {
    return;
  }
  const std::optional<int>& own = setup_.switching.tool;
  const std::vector<int>& others = setup_.switching.other_tools;
  is_in_place_ = own ? change.tool.number == *own
                     : std::ranges::find(others, change.tool.number) == others.end();
}

void TouchProbe::note(const machine::SpindleTurn& turn) {
  if (setup_.in_turret) {
    // No spindle turns the probe; those that hold parts should not, either.
    if (turn.spindle == kToolSpindle || turn.rotation == machine::Rotation::Stopped) {
      turning_parts_.erase(turn.spindle);
    } else {
      turning_parts_.insert(turn.spindle);
    }
    return;
  }
  spindle_.take(turn, now_s_);
  if (!spindle_.turns()) {
    R_MS_ = parts::rotation_to_machine({Point::Zero(), {0.0, 0.0, spindle_.angle_deg(now_s_)}});
  }
}

/// Whether it measures the same at every angle of the spindle.
bool TouchProbe::is_round() const {
  const auto is_on_axis = [](const Tip& ball) { return ball.p_S.head<2>().isZero(0.0); };
  const SwitchSetup& at_switch = setup_.at_switch;
  return std::ranges::all_of(balls_, is_on_axis) && at_switch.type == ProbeType::ThreeD &&
         (at_switch.seats == Seats::Even || at_switch.trigger_force_n == 0.0);
}

void TouchProbe::note(const machine::AuxiliaryCode& code) {
  const ProgramSwitch pressed{ProgramSwitch::Kind::Code, code.number};
  if (ready_at_s_ && pressed == setup_.switching.off) {
    ready_at_s_.reset();
  } else if (pressed == setup_.switching.on) {
    switch_on();
  }
}

/// An output that switches it on switches it off as well, unless something else does.
void TouchProbe::note(const machine::DigitalOutput& output) {
  const ProgramSwitch set{ProgramSwitch::Kind::Output, output.number};
  if (set == setup_.switching.on && output.is_on) {
    switch_on();
  } else if ((set == setup_.switching.off && output.is_on) ||
             (set == setup_.switching.on && !setup_.switching.off)) {
    ready_at_s_.reset();
  }
}

bool TouchProbe::is_on() const {
  return ready_at_s_ && machine::has_come(*ready_at_s_, now_s_);
}

void TouchProbe::switch_on() {
  if (!ready_at_s_) {
    ready_at_s_ = now_s_ + setup_.switching.start_up_s;
  }
}

machine::ToolExtent TouchProbe::tool_extent() const {
  machine::ToolExtent extent;
  if (!is_in_place_) {
    return extent;
  }
  const Point& p_S_tip = balls_.front().p_S;
  extent.p_T_tip = p_S_tip;
  for (const Tip& ball : balls_) {
    extent.signal_mm = std::max(extent.signal_mm, (R_MS_ * ball.p_S - p_S_tip).norm());
  }
  extent.body_mm = extent.signal_mm;
  const double off_tip = (R_MS_ * p_S_tip - p_S_tip).norm();
  for (const std::vector<ProbeSection>* sections : {&stem_, &rigid_}) {
    for (const ProbeSection& section : *sections) {
      extent.body_mm = std::max(extent.body_mm, off_tip + reach_of(section));
    }
  }
  return extent;
}

Point TouchProbe::centre_of(const Tip& ball, const machine::Waypoint& at) const {
  const Point& p_S_tip = balls_.front().p_S;  // what the machine takes as the tool tip
  const Point p_M_ball = R_MS_ * ball.p_S;
  if (at.tilt.coeffs() == Eigen::Quaterniond::Identity().coeffs()) {
    return linear_axes(at.q_M) + p_M_ball + at.lean_rad.cross(p_M_ball - p_S_tip);
  }
  const Point from_tip = at.tilt * (p_M_ball - p_S_tip);
  return linear_axes(at.q_M) + p_S_tip + from_tip + at.lean_rad.cross(from_tip);
}

TouchProbe::BallWay TouchProbe::way_of(const Tip& ball, const machine::Sweep& sweep) const {
  BallWay way{centre_of(ball, start_of(sweep)), centre_of(ball, end_of(sweep))};
  way.length = way.along().norm();
  return way;
}

std::vector<machine::Waypoint> TouchProbe::way_of(const Tip& ball, Points way) const {
  std::vector<machine::Waypoint> of_ball(way.begin(), way.end());
  for (machine::Waypoint& point : of_ball) {
    point.q_M.head<kLinearAxisCount>() = centre_of(ball, point);
  }
  return of_ball;
}

TouchProbe::PartHit TouchProbe::first_hit(const machine::Sweep& sweep, Question question,
                                          const Asked& asked) const {
  PartHit first;
  for (const Tip& ball : balls_) {
    const BallWay way = way_of(ball, sweep);
    for (const Part& part : parts_->parts()) {
      if (!asked.is_of(part)) {
        continue;
      }
      const PartHit met{(part.sweepers[ball.size].*question)(way.p_M_from, way.p_M_to), &part,
                        &ball, way};
      if (met.hit.status == SweepStatus::StartInContact) {
        return met;
      }
      if (met.hit.status == SweepStatus::Contact &&
          (first.part == nullptr || met.fraction() < first.fraction())) {
        first = met;
      }
    }
  }
  return first;
}

double TouchProbe::depth_of(const PartHit& touch) {
  const Point from_surface = touch.way.p_M_from - touch.hit.p_M_point;
  return touch.ball->radius - std::copysign(from_surface.norm(), from_surface.dot(touch.hit.n_M));
}

std::optional<double> TouchProbe::deflection_wanted(const Point& n_M,
                                                    const Eigen::Quaterniond& tilt) const {
  const Point n_S =
      setup_.turn_of_stylus.conjugate() * (R_MS_.transpose() * (tilt.conjugate() * n_M));
  return deflection_to_trigger(setup_.at_switch, n_S);
}

std::optional<double> TouchProbe::way_to_signal(const Pressed& surface, const BallWay& way,
                                                const Eigen::Quaterniond& tilt) const {
  const auto wanted = deflection_wanted(surface.hit.n_M, tilt);
  if (!wanted) {
    return std::nullopt;
  }
  if (surface.depth > *wanted + kTouchBandMm) {
    return *wanted - surface.depth;
  }
  const double missing = std::max(0.0, *wanted - surface.depth);
  if (surface.depth == 0.0 && missing == 0.0) {
    return 0.0;
  }
  const double inwards = way.length > 0.0 ? -surface.hit.n_M.dot(way.along() / way.length) : 0.0;
  return inwards > 0.0 ? std::optional(missing / inwards) : std::nullopt;
}

}  // namespace g31::probe

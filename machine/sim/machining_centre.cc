#include "machine/sim/machining_centre.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "machine/base/contract.h"
#include "machine/sim/arc_path.h"
#include "machine/sim/independent_path.h"
#include "machine/sim/motion_profile.h"
#include "machine/sim/skip_stop.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {
namespace {

void expect_legal(const LinearMove& move) {
  G31_EXPECTS(move.q_M_end.allFinite());
  G31_EXPECTS(move.traverse == Traverse::Rapid ||
              (move.feed_mm_min > 0.0 && std::isfinite(move.feed_mm_min)));
}

void expect_legal(const ArcMove& arc) {
  G31_EXPECTS(arc.q_M_end.allFinite());
  G31_EXPECTS(std::isfinite(arc.centre_first) && std::isfinite(arc.centre_second));
  G31_EXPECTS(arc.feed_mm_min > 0.0 && std::isfinite(arc.feed_mm_min));
}

bool is_fraction(double number) {
  return number >= 0.0 && number <= 1.0;
}

/// The fraction of the path reached some way (path units) after a fraction of it.
double fraction_after(double fraction, double way, const MotionProfile& profile) {
  // The sum may round to a hair below 1 where the way leads exactly to the end.
  const double to_go = profile.length() - fraction * profile.length();
  return way >= to_go ? 1.0 : fraction + way / profile.length();
}

AxisPositions resolutions(const MachineSetup& setup) {
  AxisPositions steps;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    steps[static_cast<Eigen::Index>(i)] = setup.axes[i].scale_resolution;
  }
  return steps;
}

}  // namespace

MachiningCentre::MachiningCentre(const MachineSetup& setup, Surroundings* surroundings)
    : limits_(setup),
      dynamics_(setup),
      stopping_(setup.stopping),
      stop_delay_s_(setup.stop_delay_s),
      wires_(setup.wires),
      surroundings_(surroundings),
      q_M_(setup.q_M_start),
      resolution_(resolutions(setup)),
      real_(setup) {
  G31_EXPECTS(q_M_.allFinite());
}

Result<AxisPositions, MachineFault> MachiningCentre::move(const LinearMove& move) {
  expect_legal(move);
  if (!limits_.contain(move.q_M_end)) {
    return soft_limit_fault(move.q_M_end);
  }
  const StraightPath path(q_M_, move.q_M_end, move.mm_per_degree);
  if (path.moves()) {
    const bool passes_on = move.traverse == Traverse::Feed && joins(move.ends);
    if (auto fault = passes_on ? pass_on(path, dynamics_.limits(path, move), move.ends)
                               : carry_out(path, move)) {
      return *std::move(fault);
    }
  }
  q_M_ = move.q_M_end;
  return q_M_;
}

Result<AxisPositions, MachineFault> MachiningCentre::move(const ArcMove& arc) {
  expect_legal(arc);
  const ArcPath path(q_M_, arc);
  if (path.length() < kFullCircleGapMm) {
    return move(LinearMove{arc.q_M_end, Traverse::Feed, arc.feed_mm_min, arc.ends});
  }
  if (const AxisBox circle = path.circle_bounds();
      !limits_.contain(circle.q_M_min) || !limits_.contain(circle.q_M_max)) {
    const AxisBox box = path.bounds();
    for (const AxisPositions& q_M_corner : {box.q_M_min, box.q_M_max}) {
      if (!limits_.contain(q_M_corner)) {
        return soft_limit_fault(q_M_corner);
      }
    }
  }
  if (auto fault = joins(arc.ends)
                       ? pass_on(path, dynamics_.limits(path, arc.feed_mm_min), arc.ends)
                       : carry_out(path, dynamics_.profile(path, arc.feed_mm_min),
                                   {Travel::Feed, arc.ends})) {
    return *std::move(fault);
  }
  q_M_ = arc.q_M_end;
  return q_M_;
}

Result<SkipOutcome, MachineFault> MachiningCentre::move_until_skip(const SkipMove& move) {
  expect_legal(move.way);
  if (!limits_.contain(move.way.q_M_end)) {
    return soft_limit_fault(move.way.q_M_end);
  }
  stand_still();
  tell_time();
  const StraightPath path(q_M_, move.way.q_M_end, move.way.mm_per_degree);
  SkipOutcome outcome = NoTouch{};
  if (path.moves()) {
    const Waypoint tip = real_.tip(q_M_);
    auto signalled = skip(path, dynamics_.profile(path, move.way), move);
    if (signalled) {
      outcome = *std::move(signalled);
    } else {
      q_M_ = move.way.q_M_end;
    }
    if (auto fault = damage(path.from(), tip)) {
      return *std::move(fault);
    }
  }
  return outcome;
}

bool MachiningCentre::skip_signal(int input) const {
  tell_time();
  return surroundings_ != nullptr && surroundings_->signals_at(real_.tip(q_M_), input);
}

std::optional<MachineFault> MachiningCentre::damage(const AxisPositions& q_M_from,
                                                    const Waypoint& tip_from) {
  if (surroundings_ == nullptr) {
    return std::nullopt;
  }
  const std::vector<Waypoint> taken = real_.way_taken(tip_from, q_M_from, q_M_);
  auto obstacle = surroundings_->first_obstacle(Way(taken), Travel::Skip);
  if (!obstacle) {
    return std::nullopt;
  }
  G31_EXPECTS(is_fraction(obstacle->fraction));
  const AxisPositions q_M_stop = q_M_from + obstacle->fraction * (q_M_ - q_M_from);
  real_.stop_at(q_M_stop);
  obstacle->contact = real_.in_machine(q_M_stop, obstacle->contact);
  return stop_at(*std::move(obstacle), q_M_stop, 0.0);
}

std::optional<SensorState> MachiningCentre::sensor_state(int input) const {
  tell_time();
  return surroundings_ != nullptr ? surroundings_->sensor_state(input) : std::nullopt;
}

std::optional<bool> MachiningCentre::digital_input(int number) const {
  const auto wire = std::ranges::find(wires_, number, &InputWire::number);
  if (wire == wires_.end()) {
    return std::nullopt;
  }
  if (wire->source == InputWire::Source::Signal) {
    return skip_signal(wire->measuring_input);
  }
  const auto state = sensor_state(wire->measuring_input);
  return state && state->is_ready();
}

std::optional<double> MachiningCentre::displacement(int input) const {
  const auto p_T =
      surroundings_ != nullptr ? surroundings_->displacement_sensor(input) : std::optional<Point>();
  if (!p_T) {
    return std::nullopt;
  }
  tell_time();
  return surroundings_->displacement(real_.place_of(*p_T, q_M_), input);
}

void MachiningCentre::change_tool(const ToolChange& change) {
  G31_EXPECTS(change.tool.number >= 0 && std::isfinite(change.tool.length_mm));
  tell(change);
}

void MachiningCentre::turn_spindle(const SpindleTurn& turn) {
  G31_EXPECTS(turn.speed_rev_min >= 0.0);
  G31_EXPECTS(!turn.angle_deg ||
              (std::isfinite(*turn.angle_deg) && turn.rotation == Rotation::Stopped));
  tell(turn);
}

void MachiningCentre::auxiliary_code(const AuxiliaryCode& code) {
  tell(code);
}

void MachiningCentre::digital_output(const DigitalOutput& output) {
  tell(output);
}

void MachiningCentre::tell_time() const {
  if (surroundings_ != nullptr) {
    told_s_ = std::max(told_s_, time_s());
    surroundings_->time_is(told_s_);
  }
}

void MachiningCentre::tell(const MachineEvent& event) {
  stand_still();
  if (surroundings_ == nullptr) {
    return;
  }
  tell_time();
  surroundings_->take(event);
  if (const auto p_T_tip = surroundings_->tool_extent().p_T_tip) {
    real_.take_tool(*p_T_tip);
  }
}

void MachiningCentre::dwell(double seconds) {
  G31_EXPECTS(seconds >= 0.0 && std::isfinite(seconds));
  stand_still();
  if (!real_.are_ideal()) {
    follow(real_.motion(StraightPath(q_M_, q_M_), {}), seconds);
    return;
  }
  if (sampler_) {
    show(StraightPath(q_M_, q_M_), {}, seconds);
  }
  clock_.advance(seconds);
}

void MachiningCentre::stand_still() {
  if (!continuous_.is_empty()) {
    pass(continuous_.finish());
  }
}

double MachiningCentre::time_s() const {
  if (continuous_.is_empty()) {
    return clock_.now_s();
  }
  Clock at_rest = clock_;
  at_rest.advance(continuous_.duration_s());
  return at_rest.now_s();
}

void MachiningCentre::trace(double period_s, TraceSink& sink) {
  continuous_.keep_ways();
  sampler_.emplace(period_s, sink);
}

MachineFault MachiningCentre::soft_limit_fault(const AxisPositions& q_M_end) const {
  return {FaultKind::SoftLimit, limits_.violation(q_M_end), q_M_, std::nullopt};
}

MachineFault MachiningCentre::stop_at(Obstacle obstacle, const AxisPositions& q_M_stop,
                                      double seconds) {
  clock_.advance(seconds);
  q_M_ = q_M_stop;
  return {FaultKind::Collision, std::move(obstacle.what), q_M_, std::move(obstacle.contact)};
}

std::optional<Obstacle> MachiningCentre::obstacle_on(const StraightPath& path, Travel travel) {
  const Waypoint ends[] = {{0.0, path.from()}, {1.0, path.to()}};
  return surroundings_->first_obstacle(Way(ends), travel);
}

template <typename Curve>
std::optional<Obstacle> MachiningCentre::obstacle_on(const Curve& path, Travel travel) {
  const CurvedWay curve{[&path](double fraction) { return path.at(fraction); }, path.bend(),
                        path.chord_count()};
  return surroundings_->first_obstacle(Way(curve), travel);
}

std::optional<MachineFault> MachiningCentre::carry_out(const StraightPath& path,
                                                       const LinearMove& move) {
  const Travel travel = move.traverse == Traverse::Rapid ? Travel::Rapid : Travel::Feed;
  const Carriage how{travel, move.ends};
  if (const auto independent = dynamics_.independent_path(path, move)) {
    return carry_out(*independent, PassingTime(*independent), how);
  }
  return carry_out(path, dynamics_.profile(path, move), how);
}

bool MachiningCentre::joins(BlockEnd ends) const {
  return real_.follow_at_once() && (ends == BlockEnd::PassOn || !continuous_.is_empty());
}

template <typename Path>
std::optional<MachineFault> MachiningCentre::pass_on(const Path& path, const PathLimits& limits,
                                                     BlockEnd ends) {
  const double length = path.length();
  double corner_speed = 0.0;
  if (!continuous_.is_empty()) {
    corner_speed = dynamics_.corner_speed(continuous_.along_end(), path.slope_at(0.0) / length);
  }
  continuous_.add({length, limits, corner_speed, path.slope_at(1.0) / length});
  if (continuous_.keeps_ways()) {
    continuous_.keep(path);
  }
  if (surroundings_ != nullptr) {
    if (auto obstacle = obstacle_in_passing(path, limits)) {
      const AxisPositions q_M_stop = path.at(obstacle->fraction);
      pass(continuous_.finish_at(obstacle->fraction * path.length()));
      real_.stop_at(q_M_stop);
      return stop_at(*std::move(obstacle), q_M_stop, 0.0);
    }
  }
  if (ends == BlockEnd::ExactStop) {
    stand_still();
  } else {
    pass(continuous_.release());
  }
  return std::nullopt;
}

/// The way of axes that follow at once is the same at every speed.  The fraction is of the path.
template <typename Path>
std::optional<Obstacle> MachiningCentre::obstacle_in_passing(const Path& path,
                                                             const PathLimits& limits) {
  if (real_.are_ideal()) {
    auto obstacle = obstacle_on(path, Travel::Feed);
    G31_EXPECTS(!obstacle || is_fraction(obstacle->fraction));
    return obstacle;
  }
  const MotionProfile alone(path.length(), limits.speed, limits.acceleration, limits.jerk);
  auto obstacle = real_.first_obstacle(real_.motion(path, alone.phases()),
                                       {Travel::Feed, BlockEnd::PassOn}, *surroundings_);
  if (!obstacle) {
    return std::nullopt;
  }
  obstacle->event.fraction = std::min(1.0, alone.distance_at(obstacle->time_s) / path.length());
  return std::move(obstacle->event);
}

void MachiningCentre::pass(const ContinuousPath::Passed& passed) {
  double start_s = clock_.now_s();
  for (const Travelled& way : passed.ways) {
    sampler_->show({start_s, way.duration_s, real_.motion(way.path, way.phases), real_.truth()},
                   resolution_);
    start_s += way.duration_s;
  }
  if (passed.seconds > 0.0) {
    clock_.advance(passed.seconds);
  }
}

template <typename Path, typename Profile>
std::optional<MachineFault> MachiningCentre::carry_out(const Path& path, const Profile& profile,
                                                       const Carriage& how) {
  stand_still();
  if (!real_.are_ideal()) {
    return carry_out_really(path, profile.phases(), how);
  }
  if (surroundings_ != nullptr) {
    auto obstacle = obstacle_on(path, how.travel);
    if (obstacle) {
      G31_EXPECTS(is_fraction(obstacle->fraction));
      const double seconds = profile.time_at(obstacle->fraction * profile.length());
      if (sampler_) {
        MotionPhases phases = profile.phases();
        phases.cut_at(seconds);
        show(path, phases, seconds);
      }
      const AxisPositions q_M_stop = path.at(obstacle->fraction);
      return stop_at(*std::move(obstacle), q_M_stop, seconds);
    }
  }
  if (sampler_) {
    show(path, profile.phases(), profile.duration_s());
  }
  clock_.advance(profile.duration_s());
  return std::nullopt;
}

std::optional<MachineFault> MachiningCentre::carry_out_really(const CommandedPath& path,
                                                              const MotionPhases& phases,
                                                              const Carriage& how) {
  const ServoMotion motion = real_.motion(path, phases);
  if (surroundings_ != nullptr) {
    auto obstacle = real_.first_obstacle(motion, how, *surroundings_);
    if (obstacle) {
      const AxisPositions q_M_stop = motion.encoder_at(obstacle->time_s);
      follow(motion, obstacle->time_s);
      real_.stop_at(q_M_stop);
      return stop_at(std::move(obstacle->event), q_M_stop, 0.0);
    }
  }
  follow(motion, real_.done_s(motion, how.ends));
  return std::nullopt;
}

std::optional<SkipOutcome> MachiningCentre::skip(const StraightPath& path,
                                                 const MotionProfile& profile,
                                                 const SkipMove& move) {
  if (!real_.are_ideal()) {
    return skip_really(path, profile, move);
  }
  if (surroundings_ != nullptr) {
    const Waypoint ends[] = {{0.0, path.from()}, {1.0, path.to()}};
    auto trigger = surroundings_->first_signal(Way(ends), {move.input, move.edge});
    if (trigger) {
      return stop_for(*std::move(trigger), path, profile, move.after);
    }
  }
  if (sampler_) {
    show(path, profile.phases(), profile.duration_s());
  }
  clock_.advance(profile.duration_s());
  return std::nullopt;
}

SkipOutcome MachiningCentre::stop_for(SkipTrigger trigger, const StraightPath& path,
                                      const MotionProfile& profile, AfterSignal after) {
  if (trigger.on_at_start) {
    return NoEdge{std::move(trigger.contact)};
  }
  G31_EXPECTS(is_fraction(trigger.fraction) && trigger.delay_s >= 0.0);
  const double fraction = trigger.fraction;
  const SkipDelays delays{trigger.delay_s, stop_delay_s_};
  const SkipStop stop = stop_after_contact(profile, fraction * profile.length(), delays, stopping_);
  const AxisPositions q_M_latched =
      in_steps(path.at(fraction_after(fraction, stop.latched_after, profile)), resolution_);
  if (after == AfterSignal::GoOn) {
    if (sampler_) {
      show(path, profile.phases(), profile.duration_s());
    }
    clock_.advance(profile.duration_s());
    q_M_ = path.to();
    return Touched{q_M_latched, q_M_, std::move(trigger.contact), trigger.signals};
  }
  if (sampler_) {
    const double latch_s = profile.time_at(fraction * profile.length()) + delays.latch_s;
    MotionPhases phases = profile.phases_braking_at(latch_s + delays.stop_s);
    if (stopping_ == Stopping::Ideal) {
      phases = profile.phases();
      phases.cut_at(latch_s);
    }
    show(path, phases, stop.duration_s);
  }
  clock_.advance(stop.duration_s);
  const AxisPositions q_M_stopped = path.at(fraction_after(fraction, stop.stopped_after, profile));
  q_M_ = q_M_stopped == path.to() ? q_M_stopped : in_steps(q_M_stopped, resolution_);
  return Touched{q_M_latched, q_M_, std::move(trigger.contact), trigger.signals};
}

std::optional<SkipOutcome> MachiningCentre::skip_really(const StraightPath& path,
                                                        const MotionProfile& profile,
                                                        const SkipMove& move) {
  const ServoMotion motion = real_.motion(path, profile.phases());
  if (surroundings_ != nullptr) {
    auto trigger = real_.first_signal(motion, {move.input, move.edge}, *surroundings_);
    if (trigger) {
      return stop_really(*std::move(trigger), path, profile, move.after);
    }
  }
  follow(motion, real_.done_s(motion, BlockEnd::ExactStop));
  return std::nullopt;
}

SkipOutcome MachiningCentre::stop_really(Timed<SkipTrigger> trigger, const StraightPath& path,
                                         const MotionProfile& profile, AfterSignal after) {
  if (trigger.event.on_at_start) {
    return NoEdge{std::move(trigger.event.contact)};
  }
  G31_EXPECTS(trigger.event.delay_s >= 0.0);
  const double latch_s = trigger.time_s + trigger.event.delay_s;
  const ServoMotion motion = real_.motion(
      path, after == AfterSignal::Stop ? profile.phases_braking_at(latch_s + stop_delay_s_)
                                       : profile.phases());
  const AxisPositions q_M_latched = motion.encoder_at(latch_s);
  if (after == AfterSignal::GoOn) {
    follow(motion, real_.done_s(motion, BlockEnd::ExactStop));
    q_M_ = path.to();
    return Touched{in_steps(q_M_latched, resolution_), q_M_, std::move(trigger.event.contact),
                   trigger.event.signals};
  }
  if (stopping_ == Stopping::Ideal) {
    follow(motion, latch_s);
    q_M_ = q_M_latched;
  } else {
    follow(motion, std::max(latch_s, real_.done_s(motion, BlockEnd::ExactStop)));
    q_M_ = motion.end();
  }
  q_M_ = q_M_ == path.to() ? q_M_ : in_steps(q_M_, resolution_);
  // What is left of the lag is gone: else the way back would begin by going on into the part.
  real_.stop_at(q_M_);
  return Touched{in_steps(q_M_latched, resolution_), q_M_, std::move(trigger.event.contact),
                 trigger.event.signals};
}

void MachiningCentre::show(const CommandedPath& path, const MotionPhases& phases,
                           double duration_s) {
  sampler_->show({clock_.now_s(), duration_s, real_.motion(path, phases), real_.truth()},
                 resolution_);
}

void MachiningCentre::follow(const ServoMotion& motion, double duration_s) {
  if (sampler_) {
    sampler_->show({clock_.now_s(), duration_s, motion, real_.truth()}, resolution_);
  }
  real_.follow(motion, duration_s);
  clock_.advance(duration_s);
}

}  // namespace g31::machine

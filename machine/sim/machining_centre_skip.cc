// Moves that listen to the skip signal.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "machine/base/contract.h"
#include "machine/sim/machining_centre.h"
#include "machine/sim/motion_profile.h"
#include "machine/sim/skip_stop.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {
namespace {

/// The fraction of the path reached some way (path units) after a fraction of it.
double fraction_after(double fraction, double way, const MotionProfile& profile) {
  // The sum may round to a hair below 1 where the way leads exactly to the end.
  const double to_go = profile.length() - fraction * profile.length();
  return way >= to_go ? 1.0 : fraction + way / profile.length();
}

}  // namespace

Result<SkipOutcome, MachineFault> MachiningCentre::move_until_skip(const SkipMove& move) {
  expect_legal(move.way);
  G31_EXPECTS(!move.further || (move.way.transform == nullptr && move.after == AfterSignal::Stop));
  if (!limits_.contain(move.way.q_M_end)) {
    return soft_limit_fault(move.way.q_M_end);
  }
  stand_still();
  if (late_) {
    return *take_late_fault();
  }
  followed_.reset();
  tell_time();
  if (const auto led = led_path(q_M_, move.way)) {
    return skip_led(*led, move);
  }
  const StraightPath path(q_M_, move.way.q_M_end, move.way.mm_per_degree);
  SkipOutcome outcome = NoTouch{};
  if (path.moves()) {
    const Waypoint tip = real_.tip(q_M_);
    if (move.further) {
      outcome = skip_for_both(path, move);
    } else if (auto signalled = skip(path, dynamics_.profile(path, move.way), move)) {
      outcome = *std::move(signalled);
    } else {
      q_M_ = move.way.q_M_end;
    }
    const auto went = [&from = path.from(), &to = q_M_](double fraction) {
      return fraction == 1.0 ? to : AxisPositions(from + fraction * (to - from));
    };
    if (auto fault = damage(went, tip)) {
      return *std::move(fault);
    }
  }
  return outcome;
}

Result<SkipOutcome, MachineFault> MachiningCentre::skip_led(const LedPath& path,
                                                            const SkipMove& move) {
  if (auto fault = fault_on(path)) {
    return *std::move(fault);
  }
  const Waypoint tip = real_.tip(q_M_);
  const PathLimits limits = dynamics_.limits(path, move.way);
  const MotionProfile profile(path.length(), limits.speed, limits.acceleration, limits.jerk);
  auto signalled = skip_really(path, profile, move);
  if (!signalled) {
    q_M_ = move.way.q_M_end;
  }
  // Rotary axes turn in proportion to the way.
  Eigen::Index turned = 0;
  const double whole = rotary_axes(path.to() - path.from()).cwiseAbs().maxCoeff(&turned);
  const double gone =
      std::abs(rotary_axes(q_M_)[turned] - rotary_axes(path.from())[turned]) / whole;
  const auto went = [&path, gone, &to = q_M_](double fraction) {
    return fraction == 1.0 ? to : path.at(std::min(1.0, fraction * gone));
  };
  if (auto fault = damage(went, tip)) {
    return *std::move(fault);
  }
  return signalled ? *std::move(signalled) : SkipOutcome(NoTouch{});
}

MaybeFault MachiningCentre::damage(const RealAxes::Encoders& went, const Waypoint& tip_from) {
  if (surroundings_ == nullptr) {
    return std::nullopt;
  }
  const std::vector<Waypoint> taken = real_.way_taken(tip_from, went);
  auto obstacle = surroundings_->first_obstacle(Way(taken), Travel::Skip);
  if (!obstacle) {
    return std::nullopt;
  }
  G31_EXPECTS(is_fraction(obstacle->fraction));
  const AxisPositions q_M_stop = went(obstacle->fraction);
  real_.stop_at(q_M_stop);
  obstacle->contact = real_.in_machine(q_M_stop, obstacle->contact);
  return stop_at(*std::move(obstacle), q_M_stop, 0.0);
}

std::optional<SkipOutcome> MachiningCentre::skip(const StraightPath& path,
                                                 const MotionProfile& profile,
                                                 const SkipMove& move) {
  if (!real_.are_ideal()) {
    return skip_really(path, profile, move);
  }
  if (auto trigger = first_signal(path, profile, listening_of(move, move.input, profile))) {
    return stop_for(*std::move(trigger), path, profile, move.after);
  }
  if (is_watched()) {
    show(path, profile.phases(), profile.duration_s());
  }
  clock_.advance(profile.duration_s());
  return std::nullopt;
}

std::optional<SkipTrigger> MachiningCentre::first_signal(const StraightPath& path,
                                                         const MotionProfile& profile,
                                                         Listening to) const {
  if (surroundings_ == nullptr) {
    return std::nullopt;
  }
  const Waypoint ends[] = {{0.0, path.from()}, {1.0, path.to()}};
  to.time_s_at = [&profile](double fraction) {
    return profile.time_at(std::min(1.0, fraction) * profile.length());
  };
  return surroundings_->first_signal(Way(ends), to);
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
    if (is_watched()) {
      show(path, profile.phases(), profile.duration_s());
    }
    clock_.advance(profile.duration_s());
    q_M_ = path.to();
    return Touched{q_M_latched, q_M_, std::move(trigger.contact), trigger.signals};
  }
  if (is_watched()) {
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

std::optional<SkipOutcome> MachiningCentre::skip_really(const CommandedPath& path,
                                                        const MotionProfile& profile,
                                                        const SkipMove& move) {
  const ServoMotion motion = real_.motion(path, profile.phases());
  if (surroundings_ != nullptr) {
    auto trigger =
        real_.first_signal(motion, listening_of(move, move.input, profile), *surroundings_);
    if (trigger) {
      return stop_really(*std::move(trigger), path, profile, move);
    }
  }
  follow(motion, real_.done_s(motion, BlockEnd::ExactStop));
  return std::nullopt;
}

SkipOutcome MachiningCentre::stop_really(Timed<SkipTrigger> trigger, const CommandedPath& path,
                                         const MotionProfile& profile, const SkipMove& move) {
  const AxisPositions& q_M_end = move.way.q_M_end;
  if (trigger.event.on_at_start) {
    return NoEdge{std::move(trigger.event.contact)};
  }
  G31_EXPECTS(trigger.event.delay_s >= 0.0);
  const double latch_s = trigger.time_s + trigger.event.delay_s;
  const ServoMotion motion = real_.motion(
      path, move.after == AfterSignal::Stop ? profile.phases_braking_at(latch_s + stop_delay_s_)
                                            : profile.phases());
  const AxisPositions q_M_latched = motion.encoder_at(latch_s);
  if (move.after == AfterSignal::GoOn) {
    follow(motion, real_.done_s(motion, BlockEnd::ExactStop));
    q_M_ = q_M_end;
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
  q_M_ = q_M_ == q_M_end ? q_M_ : in_steps(q_M_, resolution_);
  // What is left of the lag is gone: else the way back would begin by going on into the part.
  real_.stop_at(q_M_);
  return Touched{in_steps(q_M_latched, resolution_), q_M_, std::move(trigger.event.contact),
                 trigger.event.signals};
}

}  // namespace g31::machine

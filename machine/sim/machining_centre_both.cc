// Moves that listen to two sensors and end once both have given their signals.

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "machine/base/contract.h"
#include "machine/sim/machining_centre.h"
#include "machine/sim/motion_profile.h"
#include "machine/sim/skip_stop.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {
namespace {

/// The outcome of the later signal, which has ended the move, together with what was latched before
/// it.
SkipOutcome both_of(Touched later, FurtherTouch earlier, bool main_is_later) {
  FurtherTouch further{later.q_M_latched, later.contact};
  if (main_is_later) {
    std::swap(further, earlier);
  } else {
    later.q_M_latched = earlier.q_M_latched;
    later.contact = std::move(earlier.contact);
  }
  later.further = std::move(further);
  return later;
}

/// The control sees a signal when it has come, not the touch.  Infinite: it does not come
double time_of(const std::optional<Timed<SkipTrigger>>& signal) {
  return signal ? signal->time_s + signal->event.delay_s : std::numeric_limits<double>::infinity();
}

/// Where axes that follow at once stand when the signal of a trigger has come.
AxisPositions latched_ideally(const SkipTrigger& trigger, const StraightPath& path,
                              const MotionProfile& profile) {
  const SkipStop stop = stop_after_contact(profile, trigger.fraction * profile.length(),
                                           {trigger.delay_s, 0.0}, Stopping::Ideal);
  return path.at(std::min(1.0, trigger.fraction + stop.latched_after / profile.length()));
}

}  // namespace

void MachiningCentre::go_without_signal(const AxisPositions& q_M_end, const SkipMove& move) {
  const StraightPath path(q_M_, q_M_end, move.way.mm_per_degree);
  if (!path.moves()) {
    return;
  }
  const MotionProfile profile = dynamics_.profile(path, move.way);
  if (!real_.are_ideal()) {
    const ServoMotion motion = real_.motion(path, profile.phases());
    follow(motion, real_.done_s(motion, BlockEnd::ExactStop));
  } else {
    if (is_watched()) {
      show(path, profile.phases(), profile.duration_s());
    }
    clock_.advance(profile.duration_s());
  }
  q_M_ = path.to();
}

SkipOutcome MachiningCentre::skip_for_both(const StraightPath& path, const SkipMove& move) {
  const MotionProfile profile = dynamics_.profile(path, move.way);
  const ServoMotion motion = real_.motion(path, profile.phases());
  std::array<std::optional<Timed<SkipTrigger>>, 2> signals;
  for (std::size_t i = 0; surroundings_ != nullptr && i < signals.size(); ++i) {
    const Listening to = listening_of(move, i == 0 ? move.input : move.further->input, profile);
    if (!real_.are_ideal()) {
      signals.at(i) = real_.first_signal(motion, to, *surroundings_);
      continue;
    }
    if (auto trigger = first_signal(path, profile, to)) {
      const double time_s = profile.time_at(trigger->fraction * profile.length());
      signals.at(i) = Timed<SkipTrigger>{*std::move(trigger), time_s};
    }
  }
  return stop_for_both(std::move(signals), path, move);
}

SkipOutcome MachiningCentre::stop_for_both(std::array<std::optional<Timed<SkipTrigger>>, 2> signals,
                                           const StraightPath& path, const SkipMove& move) {
  if (move.further->comes_second && signals[1] &&
      (signals[1]->event.on_at_start || time_of(signals[1]) <= time_of(signals[0]))) {
    signals[1].reset();
  }
  for (auto& signal : signals) {
    if (signal && signal->event.on_at_start) {
      return NoEdge{std::move(signal->event.contact)};
    }
  }
  const bool main_is_later = time_of(signals[0]) > time_of(signals[1]);
  auto& [first, last] = signals;
  if (main_is_later) {
    std::swap(first, last);
  }
  if (!first) {
    go_without_signal(path.to(), move);
    return NoTouch{};
  }
  const MotionProfile profile = dynamics_.profile(path, move.way);
  const double first_way = profile.distance_at(time_of(first));
  const double waits_until = first_way + move.further->within_mm;
  const AxisPositions q_M_latched =
      real_.are_ideal() ? latched_ideally(first->event, path, profile)
                        : real_.motion(path, profile.phases()).encoder_at(time_of(first));
  FurtherTouch earlier{in_steps(q_M_latched, resolution_), std::move(first->event.contact)};
  if (!last || profile.distance_at(time_of(last)) > waits_until) {
    const bool goes_on = waits_until >= profile.length();
    go_without_signal(goes_on ? path.to() : path.at(waits_until / profile.length()), move);
    return NoTouch{NoTouch::Alone{!main_is_later, std::move(earlier)}};
  }
  SkipOutcome outcome = real_.are_ideal()
                            ? stop_for(std::move(last->event), path, profile, AfterSignal::Stop)
                            : stop_really(*std::move(last), path, profile, move);
  return both_of(std::get<Touched>(std::move(outcome)), std::move(earlier), main_is_later);
}

}  // namespace g31::machine

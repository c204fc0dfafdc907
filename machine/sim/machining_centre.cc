#include "machine/sim/machining_centre.h"

#include <cmath>
#include <utility>

#include "machine/base/contract.h"
#include "machine/sim/arc_path.h"
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

}  // namespace

MachiningCentre::MachiningCentre(const MachineSetup& setup, Surroundings* surroundings)
    : limits_(setup),
      dynamics_(setup),
      stopping_(setup.stopping),
      surroundings_(surroundings),
      q_M_(setup.q_M_start) {
  G31_EXPECTS(q_M_.allFinite());
}

Result<AxisPositions, MachineFault> MachiningCentre::move(const LinearMove& move) {
  expect_legal(move);
  if (!limits_.contain(move.q_M_end)) {
    return soft_limit_fault(move.q_M_end);
  }
  const StraightPath path(q_M_, move.q_M_end);
  if (path.moves()) {
    const MotionProfile profile = dynamics_.profile(path, move);
    if (surroundings_ != nullptr) {
      auto obstacle = surroundings_->first_collision({path.from(), path.to()});
      if (obstacle) {
        G31_EXPECTS(is_fraction(obstacle->fraction));
        const AxisPositions q_M_stop = path.at(obstacle->fraction);
        const double seconds = profile.time_at(obstacle->fraction * profile.length());
        return stop_at(*std::move(obstacle), q_M_stop, seconds);
      }
    }
    clock_.advance(profile.duration_s());
  }
  q_M_ = move.q_M_end;
  return q_M_;
}

Result<AxisPositions, MachineFault> MachiningCentre::move(const ArcMove& arc) {
  expect_legal(arc);
  const ArcPath path(q_M_, arc);
  if (path.length() < kFullCircleGapMm) {
    return move(LinearMove{arc.q_M_end, Traverse::Feed, arc.feed_mm_min});
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
  const MotionProfile profile = dynamics_.profile(path, arc.feed_mm_min);
  if (surroundings_ != nullptr) {
    auto fault = collide_on(path, profile);
    if (fault) {
      return *std::move(fault);
    }
  }
  clock_.advance(profile.duration_s());
  q_M_ = arc.q_M_end;
  return q_M_;
}

Result<SkipOutcome, MachineFault> MachiningCentre::move_until_skip(const LinearMove& move) {
  expect_legal(move);
  if (!limits_.contain(move.q_M_end)) {
    return soft_limit_fault(move.q_M_end);
  }
  const StraightPath path(q_M_, move.q_M_end);
  if (path.moves()) {
    const MotionProfile profile = dynamics_.profile(path, move);
    if (surroundings_ != nullptr) {
      auto trigger = surroundings_->first_trigger({path.from(), path.to()});
      if (trigger) {
        return stop_for(*std::move(trigger), path, profile);
      }
    }
    clock_.advance(profile.duration_s());
  }
  q_M_ = move.q_M_end;
  return SkipOutcome(NoTouch{});
}

void MachiningCentre::dwell(double seconds) {
  G31_EXPECTS(seconds >= 0.0 && std::isfinite(seconds));
  clock_.advance(seconds);
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

std::optional<MachineFault> MachiningCentre::collide_on(const ArcPath& path,
                                                        const MotionProfile& profile) {
  auto obstacle = surroundings_->first_collision_on_curve(
      {[&path](double fraction) { return path.at(fraction); }, path.bend(), path.chord_count()});
  if (!obstacle) {
    return std::nullopt;
  }
  G31_EXPECTS(is_fraction(obstacle->fraction));
  const AxisPositions q_M_stop = path.at(obstacle->fraction);
  const double travelled = obstacle->fraction * profile.length();
  return stop_at(*std::move(obstacle), q_M_stop, profile.time_at(travelled));
}

SkipOutcome MachiningCentre::stop_for(SkipTrigger trigger, const StraightPath& path,
                                      const MotionProfile& profile) {
  if (trigger.on_at_start) {
    return AlreadyTouching{std::move(trigger.contact)};
  }
  G31_EXPECTS(is_fraction(trigger.fraction));
  const double fraction = trigger.fraction;
  const SkipStop stop =
      stop_after_contact(profile, fraction * profile.length(), trigger.delay_s, stopping_);
  clock_.advance(stop.duration_s);
  const AxisPositions q_M_latched = path.at(fraction_after(fraction, stop.latched_after, profile));
  q_M_ = path.at(fraction_after(fraction, stop.stopped_after, profile));
  return Touched{q_M_latched, q_M_, std::move(trigger.contact)};
}

}  // namespace g31::machine

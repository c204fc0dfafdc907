#include "interpreter/dialects/fanuc/execute/feed.h"

#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/spindle.h"

namespace g31::fanuc {
namespace {

/// The least strokes in a minute (FANUC operator's manual B-62764EN, 5; M700V programming manual,
/// 7.5).
constexpr double kLeastInverseTime = 0.001;

/// mm/min, below every increment of F: what is less comes of a variable, and is no feed.
constexpr double kLeastFeed = 1e-6;

Result<double, Failure> no_less(double feed_mm_min) {
  return feed_mm_min >= kLeastFeed ? Result<double, Failure>(feed_mm_min)
                                   : block_failure(AlarmId::NoFeed);
}

bool is_tapping(const Control& control) {
  const auto& group = control.modal.group;
  return group[Group::CuttingMode].whole == 63 || group[Group::CannedCycle].whole == 74 ||
         group[Group::CannedCycle].whole == 84;
}

/// As the machine counts the way.
double length_of(const FeedWay& way) {
  const AxisPositions d = way.q_end - way.q_from;
  const double linear = linear_axes(d).norm();
  const double rotary = rotary_axes(d).norm();
  if (way.mm_per_degree == 0.0) {
    return linear > 0.0 ? linear : rotary;
  }
  return std::hypot(linear, way.mm_per_degree * rotary);
}

/// The same of an arc: along its plane, as the machine counts that of a helix, too.
double length_of_arc(const path::PlaneWay& way) {
  const double from = (way.from - way.arc->centre).norm();
  const double to = (way.to - way.arc->centre).norm();
  return std::hypot((from + to) / 2.0 * path::sweep_rad(way), to - from);
}

/// What F of G93 is multiplied by, mm.
double inverse_time_length(const Control& control, const FeedWay& way) {
  if (!way.arc) {
    return length_of(way);
  }
  const path::PlaneWay flat = flat_way(control, way);
  return control.profile.inverse_time.of_arc == InverseTime::OfArc::Radius
             ? (flat.from - flat.arc->centre).norm()
             : length_of_arc(flat);
}

/// Where the way of the present block begins, in path coordinates: a block that waits for others
/// ends where it is programmed to.
AxisPositions start_of_way(const Control& control) {
  const CutterStage& cutter = control.cutter;
  return cutter.corners.holds() || cutter.compensation.engaged()
             ? control.coordinates.to_path(control.coordinates.programmed())
             : control.path_position();
}

Result<double, Failure> inverse_time_feed(const Control& control, const FeedWay& way) {
  const double strokes = control.modal.feed;
  if (!control.has_own_feed || strokes < kLeastInverseTime) {
    return block_failure(AlarmId::NoInverseTimeFeed);
  }
  const double most = control.profile.inverse_time.most;
  if (strokes > most) {
    return block_failure(AlarmId::TooManyDigits, fmt::format("F of G93 goes up to {}", most));
  }
  const double length = inverse_time_length(control, way);
  // A block without a way takes no time: any feed will do.
  return length > 0.0 ? strokes * length : strokes;
}

Failure no_speed() {
  return block_failure(AlarmId::NoFeed,
                       "G95 needs a spindle speed S, at the centre of G96 its limit G92 S, too");
}

}  // namespace

void tell_standing_spindle(Control& control) {
  if (control.rotation == machine::Rotation::Stopped && !control.builder_may_turn &&
      !is_tapping(control) && control.feed_switches.dry_run_mm_min <= 0.0) {
    control.warn(source::DiagnosticId::FeedWithoutTurning, control.block);
  }
}

namespace {

/// G95.  @param turn_min  minutes of a turn
Result<double, Failure> feed_by_turns(Control& control, double turn_min) {
  if (control.modal.feed <= 0.0) {
    return block_failure(AlarmId::NoFeed);
  }
  tell_standing_spindle(control);
  return turn_min > 0.0 && std::isfinite(turn_min)
             ? no_less(control.to_mm(control.modal.feed) / turn_min)
             : no_speed();
}

}  // namespace

double mm_per_degree(const Control& control) {
  return control.coordinates.tip_system() != TipSystem::None ? 0.0 : control.scale.mm_per_unit();
}

path::PlaneWay flat_way(const Control& control, const FeedWay& way) {
  const path::OffsetPlane plane = offset_plane(control);
  return {plane.of(way.q_from), plane.of(way.q_end), way.arc};
}

FeedWay straight_way(const Control& control, const AxisPositions& q_B_end) {
  return {start_of_way(control), q_B_end, mm_per_degree(control)};
}

FeedWay axes_way(const Control& control, const AxisPositions& q_M_end) {
  return {control.port.position(), q_M_end, mm_per_degree(control)};
}

Result<double, Failure> feed_along(Control& control, const FeedWay& way) {
  return control.modal.inverse_time() ? inverse_time_feed(control, way)
                                      : feed_by_turns(control, mean_turn(control, way));
}

Result<double, Failure> feed_in_force(Control& control) {
  if (control.modal.inverse_time()) {
    return block_failure(AlarmId::NotInInverseTime, "this block takes F as a feed");
  }
  if (control.modal.feed <= 0.0) {
    return block_failure(AlarmId::NoFeed);
  }
  const double feed = control.to_mm(control.modal.feed);
  if (!control.modal.per_revolution()) {
    return no_less(feed);
  }
  tell_standing_spindle(control);
  const double speed = spindle_speed(control);
  return speed > 0.0 && std::isfinite(speed) ? no_less(feed * speed) : no_speed();
}

double switched_feed(const Control& control, double feed_mm_min) {
  constexpr int kOverrideOff = 1 << 1;  // of #3004
  const bool taps = is_tapping(control);
  const runtime::FeedSwitches& switches = control.feed_switches;
  if (switches.dry_run_mm_min > 0.0 && !taps) {
    return switches.dry_run_mm_min;
  }
  const bool as_programmed =
      taps || control.modal.cuts_thread() || (control.override_control & kOverrideOff) != 0;
  return as_programmed ? feed_mm_min : feed_mm_min * switches.override_percent / 100.0;
}

/// A hole is many moves and has one F; what G31, G37 and G96 do is the control's to say.
MaybeFailure refuse_in_inverse_time(const Control& control, const Codes& codes) {
  if (in_canned_cycle(control)) {
    return block_failure(AlarmId::NotInInverseTime, "a canned cycle under G93");
  }
  if (!control.profile.inverse_time.stands_alone) {
    return std::nullopt;
  }
  if (control.modal.surface_speed() || control.modal.cuts_thread()) {
    return block_failure(AlarmId::NotInInverseTime, "G96 or G33 under G93");
  }
  const bool measures =
      codes.one_shot != nullptr &&
      (codes.one_shot->action == GAction::Skip || codes.one_shot->action == GAction::MeasureTool);
  return measures ? MaybeFailure(
                        block_failure(AlarmId::NotInInverseTime,
                                      fmt::format("{} under G93", to_text(codes.one_shot->number))))
                  : std::nullopt;
}

}  // namespace g31::fanuc

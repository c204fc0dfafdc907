// G33.  Sources: FANUC operator's manual B-63534EN, thread cutting (G33): F is the lead along the
// long axis, in steps of 0.01 mm or 0.0001 inch without a point, up to 500 mm or 9.9999 inch, and
// the feed override is fixed at 100 %; M700V programming manual, constant lead thread cutting, P93.

#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/feed.h"
#include "interpreter/dialects/fanuc/execute/spindle.h"

namespace g31::fanuc {
namespace {

constexpr double kLeastLead = 1e-6;  // of either unit
constexpr double kLongestLeadMm = 500.0;
constexpr double kLongestLeadInch = 9.9999;

/// Minutes of a turn over the way; 0: nothing turns.
double turn_over(const Control& control, const FeedWay& way) {
  if (control.modal.surface_speed()) {
    return mean_turn(control, way);
  }
  const double speed = spindle_speed(control);
  return speed > 0.0 ? 1.0 / speed : 0.0;
}

/// The feed of the way whose longest axis goes the lead in a turn.
Result<double, Failure> thread_feed(Control& control, const FeedWay& way) {
  const double lead = control.modal.feed;
  const bool is_inch = control.scale.unit == LengthUnit::Inch;
  const double most = is_inch ? kLongestLeadInch : kLongestLeadMm;
  if (lead < kLeastLead || lead > most) {
    return block_failure(AlarmId::IllegalLead, fmt::format("the lead F is {}", lead));
  }
  const double turn = turn_over(control, way);
  if (turn <= 0.0) {
    return block_failure(AlarmId::IllegalLead, "G33 needs a spindle speed S");
  }
  tell_standing_spindle(control);
  const Point d = linear_axes(way.q_end) - linear_axes(way.q_from);
  const double longest = d.cwiseAbs().maxCoeff();
  const double along_axis = control.to_mm(lead) / turn;
  return longest > 0.0 ? along_axis * (d.norm() / longest) : along_axis;
}

}  // namespace

/// A straight move that turns of the spindle lead; where the spindle stands when it begins is not
/// waited for.
MaybeFailure execute_thread(Control& control, const NcBlock& block) {
  constexpr int kLine = 1;  // as documents name it
  const AxisPositions q_L_end = programmed_end(control, block);
  const AxisPositions q_B_end = control.coordinates.to_path(q_L_end);
  const auto feed = thread_feed(control, straight_way(control, q_B_end));
  if (!feed) {
    return feed.error();
  }
  if (auto failure = line_to(control, q_B_end, kLine, feed.value())) {
    return failure;
  }
  control.coordinates.arrived_at_programmed(q_L_end);
  return std::nullopt;
}

}  // namespace g31::fanuc

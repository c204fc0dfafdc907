#pragma once

#include <optional>

#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/state/failure.h"
#include "interpreter/path/path_block.h"

namespace g31::fanuc {

struct Codes;

/// The way that a feed is for.
struct FeedWay {
  AxisPositions q_from;  ///< path coordinates; of a move of the axes themselves (G53) theirs
  AxisPositions q_end;
  double mm_per_degree = 0.0;              ///< of a straight way: see machine::LinearMove
  std::optional<path::ArcShape> arc = {};  ///< in the plane in force
};

/// A way as seen in the plane in force.
path::PlaneWay flat_way(const Control& control, const FeedWay& way);

/// The straight way of a block to a place in path coordinates.
FeedWay straight_way(const Control& control, const AxisPositions& q_B_end);
/// That of the axes to a place of the machine.
FeedWay axes_way(const Control& control, const AxisPositions& q_M_end);

/// What a degree counts for in the length of a straight way, mm; 0 where the feed is that of the
/// tip.
double mm_per_degree(const Control& control);

/// The feed in mm/min in force, or why there is none; G95 takes the spindle speed S along (MB-314),
/// and it is told where the spindle stands.
/// Not under G93, whose F means nothing without a way.
Result<double, Failure> feed_in_force(Control& control);

/// mm/min of a feed that depends on its way: under G93, and under G95 with G96 the mean, so that
/// its time is right.
Result<double, Failure> feed_along(Control& control, const FeedWay& way);

/// The feed of a block, mm/min.  @param way  makes its FeedWay; not asked where it does not matter
template <typename MakeWay>
Result<double, Failure> feed_over(Control& control, MakeWay way) {
  return control.modal.feed_depends_on_way() ? feed_along(control, way()) : feed_in_force(control);
}

/// Tells of a feed per revolution or a lead while the spindle stands.  Tapping turns the spindle
/// itself, and what codes of the builder's do is not known.
void tell_standing_spindle(Control& control);

/// A programmed feed as dry run and feed override change it, mm/min (MB-128, MB-268).
double switched_feed(const Control& control, double feed_mm_min);

/// What has no place under G93.
MaybeFailure refuse_in_inverse_time(const Control& control, const Codes& codes);

}  // namespace g31::fanuc

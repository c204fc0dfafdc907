#pragma once

#include <array>
#include <vector>

#include "probe/metrology/circle_model.h"

namespace g31::metrology {

/// How far behind the reversal of an axis the model says nothing of the path, rad.
using ReversalWindows = std::array<double, 2>;

/// Where a sample stands within a turn.
struct PlaceOnTurn {
  bool is_near_end = false;  ///< the axes start or stop there
  int axis = 0;              ///< the axis that reversed last
  double since = 0.0;        ///< angle since then, rad
  bool is_before = false;    ///< within 2 degrees of the next reversal, which is the other axis'
};

/// @param way   angle from the first sample of the turn, rad
/// @param angle  about the centre, rad
PlaceOnTurn place_on_turn(const CircleTurn& turn, double way, double angle);

/// Whether the ends of turns are fitted, where the axes start or stop.
enum class Ends { LeftOut, Fitted };

/// The samples that the model describes.
std::vector<FittedRange> described_ranges(const PlaneSamples& samples,
                                          const std::vector<CircleTurn>& turns,
                                          const Eigen::Vector2d& centre,
                                          const ReversalWindows& windows, Ends ends);

/// Whether the model describes the path at such a place away from the ends.
bool is_described(const PlaceOnTurn& place, const ReversalWindows& windows);

/// Windows for a fit: 10 degrees, half a millimetre of the axis' way and the backlash, and on
/// as long as residuals of the fit are significant there; 40 degrees at most.
ReversalWindows reversal_windows(const PlaneSamples& samples, const std::vector<CircleTurn>& turns,
                                 const CircleFit& fit);

/// The same without a fit.
ReversalWindows first_windows(double radius);

/// The largest residual outwards at the reversals of each axis, mm; nothing where none was recorded
/// away from the ends.
std::array<std::optional<double>, 2> reversal_spikes(const PlaneSamples& samples,
                                                     const std::vector<CircleTurn>& turns,
                                                     const CircleFit& fit,
                                                     const ReversalWindows& windows);

}  // namespace g31::metrology

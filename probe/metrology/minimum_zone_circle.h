#pragma once

#include <optional>
#include <span>

#include "probe/metrology/circle_turns.h"
#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// The smallest distance, mm, of two circles about one centre that hold all samples of some turns
/// between them.
///
/// Repeated minimax fits of the linearised distances over those samples that touch the zone;
/// distances are exact.  Accuracy: 1e-9 mm for paths within a hundredth of the radius of the
/// circle.
/// @param near  a circle that the turns run along
/// @return nullopt: the samples do not determine a centre
std::optional<double> minimum_zone_of(const PlaneSamples& samples,
                                      std::span<const CircleTurn> turns, const Circle& near);

}  // namespace g31::metrology

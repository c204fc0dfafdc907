#pragma once

#include <vector>

#include "tools/review/review.h"
#include "tools/session/world.h"

namespace g31::review {

/// The boxes of the parts, which are those of the job and then the plates of its tool probes.
std::vector<PlacedPart> placed_parts(const std::vector<probe::ProbedPart>& parts);

/// Where the centre of the ball comes, by the travel of X, Y and Z; endless where rotary axes turn
/// tool and part against each other.
Box reach_of(const setup::Job& job);

/// Parts with one name, parts in one place, parts out of reach or of a size that no workpiece has.
void judge_places(const setup::Job& job, const std::vector<PlacedPart>& placed, const Box& reach,
                  std::vector<source::Diagnostic>& findings);

}  // namespace g31::review

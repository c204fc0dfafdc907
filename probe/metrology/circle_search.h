#pragma once

#include <optional>

#include "probe/metrology/plane_samples.h"

namespace g31::metrology {

/// The circle that most of a path runs along, whatever else the record holds (ways to it and from
/// it, standstill, single wild samples); nullopt where less than a quarter of the way lies on one.
///
/// Accuracy: good enough to tell what belongs to the circle, about the errors of the path itself.
/// The same samples give the same circle.
std::optional<Circle> search_circle(const PlaneSamples& samples);

}  // namespace g31::metrology

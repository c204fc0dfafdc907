#pragma once

#include <functional>
#include <optional>
#include <string>

#include "parts/features/feature.h"
#include "probe/planning/inspection_plan.h"

namespace g31::probe {

/// Murase's distances, mm.
struct PlanningDistances {
  double approach = 3.0;     ///< from the ball to the face before a touch sideways
  double approach_z = 10.0;  ///< and before one downwards
  double depth = 5.0;        ///< of a touch on a wall below its upper edge
  double beside = 3.0;       ///< of a touch on the upper face from the edge
};

struct PlanningOptions {
  double ball_radius_mm = 3.0;    ///< > 0
  double surface_error_mm = 0.0;  ///< >= 0: how far facets of round walls may be off
  PlanningDistances distances;
  std::optional<Tolerance> tolerance;  ///< of every measure
};

/// Why a probe does not get to a point, or does not touch it there; nothing: it does.
/// @param surface_error_mm  what facets may be off there
using IsUnreachable =
    std::function<std::optional<std::string>(const PlannedPoint&, double surface_error_mm)>;

/// What of each feature is measured, by its kind (Murase): sizes in X, Y and Z, as far as two faces
/// bound them, and the places of facing walls.  A point that the probe does not reach is moved
/// along its face, and the reason noted; where none is reached, the size is left out, with the
/// reason of the first place.
/// @param product_P  the box of the product
InspectionPlan plan_inspection(const parts::RecognisedPart& part, const parts::Box& product_P,
                               const PlanningOptions& options, const IsUnreachable& unreachable);

}  // namespace g31::probe

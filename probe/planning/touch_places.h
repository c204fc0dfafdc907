#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parts/features/feature.h"
#include "probe/planning/inspection_plan.h"
#include "probe/planning/plan_inspection.h"

namespace g31::probe {

/// Where a face may be touched: first where the method wants it, then along the face, near places
/// before far ones.
struct TouchPlaces {
  std::vector<PlannedPoint> points;
  std::string why_none;  ///< what is too small for the ball, where there are none
};

/// What the places of one part are made from.
struct PlacedOn {
  const parts::Feature& feature;
  parts::Box product_P;
  double ball_radius_mm;
  PlanningDistances distances;
};

/// On a wall, at the middle across and a depth below the upper edge.  Of a round wall all places
/// are at the middle across.  Walls of a standing feature are touched from outside.
TouchPlaces wall_places(const PlacedOn& on, parts::Side side);

/// On the outer face of the product at an open side, a depth below the floor.
TouchPlaces outer_places(const PlacedOn& on, parts::Side side);

/// On the floor, first in its middle; beside a standing feature.
TouchPlaces floor_places(const PlacedOn& on);

/// On the upper face beside the walls; on top of a standing feature.
TouchPlaces top_places(const PlacedOn& on);

}  // namespace g31::probe

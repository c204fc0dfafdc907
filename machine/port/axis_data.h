#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "machine/units/axis_positions.h"

namespace g31::machine {

/// What smooths the command of a feed behind the interpolation, each axis on its own.
enum class FeedFilter {
  None,
  Exponential,  ///< a first-order lag
  Linear,       ///< the mean over the time constant: a step of speed becomes a ramp
  Bell          ///< two such means in a row, each over the time constant / sqrt(2)
};

/// What the data of a control say of the axes; mm or deg, s.
struct AxisData {
  // So near its end an axis has arrived, > 0.
  AxisPositions stop_fine = AxisPositions::Constant(0.01);
  AxisPositions stop_coarse = AxisPositions::Constant(0.04);
  AxisPositions jerk_per_s3 = AxisPositions::Zero();  ///< >= 0; 0: not limited
  /// By so much an axis may change its speed at a corner; < 0: the machine's own.
  AxisPositions corner_jump_per_s = AxisPositions::Constant(-1.0);
  // Soft limits, machine coordinates; an axis that the machine does not have takes none.
  AxisPositions travel_min = AxisPositions::Constant(-std::numeric_limits<double>::infinity());
  AxisPositions travel_max = AxisPositions::Constant(std::numeric_limits<double>::infinity());
  FeedFilter feed_filter = FeedFilter::None;       ///< of feeds that are not planned ahead
  AxisPositions filter_s = AxisPositions::Zero();  ///< >= 0, its time constants; 0: none
};

/// A table of a control that moves an axis by the place of one: what is added to its true place.
struct CompensationTable {
  /// One axis' share; straight between the points, outside them as at the nearest.
  struct Factor {
    int axis = 0;  ///< storage index: its place, machine coordinate, counts
    /// Place, mm or deg, rising, and value there; not empty.
    std::vector<std::pair<double, double>> points;
    double period = 0.0;  ///< > 0: the points go round, and begin with the first one's place
  };
  int compensated = 0;          ///< storage index of the axis that is moved
  std::vector<Factor> factors;  ///< multiplied with each other: mm or deg; not empty
  /// +1, -1: it counts while the axis of its first factor goes that way, or last went; 0: always.
  int direction = 0;
};

}  // namespace g31::machine

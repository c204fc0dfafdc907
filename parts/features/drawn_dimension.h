#pragma once

#include <optional>
#include <vector>

#include "parts/features/removed_volume.h"

namespace g31::parts {

/// A size that the model itself states, with the faces that it is about.
struct DrawnDimension {
  double nominal_mm = 0.0;
  /// Limits of the deviation, where the model has them; lower <= upper.
  std::optional<double> lower_mm;
  std::optional<double> upper_mm;
  /// Two planes, or the faces of one cylinder: a diameter; of each its surface and a place on it.
  std::vector<RemovedFace> faces;
};

}  // namespace g31::parts

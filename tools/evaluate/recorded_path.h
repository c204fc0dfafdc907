#pragma once

#include <vector>

#include "machine/base/result.h"
#include "probe/metrology/plane_samples.h"
#include "tools/evaluate/evaluate.h"

namespace g31::evaluate {

/// A path in a plane.
struct RecordedPath {
  std::vector<double> t;                ///< s, rising; empty for kinds that need no time
  std::vector<double> x;                ///< first axis of the plane, mm
  std::vector<double> y;                ///< second axis
  double resolution = 0.0;              ///< one step of the coarser axis' last digit, mm
  machine::WorkWatch* watch = nullptr;  ///< may end the evaluation, by an exception

  [[nodiscard]] metrology::PlaneSamples samples() const { return {t, x, y, watch}; }
};

/// A length of the command line as a point; nothing where none was given.
std::optional<Eigen::Vector2d> point_of(const std::optional<Pair>& pair);

/// Reads the columns t (or time_s; or none with an interval, and for a diagonal) and the two axes
/// of the plane (X, else X_true, and so on).  A row of the same time and place as the one before it
/// is passed over; time that does not rise otherwise is an error.
Result<RecordedPath, DataError> read_path(const DataFile& file, const Request& request);

}  // namespace g31::evaluate

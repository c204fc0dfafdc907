#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/evaluate/evaluate.h"

namespace g31::evaluate {

/// Readings of sensors along one line, in the sense of travel (they rise as the work comes nearer).
struct SensorRows {
  double first = 0.0;  ///< K of the first row
  std::vector<double> a;
  std::vector<double> b;
  std::vector<double> c;  ///< empty without a third sensor
};

/// Readings that belong together: those of one angle or of one line across a plane.
struct SensorLine {
  double key = 0.0;
  SensorRows rows;
};

/// Reads the columns K, A, B and, where there is one, C.  Without K the rows count, from 0.
Result<SensorRows, DataError> read_sensor_rows(const DataFile& file, const Request& request);

/// The same of two sensors with a column that says which line a row belongs to, in the order of the
/// file; the rows of one line may stand anywhere, but each line has the same places.
Result<std::vector<SensorLine>, DataError> read_sensor_lines(const DataFile& file,
                                                             const Request& request,
                                                             const WantedColumn& key);

}  // namespace g31::evaluate

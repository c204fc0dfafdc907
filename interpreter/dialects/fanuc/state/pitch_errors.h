#pragma once

#include <optional>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "machine/port/axis_data.h"

namespace g31::fanuc {

/// The tables of stored pitch error compensation, of the linear axes that have points.
///
/// The value of a point is what the correction gains over one interval: over that which ends at
/// coordinate 0 for point 3620, over that behind it for the next one.  At coordinate 0 the
/// correction is 0, outside of the points it stays.  Source: B-63980EN/01 pp. 99 and 100; that the
/// gain is even within an interval is a model, a control may step.
std::vector<machine::CompensationTable> pitch_error_tables(const Parameters& parameters);

/// In what values of compensations count.
inline constexpr double kDetectionUnitMm = 0.001;

/// Where the points of pitch error compensation of an axis are.
struct PitchGrid {
  int reference = 0;
  int lowest = 0;
  int highest = 0;
  double interval_mm = 0.0;

  /// Where the section of a point ends towards positive places, mm.
  [[nodiscard]] double end_of(int point) const { return (point - reference) * interval_mm; }
};

/// nullopt: the axis has none.  @param axis  storage index
std::optional<PitchGrid> pitch_grid(const Parameters& parameters, int axis);

}  // namespace g31::fanuc

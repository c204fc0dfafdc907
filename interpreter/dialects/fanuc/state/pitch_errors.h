#pragma once

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

}  // namespace g31::fanuc

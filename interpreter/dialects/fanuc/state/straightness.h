#pragma once

#include <vector>

#include "interpreter/dialects/fanuc/state/failure.h"
#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "machine/port/axis_data.h"

namespace g31::fanuc {

/// The tables of straightness compensation: a linear axis is moved by the place of another one, by
/// four values at points of the latter's pitch error compensation, straight between them and
/// constant outside.
///
/// Fails with alarm 5046 for a pair whose axes are none or the same, and for points that fall or
/// lie beyond those of the moving axis.  Source: general knowledge of the 16i and 30i; that the
/// value of a point is reached where its section ends towards positive places is a model.
Result<std::vector<machine::CompensationTable>, Failure> straightness_tables(
    const Parameters& parameters);

}  // namespace g31::fanuc

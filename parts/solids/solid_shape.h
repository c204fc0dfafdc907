#pragma once

#include <string>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "machine/base/result.h"
#include "parts/geometry/box.h"
#include "parts/solids/removal_module.h"
#include "parts/solids/step_dimensions.h"

// A file of the module g31_step; functions throw what Open CASCADE throws.

namespace g31::parts {

/// The solids of a source, faces of one surface joined, and what its file says of sizes.
struct SourceSolids {
  TopoDS_Shape shape;
  std::vector<StepDimension> dimensions;
};

/// Error: why there are none, with the name.
Result<SourceSolids, std::string> solids_of(const SolidSource& source);

/// The box around a shape, exact where its vertices bound it.
Box box_around(const TopoDS_Shape& shape);

}  // namespace g31::parts

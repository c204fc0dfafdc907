#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

#include "machine/base/result.h"

// A file of the module g31_step.

namespace g31::parts {

/// All that a STEP file describes; lengths are mm, whatever the file's unit.
/// Error: what is wrong, without the path; throws what Open CASCADE throws.
Result<TopoDS_Shape, std::string> read_step_shape(const std::string& path);

}  // namespace g31::parts

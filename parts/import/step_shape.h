#pragma once

#include <string>

#include <STEPControl_Reader.hxx>
#include <TopoDS_Shape.hxx>

#include "machine/base/result.h"

// A file of the module g31_step.

namespace g31::parts {

/// All that a STEP file describes; lengths are mm, whatever the file's unit.
/// @param reader  has read it then
/// Error: what is wrong, without the path; throws what Open CASCADE throws.
Result<TopoDS_Shape, std::string> read_step_shape(const std::string& path,
                                                  STEPControl_Reader& reader);

}  // namespace g31::parts

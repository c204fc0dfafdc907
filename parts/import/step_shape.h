#pragma once

#include <string>

#include <STEPControl_Reader.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shape.hxx>

#include "machine/base/result.h"

// A file of the module g31_step.

namespace g31::parts {

/// All that a STEP file describes; lengths are mm, whatever the file's unit.
/// @param reader  has read it then
/// Error: what is wrong, without the path; throws what Open CASCADE throws.
Result<TopoDS_Shape, std::string> read_step_shape(const std::string& path,
                                                  STEPControl_Reader& reader);

/// The solids of a shape, and closed shells that are part of none; null where it has neither.
///
/// What else is in a file that has bodies is drawn as a help, and is no material: planes and axes
/// of references, surfaces that a body was cut with (CAx-IF, Recommended Practices for
/// Supplemental Geometry).
TopoDS_Compound bodies_in(const TopoDS_Shape& shape);

}  // namespace g31::parts

#pragma once

#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Whether a path ends like a STEP file: .step or .stp, in whatever case.
bool is_step_file(std::string_view path);

/// Whether this g31 was built with Open CASCADE, which reads STEP.
bool can_read_step();

/// Reads the faces of a STEP file as triangles; lengths become mm, whatever the file's unit.
///
/// Facets have their corners on the true surfaces, and no edge of one is farther from them than
/// the sagitta; so a hole reads too small, a shaft too small.  Plane faces are exact.
/// @param sagitta_mm  > 0
///
/// Error: what is wrong, without the path: g31 built without Open CASCADE (and what to build it
/// with), not understood, no faces.
Result<Mesh, std::string> read_step_file(const std::string& path, double sagitta_mm);

}  // namespace g31::parts

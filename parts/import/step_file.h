#pragma once

#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Whether a path ends like a STEP file: .step or .stp, in whatever case.
bool is_step_file(std::string_view path);

/// Whether the module that reads STEP through Open CASCADE is there; it is loaded then.
bool can_read_step();

/// Reads the faces of a STEP file as triangles; lengths become mm, whatever the file's unit.
/// Those of its bodies where it has any (step_shape.h): the others are counted alone.
///
/// Facets have their corners on the true surfaces, and no edge of one is farther from them than
/// the sagitta; so a hole reads too small, a shaft too small.  Plane faces are exact, and so are
/// upright round walls where a ball comes along X or Y (round_walls.h).
/// @param sagitta_mm  > 0
///
/// Error: what is wrong, without the path: no module (and what to install), not understood, no
/// faces.
Result<Mesh, std::string> read_step_file(const std::string& path, double sagitta_mm,
                                         const GoesOn& goes_on = {});

}  // namespace g31::parts

#pragma once

#include <string>

#include "machine/base/result.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// How far the facets of a STEP file may be from its surfaces where nothing else is asked for, mm.
inline constexpr double kStepSagittaMm = 1e-3;

/// Reads a triangle mesh from a file: STL, OBJ, PLY, 3MF and what else assimp knows; STEP where g31
/// was built with Open CASCADE (step_file.h).
///
/// The transforms of the file's nodes are applied, all its meshes are put into one, polygons become
/// triangles, vertices at the same place are joined.  Degenerate triangles stay; lines and points
/// in the file are left out.  Lengths are taken as mm.
///
/// Accuracy: STL is float32 by definition and assimp keeps float32 for the others: 4 nm at 100 mm,
/// 30 nm at 500 mm from the file's origin.
///
/// @param step_sagitta_mm  > 0, for STEP only
///
/// Error: one line that says what is wrong with the file (missing, empty, not finite, an index
/// without a vertex, no triangles, not understood) and what would be right.
Result<Mesh, std::string> read_mesh_file(const std::string& path,
                                         double step_sagitta_mm = kStepSagittaMm);

}  // namespace g31::parts

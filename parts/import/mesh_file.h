#pragma once

#include <string>

#include "machine/base/result.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Reads a triangle mesh from a file: STL, OBJ, PLY, 3MF and what else assimp knows.
///
/// The transforms of the file's nodes are applied, all its meshes are put into one, polygons become
/// triangles, vertices at the same place are joined.  Degenerate triangles stay; lines and points
/// in the file are left out.  Lengths are taken as mm.
///
/// Accuracy: STL is float32 by definition and assimp keeps float32 for the others: 4 nm at 100 mm,
/// 30 nm at 500 mm from the file's origin.
///
/// Error: one line that says what is wrong with the file (missing, empty, not finite, an index
/// without a vertex, no triangles, not understood) and what would be right.
Result<Mesh, std::string> read_mesh_file(const std::string& path);

}  // namespace g31::parts

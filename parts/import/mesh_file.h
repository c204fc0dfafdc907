#pragma once

#include <string>

#include "machine/base/result.h"
#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// How far the facets of a STEP file may be from its surfaces where nothing else is asked for, mm.
inline constexpr double kStepSagittaMm = 1e-3;

/// Why a pipe or a device is not read as a part.
inline constexpr const char* kNoRegularFile =
    "this is a pipe or a device; a part is read from a regular file: save it as one first";

/// How a file becomes a mesh, beside what it says itself.
struct MeshFileReading {
  double step_sagitta_mm = kStepSagittaMm;  ///< > 0, for STEP only
  std::string unit = {};                    ///< a name of mesh_units.def; empty: the file's, or mm
  double scale = 1.0;                       ///< > 0: factor of all lengths
  GoesOn goes_on = {};                      ///< may break the reading off
};

/// Reads a triangle mesh from a file: STL, OBJ, PLY, OFF, 3MF and what else assimp knows; STEP
/// where g31 was built with Open CASCADE (step_file.h).
///
/// The transforms of the file's nodes are applied, all its meshes are put into one, polygons become
/// triangles, vertices at the same place are joined.  Degenerate triangles stay; lines and points
/// in the file are left out.  Lengths become mm: 3MF and STEP say their unit, of others it is
/// given.
///
/// A file that is cut off, or whose head promises more than it holds, is refused as far as its form
/// tells (stl_file.h, whole_file.h, three_mf_file.h), before memory is asked for.
///
/// Accuracy: a text STL is read in double.  A binary one is float32 by definition and assimp keeps
/// float32 for the others: 4 nm at 100 mm, 30 nm at 500 mm from the file's origin.
///
/// Error: one line that says what is wrong with the file (missing, empty, cut off, too large, not
/// finite, an index without a vertex, no triangles, a unit for a file that has one, not
/// understood) and what would be right.
///
/// @throws BrokenOff  as `how` has it: of STL within 4096 facets, of STEP within a tenth of a
///     second, of the others when assimp next reads a piece, and behind it
Result<Mesh, std::string> read_mesh_file(const std::string& path, const MeshFileReading& how = {});

}  // namespace g31::parts

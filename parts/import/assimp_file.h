#pragma once

#include <string>

#include "machine/base/result.h"
#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Reads a mesh file of any kind that assimp knows, in its own unit; float32.
///
/// The transforms of the file's nodes are applied, all its meshes are put into one, polygons become
/// triangles, vertices at the same place are joined.  assimp works in a process of its own: some of
/// its readers end the process at a damaged file.
/// @param path   says the kind; nothing is read from there
/// @param bytes  of the file
/// Error: without the path.
/// @throws BrokenOff
Result<Mesh, std::string> read_through_assimp(const std::string& path, std::string bytes,
                                              const GoesOn& goes_on = {});

}  // namespace g31::parts

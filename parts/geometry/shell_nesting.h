#pragma once

#include <cstdint>
#include <vector>

#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh_shells.h"

namespace g31::parts {

/// How a shell lies among the closed ones around it.
struct ShellPlace {
  enum class Judged { Yes, No };
  Judged judged = Judged::No;
  std::uint32_t depth = 0;  ///< how many closed shells it is inside of
  bool crosses = false;     ///< it is partly inside another one
};

/// How much may be done to place shells.
struct NestingWork {
  std::uint64_t most = 0;  ///< facets and shells looked at; shells that come later are not judged
  GoesOn goes_on = {};
};

/// By shells.
/// @throws BrokenOff  as `work` has it
std::vector<ShellPlace> shell_places(const Mesh& mesh, const MeshShells& found,
                                     const FacetsByShell& facets, const NestingWork& work);

/// The shells that the stray ones of mesh_defects.h are, rising.
std::vector<std::uint32_t> stray_shells(const Mesh& mesh, const MeshShells& found,
                                        const std::vector<ShellPlace>& places);

}  // namespace g31::parts

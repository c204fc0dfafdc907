#pragma once

#include <span>
#include <string_view>

namespace g31::parts {

/// A row of mesh_units.def.
struct MeshUnit {
  std::string_view name;         ///< in a set-up sheet
  std::string_view name_in_3mf;  ///< the attribute of its model
  double mm = 1.0;
};

inline constexpr MeshUnit kMeshUnits[] = {
#define MESH_UNIT(name, name_in_3mf, mm) {name, name_in_3mf, mm},
#include "parts/import/mesh_units.def"
#undef MESH_UNIT
};

}  // namespace g31::parts

#include "parts/import/assimp_file.h"

#include <utility>

#include "machine/base/module.h"
#include "parts/import/assimp_module.h"
#include "parts/import/coordinate_rounding.h"
#include "parts/import/made_apart.h"

namespace g31::parts {

Result<Mesh, std::string> read_through_assimp(const std::string& path, std::string bytes,
                                              const GoesOn& goes_on) {
  static const ModuleFunction function = find_in_module(
      {.file = "g31_assimp.so", .does = "reads such meshes", .package = "libassimp5"},
      "g31_read_scene");
  if (function.address == nullptr) {
    return function.why_not + ", or save the part as STL";
  }
  const auto read_scene = reinterpret_cast<decltype(&g31_read_scene)>(function.address);
  MadeApart<Mesh> read = make_apart<Mesh>(
      [&](Mesh& mesh) {
        std::string error;
        read_scene(path.c_str(), &bytes, &mesh, &error);
        return error;
      },
      goes_on);
  if (!read.why_not.empty()) {
    return "not understood as a mesh: assimp does not get through it (" + read.why_not +
           "); expected a whole STL, OBJ, PLY, OFF or 3MF file: export STEP or STL";
  }
  if (!read.error.empty()) {
    return std::move(read.error);
  }
  read.made.rounding_mm = rounding_of(read.made);
  return std::move(read.made);
}

}  // namespace g31::parts

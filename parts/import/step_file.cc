#include "parts/import/step_file.h"

#include <string>
#include <vector>

#include "parts/import/made_apart.h"
#include "parts/import/round_walls.h"
#include "parts/import/step_library.h"
#include "parts/import/step_module.h"

namespace g31::parts {
namespace {

const ModuleFunction& step_reader() {
  static const ModuleFunction reader = find_in_step_library("g31_read_step");
  return reader;
}

/// What a file was read as.
struct ReadFaces {
  Mesh mesh;
  std::vector<RoundWall> walls;
};

template <typename Stream>
void pass(Stream& stream, ReadFaces& faces) {
  pass(stream, faces.mesh);
  pass(stream, faces.walls);
}

}  // namespace

bool can_read_step() {
  return step_reader().address != nullptr;
}

Result<Mesh, std::string> read_step_file(const std::string& path, double sagitta_mm,
                                         const GoesOn& goes_on) {
  if (!can_read_step()) {
    return step_reader().why_not + ", or save the part as STL, OBJ, PLY or 3MF";
  }
  const auto read = reinterpret_cast<decltype(&g31_read_step)>(step_reader().address);
  const auto read_by = [&](FaceMesher mesher) {
    return make_apart<ReadFaces>(
        [&](ReadFaces& faces) {
          std::string error;
          read({path, sagitta_mm, mesher}, &faces.mesh, &faces.walls, &error);
          return error;
        },
        goes_on);
  };
  MadeApart<ReadFaces> apart = read_by(FaceMesher::Quick);
  if (!apart.why_not.empty()) {
    // It may be the way of meshing that breaks off, not the file.
    apart = read_by(FaceMesher::Sure);
  }
  if (!apart.why_not.empty()) {
    return "not understood as STEP: Open CASCADE does not get through it (" + apart.why_not + ")";
  }
  if (!apart.error.empty()) {
    return std::move(apart.error);
  }
  refine_round_walls(apart.made.mesh, apart.made.walls);
  return std::move(apart.made.mesh);
}

}  // namespace g31::parts

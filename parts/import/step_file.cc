#include "parts/import/step_file.h"

#include <string>
#include <vector>

#include "parts/import/made_apart.h"
#include "parts/import/round_walls.h"
#include "parts/import/step_library.h"
#include "parts/import/step_module.h"

namespace g31::parts {
namespace {

const StepFunction& step_reader() {
  static const StepFunction reader = find_in_step_library("g31_read_step");
  return reader;
}

/// What a file was read as; with an error nothing else.
struct ReadFaces {
  std::string error;
  Mesh mesh;
  std::vector<RoundWall> walls;
};

template <typename Stream>
void pass(Stream& stream, ReadFaces& faces) {
  pass(stream, faces.error);
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
  ReadFaces faces;
  const std::string why_not = make_apart<ReadFaces>(
      faces,
      [&](ReadFaces& of_file) {
        read(path.c_str(), sagitta_mm, &of_file.mesh, &of_file.walls, &of_file.error);
      },
      goes_on);
  if (!why_not.empty()) {
    return "not understood as STEP: Open CASCADE does not get through it (" + why_not + ")";
  }
  if (!faces.error.empty()) {
    return faces.error;
  }
  refine_round_walls(faces.mesh, faces.walls);
  return faces.mesh;
}

}  // namespace g31::parts

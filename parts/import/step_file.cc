#include "parts/import/step_file.h"

#include <string>
#include <vector>

#include "parts/import/round_walls.h"
#include "parts/import/step_library.h"
#include "parts/import/step_module.h"

namespace g31::parts {
namespace {

const StepFunction& step_reader() {
  static const StepFunction reader = find_in_step_library("g31_read_step");
  return reader;
}

}  // namespace

bool can_read_step() {
  return step_reader().address != nullptr;
}

Result<Mesh, std::string> read_step_file(const std::string& path, double sagitta_mm) {
  if (!can_read_step()) {
    return step_reader().why_not + ", or save the part as STL, OBJ, PLY or 3MF";
  }
  const auto read = reinterpret_cast<decltype(&g31_read_step)>(step_reader().address);
  Mesh mesh;
  std::vector<RoundWall> walls;
  std::string error;
  if (!read(path.c_str(), sagitta_mm, &mesh, &walls, &error)) {
    return error;
  }
  refine_round_walls(mesh, walls);
  return mesh;
}

}  // namespace g31::parts

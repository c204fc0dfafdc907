#include "parts/import/step_file.h"

#include <string>
#include <vector>

#include "parts/import/byte_stream.h"
#include "parts/import/round_walls.h"
#include "parts/import/step_library.h"
#include "parts/import/step_module.h"
#include "parts/import/work_apart.h"

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
  const WorkApart done = done_apart(
      [&] {
        ReadFaces faces;
        read(path.c_str(), sagitta_mm, &faces.mesh, &faces.walls, &faces.error);
        ByteWriter writer;
        pass(writer, faces);
        return std::move(writer).take();
      },
      goes_on);
  if (!done.why_not.empty()) {
    return "not understood as STEP: Open CASCADE does not get through it (" + done.why_not + ")";
  }
  ByteReader reader(done.bytes);
  ReadFaces faces;
  pass(reader, faces);
  if (!faces.error.empty()) {
    return faces.error;
  }
  refine_round_walls(faces.mesh, faces.walls);
  return faces.mesh;
}

}  // namespace g31::parts

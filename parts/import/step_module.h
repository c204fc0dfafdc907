#pragma once

#include <string>
#include <vector>

#include "parts/geometry/mesh.h"
#include "parts/import/round_walls.h"

// A function of the module g31_step, which is loaded when a STEP file is to be read: the libraries
// of Open CASCADE would add 25 ms to each start of g31, which takes 4 ms without them. Program and
// module come from one build, so they agree on these types.

namespace g31::parts {

/// How Open CASCADE makes triangles of plane faces.
enum class FaceMesher {
  Quick,  ///< Delabella's way where a face has many corners
  Sure,   ///< Watson's way for all faces: its time grows with the square of their corners
};

/// What is to be read, and how.
struct StepReading {
  std::string path;
  double sagitta_mm = 0.0;  ///< > 0
  FaceMesher mesher = FaceMesher::Quick;
};

}  // namespace g31::parts

/// Reads the faces of a STEP file as triangles, as parts::read_step_file says.
/// @param mesh   what was read, mm; unchanged on failure
/// @param walls  those of upright cylinders in it
/// @param error  on failure what is wrong, without the path
/// @returns whether it was read; no exception leaves it but that of memory
extern "C" __attribute__((visibility("default"))) bool g31_read_step(
    const g31::parts::StepReading& reading, g31::parts::Mesh* mesh,
    std::vector<g31::parts::RoundWall>* walls, std::string* error);

// Stands in for step_file.cc where Open CASCADE is not installed.

#include "parts/import/step_file.h"

namespace g31::parts {

bool can_read_step() {
  return false;
}

Result<Mesh, std::string> read_step_file(const std::string&, double) {
  return std::string(
      "this g31 was built without Open CASCADE, which reads STEP; install "
      "libocct-data-exchange-dev and build again with cmake -DG31_STEP=ON, or save the part as "
      "STL, "
      "OBJ, PLY or 3MF");
}

}  // namespace g31::parts

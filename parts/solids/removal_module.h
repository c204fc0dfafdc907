#pragma once

#include <string>

#include "parts/geometry/mesh.h"
#include "parts/solids/removal.h"

// The other function of the module g31_step (step_module.h).

namespace g31::parts {

/// Where a solid comes from: a STEP file, or a mesh where there is no path.
struct SolidSource {
  std::string name;  ///< for messages
  std::string step_path;
  Mesh mesh;
};

struct RemovalRequest {
  SolidSource product;
  std::optional<SolidSource> stock;  ///< of a file
  std::optional<Point> block_mm;     ///< else as StockChoice says
};

}  // namespace g31::parts

/// As parts::removal_of says.
/// @param removal  filled on success
/// @param error    on failure what is wrong
/// @returns whether it succeeded; no exception leaves it but that of memory
extern "C" __attribute__((visibility("default"))) bool g31_remove(
    const g31::parts::RemovalRequest* request, g31::parts::Removal* removal, std::string* error);

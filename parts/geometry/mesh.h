#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "machine/units/point.h"

namespace g31::parts {

/// A triangle mesh in the part frame P, mm, double throughout.  May be open, unoriented or contain
/// slivers; nothing is assumed but that indices lie inside `vertices` and coordinates are finite.
struct Mesh {
  std::vector<Point> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double rounding_mm = 0.0;  ///< by how much the file that it comes from may round coordinates
  std::uint64_t faces_left_out = 0;  ///< of that file: they belong to none of its bodies
};

}  // namespace g31::parts

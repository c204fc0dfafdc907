#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Corner 0, 1 or 2 of a triangle.
struct Corner {
  std::uint32_t triangle = 0;
  std::uint32_t index = 0;
};

/// Which triangle corners meet at each vertex.  Vertices of equal coordinates count as one: file
/// formats without shared vertices give the same fans as others.
class CornerFans {
 public:
  explicit CornerFans(const Mesh& mesh);

  /// The number that stands for the place of vertex v: the least vertex in that place.
  [[nodiscard]] std::uint32_t place_of(std::uint32_t v) const { return place_[v]; }

  /// The corners in the place of vertex v, by rising triangles; empty for a vertex that is not the
  /// least in its place.
  [[nodiscard]] std::span<const Corner> fan(std::uint32_t v) const {
    return std::span(corners_).subspan(first_[v], first_[v + 1] - first_[v]);
  }

  [[nodiscard]] std::size_t memory_bytes() const {
    return (place_.capacity() + first_.capacity()) * sizeof(std::uint32_t) +
           corners_.capacity() * sizeof(Corner);
  }

 private:
  std::vector<std::uint32_t> place_;
  std::vector<std::uint32_t> first_;
  std::vector<Corner> corners_;
};

}  // namespace g31::parts

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Adds vertices to a mesh; those in the same place, bit for bit, become one.
class VertexWeld {
 public:
  /// @param mesh  not owned: it must outlive the weld
  explicit VertexWeld(Mesh& mesh) : mesh_(mesh) {}

  std::uint32_t vertex_at(const Point& p) {
    // + 0.0 turns -0 into 0: the two are the same place but not the same bits.
    const Place place = {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0};
    const auto next = static_cast<std::uint32_t>(mesh_.vertices.size());
    const auto [entry, is_new] = vertex_of_.try_emplace(place, next);
    if (is_new) {
      mesh_.vertices.emplace_back(place[0], place[1], place[2]);
    }
    return entry->second;
  }

 private:
  using Place = std::array<double, 3>;
  struct Hash {
    std::size_t operator()(const Place& place) const {
      std::size_t hash = 0;
      for (const double coordinate : place) {
        hash = hash * 1000003U ^ std::hash<double>{}(coordinate);
      }
      return hash;
    }
  };

  Mesh& mesh_;
  std::unordered_map<Place, std::uint32_t, Hash> vertex_of_;
};

}  // namespace g31::parts

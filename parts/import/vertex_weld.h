#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// Adds vertices to a mesh; those in the same place, bit for bit, become one.
class VertexWeld {
 public:
  /// @param mesh      not owned: it must outlive the weld
  /// @param expected  about so many vertices: room for them is made at once
  explicit VertexWeld(Mesh& mesh, std::size_t expected = 0)
      : mesh_(mesh), slots_(std::bit_ceil(std::max(kFewest, 2 * expected + 1)), kNone) {
    mesh.vertices.reserve(expected);
  }

  /// Has the processor fetch what vertex_at will look at.
  void prefetch(const Point& p) const {
    __builtin_prefetch(&slots_[first_slot_of(p + Point::Zero())]);
  }

  /// @returns the number of a point among the vertices of the mesh
  std::uint32_t vertex_at(const Point& p) {
    // + 0.0 turns -0 into 0: the two are the same place but not the same bits.
    const Point place = p + Point::Zero();
    std::size_t at = first_slot_of(place);
    for (; slots_[at] != kNone; at = (at + 1) & (slots_.size() - 1)) {
      // By bits, so that numbers that are none are found again, too.
      if (std::memcmp(mesh_.vertices[slots_[at]].data(), place.data(), sizeof place) == 0) {
        return slots_[at];
      }
    }
    const auto number = static_cast<std::uint32_t>(mesh_.vertices.size());
    slots_[at] = number;
    mesh_.vertices.push_back(place);
    if (2 * mesh_.vertices.size() > slots_.size()) {
      make_room();
    }
    return number;
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kFewest = 64;  // a power of two, as all sizes of the table

  [[nodiscard]] std::size_t first_slot_of(const Point& place) const {
    std::uint64_t hash = 0;
    for (const double coordinate : place) {
      // The finalizer of SplitMix64: neighbours on a grid differ in few bits.
      hash += std::bit_cast<std::uint64_t>(coordinate);
      hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
      hash = (hash ^ (hash >> 27U)) * 0x94d049bb133111ebU;
      hash ^= hash >> 31U;
    }
    return static_cast<std::size_t>(hash) & (slots_.size() - 1);
  }

  void make_room() {
    slots_ = std::vector<std::uint32_t>();  // gives its memory back first
    slots_.assign(std::bit_ceil(4 * mesh_.vertices.size()), kNone);
    for (std::uint32_t i = 0; i < mesh_.vertices.size(); ++i) {
      std::size_t at = first_slot_of(mesh_.vertices[i]);
      while (slots_[at] != kNone) {
        at = (at + 1) & (slots_.size() - 1);
      }
      slots_[at] = i;
    }
  }

  Mesh& mesh_;
  std::vector<std::uint32_t> slots_;  ///< open addressing: numbers of vertices, at most half full
};

}  // namespace g31::parts

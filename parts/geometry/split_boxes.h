#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "parts/geometry/box.h"

namespace g31::parts {

/// X, Y, Z and an unused 0 in one register: what the compilers do not see by themselves.
using FloatPoint [[gnu::vector_size(16)]] = float;

/// An axis-aligned box in float32; an empty one until something is included.
struct SmallBox {
  FloatPoint min{kNone, kNone, kNone, kNone};
  FloatPoint max{-kNone, -kNone, -kNone, -kNone};

  void include(const FloatPoint& low, const FloatPoint& high) {
    min = low < min ? low : min;
    max = high > max ? high : max;
  }
  void include(const SmallBox& box) { include(box.min, box.max); }

  [[nodiscard]] float extent(std::size_t axis) const { return max[axis] - min[axis]; }
  [[nodiscard]] float half_surface() const;

 private:
  static constexpr float kNone = std::numeric_limits<float>::infinity();
};

/// One of the boxes that a tree is made of.
struct BoxItem {
  SmallBox box;
  std::uint32_t index = 0;  ///< in the list that the tree was given
  std::uint32_t bin = 0;    ///< of split_in_two

  /// @param middle  the box is taken relative to it, and rounded outwards
  BoxItem() = default;
  BoxItem(const Box& exact, const Point& middle, std::uint32_t number);

  /// Twice the centre.
  [[nodiscard]] float place(std::size_t axis) const { return box.min[axis] + box.max[axis]; }
  [[nodiscard]] FloatPoint place() const { return box.min + box.max; }
};

/// Some boxes that lie together, and what is known of all of them.
struct BoxGroup {
  std::span<BoxItem> items;
  SmallBox box;
  SmallBox places;       ///< around the places of the items
  float surface = 0.0F;  ///< half that of the box
  int depth = 0;         ///< how often everything was cut in two to get it
};

BoxGroup group_of(std::span<BoxItem> items, int depth);

/// Cuts a group of at least two in two, which take the places of its items: at most 48 times by the
/// surface area heuristic, in halves after that, so that no input makes the tree too deep.
std::array<BoxGroup, 2> split_in_two(const BoxGroup& group);

}  // namespace g31::parts

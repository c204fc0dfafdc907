#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "parts/geometry/box.h"

namespace g31::parts {

/// X, Y, Z and one lane to spare in one register: what the compilers do not see by themselves.
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
  [[nodiscard]] float half_surface() const {
    const FloatPoint size = max - min;
    const FloatPoint side = size > 0.0F ? size : FloatPoint{};
    return side[0] * side[1] + side[1] * side[2] + side[2] * side[0];
  }

 private:
  static constexpr float kNone = std::numeric_limits<float>::infinity();
};

/// One of the boxes that a tree is made of, in 32 bytes: two whole numbers take the lanes to spare.
class BoxItem {
 public:
  /// @param middle  the box is taken relative to it, and rounded outwards
  /// @param index   in the list that the tree was given
  BoxItem(const Box& exact, const Point& middle, std::uint32_t index);

  [[nodiscard]] const SmallBox& box() const { return box_; }
  [[nodiscard]] std::uint32_t index() const { return std::bit_cast<std::uint32_t>(box_.min[3]); }

  /// Where split_in_two has put it.
  [[nodiscard]] std::uint32_t bin() const { return std::bit_cast<std::uint32_t>(box_.max[3]); }
  void put_in(std::uint32_t bin) { box_.max[3] = std::bit_cast<float>(bin); }

  /// Twice the centre.
  [[nodiscard]] float place(std::size_t axis) const { return box_.min[axis] + box_.max[axis]; }
  [[nodiscard]] FloatPoint place() const { return box_.min + box_.max; }

 private:
  SmallBox box_;
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

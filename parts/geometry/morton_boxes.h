#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "parts/geometry/box.h"

namespace g31::parts {

/// Four lanes in one register: what the compilers do not see by themselves.
using FourFloats [[gnu::vector_size(16)]] = float;

/// A box in float32.
struct RoundedBox {
  std::array<float, 3> min;
  std::array<float, 3> max;

  void include(const RoundedBox& other);
};

/// Eight boxes that are compared with another one at once; lanes without one are inside out.
class EightBoxes {
 public:
  static constexpr std::size_t kLanes = 8;

  EightBoxes();
  void put(std::size_t lane, const RoundedBox& box);
  [[nodiscard]] RoundedBox at(std::size_t lane) const;
  /// The box around them.
  [[nodiscard]] RoundedBox around() const;

  /// Those that meet a box, one bit each, the least for the first; boxes that touch meet.
  [[nodiscard]] unsigned int meet(const RoundedBox& box) const {
    return meet_in_half(0, box) | meet_in_half(1, box) << 4U;
  }

 private:
  using FourWholes [[gnu::vector_size(16)]] = std::int32_t;

  [[nodiscard]] unsigned int meet_in_half(std::size_t half, const RoundedBox& box) const {
    FourWholes hits = FourWholes{1, 2, 4, 8};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      hits &= min_[half][axis] <= box.max[axis];
      hits &= max_[half][axis] >= box.min[axis];
    }
    hits |= __builtin_shufflevector(hits, hits, 2, 3, 0, 1);
    hits |= __builtin_shufflevector(hits, hits, 1, 0, 3, 2);
    return static_cast<unsigned int>(hits[0]);
  }

  std::array<std::array<FourFloats, 3>, 2> min_;
  std::array<std::array<FourFloats, 3>, 2> max_;
};

/// Boxes of facets in the order of a curve through space that comes near neighbours together (G. M.
/// Morton, 1966), eight by eight, and those by eight again: quickly made, for questions whose
/// answers are short.
///
/// In float32 about the middle of all, grown by what that loses: no two boxes that meet are told
/// apart.  About 28 bytes a box.
class MortonBoxes {
 public:
  /// @param boxes  none empty, at least one; fewer than 2^30
  explicit MortonBoxes(const std::vector<Box>& boxes);

  /// The boxes given, in the order of the curve: slot i is box order()[i].
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }

  /// Groups of eight slots each; the last may have less.
  [[nodiscard]] std::size_t groups() const { return levels_.front().size(); }
  [[nodiscard]] const EightBoxes& group(std::size_t number) const {
    return levels_.front()[number];
  }

  /// Puts the numbers of the groups from `first` on that meet a box into `found`, rising.
  /// @returns how many boxes were compared
  std::size_t groups_near(const RoundedBox& box, std::size_t first,
                          std::vector<std::uint32_t>& found) const;

 private:
  std::size_t look_at(std::size_t level, std::size_t number, const RoundedBox& box,
                      std::size_t first, std::vector<std::uint32_t>& found) const;

  std::vector<std::uint32_t> order_;
  std::vector<std::vector<EightBoxes>> levels_;  ///< boxes of facets, of groups, of groups of those
};

}  // namespace g31::parts

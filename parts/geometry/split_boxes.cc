#include "parts/geometry/split_boxes.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace g31::parts {
namespace {

constexpr std::uint32_t kBins = 16;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// std::nextafter(x, infinity), which the library makes no inline function of.
float next_above(float x) {
  const auto bits = std::bit_cast<std::int32_t>(x);
  if (x == 0.0F) {
    return std::bit_cast<float>(1);
  }
  return x == kInfinity ? x : std::bit_cast<float>(bits < 0 ? bits - 1 : bits + 1);
}

float next_below(float x) {
  return -next_above(-x);
}

/// What of a group lies in one slice of it.
struct Bin {
  SmallBox box;
  SmallBox places;
  std::size_t count = 0;

  void include(const BoxItem& item) {
    const FloatPoint place = item.place();
    box.include(item.box);
    places.include(place, place);
    ++count;
  }
  void include(const Bin& bin) {
    box.include(bin.box);
    places.include(bin.places);
    count += bin.count;
  }
  [[nodiscard]] float cost() const { return box.half_surface() * static_cast<float>(count); }
};

BoxGroup group_of(std::span<BoxItem> items, int depth, const Bin& all) {
  return {items, all.box, all.places, all.box.half_surface(), depth};
}

/// The slices of a group across its longest axis.
class Bins {
 public:
  /// Notes in each item which bin it is in.
  Bins(const BoxGroup& group, std::size_t axis) {
    const float low = group.places.min[axis];
    const float extent = group.places.extent(axis);
    for (BoxItem& item : group.items) {
      const float share = (item.place(axis) - low) / extent * static_cast<float>(kBins);
      item.bin = std::min(kBins - 1, static_cast<std::uint32_t>(share));
      if (!has(item.bin)) {
        bins_[item.bin] = Bin();
        used_ |= 1U << item.bin;
      }
      bins_[item.bin].include(item);
    }
  }

  struct Split {
    std::uint32_t border = 0;  ///< the first bin on the right side; 0: no split separates anything
    Bin left;
    Bin right;
  };

  [[nodiscard]] Split cheapest() const {
    // Empty bins change nothing: only the first border after a bin that is used can be the best.
    std::array<float, kBins> right_cost;
    Bin right;
    for (std::uint32_t rest = used_; rest != 0;) {
      const auto last = static_cast<std::uint32_t>(std::bit_width(rest)) - 1;
      right.include(bins_[last]);
      right_cost[last] = right.cost();
      rest &= ~(1U << last);
    }
    Split best;
    float best_cost = kInfinity;
    Bin left;
    for (std::uint32_t rest = used_; (rest & (rest - 1)) != 0;) {
      const auto bin = static_cast<std::uint32_t>(std::countr_zero(rest));
      left.include(bins_[bin]);
      rest &= rest - 1;
      const float cost = left.cost() + right_cost[static_cast<std::size_t>(std::countr_zero(rest))];
      if (cost < best_cost) {
        best_cost = cost;
        best.border = bin + 1;
        best.left = left;
      }
    }
    for (std::uint32_t bin = best.border; bin < kBins; ++bin) {
      if (has(bin)) {
        best.right.include(bins_[bin]);
      }
    }
    return best;
  }

 private:
  [[nodiscard]] bool has(std::uint32_t bin) const { return (used_ >> bin & 1U) != 0; }

  std::uint32_t used_ = 0;  ///< a bit for each bin that holds something
  std::array<Bin, kBins> bins_;
};

std::size_t longest_axis(const SmallBox& box) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    axis = box.extent(i) > box.extent(axis) ? i : axis;
  }
  return axis;
}

}  // namespace

float SmallBox::half_surface() const {
  const float x = std::max(0.0F, extent(0));
  const float y = std::max(0.0F, extent(1));
  const float z = std::max(0.0F, extent(2));
  return x * y + y * z + z * x;
}

BoxItem::BoxItem(const Box& exact, const Point& middle, std::uint32_t number) : index(number) {
  box.min[3] = 0.0F;
  box.max[3] = 0.0F;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    box.min[i] = next_below(static_cast<float>(exact.min[axis] - middle[axis]));
    box.max[i] = next_above(static_cast<float>(exact.max[axis] - middle[axis]));
  }
}

BoxGroup group_of(std::span<BoxItem> items, int depth) {
  Bin all;
  for (const BoxItem& item : items) {
    all.include(item);
  }
  return group_of(items, depth, all);
}

std::array<BoxGroup, 2> split_in_two(const BoxGroup& group) {
  constexpr int kHeuristicDepth = 48;
  const std::size_t axis = longest_axis(group.places);
  const int depth = group.depth + 1;
  const std::span<BoxItem> items = group.items;
  if (group.depth < kHeuristicDepth && group.places.extent(axis) > 0.0F) {
    const Bins::Split split = Bins(group, axis).cheapest();
    if (split.border > 0) {
      std::partition(items.begin(), items.end(),
                     [&](const BoxItem& item) { return item.bin < split.border; });
      const std::size_t left = split.left.count;
      return {group_of(items.first(left), depth, split.left),
              group_of(items.subspan(left), depth, split.right)};
    }
  }
  const std::size_t half = items.size() / 2;
  std::nth_element(
      items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
      [&](const BoxItem& a, const BoxItem& b) { return a.place(axis) < b.place(axis); });
  return {group_of(items.first(half), depth), group_of(items.subspan(half), depth)};
}

}  // namespace g31::parts

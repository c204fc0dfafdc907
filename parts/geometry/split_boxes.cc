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

/// What is known of some items.
struct Summary {
  SmallBox box;
  SmallBox places;
  std::size_t count = 0;

  void include(const BoxItem& item) {
    const FloatPoint place = item.place();
    box.include(item.box());
    places.include(place, place);
    ++count;
  }
  void include(const Summary& more) {
    box.include(more.box);
    places.include(more.places);
    count += more.count;
  }
};

BoxGroup group_of(std::span<BoxItem> items, int depth, const Summary& all) {
  return {items, all.box, all.places, all.box.half_surface(), depth};
}

/// A side of a split that grows bin by bin.
struct Side {
  SmallBox box;
  std::size_t count = 0;

  /// The cost of the side.
  float include(const Summary& bin) {
    box.include(bin.box);
    count += bin.count;
    return box.half_surface() * static_cast<float>(count);
  }
};

/// The slices of a group across its longest axis.
class Bins {
 public:
  /// Notes in each item which bin it is in.
  Bins(const BoxGroup& group, std::size_t axis) {
    const float low = group.places.min[axis];
    const float extent = group.places.extent(axis);
    for (BoxItem& item : group.items) {
      const float share = (item.place(axis) - low) / extent * static_cast<float>(kBins);
      const std::uint32_t bin = std::min(kBins - 1, static_cast<std::uint32_t>(share));
      if ((used_ >> bin & 1U) == 0) {
        bins_[bin] = Summary();
        used_ |= 1U << bin;
      }
      bins_[bin].include(item);
      item.put_in(bin);  // after the box has been read: the other way round the processor waits
    }
  }

  /// The first bin on the right side of the cheapest split; 0: no split separates anything.
  [[nodiscard]] std::uint32_t cheapest_border() const {
    // Empty bins change nothing: only the first border after a bin that is used can be the best.
    std::array<float, kBins> right_cost;
    Side right;
    for (std::uint32_t rest = used_; rest != 0;) {
      const auto last = static_cast<std::uint32_t>(std::bit_width(rest)) - 1;
      right_cost[last] = right.include(bins_[last]);
      rest &= ~(1U << last);
    }
    std::uint32_t best = 0;
    float best_cost = kInfinity;
    Side left;
    for (std::uint32_t rest = used_; (rest & (rest - 1)) != 0;) {
      const auto bin = static_cast<std::uint32_t>(std::countr_zero(rest));
      rest &= rest - 1;
      const float cost =
          left.include(bins_[bin]) + right_cost[static_cast<std::size_t>(std::countr_zero(rest))];
      if (cost < best_cost) {
        best_cost = cost;
        best = bin + 1;
      }
    }
    return best;
  }

  /// What lies in the bins before a border, and in those from there on.
  [[nodiscard]] std::array<Summary, 2> sides_of(std::uint32_t border) const {
    std::array<Summary, 2> sides;
    for (std::uint32_t rest = used_; rest != 0; rest &= rest - 1) {
      const auto bin = static_cast<std::uint32_t>(std::countr_zero(rest));
      sides[bin < border ? 0 : 1].include(bins_[bin]);
    }
    return sides;
  }

 private:
  std::uint32_t used_ = 0;  ///< a bit for each bin that holds something
  std::array<Summary, kBins> bins_;
};

std::size_t longest_axis(const SmallBox& box) {
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    axis = box.extent(i) > box.extent(axis) ? i : axis;
  }
  return axis;
}

}  // namespace

BoxItem::BoxItem(const Box& exact, const Point& middle, std::uint32_t index) {
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    box_.min[i] = next_below(static_cast<float>(exact.min[axis] - middle[axis]));
    box_.max[i] = next_above(static_cast<float>(exact.max[axis] - middle[axis]));
  }
  box_.min[3] = std::bit_cast<float>(index);
  put_in(0);
}

BoxGroup group_of(std::span<BoxItem> items, int depth) {
  Summary all;
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
    const Bins bins(group, axis);
    if (const std::uint32_t border = bins.cheapest_border(); border > 0) {
      std::partition(items.begin(), items.end(),
                     [&](const BoxItem& item) { return item.bin() < border; });
      const auto [left, right] = bins.sides_of(border);
      return {group_of(items.first(left.count), depth, left),
              group_of(items.subspan(left.count), depth, right)};
    }
  }
  const std::size_t half = items.size() / 2;
  std::nth_element(
      items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
      [&](const BoxItem& a, const BoxItem& b) { return a.place(axis) < b.place(axis); });
  return {group_of(items.first(half), depth), group_of(items.subspan(half), depth)};
}

}  // namespace g31::parts

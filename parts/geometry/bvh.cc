#include "parts/geometry/bvh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "machine/base/contract.h"

namespace g31::parts {
namespace {

constexpr std::size_t kBins = 16;
constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

/// A box relative to the middle of all, rounded outwards.
struct SmallBox {
  std::array<float, 3> min{kFloatInfinity, kFloatInfinity, kFloatInfinity};
  std::array<float, 3> max{-kFloatInfinity, -kFloatInfinity, -kFloatInfinity};

  void include(const SmallBox& box) {
    for (std::size_t i = 0; i < 3; ++i) {
      min[i] = std::min(min[i], box.min[i]);
      max[i] = std::max(max[i], box.max[i]);
    }
  }
  [[nodiscard]] float half_surface() const {
    const float x = std::max(0.0F, max[0] - min[0]);
    const float y = std::max(0.0F, max[1] - min[1]);
    const float z = std::max(0.0F, max[2] - min[2]);
    return x * y + y * z + z * x;
  }
  /// Twice the centre.
  [[nodiscard]] float place(std::size_t axis) const { return min[axis] + max[axis]; }
};

SmallBox small_box(const Box& box, const Point& middle) {
  SmallBox small;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    const auto low = static_cast<float>(box.min[axis] - middle[axis]);
    const auto high = static_cast<float>(box.max[axis] - middle[axis]);
    small.min[i] = std::nextafter(low, -kFloatInfinity);
    small.max[i] = std::nextafter(high, kFloatInfinity);
  }
  return small;
}

struct Item {
  SmallBox box;
  std::uint32_t index = 0;
};

struct Bin {
  SmallBox box;
  std::size_t count = 0;
};

/// The number of bins on the left side of the cheapest split; 0 when no split separates anything.
std::size_t cheapest_split(const std::array<Bin, kBins>& bins) {
  std::array<float, kBins> right_cost{};
  Bin right;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    right.box.include(bins[i].box);
    right.count += bins[i].count;
    right_cost[i] =
        right.count == 0 ? 0.0F : right.box.half_surface() * static_cast<float>(right.count);
  }
  std::size_t best = 0;
  float best_cost = kFloatInfinity;
  Bin left;
  std::size_t right_count = right.count + bins[0].count;
  for (std::size_t i = 1; i < kBins; ++i) {
    left.box.include(bins[i - 1].box);
    left.count += bins[i - 1].count;
    right_count -= bins[i - 1].count;
    if (left.count == 0 || right_count == 0) {
      continue;
    }
    const float cost = left.box.half_surface() * static_cast<float>(left.count) + right_cost[i];
    if (cost < best_cost) {
      best_cost = cost;
      best = i;
    }
  }
  return best;
}

/// Some boxes that will be one child of a node.
struct Part {
  std::span<Item> items;
  SmallBox box;
  int depth = 0;  ///< how often everything was cut in two to get it
};

Part part_of(std::span<Item> items, int depth) {
  Part part{items, {}, depth};
  for (const Item& item : items) {
    part.box.include(item.box);
  }
  return part;
}

/// Where to cut a part of at least two in two: at most kHeuristicDepth times by the surface area
/// heuristic, in halves after that, so that no input makes the tree too deep.
std::size_t split(const Part& part) {
  constexpr int kHeuristicDepth = 48;
  std::array<float, 3> low;
  std::array<float, 3> high;
  low.fill(kFloatInfinity);
  high.fill(-kFloatInfinity);
  for (const Item& item : part.items) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], item.box.place(i));
      high[i] = std::max(high[i], item.box.place(i));
    }
  }
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    axis = high[i] - low[i] > high[axis] - low[axis] ? i : axis;
  }
  const float extent = high[axis] - low[axis];
  const auto bin_of = [&](const Item& item) {
    const float place = (item.box.place(axis) - low[axis]) / extent * static_cast<float>(kBins);
    return std::min(kBins - 1, static_cast<std::size_t>(place));
  };
  if (part.depth < kHeuristicDepth && extent > 0.0F) {
    std::array<Bin, kBins> bins;
    for (const Item& item : part.items) {
      Bin& bin = bins[bin_of(item)];
      bin.box.include(item.box);
      ++bin.count;
    }
    if (const std::size_t border = cheapest_split(bins); border > 0) {
      const auto middle = std::partition(part.items.begin(), part.items.end(),
                                         [&](const Item& item) { return bin_of(item) < border; });
      return static_cast<std::size_t>(middle - part.items.begin());
    }
  }
  const std::size_t half = part.items.size() / 2;
  std::nth_element(
      part.items.begin(), part.items.begin() + static_cast<std::ptrdiff_t>(half), part.items.end(),
      [&](const Item& a, const Item& b) { return a.box.place(axis) < b.box.place(axis); });
  return half;
}

}  // namespace

class Bvh::Builder {
 public:
  Builder(std::vector<Node>& nodes, std::vector<std::uint32_t>& order)
      : nodes_(nodes), order_(order) {}

  void build(const Part& whole) {
    const std::size_t here = nodes_.size();
    nodes_.push_back(empty_node());
    std::array<Part, kWidth> parts;
    const std::size_t count = split_in_eight(whole, parts);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const Part& part = parts[lane];
      const bool is_leaf = part.items.size() == 1;
      for (std::size_t i = 0; i < 3; ++i) {
        nodes_[here].min[i][lane] = part.box.min[i];
        nodes_[here].max[i][lane] = part.box.max[i];
      }
      nodes_[here].child[lane] = is_leaf ? kLeaf + static_cast<std::uint32_t>(order_.size())
                                         : static_cast<std::uint32_t>(nodes_.size());
      if (is_leaf) {
        order_.push_back(part.items.front().index);
      } else {
        build(part);
      }
    }
  }

 private:
  static Node empty_node() {
    Node node;
    for (std::size_t i = 0; i < 3; ++i) {
      node.min[i].fill(kFloatInfinity);
      node.max[i].fill(-kFloatInfinity);
    }
    node.child.fill(0);
    return node;
  }

  /// Splits what is likeliest to be met until there are eight parts or nothing left to split.
  static std::size_t split_in_eight(const Part& whole, std::array<Part, kWidth>& parts) {
    parts[0] = whole;
    std::size_t count = 1;
    while (count < kWidth) {
      std::size_t largest = kWidth;
      for (std::size_t i = 0; i < count; ++i) {
        const bool larger =
            largest == kWidth || parts[i].box.half_surface() > parts[largest].box.half_surface();
        if (parts[i].items.size() > 1 && larger) {
          largest = i;
        }
      }
      if (largest == kWidth) {
        break;
      }
      const Part part = parts[largest];
      const std::size_t left = split(part);
      parts[largest] = part_of(part.items.first(left), part.depth + 1);
      parts[count++] = part_of(part.items.subspan(left), part.depth + 1);
    }
    return count;
  }

  std::vector<Node>& nodes_;
  std::vector<std::uint32_t>& order_;
};

std::vector<Box> triangle_boxes(const Mesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    Box box;
    for (const std::uint32_t vertex : triangle) {
      box.include(mesh.vertices[vertex]);
    }
    boxes.push_back(box);
  }
  return boxes;
}

Bvh::Bvh(std::vector<Box> boxes) {
  G31_EXPECTS(boxes.size() < kLeaf);
  if (boxes.empty()) {
    return;
  }
  for (const Box& box : boxes) {
    bounds_.include(box);
  }
  middle_ = 0.5 * (bounds_.min + bounds_.max);
  size_ = (bounds_.max - bounds_.min).norm();
  std::vector<Item> items(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    items[i] = {small_box(boxes[i], middle_), static_cast<std::uint32_t>(i)};
  }
  std::vector<Box>().swap(boxes);
  nodes_.reserve(items.size() / 5 + 1);
  order_.reserve(items.size());
  Builder(nodes_, order_).build(part_of(items, 0));
  nodes_.shrink_to_fit();
}

std::size_t Bvh::memory_bytes() const {
  return nodes_.capacity() * sizeof(Node) + order_.capacity() * sizeof(std::uint32_t);
}

}  // namespace g31::parts

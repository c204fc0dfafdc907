#include "parts/geometry/bvh.h"

#include <array>
#include <limits>

#include "machine/base/contract.h"
#include "parts/geometry/split_boxes.h"

namespace g31::parts {

class Bvh::Builder {
 public:
  Builder(std::vector<Node>& nodes, std::vector<std::uint32_t>& order)
      : nodes_(nodes), order_(order) {}

  void build(const BoxGroup& whole) {
    const std::size_t here = nodes_.size();
    nodes_.push_back(empty_node());
    std::array<BoxGroup, kWidth> parts;
    const std::size_t count = split_in_eight(whole, parts);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const BoxGroup& part = parts[lane];
      const bool is_leaf = part.items.size() == 1;
      for (std::size_t i = 0; i < 3; ++i) {
        nodes_[here].min[i][lane] = part.box.min[i];
        nodes_[here].max[i][lane] = part.box.max[i];
      }
      nodes_[here].child[lane] = is_leaf ? kLeaf + static_cast<std::uint32_t>(order_.size())
                                         : static_cast<std::uint32_t>(nodes_.size());
      if (is_leaf) {
        order_.push_back(part.items.front().index());
      } else {
        build(part);
      }
    }
  }

 private:
  static Node empty_node() {
    constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
    Node node;
    for (std::size_t i = 0; i < 3; ++i) {
      node.min[i].fill(kFloatInfinity);
      node.max[i].fill(-kFloatInfinity);
    }
    node.child.fill(0);
    return node;
  }

  /// Splits what is likeliest to be met until there are eight parts or nothing left to split.
  static std::size_t split_in_eight(const BoxGroup& whole, std::array<BoxGroup, kWidth>& parts) {
    parts[0] = whole;
    std::size_t count = 1;
    while (count < kWidth) {
      std::size_t largest = kWidth;
      for (std::size_t i = 0; i < count; ++i) {
        const bool larger = largest == kWidth || parts[i].surface > parts[largest].surface;
        if (parts[i].items.size() > 1 && larger) {
          largest = i;
        }
      }
      if (largest == kWidth) {
        break;
      }
      const auto [left, right] = split_in_two(parts[largest]);
      parts[largest] = left;
      parts[count++] = right;
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
  std::vector<BoxItem> items;
  items.reserve(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    items.emplace_back(boxes[i], middle_, static_cast<std::uint32_t>(i));
  }
  std::vector<Box>().swap(boxes);
  // More than most trees need, and what is not used is never touched; growing would for a moment
  // take the memory twice.
  nodes_.reserve(items.size() / 3 + 1);
  order_.reserve(items.size());
  Builder(nodes_, order_).build(group_of(items, 0));
}

bool Bvh::may_meet(const Path& path, double reach) const {
  return !nodes_.empty() && !PathQuery(*this, path, Point::Constant(reach)).misses();
}

std::size_t Bvh::memory_bytes() const {
  return nodes_.size() * sizeof(Node) + order_.size() * sizeof(std::uint32_t);
}

}  // namespace g31::parts

#include "parts/geometry/bvh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <deque>
#include <limits>
#include <mutex>
#include <utility>

#include "machine/base/contract.h"
#include "parts/geometry/split_boxes.h"

namespace g31::parts {
namespace {

/// Boxes in a branch that is made when a query comes to it.
constexpr std::size_t kBranchBoxes = 1024;

/// A node has eight children or none but leaves, two at least: from that it follows.
constexpr std::size_t most_nodes(std::size_t boxes) {
  return boxes * 4 / 7 + 1;
}

}  // namespace

/// Makes nodes one after the other.
class Bvh::Builder {
 public:
  Builder(Node* nodes, std::uint32_t first) : nodes_(nodes), next_(first) {}

  /// Where the next node goes.
  [[nodiscard]] std::uint32_t next() const { return next_; }

  /// @param end_of  what becomes of a part: kLeaf + slot, kBranch + its number, or 0: it is a node
  template <typename EndOf>
  void build(const BoxGroup& whole, const EndOf& end_of) {
    Node& here = nodes_[next_++] = empty_node();
    std::array<BoxGroup, kWidth> parts;
    const std::size_t count = split_in_eight(whole, parts);
    for (std::size_t lane = 0; lane < count; ++lane) {
      const BoxGroup& part = parts[lane];
      for (std::size_t i = 0; i < 3; ++i) {
        here.min[i][lane] = part.box.min[i];
        here.max[i][lane] = part.box.max[i];
      }
      const std::uint32_t end = end_of(part);
      here.child[lane] = end != 0 ? end : next_;
      if (end == 0) {
        build(part, end_of);
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

  Node* nodes_;
  std::uint32_t next_;
};

/// What of a tree is not made before it is asked for.
class Bvh::Branches {
 public:
  explicit Branches(std::vector<BoxItem> items) : items_(std::move(items)) {}

  [[nodiscard]] std::span<BoxItem> items() { return items_; }

  /// Takes a group for later; returns its number.
  std::uint32_t add(const BoxGroup& group) {
    Branch& branch = all_.emplace_back();
    branch.items = group.items;
    branch.depth = group.depth;
    return static_cast<std::uint32_t>(all_.size() - 1);
  }

  /// Gives every branch its room from a node on; returns where the room of all ends.
  std::uint32_t place_from(std::uint32_t node) {
    for (Branch& branch : all_) {
      branch.root = node;
      node += static_cast<std::uint32_t>(most_nodes(branch.items.size()));
    }
    return node;
  }

  std::uint32_t root_of(std::uint32_t number, Node* nodes) {
    Branch& branch = all_[number];
    std::call_once(branch.made, [&] {
      Builder builder(nodes, branch.root);
      builder.build(group_of(branch.items, branch.depth), [](const BoxGroup& part) {
        return part.items.size() == 1 ? kLeaf + part.items.front().index() : 0;
      });
      nodes_made_ += builder.next() - branch.root;
    });
    return branch.root;
  }

  [[nodiscard]] std::size_t nodes_made() const { return nodes_made_; }
  [[nodiscard]] std::size_t memory_bytes() const {
    return items_.size() * sizeof(BoxItem) + all_.size() * sizeof(Branch);
  }

 private:
  struct Branch {
    std::once_flag made;
    std::span<BoxItem> items;
    int depth = 0;
    std::uint32_t root = 0;
  };

  std::vector<BoxItem> items_;
  std::deque<Branch> all_;
  std::atomic<std::size_t> nodes_made_ = 0;
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

Bvh::Bvh() = default;
Bvh::Bvh(Bvh&&) noexcept = default;
Bvh& Bvh::operator=(Bvh&&) noexcept = default;
Bvh::~Bvh() = default;

Bvh::Bvh(std::vector<Box> boxes, Growth growth) {
  G31_EXPECTS(boxes.size() < kBranch);
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
  if (growth == Growth::AtOnce) {
    build_whole(items);
  } else {
    build_stem(std::move(items));
  }
}

void Bvh::build_whole(std::vector<BoxItem>& items) {
  order_.reserve(items.size());
  // What is not used is never touched, and no node ever moves.
  nodes_ = std::make_unique_for_overwrite<Node[]>(most_nodes(items.size()));
  Builder builder(nodes_.get(), 0);
  builder.build(group_of(items, 0), [&](const BoxGroup& part) -> std::uint32_t {
    if (part.items.size() > 1) {
      return 0;
    }
    order_.push_back(part.items.front().index());
    return kLeaf + static_cast<std::uint32_t>(order_.size() - 1);
  });
  node_count_ = builder.next();
}

void Bvh::build_stem(std::vector<BoxItem> items) {
  const std::size_t count = items.size();
  branches_ = std::make_unique<Branches>(std::move(items));
  const auto stem = std::make_unique_for_overwrite<Node[]>(most_nodes(count));
  Builder builder(stem.get(), 0);
  builder.build(group_of(branches_->items(), 0), [&](const BoxGroup& part) -> std::uint32_t {
    return part.items.size() == 1              ? kLeaf + part.items.front().index()
           : part.items.size() <= kBranchBoxes ? kBranch + branches_->add(part)
                                               : 0;
  });
  node_count_ = builder.next();
  nodes_ = std::make_unique_for_overwrite<Node[]>(branches_->place_from(node_count_));
  std::copy_n(stem.get(), node_count_, nodes_.get());
}

std::uint32_t Bvh::root_of_branch(std::uint32_t branch) const {
  return branches_->root_of(branch, nodes_.get());
}

bool Bvh::may_meet(const Path& path, double reach) const {
  return nodes_ != nullptr && !PathQuery(*this, path, Point::Constant(reach)).misses();
}

std::size_t Bvh::memory_bytes() const {
  const std::size_t order = order_.size() * sizeof(std::uint32_t);
  return branches_ == nullptr
             ? node_count_ * sizeof(Node) + order
             : (node_count_ + branches_->nodes_made()) * sizeof(Node) + branches_->memory_bytes();
}

}  // namespace g31::parts

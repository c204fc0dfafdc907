#include "parts/geometry/bvh.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <utility>

#include "machine/base/contract.h"
#include "parts/geometry/split_boxes.h"

namespace g31::parts {
namespace {

/// Twigs of a branch that is made when a query comes to it, where the owner does not say.
constexpr std::size_t kBranchTwigs = 1024;

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
  /// @param items  of the branches to be added
  explicit Branches(std::vector<BoxItem> items) : items_(std::move(items)) {}
  Branches(std::vector<BoxItem> items, Grow grow)
      : items_(std::move(items)), grow_(std::move(grow)) {}

  /// Twigs, or a box for each branch that the owner lets grow.
  [[nodiscard]] std::span<BoxItem> items() { return items_; }

  /// Takes a group for later; returns its number.
  std::uint32_t add(const BoxGroup& group) {
    Branch& branch = all_.emplace_back();
    branch.items = group.items;
    branch.depth = group.depth;
    return static_cast<std::uint32_t>(all_.size() - 1);
  }

  /// @param middle  of the tree
  const Node* nodes_of(std::uint32_t number, const Point& middle) {
    Branch& branch = all_[number];
    if (!branch.is_made.load(std::memory_order_acquire)) {
      std::call_once(branch.once, [&] {
        branch.nodes = grow_ ? grown(branch, middle) : made(branch.items, branch.depth);
        branch.is_made.store(true, std::memory_order_release);
      });
    }
    return branch.nodes.get();
  }

  [[nodiscard]] std::size_t memory_bytes() const {
    return items_.size() * sizeof(BoxItem) + all_.size() * sizeof(Branch) +
           nodes_made_ * sizeof(Node);
  }

 private:
  using Nodes = std::unique_ptr<Node[]>;  // NOLINT(modernize-avoid-c-arrays): room of known size
  struct Branch {
    std::atomic<bool> is_made = false;
    std::once_flag once;
    int depth = 0;
    std::span<BoxItem> items;
    Nodes nodes;
  };

  Nodes grown(const Branch& branch, const Point& middle) {
    constexpr std::size_t kMostTwigs = 1U << 20U;
    const std::vector<Twig> twigs = grow_(branch.items.front().index());
    if (twigs.empty()) {
      return nullptr;
    }
    G31_EXPECTS(twigs.size() < kMostTwigs);
    std::vector<BoxItem> items;
    items.reserve(twigs.size());
    for (const Twig& twig : twigs) {
      items.emplace_back(twig.box, middle, twig.slot);
    }
    return made(items, branch.depth);
  }

  Nodes made(std::span<BoxItem> items, int depth) {
    const auto room = std::make_unique_for_overwrite<Node[]>(most_nodes(items.size()));
    Builder builder(room.get(), 0);
    builder.build(group_of(items, depth), [](const BoxGroup& part) {
      return part.items.size() == 1 ? kLeaf + part.items.front().index() : 0;
    });
    Nodes nodes = std::make_unique_for_overwrite<Node[]>(builder.next());
    std::copy_n(room.get(), builder.next(), nodes.get());
    nodes_made_ += builder.next();
    return nodes;
  }

  std::vector<BoxItem> items_;
  std::deque<Branch> all_;
  Grow grow_;
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

namespace {

const Box& box_of(const Box& box) {
  return box;
}
const Box& box_of(const Bvh::Twig& twig) {
  return twig.box;
}
std::uint32_t slot_of(const Box&, std::uint32_t number) {
  return number;
}
std::uint32_t slot_of(const Bvh::Twig& twig, std::uint32_t) {
  return twig.slot;
}

}  // namespace

template <typename Boxes>
std::vector<BoxItem> Bvh::items_of(Boxes boxes) {
  G31_EXPECTS(boxes.size() < kBranch);
  for (const auto& box : boxes) {
    bounds_.include(box_of(box));
  }
  middle_ = 0.5 * (bounds_.min + bounds_.max);
  size_ = (bounds_.max - bounds_.min).norm();
  std::vector<BoxItem> items;
  items.reserve(boxes.size());
  for (const auto& box : boxes) {
    const auto number = static_cast<std::uint32_t>(items.size());
    items.emplace_back(box_of(box), middle_, slot_of(box, number));
  }
  return items;
}

Bvh::Bvh(std::vector<Box> boxes, const GoesOn& goes_on) {
  if (boxes.empty()) {
    return;
  }
  std::vector<BoxItem> items = items_of(std::move(boxes));
  order_.reserve(items.size());
  // What is not used is never touched, and no node ever moves.
  nodes_ = std::make_unique_for_overwrite<Node[]>(most_nodes(items.size()));
  Builder builder(nodes_.get(), 0);
  Steps steps(goes_on);
  builder.build(group_of(items, 0), [&](const BoxGroup& part) -> std::uint32_t {
    steps.step();
    if (part.items.size() > 1) {
      return 0;
    }
    order_.push_back(part.items.front().index());
    return kLeaf + static_cast<std::uint32_t>(order_.size() - 1);
  });
  node_count_ = builder.next();
}

Bvh::Bvh(std::vector<Twig> twigs) {
  if (!twigs.empty()) {
    build_stem(std::make_unique<Branches>(items_of(std::move(twigs))), kBranchTwigs);
  }
}

Bvh::Bvh(std::vector<Box> branches, Grow grow) {
  if (!branches.empty()) {
    build_stem(std::make_unique<Branches>(items_of(std::move(branches)), std::move(grow)), 1);
  }
}

/// @param together  items that make a branch
void Bvh::build_stem(std::unique_ptr<Branches> branches, std::size_t together) {
  branches_ = std::move(branches);
  const std::span<BoxItem> items = branches_->items();
  const auto room = std::make_unique_for_overwrite<Node[]>(most_nodes(items.size()));
  Builder builder(room.get(), 0);
  builder.build(group_of(items, 0), [&](const BoxGroup& part) -> std::uint32_t {
    const std::size_t count = part.items.size();
    return together > 1 && count == 1 ? kLeaf + part.items.front().index()
           : count <= together        ? kBranch + branches_->add(part)
                                      : 0;
  });
  node_count_ = builder.next();
  nodes_ = std::make_unique_for_overwrite<Node[]>(node_count_);
  std::copy_n(room.get(), node_count_, nodes_.get());
}

const Bvh::Node* Bvh::nodes_of_branch(std::uint32_t branch) const {
  return branches_->nodes_of(branch, middle_);
}

std::vector<Bvh::SlotRange> Bvh::ranges(const Together& together) const {
  std::vector<SlotRange> ranges;
  const auto all = static_cast<std::uint32_t>(order_.size());
  if (all > 0 && together(all, size_)) {
    ranges.push_back({0, all});
  } else if (all > 0) {
    add_ranges(0, all, together, ranges);
  }
  return ranges;
}

std::uint32_t Bvh::first_slot_of(std::uint32_t child) const {
  while ((child & kLeaf) == 0) {
    child = nodes_[child].child[0];
  }
  return child - kLeaf;
}

/// @param end  one behind the last slot below the node
void Bvh::add_ranges(std::uint32_t node, std::uint32_t end, const Together& together,
                     std::vector<SlotRange>& ranges) const {
  const Node& here = nodes_[node];
  for (std::size_t lane = 0; lane < kWidth && here.child[lane] != 0; ++lane) {
    const std::uint32_t child = here.child[lane];
    const std::uint32_t next = lane + 1 < kWidth ? here.child[lane + 1] : 0;
    const std::uint32_t first = first_slot_of(child);
    const std::uint32_t behind = next != 0 ? first_slot_of(next) : end;
    double squared = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double size = double{here.max[i][lane]} - double{here.min[i][lane]};
      squared += size * size;
    }
    if ((child & kLeaf) != 0 || together(behind - first, std::sqrt(squared))) {
      ranges.push_back({first, behind - first});
    } else {
      add_ranges(child, behind, together, ranges);
    }
  }
}

bool Bvh::may_meet(const Path& path, double reach) const {
  return nodes_ != nullptr && !PathQuery(*this, path, Point::Constant(reach)).misses();
}

std::size_t Bvh::memory_bytes() const {
  return node_count_ * sizeof(Node) + order_.size() * sizeof(std::uint32_t) +
         (branches_ == nullptr ? 0 : branches_->memory_bytes());
}

}  // namespace g31::parts

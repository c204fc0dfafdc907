#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"

namespace g31::parts {

/// An axis-aligned box, mm; an empty one until the first point is included.
struct Box {
  Point min = Point::Constant(std::numeric_limits<double>::infinity());
  Point max = Point::Constant(-std::numeric_limits<double>::infinity());

  void include(const Point& p) {
    min = min.cwiseMin(p);
    max = max.cwiseMax(p);
  }
  void include(const Box& box) {
    min = min.cwiseMin(box.min);
    max = max.cwiseMax(box.max);
  }
};

/// The box of each triangle of the mesh, in the order of the triangles.
std::vector<Box> triangle_boxes(const Mesh& mesh);

/// A straight path: the points from + s direction, 0 <= s <= length, mm.
struct Path {
  Point from;
  Point direction;  ///< unit vector
  double length = 0.0;
};

/// A bounding volume tree over boxes: which of them does a point or a path come near?
///
/// Binary, one flat array of nodes in depth-first order, split by the surface area heuristic.
/// How near is near is said at query time, so one tree serves every ball radius.  Immutable after
/// building: queries may run on many threads.
///
/// Queries speak of *slots*: slot i is box order()[i] of the list given.  Neighbouring slots are
/// neighbours in space, so the owner does well to keep his data in slot order.
class Bvh {
 public:
  explicit Bvh(std::span<const Box> boxes);

  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }

  /// Calls visit(slot) for every box within `reach` mm of the point; and, leaf-wise, for some more.
  template <typename Visit>
  void visit_near(const Point& p, double reach, Visit&& visit) const;

  /// Calls visit(slot) for every box that comes within `reach` mm of the path; and, leaf-wise, for
  /// some more.  Near boxes tend to come first.
  ///
  /// `visit` returns how far along the path is still of interest, mm: what a ball of radius `reach`
  /// meets behind a contact is not walked.  Roundoff of the tests is below 1e-15 of the
  /// coordinates; `reach` must include what the caller cannot afford to lose.
  template <typename Visit>
  void visit_along(const Path& path, double reach, Visit&& visit) const;

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< leaf: first slot; inner node: index of the right child
    std::uint32_t count = 0;  ///< leaf: number of slots; inner node: 0, left child is the next node
  };
  struct Item {
    Box box;
    Point centre;
    std::uint32_t index = 0;
  };
  /// Deeper than any tree build_node makes: kHeuristicDepth levels, then halves of 2^32 items.
  static constexpr std::size_t kMaxDepth = 96;
  static constexpr int kHeuristicDepth = 48;

  void build_node(std::span<Item> items, int depth);
  static std::size_t split(std::span<Item> items, int depth);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

namespace bvh_detail {

inline constexpr double kNever = std::numeric_limits<double>::infinity();

/// mm^2; 0 inside.
inline double squared_distance(const Box& box, const Point& p) {
  return (p - p.cwiseMax(box.min).cwiseMin(box.max)).squaredNorm();
}

/// A path prepared for the question when a ball of radius `reach` gets to a node at the earliest.
class Approach {
 public:
  Approach(const Path& path, double reach) : path_(path), reach_(reach) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      // A finite stand-in for 1/0: it keeps 0 * infinity = NaN out of the slab test.
      constexpr double kHuge = 1e300;
      const double d = path.direction[i];
      inverse_[i] = d > 1.0 / kHuge || d < -1.0 / kHuge ? 1.0 / d : kHuge;
    }
  }

  /// A lower bound in mm, kNever when it does not get there before `limit`.
  ///
  /// First the entry into the box grown by `reach`.  That is a box with square edges, far from the
  /// round one that counts where the box is small against `reach`, so then on in safe steps: what
  /// is still d away cannot be touched before d more have been travelled.
  [[nodiscard]] double earliest(const Box& box, double limit) const {
    constexpr int kSteps = 3;
    double s = 0.0;
    double far = limit;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const double a = (box.min[i] - reach_ - path_.from[i]) * inverse_[i];
      const double b = (box.max[i] + reach_ - path_.from[i]) * inverse_[i];
      const double low = a < b ? a : b;
      const double high = a < b ? b : a;
      s = low > s ? low : s;
      far = high < far ? high : far;
    }
    for (int step = 0; step < kSteps && s <= far; ++step) {
      const Point here = path_.from + s * path_.direction;
      const double squared = squared_distance(box, here);
      if (squared <= reach_ * reach_) {
        return s;
      }
      s += std::sqrt(squared) - reach_;
    }
    if (s > far) {
      return kNever;
    }
    return s;
  }

 private:
  const Path& path_;
  double reach_;
  Point inverse_;
};

}  // namespace bvh_detail

template <typename Visit>
void Bvh::visit_near(const Point& p, double reach, Visit&& visit) const {
  if (nodes_.empty()) {
    return;
  }
  std::array<std::uint32_t, kMaxDepth> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t here = stack[--waiting];
    const Node& node = nodes_[here];
    if (bvh_detail::squared_distance(node.box, p) > reach * reach) {
      continue;
    }
    for (std::uint32_t i = 0; i < node.count; ++i) {
      visit(node.first + i);
    }
    if (node.count == 0) {
      stack[waiting++] = node.first;
      stack[waiting++] = here + 1;
    }
  }
}

template <typename Visit>
void Bvh::visit_along(const Path& path, double reach, Visit&& visit) const {
  struct Waiting {
    double earliest;
    std::uint32_t node;
  };
  if (nodes_.empty()) {
    return;
  }
  const bvh_detail::Approach approach(path, reach);
  double limit = path.length;
  std::array<Waiting, kMaxDepth> stack;
  std::size_t waiting = 0;
  stack[waiting++] = {approach.earliest(nodes_[0].box, limit), 0};
  while (waiting > 0) {
    const Waiting now = stack[--waiting];
    if (!(now.earliest <= limit)) {
      continue;
    }
    const Node& node = nodes_[now.node];
    for (std::uint32_t i = 0; i < node.count; ++i) {
      limit = visit(node.first + i);
    }
    if (node.count == 0) {
      const Waiting left{approach.earliest(nodes_[now.node + 1].box, limit), now.node + 1};
      const Waiting right{approach.earliest(nodes_[node.first].box, limit), node.first};
      const bool left_first = left.earliest <= right.earliest;
      stack[waiting++] = left_first ? right : left;
      stack[waiting++] = left_first ? left : right;
    }
  }
}

}  // namespace g31::parts

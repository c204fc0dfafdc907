#pragma once

// The walk through the tree: bodies of the templates of bvh.h, which includes this file.

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "machine/base/contract.h"

namespace g31::parts {

/// Room for every tree that Builder makes: stem and branch together are at most 98 levels deep (48
/// by the heuristic, then in halves 2^30 and 2^20 boxes), each leaves seven behind.
class Bvh::Stack {
 public:
  [[nodiscard]] bool empty() const { return size_ == 0; }

  Waiting pop() { return entries_[--size_]; }

  /// Adds the children whose lane holds a finite number, the least one on top.
  void push(const Lanes& at, const Node& node, const Node* nodes) {
    G31_EXPECTS(size_ + kWidth <= kMostWaiting);
    const std::size_t bottom = size_;
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      if (at[lane] < std::numeric_limits<float>::infinity()) {
        std::size_t place = size_++;
        for (; place > bottom && entries_[place - 1].at < at[lane]; --place) {
          entries_[place] = entries_[place - 1];
        }
        entries_[place] = {at[lane], node.child[lane], nodes};
      }
    }
  }

 private:
  static constexpr std::size_t kMostWaiting = 704;
  std::array<Waiting, kMostWaiting> entries_;
  std::size_t size_ = 0;
};

class Bvh::PointQuery {
 public:
  PointQuery(const Bvh& tree, const Point& p, double reach) : loss_(kFloatLoss * tree.size_) {
    const Point from_middle = p - tree.middle_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      p_[axis] = static_cast<float>(from_middle[static_cast<Eigen::Index>(axis)]);
    }
    limit(reach);
  }

  /// mm^2
  void limit(double reach) {
    const double r = reach + loss_ + kFloatLoss * reach;
    squared_limit_ = static_cast<float>(r * r * (1.0 + kFloatLoss));
  }
  [[nodiscard]] float squared_limit() const { return squared_limit_; }

  /// The squared distance of each child that is in reach.
  [[nodiscard]] Lanes distances(const Node& node) const {
    Lanes squared;
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      float sum = 0.0F;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const float below = node.min[axis][lane] - p_[axis];
        const float above = p_[axis] - node.max[axis][lane];
        float outside = below > above ? below : above;
        outside = outside > 0.0F ? outside : 0.0F;
        sum += outside * outside;
      }
      squared[lane] = sum <= squared_limit_ ? sum : std::numeric_limits<float>::infinity();
    }
    return squared;
  }

 private:
  double loss_;
  std::array<float, 3> p_{};
  float squared_limit_ = 0.0F;
};

class Bvh::PathQuery {
 public:
  PathQuery(const Bvh& tree, const Path& path, const Point& reach)
      : size_(tree.size_ + reach.maxCoeff()) {
    const Point grown = reach + Point::Constant(kFloatLoss * size_);
    double leave = path.length;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double inverse = inverse_of(path.direction[axis]);
      const double a = (tree.bounds_.min[axis] - grown[axis] - path.from[axis]) * inverse;
      const double b = (tree.bounds_.max[axis] + grown[axis] - path.from[axis]) * inverse;
      enter_ = std::max(enter_, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    misses_ = !(enter_ <= leave);
    const Point from = path.from + enter_ * path.direction - tree.middle_;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      const double side = path.direction[i] < 0.0 ? -1.0 : 1.0;
      backwards_[axis] = side < 0.0;
      inverse_[axis] = static_cast<float>(inverse_of(path.direction[i]));
      near_from_[axis] = static_cast<float>(from[i] + side * grown[i]);
      far_from_[axis] = static_cast<float>(from[i] - side * grown[i]);
    }
    limit(path.length);
  }

  /// Whether the path passes by the whole tree.
  [[nodiscard]] bool misses() const { return misses_; }

  /// mm along the path
  void limit(double length) {
    limit_ = static_cast<float>((length - enter_) * (1.0 + kFloatLoss) + kFloatLoss * size_);
  }
  [[nodiscard]] float limit() const { return limit_; }

  /// How far along the path it enters each child, of those that it enters before the limit.
  [[nodiscard]] Lanes entries(const Node& node) const {
    Lanes enter;
    Lanes leave;
    enter.fill(0.0F);
    leave.fill(limit_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Lanes& near = backwards_[axis] ? node.max[axis] : node.min[axis];
      const Lanes& far = backwards_[axis] ? node.min[axis] : node.max[axis];
      for (std::size_t lane = 0; lane < kWidth; ++lane) {
        const float in = (near[lane] - near_from_[axis]) * inverse_[axis];
        const float out = (far[lane] - far_from_[axis]) * inverse_[axis];
        enter[lane] = in > enter[lane] ? in : enter[lane];
        leave[lane] = out < leave[lane] ? out : leave[lane];
      }
    }
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      enter[lane] =
          enter[lane] <= leave[lane] ? enter[lane] : std::numeric_limits<float>::infinity();
    }
    return enter;
  }

 private:
  /// With a finite stand-in for 1/0: it keeps 0 * infinity = NaN out of the slab test.
  static double inverse_of(double d) {
    constexpr double kHuge = 1e30;
    return std::fabs(d) > 1.0 / kHuge ? 1.0 / d : (d < 0.0 ? -kHuge : kHuge);
  }

  double size_;
  double enter_ = 0.0;  ///< mm along the path; the float lengths count from there
  bool misses_ = false;
  std::array<bool, 3> backwards_{};
  std::array<float, 3> inverse_{};
  std::array<float, 3> near_from_{};
  std::array<float, 3> far_from_{};
  float limit_ = 0.0F;
};

template <typename Push>
void Bvh::go_on(const Waiting& from, const Push& push) const {
  if ((from.child & kBranch) == 0) {
    push(from.nodes, from.child);
  } else if (const Node* const nodes = nodes_of_branch(from.child - kBranch)) {
    push(nodes, 0);
  }
}

template <typename Visit>
void Bvh::visit_near(const Point& p, double reach, Visit&& visit) const {
  const Point outside = (p - p.cwiseMax(bounds_.min).cwiseMin(bounds_.max));
  if (nodes_ == nullptr || outside.squaredNorm() > reach * reach) {
    return;
  }
  PointQuery query(*this, p, reach);
  Stack stack;
  const auto push = [&](const Node* nodes, std::uint32_t node) {
    stack.push(query.distances(nodes[node]), nodes[node], nodes);
  };
  push(nodes_.get(), 0);
  while (!stack.empty()) {
    const Waiting next = stack.pop();
    if (next.at > query.squared_limit()) {
      continue;
    }
    if ((next.child & kLeaf) != 0) {
      query.limit(visit(next.child - kLeaf));
    } else {
      go_on(next, push);
    }
  }
}

template <typename Visit>
void Bvh::visit_along(const Path& path, double reach, Visit&& visit) const {
  visit_along(path, Point(Point::Constant(reach)), std::forward<Visit>(visit));
}

template <typename Visit>
void Bvh::visit_along(const Path& path, const Point& reach, Visit&& visit) const {
  visit_along(
      path, reach, [] { return std::span<const Plane>(); }, std::forward<Visit>(visit));
}

template <typename Range>
void Bvh::leave_out_beyond(const Range& planes, const Node& node, Lanes& entries) const {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  for (const Plane& plane : planes) {
    const auto limit =
        static_cast<float>(plane.limit - plane.normal.dot(middle_) + kFloatLoss * size_);
    Lanes nearest;
    nearest.fill(0.0F);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto across = static_cast<float>(plane.normal[static_cast<Eigen::Index>(axis)]);
      const Lanes& near = across < 0.0F ? node.max[axis] : node.min[axis];
      for (std::size_t lane = 0; lane < kWidth; ++lane) {
        nearest[lane] += across * near[lane];
      }
    }
    float first = kNone;
    for (std::size_t lane = 0; lane < kWidth; ++lane) {
      entries[lane] = nearest[lane] > limit ? kNone : entries[lane];
      first = entries[lane] < first ? entries[lane] : first;
    }
    if (first == kNone) {
      return;
    }
  }
}

template <typename Planes, typename Visit>
void Bvh::visit_along(const Path& path, const Point& reach, Planes&& planes, Visit&& visit) const {
  if (nodes_ == nullptr) {
    return;
  }
  PathQuery query(*this, path, reach);
  if (query.misses()) {
    return;
  }
  Stack stack;
  const auto push = [&](const Node* nodes, std::uint32_t node) {
    Lanes entries = query.entries(nodes[node]);
    leave_out_beyond(planes(), nodes[node], entries);
    stack.push(entries, nodes[node], nodes);
  };
  push(nodes_.get(), 0);
  while (!stack.empty()) {
    const Waiting next = stack.pop();
    if (next.at > query.limit()) {
      continue;
    }
    if ((next.child & kLeaf) != 0) {
      query.limit(visit(next.child - kLeaf));
    } else {
      go_on(next, push);
    }
  }
}

}  // namespace g31::parts

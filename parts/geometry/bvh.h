#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "parts/geometry/box.h"
#include "parts/geometry/goes_on.h"

namespace g31::parts {

class BoxItem;

/// A plane and what is beyond it: the points with normal . p > limit.
struct Plane {
  Point normal;        ///< unit vector
  double limit = 0.0;  ///< mm
};

/// A bounding volume tree over boxes: which of them does a point or a path come near?
///
/// Eight boxes a node, tested at once, in float32 about the middle of all; whatever float32 loses
/// is added to the boxes again when they are tested, so no box is ever left out (some are visited
/// that are up to 2^-19 of the tree's size out of reach).  224 bytes a node, about 36 bytes a box.
/// Split by the surface area heuristic.  Queries may run on many threads, and find the same
/// whenever the nodes were made.
///
/// Queries speak of *slots*: slot i is box order()[i] of the list given, and neighbouring slots are
/// neighbours in space: the owner does well to keep his data so.  Of a tree that grows where
/// queries come, slots are what its owner says.
class Bvh {
 public:
  /// What a branch holds that is made when a query first comes to it.
  struct Twig {
    Box box;                 ///< not empty, mm
    std::uint32_t slot = 0;  ///< less than 2^31
  };
  /// Gives the twigs of a branch, fewer than 2^20; asked at most once for each, from any thread.
  using Grow = std::function<std::vector<Twig>(std::uint32_t branch)>;
  /// Slots that lie together: from `first` on.
  struct SlotRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };

  Bvh();
  /// @param boxes  none empty; fewer than 2^30; given up before the tree takes memory of its own
  /// @throws BrokenOff  as `goes_on` has it
  explicit Bvh(std::vector<Box> boxes, const GoesOn& goes_on = {});
  /// A tree that grows where queries come, by a thousand twigs.
  explicit Bvh(std::vector<Twig> twigs);
  /// A tree that grows where queries come, as its owner says.
  ///
  /// @param branches  a box for each: a query that meets it comes to the branch
  Bvh(std::vector<Box> branches, Grow grow);
  Bvh(Bvh&&) noexcept;
  Bvh& operator=(Bvh&&) noexcept;
  ~Bvh();

  /// Empty where the owner says what slots are.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }

  /// Whether so many slots may stay together whose boxes lie in one of that diagonal, mm.
  using Together = std::function<bool(std::uint32_t count, double diagonal)>;

  /// All slots, by branches of the tree as large as may be.
  [[nodiscard]] std::vector<SlotRange> ranges(const Together& together) const;

  /// Calls visit(slot) for every box within `reach` mm of the point, nearest boxes first.
  ///
  /// `visit` returns the reach that is still of interest, mm, never more than before.
  template <typename Visit>
  void visit_near(const Point& p, double reach, Visit&& visit) const;

  /// Calls visit(slot) for every box that, grown by `reach` mm on all sides, the path meets.  Near
  /// boxes tend to come first.
  ///
  /// `visit` returns how far along the path is still of interest, mm, never more than before: what
  /// begins behind a contact is not walked.
  template <typename Visit>
  void visit_along(const Path& path, double reach, Visit&& visit) const;

  /// The same with a reach of its own along X, Y and Z: what a box that goes along the path, with
  /// its middle on it, meets.
  template <typename Visit>
  void visit_along(const Path& path, const Point& reach, Visit&& visit) const;

  /// The same, leaving out boxes that lie wholly beyond a plane; in the same order.
  ///
  /// @param planes  gives a range of Plane when asked, for each node anew
  template <typename Planes, typename Visit>
  void visit_along(const Path& path, const Point& reach, Planes&& planes, Visit&& visit) const;

  /// Whether the path comes within `reach` mm of the box around everything.  "No" is certain.
  [[nodiscard]] bool may_meet(const Path& path, double reach) const;

  /// Of what is made by now.
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  static constexpr std::size_t kWidth = 8;
  using Lanes = std::array<float, kWidth>;

  /// Boxes of eight children, relative to middle_; lanes without a child hold an inside-out box.
  struct alignas(32) Node {
    std::array<Lanes, 3> min;
    std::array<Lanes, 3> max;
    std::array<std::uint32_t, kWidth> child;  ///< kLeaf + slot, kBranch + its number, or a node's
  };
  struct Waiting {
    float at;  ///< how soon or how near
    std::uint32_t child;
    const Node* nodes;  ///< of the stem or of the branch that the child is in
  };
  /// The nodes still to be looked at, nearest on top.
  class Stack;
  class Builder;
  class Branches;
  /// A point or a path of points as the nodes see it.
  class PointQuery;
  class PathQuery;

  /// Takes children beyond a plane out of those that a path enters.
  template <typename Range>
  void leave_out_beyond(const Range& planes, const Node& node, Lanes& entries) const;

  /// Calls push(nodes, number) for the node that a child is, or the root of a branch.
  template <typename Push>
  void go_on(const Waiting& from, const Push& push) const;

  /// The nodes of a branch, its root first; null for an empty one.  Makes them for the first query.
  [[nodiscard]] const Node* nodes_of_branch(std::uint32_t branch) const;
  void build_stem(std::unique_ptr<Branches> branches, std::size_t together);
  /// Measures them all.  @param boxes  or twigs; their memory is given back
  template <typename Boxes>
  [[nodiscard]] std::vector<BoxItem> items_of(Boxes boxes);
  [[nodiscard]] std::uint32_t first_slot_of(std::uint32_t child) const;
  void add_ranges(std::uint32_t node, std::uint32_t end, const Together& together,
                  std::vector<SlotRange>& ranges) const;

  static constexpr std::uint32_t kLeaf = 0x8000'0000U;
  static constexpr std::uint32_t kBranch = 0x4000'0000U;
  /// Added to every reach, of the size of the numbers that meet in float32 (2^-24 each).
  static constexpr double kFloatLoss = 0x1p-20;

  std::unique_ptr<Node[]> nodes_;  // NOLINT(modernize-avoid-c-arrays): room that nobody touches
  std::uint32_t node_count_ = 0;
  std::unique_ptr<Branches> branches_;
  std::vector<std::uint32_t> order_;
  Box bounds_;
  Point middle_ = Point::Zero();
  double size_ = 0.0;  ///< mm, diagonal of bounds_
};

}  // namespace g31::parts

#include "parts/geometry/bvh_queries.h"  // the bodies of the templates

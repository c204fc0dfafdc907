#include "parts/geometry/crossing_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "parts/geometry/bvh.h"
#include "parts/geometry/facet_normal.h"

namespace g31::parts {
namespace {

/// A facet with its plane.
struct FacetInPlane {
  std::array<Point, 3> corners;
  Point normal;  ///< unit vector
};

/// How far the corners are above a plane, mm.
using Heights = std::array<double, 3>;

/// Where a facet is on a line, mm along it.
struct Chord {
  double from = 0.0;
  double to = 0.0;
};

std::optional<FacetInPlane> facet_of(const Mesh& mesh, std::uint32_t t) {
  const auto normal = facet_normal(mesh, t);
  if (!normal) {
    return std::nullopt;
  }
  const auto& v = mesh.triangles[t];
  return FacetInPlane{{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]}, *normal};
}

/// nullopt: the facet is not on both sides of the plane, each by more than `little`.
std::optional<Heights> heights_above(const FacetInPlane& plane, const FacetInPlane& facet,
                                     double little) {
  Heights heights{};
  for (std::size_t i = 0; i < 3; ++i) {
    heights.at(i) = plane.normal.dot(facet.corners.at(i) - plane.corners[0]);
  }
  const auto [low, high] = std::ranges::minmax(heights);
  return low < -little && high > little ? std::optional(heights) : std::nullopt;
}

/// What of a facet lies in a plane that it goes through, along the line `direction` in the plane.
Chord chord_in(const FacetInPlane& facet, const Heights& heights, const Point& direction) {
  Chord chord{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const double low = heights.at(i);
    const double high = heights.at(next);
    if ((low > 0.0) == (high > 0.0)) {
      continue;
    }
    const double share = low / (low - high);
    const Point p = facet.corners.at(i) + share * (facet.corners.at(next) - facet.corners.at(i));
    chord.from = std::min(chord.from, direction.dot(p));
    chord.to = std::max(chord.to, direction.dot(p));
  }
  return chord;
}

/// Both facets go through the plane of the other one: then they cross where their pieces of the
/// line in both planes lie over each other.  T. Moeller, Journal of Graphics Tools 2 (1997) 25.
bool cross(const FacetInPlane& a, const FacetInPlane& b, double little) {
  const auto of_b = heights_above(a, b, little);
  const auto of_a = of_b ? heights_above(b, a, little) : std::nullopt;
  if (!of_a) {
    return false;
  }
  const Point direction = a.normal.cross(b.normal).normalized();
  const Chord in_b = chord_in(a, *of_a, direction);
  const Chord in_a = chord_in(b, *of_b, direction);
  return std::min(in_a.to, in_b.to) - std::max(in_a.from, in_b.from) > little;
}

/// Two facets of one plane that face the same way and lie over each other: across the sides of
/// neither of them, in the plane, is there a line that parts them.
bool lie_over(const FacetInPlane& a, const FacetInPlane& b, double little) {
  if (a.normal.dot(b.normal) <= 0.0) {
    return false;  // pieces that stand on each other
  }
  for (const Point& p : b.corners) {
    if (std::abs(a.normal.dot(p - a.corners[0])) > little) {
      return false;
    }
  }
  // Facets that only abut may do so inexactly.
  const double least = 16.0 * little;
  for (const FacetInPlane* const facet : {&a, &b}) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point side = facet->corners.at((i + 1) % 3) - facet->corners.at(i);
      const Point across = a.normal.cross(side).normalized();
      const auto along = [&](const Point& p) { return across.dot(p); };
      const auto [a_low, a_high] = std::ranges::minmax(a.corners, {}, along);
      const auto [b_low, b_high] = std::ranges::minmax(b.corners, {}, along);
      if (std::min(along(a_high), along(b_high)) - std::max(along(a_low), along(b_low)) <= least) {
        return false;
      }
    }
  }
  return true;
}

int common_corners(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  return static_cast<int>(std::ranges::count_if(
      a, [&](std::uint32_t corner) { return std::ranges::find(b, corner) != b.end(); }));
}

bool meet(const Box& a, const Box& b) {
  return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// Facets that are neighbours in space look for theirs together: one walk of the tree for a dozen
/// facets in place of one for each.
class CrossingSearch {
 public:
  CrossingSearch(const Mesh& mesh, std::uint64_t most_compared)
      : mesh_(mesh),
        most_compared_(most_compared),
        tree_(triangle_boxes(mesh)),
        boxes_(tree_.order().size()),
        crosses_(mesh.triangles.size(), false) {
    double largest = 0.0;
    for (const Point& p : mesh.vertices) {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    little_ = 0x1p-22 * largest;
    const std::vector<Box> boxes = triangle_boxes(mesh);
    std::ranges::transform(tree_.order(), boxes_.begin(), [&](auto t) { return boxes[t]; });
  }

  CrossingFacets find() {
    CrossingFacets found;
    const auto together = [](std::uint32_t count, double /*diagonal*/) { return count <= kGroup; };
    for (const Bvh::SlotRange& group : tree_.ranges(together)) {
      if (compared_ > most_compared_) {
        break;
      }
      look_at(group);
      found.looked_at += group.count;
    }
    for (std::uint32_t t = 0; t < crosses_.size(); ++t) {
      if (crosses_[t]) {
        found.facets.push_back(t);
      }
    }
    return found;
  }

 private:
  static constexpr std::uint32_t kGroup = 16;

  /// Each facet of the group with each that lies behind it in the tree.
  void look_at(const Bvh::SlotRange& group) {
    Box all = boxes_[group.first];
    for (std::uint32_t slot = group.first; slot < group.first + group.count; ++slot) {
      all.min = all.min.cwiseMin(boxes_[slot].min);
      all.max = all.max.cwiseMax(boxes_[slot].max);
    }
    near_.clear();
    const Path middle{0.5 * (all.min + all.max), Point::UnitX(), 0.0};
    tree_.visit_along(middle, Point(0.5 * (all.max - all.min)), [&](std::uint32_t slot) {
      if (slot > group.first && meet(all, boxes_[slot])) {
        near_.push_back(slot);
      }
      return 0.0;
    });
    for (std::uint32_t slot = group.first; slot < group.first + group.count; ++slot) {
      look_near(slot);
    }
  }

  void look_near(std::uint32_t slot) {
    const std::uint32_t t = tree_.order()[slot];
    const auto facet = facet_of(mesh_, t);
    if (!facet) {
      return;
    }
    compared_ += near_.size();
    for (const std::uint32_t later : near_) {
      const std::uint32_t other = tree_.order()[later];
      if (later > slot && !crosses_[std::min(t, other)] && meet(boxes_[slot], boxes_[later])) {
        compared_ += kTestOfTwo;
        crosses_[std::min(t, other)] = go_through(*facet, t, other);
      }
    }
  }

  bool go_through(const FacetInPlane& facet, std::uint32_t t, std::uint32_t other) const {
    if (is_beside(facet, other) || common_corners(mesh_.triangles[t], mesh_.triangles[other]) > 1) {
      return false;
    }
    const auto second = facet_of(mesh_, other);
    return second && (cross(facet, *second, little_) || lie_over(facet, *second, little_));
  }

  /// Whether a facet is on one side of a plane, and not in it: most are.
  bool is_beside(const FacetInPlane& plane, std::uint32_t other) const {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::uint32_t corner : mesh_.triangles[other]) {
      const double height = plane.normal.dot(mesh_.vertices[corner] - plane.corners[0]);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return (low >= -little_ && high > little_) || (high <= little_ && low < -little_);
  }

  static constexpr std::uint64_t kTestOfTwo = 16;  ///< comparisons of boxes in the same time

  const Mesh& mesh_;
  std::uint64_t most_compared_;
  Bvh tree_;
  std::vector<Box> boxes_;     ///< by slots of the tree
  std::vector<bool> crosses_;  ///< by facets of the mesh
  double little_ = 0.0;
  std::uint64_t compared_ = 0;
  std::vector<std::uint32_t> near_;  ///< slots near the group at hand
};

}  // namespace

CrossingFacets crossing_facets(const Mesh& mesh, std::uint64_t most_compared) {
  const bool is_judged =
      !mesh.triangles.empty() && mesh.triangles.size() <= kMostFacetsForCrossings;
  return is_judged ? CrossingSearch(mesh, most_compared).find() : CrossingFacets{};
}

}  // namespace g31::parts

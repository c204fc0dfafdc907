#include "parts/geometry/crossing_facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

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

class CrossingSearch {
 public:
  CrossingSearch(const Mesh& mesh, std::uint64_t most_pairs)
      : mesh_(mesh), most_pairs_(most_pairs), boxes_(triangle_boxes(mesh)), tree_(boxes_) {
    double largest = 0.0;
    for (const Point& p : mesh.vertices) {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    little_ = 0x1p-22 * largest;
  }

  CrossingFacets find() {
    CrossingFacets found;
    for (std::uint32_t t = 0; t < mesh_.triangles.size() && pairs_ <= most_pairs_; ++t) {
      if (crosses_later_one(t)) {
        found.facets.push_back(t);
      }
      ++found.looked_at;
    }
    return found;
  }

 private:
  bool crosses_later_one(std::uint32_t t) {
    const auto facet = facet_of(mesh_, t);
    if (!facet) {
      return false;
    }
    const Box& box = boxes_[t];
    const Path here{0.5 * (box.min + box.max), Point::UnitX(), 0.0};
    bool crosses = false;
    tree_.visit_along(here, Point(0.5 * (box.max - box.min)), [&](std::uint32_t slot) {
      const std::uint32_t other = tree_.order()[slot];
      if (other > t && !crosses) {
        ++pairs_;
        const bool hang_together = common_corners(mesh_.triangles[t], mesh_.triangles[other]) > 1;
        const auto second = hang_together ? std::nullopt : facet_of(mesh_, other);
        crosses = second && (cross(*facet, *second, little_) || lie_over(*facet, *second, little_));
      }
      return 0.0;
    });
    return crosses;
  }

  const Mesh& mesh_;
  std::uint64_t most_pairs_;
  std::vector<Box> boxes_;
  Bvh tree_;
  double little_ = 0.0;
  std::uint64_t pairs_ = 0;
};

}  // namespace

CrossingFacets crossing_facets(const Mesh& mesh, std::uint64_t most_pairs) {
  const bool is_judged =
      !mesh.triangles.empty() && mesh.triangles.size() <= kMostFacetsForCrossings;
  return is_judged ? CrossingSearch(mesh, most_pairs).find() : CrossingFacets{};
}

}  // namespace g31::parts

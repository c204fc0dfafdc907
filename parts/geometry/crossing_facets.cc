#include "parts/geometry/crossing_facets.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

#include "parts/geometry/facet_pair.h"
#include "parts/geometry/morton_boxes.h"

namespace g31::parts {
namespace {

int common_corners(const std::array<std::uint32_t, 3>& a, const std::array<std::uint32_t, 3>& b) {
  int common = 0;
  for (const std::uint32_t corner : a) {
    common += corner == b[0] || corner == b[1] || corner == b[2] ? 1 : 0;
  }
  return common;
}

/// Facets that are neighbours in space look for theirs together: one walk through the boxes for
/// eight facets in place of one for each.
class CrossingSearch {
 public:
  CrossingSearch(const Mesh& mesh, std::uint64_t most_compared, const GoesOn& goes_on)
      : mesh_(mesh),
        most_compared_(most_compared),
        steps_(goes_on),
        boxes_(triangle_boxes(mesh)),
        crosses_(mesh.triangles.size(), false) {
    double largest = 0.0;
    for (const Point& p : mesh.vertices) {
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    little_ = 0x1p-22 * largest;
  }

  CrossingFacets find() {
    CrossingFacets found;
    for (std::size_t group = 0; group < boxes_.groups() && look_at(group); ++group) {
      found.looked_at += facets_of(group);
    }
    for (std::uint32_t t = 0; t < crosses_.size(); ++t) {
      if (crosses_[t]) {
        found.facets.push_back(t);
      }
    }
    return found;
  }

 private:
  static constexpr std::size_t kGroup = EightBoxes::kLanes;
  static constexpr std::uint64_t kFacetHeld = 8;  ///< comparisons of boxes in the same time

  [[nodiscard]] std::size_t facets_of(std::size_t group) const {
    return std::min(kGroup, boxes_.order().size() - kGroup * group);
  }

  /// Each facet of the group with each that lies behind it on the curve.  @returns whether it was
  /// done with all
  bool look_at(std::size_t group) {
    const EightBoxes& here = boxes_.group(group);
    has_near_ = false;
    for (std::size_t lane = 0; lane < facets_of(group); ++lane) {
      if (!look_from(group, lane, here.at(lane))) {
        return false;
      }
    }
    return true;
  }

  bool look_from(std::size_t group, std::size_t lane, const RoundedBox& box) {
    const std::uint32_t t = boxes_.order()[kGroup * group + lane];
    const auto facet = facet_in_plane(mesh_, t);
    if (!facet) {
      return true;
    }
    if (!has_near_) {  // of facets without area, which may all lie in one place, nothing is asked
      compared_ += boxes_.groups_near(boxes_.group(group).around(), group, near_);
      has_near_ = true;
    }
    for (const std::uint32_t other : near_) {
      unsigned int meeting = boxes_.group(other).meet(box);
      if (other == group) {
        meeting &= ~0U << (lane + 1);
      }
      compared_ += kGroup;
      steps_.step();
      for (; meeting != 0; meeting &= meeting - 1) {
        const auto slot = kGroup * other + static_cast<std::size_t>(std::countr_zero(meeting));
        hold_against(*facet, t, boxes_.order()[slot]);
      }
      if (compared_ > most_compared_) {
        return false;
      }
    }
    return true;
  }

  void hold_against(const FacetInPlane& facet, std::uint32_t t, std::uint32_t other) {
    compared_ += kFacetHeld;
    const auto first = std::min(t, other);
    if (!crosses_[first]) {
      crosses_[first] = meets(facet, t, other);
    }
  }

  [[nodiscard]] bool meets(const FacetInPlane& facet, std::uint32_t t, std::uint32_t other) const {
    const auto& v = mesh_.triangles[other];
    if (common_corners(mesh_.triangles[t], v) > 1) {
      return false;
    }
    const Side side =
        side_of(facet, {mesh_.vertices[v[0]], mesh_.vertices[v[1]], mesh_.vertices[v[2]]}, little_);
    const auto second = side == Side::Beside ? std::nullopt : facet_in_plane(mesh_, other);
    return second && (side == Side::Across ? go_through(facet, *second, little_)
                                           : lie_over(facet, *second, little_));
  }

  const Mesh& mesh_;
  std::uint64_t most_compared_;
  Steps steps_;
  MortonBoxes boxes_;
  std::vector<bool> crosses_;  ///< by facets of the mesh
  double little_ = 0.0;
  std::uint64_t compared_ = 0;
  std::vector<std::uint32_t> near_;  ///< groups near the one at hand
  bool has_near_ = false;            ///< it has been asked for them
};

}  // namespace

CrossingFacets crossing_facets(const Mesh& mesh, std::uint64_t most_compared,
                               const GoesOn& goes_on) {
  return mesh.triangles.empty() ? CrossingFacets{}
                                : CrossingSearch(mesh, most_compared, goes_on).find();
}

CrossingFacets crossing_facets(const Mesh& mesh, const GoesOn& goes_on) {
  return crossing_facets(
      mesh, std::max(kMostComparedAtLeast, kMostComparedForEach * mesh.triangles.size()), goes_on);
}

}  // namespace g31::parts

#include "probe/contact/offset_patches.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

#include "parts/geometry/corner_fans.h"
#include "probe/contact/exposed_directions.h"

namespace g31::probe {
namespace {

using parts::Box;
using parts::Corner;

/// An edge from a vertex, seen from one of its triangles.
struct Spoke {
  std::uint32_t to = 0;      ///< place of the other end
  std::uint32_t number = 0;  ///< in the order in which the fan has them
  std::uint32_t triangle = 0;
  std::uint32_t edge = 0;  ///< index of it in the triangle
};

Box moved(const Box& unit, double radius, const Point& p) {
  return {p + radius * unit.min, p + radius * unit.max};
}

class PatchMaker {
 public:
  PatchMaker(const parts::Mesh& mesh, std::span<const ContactTriangle> triangles, double radius)
      : mesh_(mesh), triangles_(triangles), radius_(radius), fans_(mesh) {}

  OffsetPatches make() {
    add_faces();
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
      if (!fans_.fan(v).empty()) {
        add_fan(v);
      }
    }
    return std::move(patches_);
  }

 private:
  /// Triangle t has the patches 2 t (on the side of its normal) and 2 t + 1; a sliver's are equal.
  void add_faces() {
    // Room for the most there are: what is not used is never touched, and growing would for a
    // moment take the memory twice.
    constexpr std::size_t kUsualMost = 6;
    patches_.boxes.reserve(kUsualMost * triangles_.size());
    patches_.owners.reserve(kUsualMost * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const ContactTriangle& triangle = triangles_[t];
      Box box;
      for (const Point& vertex : triangle.vertices) {
        box.include(vertex);
      }
      if (triangle.is_sliver()) {
        const Point reach = Point::Constant(radius_);
        const Box whole{box.min - reach, box.max + reach};
        append(whole, {t, kAllFeatures});
        append(whole, {t, kAllFeatures});
        continue;
      }
      const Point up = radius_ * triangle.normal;
      append({box.min + up, box.max + up}, {t, kFace});
      append({box.min - up, box.max - up}, {t, kFace});
    }
  }

  void add_fan(std::uint32_t v) {
    collect_spokes(v);
    away_.clear();
    for (std::size_t i = 0; i < spokes_.size();) {
      std::size_t end = i + 1;
      while (end < spokes_.size() && spokes_[end].to == spokes_[i].to) {
        ++end;
      }
      const Point way = mesh_.vertices[spokes_[i].to] - mesh_.vertices[v];
      const double length = way.norm();
      // A shorter edge has no direction to speak of; without it more counts as exposed.
      constexpr double kShortestEdgeMm = 1e-9;
      if (length >= kShortestEdgeMm) {
        away_.emplace_back(way / length);
      }
      if (v < spokes_[i].to) {
        add_edge(std::span(spokes_).subspan(i, end - i));
      }
      i = end;
    }
    add_vertex(v);
  }

  void collect_spokes(std::uint32_t v) {
    spokes_.clear();
    for (const Corner& corner : fans_.fan(v)) {
      const auto& vertices = mesh_.triangles[corner.triangle];
      const std::uint32_t before = (corner.index + 2) % 3;
      const std::uint32_t to_next = fans_.place_of(vertices[(corner.index + 1) % 3]);
      const std::uint32_t to_before = fans_.place_of(vertices[before]);
      if (to_next != v) {
        add_spoke(to_next, corner.triangle, corner.index);
      }
      if (to_before != v) {
        add_spoke(to_before, corner.triangle, before);
      }
    }
    // By their ends, and what ends together as it comes: no sort that takes memory is needed.
    std::ranges::sort(spokes_, {}, [](const Spoke& spoke) {
      return std::uint64_t{spoke.to} << 32U | spoke.number;
    });
  }

  void add_spoke(std::uint32_t to, std::uint32_t triangle, std::uint32_t edge) {
    spokes_.push_back({to, static_cast<std::uint32_t>(spokes_.size()), triangle, edge});
  }

  void add_edge(std::span<const Spoke> spokes) {
    inwards_.clear();
    const Spoke* owner = nullptr;
    ContactEdge edge;
    for (const Spoke& spoke : spokes) {
      const ContactTriangle& triangle = triangles_[spoke.triangle];
      if (!triangle.is_sliver()) {
        const ContactEdge here = triangle.edge(spoke.edge);
        const Point opposite = triangle.vertices[(spoke.edge + 2) % 3] - here.start;
        const Point inwards = triangle.normal.cross(here.direction);
        inwards_.push_back(inwards.dot(opposite) < 0.0 ? Point(-inwards) : inwards);
        owner = owner == nullptr ? &spoke : owner;
        edge = here;
      }
    }
    if (owner == nullptr) {
      return;  // slivers only, and each of them covers its own edges
    }
    const Point end = edge.start + edge.length * edge.direction;
    for (const ExposedPiece& piece : exposed_around_edge(edge.direction, inwards_)) {
      const Box unit = piece.box();
      Box box = moved(unit, radius_, edge.start);
      box.include(moved(unit, radius_, end));
      add(box, {owner->triangle, edge_feature(owner->edge)}, piece.middle());
    }
  }

  void add_vertex(std::uint32_t v) {
    const Corner* owner = nullptr;
    for (const Corner& corner : fans_.fan(v)) {
      if (!triangles_[corner.triangle].is_sliver()) {
        owner = &corner;
        break;
      }
    }
    if (owner == nullptr) {
      return;
    }
    for (const ExposedPiece& piece : exposed_around_vertex(away_)) {
      const Box box = moved(piece.box(), radius_, mesh_.vertices[v]);
      add(box, {owner->triangle, edge_feature(owner->index)}, piece.middle());
    }
  }

  void append(const Box& box, const PatchOwner& owner) {
    patches_.boxes.push_back(box);
    patches_.owners.push_back(owner);
  }

  /// Goes in with the face on that side of its triangle where the face does not grow much by it.
  void add(const Box& box, const PatchOwner& owner, const Point& towards) {
    const ContactTriangle& triangle = triangles_[owner.triangle];
    const std::size_t face =
        2 * std::size_t{owner.triangle} + (triangle.normal.dot(towards) < 0.0 ? 1 : 0);
    Box both = patches_.boxes[face];
    both.include(box);
    constexpr double kGrowth = 2.0;
    Box bare;
    for (const Point& vertex : triangle.vertices) {
      bare.include(vertex);
    }
    if (half_surface(both) <= kGrowth * half_surface(bare)) {
      patches_.boxes[face] = both;
      patches_.owners[face].features |= owner.features;
    } else {
      append(box, owner);
    }
  }

  const parts::Mesh& mesh_;
  std::span<const ContactTriangle> triangles_;
  double radius_;
  parts::CornerFans fans_;
  OffsetPatches patches_;
  // Of the fan at work.
  std::vector<Spoke> spokes_;
  std::vector<Point> away_;
  std::vector<Point> inwards_;
};

}  // namespace

OffsetPatches offset_patches(const parts::Mesh& mesh, std::span<const ContactTriangle> triangles,
                             double radius) {
  return PatchMaker(mesh, triangles, radius).make();
}

}  // namespace g31::probe

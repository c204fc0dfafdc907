#include "probe/contact/offset_patches.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include <Eigen/Geometry>

#include "probe/contact/exposed_directions.h"
#include "probe/contact/hiding_vertices.h"

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
  explicit PatchMaker(const OffsetSurface& surface)
      : mesh_(surface.mesh.mesh()),
        triangles_(surface.mesh.triangles()),
        fans_(surface.fans),
        radius_(surface.radius) {}

  /// All patches: those of the faces first.
  std::vector<OffsetPatch> make() {
    end_ = static_cast<std::uint32_t>(triangles_.size());
    // Room for the most there are: what is not used is never touched, and growing would for a
    // moment take the memory twice.
    constexpr std::size_t kUsualMost = 6;
    patches_.reserve(kUsualMost * triangles_.size());
    add_faces();
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v) {
      if (!fans_.fan(v).empty()) {
        add_fan(v);
      }
    }
    return std::move(patches_);
  }

  std::vector<OffsetPatch> make_what_is_not_hidden(const OffsetRegion& region) {
    // A few triangles at a time: only vertices near by hide anything of them.
    constexpr std::uint32_t kTogether = 32;
    side_ = region.side;
    const std::uint32_t end = region.triangles.first + region.triangles.count;
    for (first_ = region.triangles.first; first_ < end; first_ = end_) {
      end_ = std::min(first_ + kTogether, end);
      const std::vector<std::uint32_t> places = places_of_triangles();
      hiding_.emplace(vertices_around(places), radius_);
      add_faces();
      for (const std::uint32_t v : places) {
        add_fan(v);
      }
      gather();
    }
    return std::move(all_);
  }

 private:
  /// Puts the patches of the triangles at work with the others.
  void gather() {
    std::ranges::copy_if(patches_, std::back_inserter(all_),
                         [](const OffsetPatch& patch) { return is_there(patch); });
    patches_.clear();
  }

  /// The vertices of the triangles at work, rising.
  [[nodiscard]] std::vector<std::uint32_t> places_of_triangles() const {
    std::vector<std::uint32_t> places;
    for (std::uint32_t t = first_; t < end_; ++t) {
      for (const std::uint32_t vertex : mesh_.triangles[t]) {
        places.push_back(fans_.place_of(vertex));
      }
    }
    sort_and_take_once(places);
    return places;
  }

  /// Of all triangles that meet at some vertices.
  [[nodiscard]] std::vector<Point> vertices_around(const std::vector<std::uint32_t>& places) const {
    constexpr std::size_t kMostTriangles = 32;  // more would hide little for much work
    std::vector<std::uint32_t> around;
    for (const std::uint32_t place : places) {
      const auto fan = fans_.fan(place);
      for (const Corner& corner : fan.first(std::min(fan.size(), kMostTriangles))) {
        for (const std::uint32_t near : mesh_.triangles[corner.triangle]) {
          around.push_back(fans_.place_of(near));
        }
      }
    }
    sort_and_take_once(around);
    std::vector<Point> vertices;
    vertices.reserve(around.size());
    for (const std::uint32_t place : around) {
      vertices.push_back(mesh_.vertices[place]);
    }
    return vertices;
  }

  static void sort_and_take_once(std::vector<std::uint32_t>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  }

  /// A triangle has a patch on the side of its normal and one on the other, without features where
  /// there is none; a sliver's are equal.
  void add_faces() {
    for (std::uint32_t t = first_; t < end_; ++t) {
      const ContactTriangle& triangle = triangles_[t];
      Box box;
      for (const Point& vertex : triangle.vertices) {
        box.include(vertex);
      }
      if (triangle.is_sliver()) {
        const Point reach = Point::Constant(radius_);
        const Box whole{box.min - reach, box.max + reach};
        patches_.insert(patches_.end(), 2, {whole, PatchOwner{t, kAllFeatures}.as_slot()});
        continue;
      }
      const Point up = radius_ * triangle.normal;
      add_face({box.min + up, box.max + up}, t, triangle.normal);
      add_face({box.min - up, box.max - up}, t, -triangle.normal);
    }
  }

  void add_face(const Box& box, std::uint32_t t, const Point& up) {
    const bool is_seen = is_on_side(up) && !(hiding_ && hiding_->hide_face(triangles_[t], up));
    patches_.push_back({box, PatchOwner{t, is_seen ? kFace : 0}.as_slot()});
  }

  static bool is_there(const OffsetPatch& patch) {
    return PatchOwner::of_slot(patch.slot).features != 0;
  }

  [[nodiscard]] bool is_on_side(const Point& direction) const {
    return direction.dot(side_) >= 0.0;
  }

  [[nodiscard]] bool is_at_work(std::uint32_t triangle) const {
    return triangle >= first_ && triangle < end_;
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
    if (owner == nullptr || !is_at_work(owner->triangle)) {
      return;  // slivers only, and each of them covers its own edges; or with other triangles
    }
    const Point end = edge.start + edge.length * edge.direction;
    for (const ExposedPiece& piece : exposed_around_edge(edge.direction, inwards_)) {
      add_exposed(piece, {edge.start, end}, {owner->triangle, edge_feature(owner->edge)});
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
    if (owner == nullptr || !is_at_work(owner->triangle)) {
      return;
    }
    const Point& p = mesh_.vertices[v];
    for (const ExposedPiece& piece : exposed_around_vertex(away_)) {
      add_exposed(piece, {p, p}, {owner->triangle, edge_feature(owner->index)});
    }
  }

  /// What is exposed around a vertex, or around an edge between two, and not hidden.
  void add_exposed(const ExposedPiece& exposed, const std::array<Point, 2>& ends,
                   const PatchOwner& owner) {
    if (!hiding_) {
      add_piece(exposed, ends, owner);
    } else if (is_on_side(exposed.middle())) {
      const ExposedPiece left = hiding_->left_of(exposed, ends);
      if (left.count > 0) {
        add_piece(left, ends, owner);
      }
    }
  }

  void add_piece(const ExposedPiece& piece, const std::array<Point, 2>& ends,
                 const PatchOwner& owner) {
    const Box unit = piece.box();
    Box box = moved(unit, radius_, ends[0]);
    box.include(moved(unit, radius_, ends[1]));
    add(box, owner, piece.middle());
  }

  /// Goes in with the face on that side of its triangle where the face does not grow much by it.
  void add(const Box& box, const PatchOwner& owner, const Point& towards) {
    const ContactTriangle& triangle = triangles_[owner.triangle];
    const std::size_t below = triangle.normal.dot(towards) < 0.0 ? 1 : 0;
    OffsetPatch& face = patches_[2 * std::size_t{owner.triangle - first_} + below];
    Box both = face.box;
    both.include(box);
    constexpr double kGrowth = 2.0;
    Box bare;
    for (const Point& vertex : triangle.vertices) {
      bare.include(vertex);
    }
    if (is_there(face) && half_surface(both) <= kGrowth * half_surface(bare)) {
      face.box = both;
      face.slot |= owner.as_slot();
    } else {
      patches_.push_back({box, owner.as_slot()});
    }
  }

  const parts::Mesh& mesh_;
  std::span<const ContactTriangle> triangles_;
  const parts::CornerFans& fans_;
  double radius_;
  Point side_ = Point::Zero();
  std::optional<HidingVertices> hiding_;
  std::vector<OffsetPatch> all_;
  // Of the triangles at work.
  std::uint32_t first_ = 0;
  std::uint32_t end_ = 0;
  std::vector<OffsetPatch> patches_;  ///< two of the faces of each first
  // Of the fan at work.
  std::vector<Spoke> spokes_;
  std::vector<Point> away_;
  std::vector<Point> inwards_;
};

}  // namespace

std::vector<OffsetPatch> offset_patches(const OffsetSurface& surface) {
  return PatchMaker(surface).make();
}

std::vector<OffsetPatch> offset_patches_not_hidden(const OffsetSurface& surface,
                                                   const OffsetRegion& region) {
  return PatchMaker(surface).make_what_is_not_hidden(region);
}

}  // namespace g31::probe

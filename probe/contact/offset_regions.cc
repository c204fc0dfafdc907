#include "probe/contact/offset_regions.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>

#include "probe/contact/exposed_directions.h"

namespace g31::probe {
namespace {

using parts::Box;
using parts::Corner;

/// Directions at most so far from an axis.
struct Cone {
  Point axis;
  double cosine = 1.0;
};

/// Around the unit vectors of a cone, mm.
Box box_of(const Cone& cone) {
  // More than exposed directions are widened, and normals are off.
  constexpr double kSlackRad = 10.0 * kExposureSlackRad;
  const double angle = std::acos(std::min(1.0, cone.cosine)) + kSlackRad;
  Box box;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const double from_axis = std::acos(std::clamp(cone.axis[i], -1.0, 1.0));
    box.max[i] = std::cos(std::max(0.0, from_axis - angle));
    box.min[i] = std::cos(std::min(std::numbers::pi, from_axis + angle));
  }
  return box;
}

class RegionMaker {
 public:
  explicit RegionMaker(const OffsetSurface& surface) : surface_(surface) {}

  void add(const parts::Bvh::SlotRange& range, std::vector<OffsetRegion>& regions) {
    const double radius = surface_.radius;
    Box box;
    for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot) {
      for (const Point& vertex : surface_.mesh.triangles()[slot].vertices) {
        box.include(vertex);
      }
    }
    if (const auto cone = normals_of(range)) {
      const Box unit = box_of(*cone);
      regions.push_back(
          {range, cone->axis, {box.min + radius * unit.min, box.max + radius * unit.max}});
      regions.push_back(
          {range, -cone->axis, {box.min - radius * unit.max, box.max - radius * unit.min}});
    } else {
      const Point reach = Point::Constant(radius);
      regions.push_back({range, Point::Zero(), {box.min - reach, box.max + reach}});
    }
  }

 private:
  /// Around the normals of all triangles that meet these, if the mesh is a sheet there: around each
  /// vertex the triangles close up, all the same way round as the axis sees them.
  ///
  /// Then a direction in which an edge or a vertex is exposed is none farther from the axis, on
  /// either side: the sheet goes on from a vertex towards where such a direction leans to, and
  /// falls there no steeper than the normals tell.
  [[nodiscard]] std::optional<Cone> normals_of(const parts::Bvh::SlotRange& range) const {
    constexpr double kLeastCosine = 0.5;
    Point sum = Point::Zero();
    for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot) {
      sum += surface_.mesh.triangles()[slot].normal;
    }
    Cone cone{sum.normalized(), 1.0};
    for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot) {
      for (const std::uint32_t vertex : surface_.mesh.mesh().triangles[slot]) {
        const auto fan = surface_.fans.fan(surface_.fans.place_of(vertex));
        const bool is_known = std::ranges::any_of(fan, [&](const Corner& corner) {
          return corner.triangle >= range.first && corner.triangle < slot;
        });
        if (is_known) {
          continue;
        }
        for (const Corner& corner : fan) {
          const Point& normal = surface_.mesh.triangles()[corner.triangle].normal;
          cone.cosine = std::min(cone.cosine, normal.dot(cone.axis));
        }
        if (cone.cosine < kLeastCosine || !closes_up(fan)) {
          return std::nullopt;
        }
      }
    }
    return cone;
  }

  /// Whether each edge from the vertex begins one triangle of the fan and ends one.
  [[nodiscard]] bool closes_up(std::span<const Corner> fan) const {
    constexpr std::size_t kMostTriangles = 32;
    return fan.size() <= kMostTriangles && std::ranges::all_of(fan, [&](const Corner& one) {
             const std::uint32_t edge_to = end_of(one, 1);
             return std::ranges::count(fan, edge_to,
                                       [&](const Corner& other) { return end_of(other, 2); }) == 1;
           });
  }

  /// The place of the next vertex of a corner's triangle, or of the one after it.
  [[nodiscard]] std::uint32_t end_of(const Corner& corner, std::uint32_t step) const {
    const auto& vertices = surface_.mesh.mesh().triangles[corner.triangle];
    return surface_.fans.place_of(vertices[(corner.index + step) % 3]);
  }

  const OffsetSurface& surface_;
};

/// Whether the triangle is so, as the ones that meet at its first vertex tell.
bool is_rough_and_fine_at(const OffsetSurface& surface, std::uint32_t slot) {
  constexpr double kFine = 0.5;  // of the radius
  const auto& triangles = surface.mesh.triangles();
  const ContactTriangle& triangle = triangles[slot];
  double longest = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, triangle.edge(i).length);
  }
  const double most_of_ball = std::cos(std::min(1.0, longest / surface.radius));
  const auto fan = surface.fans.fan(surface.fans.place_of(surface.mesh.mesh().triangles[slot][0]));
  return longest <= kFine * surface.radius && std::ranges::any_of(fan, [&](const Corner& corner) {
           return std::abs(triangles[corner.triangle].normal.dot(triangle.normal)) < most_of_ball;
         });
}

}  // namespace

bool is_rough_and_fine(const OffsetSurface& surface) {
  constexpr std::size_t kSamples = 1000;
  const std::size_t count = surface.mesh.triangles().size();
  const std::size_t step = std::max<std::size_t>(1, count / kSamples);
  std::size_t asked = 0;
  std::size_t are = 0;
  for (std::size_t slot = 0; slot < count; slot += step) {
    ++asked;
    are += is_rough_and_fine_at(surface, static_cast<std::uint32_t>(slot)) ? 1U : 0U;
  }
  return 2 * are > asked;
}

std::vector<OffsetRegion> offset_regions(const OffsetSurface& surface) {
  // As large as the ball where triangles are small: the box around normals is a good one then.
  const auto together = [&](std::uint32_t count, double diagonal) {
    constexpr std::uint32_t kFew = 64;
    constexpr std::uint32_t kMany = 4096;
    return count <= kFew || (count <= kMany && diagonal <= 2.0 * surface.radius);
  };
  RegionMaker maker(surface);
  std::vector<OffsetRegion> regions;
  for (const auto& range : surface.mesh.tree().ranges(together)) {
    maker.add(range, regions);
  }
  return regions;
}

}  // namespace g31::probe

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "parts/artefacts/makers.h"
#include "parts/artefacts/polygon.h"
#include "parts/artefacts/solid.h"

namespace g31::parts {
namespace {

constexpr std::size_t kMostCornerSides = 25000;

struct Range {
  double low = 0.0;
  double high = 0.0;
};

/// A box with its top in the plane z = 0, symmetric to the plane XZ.
Mesh box(const Range& x, double width, double height) {
  const std::array<Point2, 4> outline = {Point2(x.low, -height), Point2(x.high, -height),
                                         Point2(x.high, 0.0), Point2(x.low, 0.0)};
  return extruded(outline, width);
}

/// The rounding of a pocket's corners; without one they are sharp.
struct Rounding {
  double radius = 0.0;
  std::size_t sides = 1;
};

/// A block with a pocket, built from its outlines: four corners outside at the bottom and the top,
/// the opening of the pocket and the outline of its floor.
class PocketMesh {
 public:
  PocketMesh(const Point2& block, const Range& block_z, std::vector<Point2> opening)
      : opening_(std::move(opening)) {
    for (const double z : {block_z.low, block_z.high}) {
      add_outline(rectangle(block, 0.0, 1), z);
    }
  }

  Mesh with_floor_at(double floor_z) {
    const std::size_t count = opening_.size();
    add_outline(opening_, 0.0);
    add_outline(opening_, floor_z);
    const std::uint32_t top = 8;
    const std::uint32_t floor = vertex_of(top, count, 0);
    add_face(0, {0, 3, 2, 1});
    add_wall(0, 4, 4);
    add_wall(floor, top, count, Facing::Inwards);
    add_top(top, count);
    for (std::size_t i = 1; i + 1 < count; ++i) {
      add_triangle(floor, vertex_of(floor, i, 0), vertex_of(floor, i, 1));
    }
    return mesh_;
  }

 private:
  enum class Facing { Outwards, Inwards };

  static std::uint32_t vertex_of(std::uint32_t first, std::size_t i, std::size_t more) {
    return first + static_cast<std::uint32_t>(i + more);
  }

  void add_outline(const std::vector<Point2>& outline, double z) {
    for (const Point2& p : outline) {
      mesh_.vertices.emplace_back(p.x(), p.y(), z);
    }
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.triangles.push_back({a, b, c});
  }

  void add_face(std::uint32_t first, const std::array<std::uint32_t, 4>& corners) {
    add_triangle(first + corners[0], first + corners[1], first + corners[2]);
    add_triangle(first + corners[0], first + corners[2], first + corners[3]);
  }

  /// Between two outlines of `count` corners that lie one above the other.
  void add_wall(std::uint32_t below, std::uint32_t above, std::size_t count,
                Facing facing = Facing::Outwards) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t here = vertex_of(0, i, 0);
      const std::uint32_t next = vertex_of(0, (i + 1) % count, 0);
      if (facing == Facing::Outwards) {
        add_face(0, {below + here, below + next, above + next, above + here});
      } else {
        add_face(0, {below + next, below + here, above + here, above + next});
      }
    }
  }

  /// From each outer corner a fan to its quarter of the opening, and a strip to the next corner.
  void add_top(std::uint32_t opening, std::size_t count) {
    constexpr std::uint32_t kOuter = 4;
    const std::size_t quarter = count / 4;
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const std::uint32_t outer = kOuter + corner;
      const std::uint32_t next_outer = kOuter + (corner + 1) % 4;
      const std::size_t start = corner * quarter;
      for (std::size_t i = start; i + 1 < start + quarter; ++i) {
        add_triangle(outer, vertex_of(opening, i, 1), vertex_of(opening, i, 0));
      }
      const std::uint32_t last = vertex_of(opening, start, quarter - 1);
      const std::uint32_t next = vertex_of(opening, (start + quarter) % count, 0);
      add_triangle(outer, next_outer, last);
      add_triangle(next_outer, next, last);
    }
  }

  Mesh mesh_;
  std::vector<Point2> opening_;
};

}  // namespace

Result<Mesh, std::string> make_block(const Sizes& sizes) {
  const double half = 0.5 * sizes.at("length");
  return box({-half, half}, sizes.at("width"), sizes.at("height"));
}

Result<Mesh, std::string> make_gauge_block(const Sizes& sizes) {
  return box({0.0, sizes.at("length")}, sizes.at("width"), sizes.at("height"));
}

Result<Mesh, std::string> make_pocket(const Sizes& sizes) {
  const Point2 opening(sizes.at("length"), sizes.at("width"));
  const double wall = sizes.at("wall");
  const double depth = sizes.at("depth");
  Rounding rounding;
  if (const double radius = sizes.at("corner_radius"); radius > 0.0) {
    if (2.0 * radius > opening.minCoeff()) {
      return std::string(
          "the corner_radius of a pocket must be at most half of its length and its width");
    }
    const auto facets = sides_within(radius, sizes.at("sagitta"), 4 * kMostCornerSides);
    if (!facets) {
      return std::string(
          "the sagitta of the pocket is too small: it would take more than 100000 facets");
    }
    rounding = {radius, *facets / 4};
  }
  PocketMesh mesh(opening + Point2(2.0 * wall, 2.0 * wall), {-(depth + sizes.at("floor")), 0.0},
                  rectangle(opening, rounding.radius, rounding.sides));
  return mesh.with_floor_at(-depth);
}

Result<Mesh, std::string> make_groove(const Sizes& sizes) {
  const double half = 0.5 * sizes.at("width");
  const double outer = half + sizes.at("wall");
  const double floor = -sizes.at("depth");
  const double bottom = floor - sizes.at("floor");
  const std::array<Point2, 8> outline = {
      Point2(-outer, bottom), Point2(outer, bottom), Point2(outer, 0.0), Point2(half, 0.0),
      Point2(half, floor),    Point2(-half, floor),  Point2(-half, 0.0), Point2(-outer, 0.0)};
  return extruded(outline, sizes.at("length"));
}

Result<Mesh, std::string> make_rib(const Sizes& sizes) {
  const double half = 0.5 * sizes.at("width");
  const double outer = half + sizes.at("shoulder");
  const double foot = -sizes.at("height");
  const double bottom = foot - sizes.at("base");
  const std::array<Point2, 8> outline = {
      Point2(-outer, bottom), Point2(outer, bottom), Point2(outer, foot), Point2(half, foot),
      Point2(half, 0.0),      Point2(-half, 0.0),    Point2(-half, foot), Point2(-outer, foot)};
  return extruded(outline, sizes.at("length"));
}

Result<Mesh, std::string> make_step(const Sizes& sizes) {
  const double upper = -sizes.at("upper");
  const double lower = sizes.at("lower");
  const double foot = -sizes.at("rise");
  const double bottom = foot - sizes.at("base");
  const std::array<Point2, 6> outline = {Point2(upper, bottom), Point2(lower, bottom),
                                         Point2(lower, foot),   Point2(0.0, foot),
                                         Point2(0.0, 0.0),      Point2(upper, 0.0)};
  return extruded(outline, sizes.at("width"));
}

}  // namespace g31::parts

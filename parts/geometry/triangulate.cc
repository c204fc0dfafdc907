#include "parts/geometry/triangulate.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

namespace g31::parts {
namespace {

/// Twice the area vector of the polygon (Newell): its direction is the side it is seen from.
Point area_vector(std::span<const Point> vertices, std::span<const std::uint32_t> corners) {
  Point sum = Point::Zero();
  const Point& origin = vertices[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    sum += (vertices[corners[i]] - origin).cross(vertices[corners[i + 1]] - origin);
  }
  return sum;
}

/// Three successive corners of what is left of a polygon, seen from the side of `area`.
class Ear {
 public:
  Ear(std::span<const Point> vertices, const std::array<std::uint32_t, 3>& corners,
      const Point& area)
      : vertices_(vertices), corners_(corners), area_(area) {}

  [[nodiscard]] bool turns_inwards() const {
    return turn(corners_[0], corners_[1], corners_[2]) <= 0.0;
  }

  [[nodiscard]] bool covers(std::uint32_t vertex) const {
    return std::ranges::find(corners_, vertex) == corners_.end() &&
           turn(corners_[0], corners_[1], vertex) >= 0.0 &&
           turn(corners_[1], corners_[2], vertex) >= 0.0 &&
           turn(corners_[2], corners_[0], vertex) >= 0.0;
  }

 private:
  /// Positive when a, b, c turn the way the whole polygon does.
  [[nodiscard]] double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return (vertices_[b] - vertices_[a]).cross(vertices_[c] - vertices_[a]).dot(area_);
  }

  std::span<const Point> vertices_;
  std::array<std::uint32_t, 3> corners_;
  const Point& area_;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulated(std::span<const Point> vertices,
                                                       std::span<const std::uint32_t> corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  if (corners.size() < 3) {
    return triangles;
  }
  if (corners.size() == 3) {
    return {{corners[0], corners[1], corners[2]}};
  }
  std::vector<std::uint32_t> rest(corners.begin(), corners.end());
  const Point area = area_vector(vertices, rest);
  const auto corners_at = [&](std::size_t i) {
    return std::array{rest[(i + rest.size() - 1) % rest.size()], rest[i],
                      rest[(i + 1) % rest.size()]};
  };
  const auto is_ear = [&](std::size_t i) {
    const Ear ear(vertices, corners_at(i), area);
    return !ear.turns_inwards() &&
           std::ranges::none_of(rest, [&](std::uint32_t vertex) { return ear.covers(vertex); });
  };
  while (rest.size() >= 3) {
    std::size_t tip = 0;
    while (tip < rest.size() && !is_ear(tip)) {
      ++tip;
    }
    // No ear: the polygon is no simple one, and any corner is as good as another.
    tip = tip == rest.size() ? 1 : tip;
    triangles.push_back(corners_at(tip));
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(tip));
  }
  return triangles;
}

}  // namespace g31::parts

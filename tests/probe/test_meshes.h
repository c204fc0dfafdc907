#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <utility>

#include <Eigen/Geometry>

#include "parts/geometry/mesh.h"

namespace g31::testing {

inline const Eigen::Quaterniond kUpright = Eigen::Quaterniond::Identity();

/// A number evenly in [low, high), the same on every machine.
inline double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

inline Point point_between(std::mt19937_64& random, double low, double high) {
  const double x = between(random, low, high);
  const double y = between(random, low, high);
  return {x, y, between(random, low, high)};
}

/// Evenly over the unit sphere.
inline Point any_direction(std::mt19937_64& random) {
  for (;;) {
    const Point p = point_between(random, -1.0, 1.0);
    if (p.norm() > 0.1 && p.norm() < 1.0) {
      return p.normalized();
    }
  }
}

/// A closed box from the origin to `size`, normals outwards.
inline parts::Mesh box_mesh(const Point& size) {
  parts::Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? size.x() : 0.0, (i & 2) != 0 ? size.y() : 0.0,
                               (i & 4) != 0 ? size.z() : 0.0);
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// A closed sphere around the origin of `bands` x 2 `bands` facets with vertices on the sphere.
inline parts::Mesh sphere_mesh(double radius, std::uint32_t bands) {
  parts::Mesh mesh;
  const std::uint32_t around = 2 * bands;
  mesh.vertices.emplace_back(0.0, 0.0, radius);
  for (std::uint32_t i = 1; i < bands; ++i) {
    for (std::uint32_t j = 0; j < around; ++j) {
      const double polar = std::numbers::pi * i / bands;
      const double azimuth = std::numbers::pi * j / bands;
      mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(azimuth),
                                 radius * std::sin(polar) * std::sin(azimuth),
                                 radius * std::cos(polar));
    }
  }
  mesh.vertices.emplace_back(0.0, 0.0, -radius);
  const auto last = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return 1 + (i - 1) * around + j % around;
  };
  for (std::uint32_t j = 0; j < around; ++j) {
    mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
    mesh.triangles.push_back({last, at(bands - 1, j + 1), at(bands - 1, j)});
    for (std::uint32_t i = 1; i + 1 < bands; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      mesh.triangles.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

/// Single triangles in a cube of 40 mm: open, unoriented, crossing each other.
inline parts::Mesh loose_triangles(std::uint64_t seed, std::uint32_t count) {
  std::mt19937_64 random(seed);
  parts::Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point middle = point_between(random, -20.0, 20.0);
    for (int corner = 0; corner < 3; ++corner) {
      mesh.vertices.push_back(middle + point_between(random, -6.0, 6.0));
    }
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Triangles 1e-3 mm down to 1e-14 mm high, and such with two or three vertices in one place.
inline parts::Mesh slivers(std::uint64_t seed, std::uint32_t count) {
  std::mt19937_64 random(seed);
  parts::Mesh mesh;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Point a = point_between(random, -20.0, 20.0);
    const double length = between(random, 0.1, 30.0);
    const double height = std::pow(10.0, between(random, -14.0, -3.0));
    const Point along = length * any_direction(random);
    const Point aside = height * any_direction(random);
    mesh.vertices.push_back(a);
    mesh.vertices.push_back(i % 11 == 0 ? a : Point(a + along));
    mesh.vertices.push_back(i % 7 == 0 ? a : Point(a + between(random, -0.2, 1.2) * along + aside));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// The same shape with some triangles turned over.
inline parts::Mesh turned_at_random(parts::Mesh mesh, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (auto& triangle : mesh.triangles) {
    if (random() % 2 == 0) {
      std::swap(triangle[0], triangle[1]);
    }
  }
  return mesh;
}

/// The same shape, each triangle with vertices of its own, as STL has it.
inline parts::Mesh unshared(const parts::Mesh& mesh) {
  parts::Mesh own;
  for (const auto& triangle : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(own.vertices.size());
    for (const std::uint32_t vertex : triangle) {
      own.vertices.push_back(mesh.vertices[vertex]);
    }
    own.triangles.push_back({first, first + 1, first + 2});
  }
  return own;
}

/// With a hole where every n-th triangle was.
inline parts::Mesh without_every(const parts::Mesh& mesh, std::size_t n) {
  parts::Mesh open{mesh.vertices, {}};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % n != 0) {
      open.triangles.push_back(mesh.triangles[i]);
    }
  }
  return open;
}

/// Each vertex moved by up to `amount` mm along each axis: dents, saddles and ridges.
inline parts::Mesh shaken(parts::Mesh mesh, double amount, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  for (Point& vertex : mesh.vertices) {
    vertex += point_between(random, -amount, amount);
  }
  return mesh;
}

inline parts::Mesh moved_by(parts::Mesh mesh, const Point& way) {
  for (Point& vertex : mesh.vertices) {
    vertex += way;
  }
  return mesh;
}

/// Two crowns of `spokes` triangles, one around a peak, one around a flat middle.
inline parts::Mesh spiked_fan(double radius, std::uint32_t spokes) {
  parts::Mesh mesh;
  for (const double peak : {radius, 0.0}) {
    const auto middle = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.emplace_back(0.0, 0.0, peak - (peak > 0.0 ? 0.0 : radius));
    for (std::uint32_t i = 0; i < spokes; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / spokes;
      const double height = peak > 0.0 && i % 2 == 0 ? 3.0 : 0.0;
      mesh.vertices.emplace_back(radius * std::cos(angle), radius * std::sin(angle),
                                 height - (peak > 0.0 ? 0.0 : radius));
      mesh.triangles.push_back({middle, middle + 1 + i, middle + 1 + (i + 1) % spokes});
    }
  }
  return mesh;
}

/// `leaves` square sheets that share one edge along Z, half a turn of them.
inline parts::Mesh book(double size, std::uint32_t leaves) {
  parts::Mesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {0.0, 0.0, size}};
  for (std::uint32_t i = 0; i < leaves; ++i) {
    const double angle = std::numbers::pi * i / leaves;
    const Point out(size * std::cos(angle), size * std::sin(angle), 0.0);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(out);
    mesh.vertices.push_back(out + size * Point::UnitZ());
    mesh.triangles.push_back({0, first, 1});
    mesh.triangles.push_back({1, first, first + 1});
  }
  return mesh;
}

/// How often each edge is used in each direction: a mesh is closed and consistently oriented when
/// every directed edge stands against exactly one opposite one.
inline bool is_closed_and_oriented(const parts::Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++uses[{t[i], t[(i + 1) % 3]}];
    }
  }
  for (const auto& [edge, count] : uses) {
    const auto opposite = uses.find({edge.second, edge.first});
    if (count != 1 || opposite == uses.end() || opposite->second != 1) {
      return false;
    }
  }
  return !mesh.triangles.empty();
}

/// mm^3; positive when the normals point outwards.
inline double enclosed_volume(const parts::Mesh& mesh) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    sum += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return sum;
}

}  // namespace g31::testing

#include "parts/geometry/triangulate.h"

#include <cstdint>
#include <numeric>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace g31::parts::triangulate_test {
namespace {

TEST(Triangulated, CoversThePolygonOnce) {
  struct Case {
    const char* name;
    std::vector<Point> polygon;
    double area;
  };
  const Case kCases[] = {
      {"triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 0.5},
      {"square", {{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}}, 4.0},
      {"square the other way round", {{0, 2, 5}, {2, 2, 5}, {2, 0, 5}, {0, 0, 5}}, 4.0},
      {"arrow head: a fan from the first corner would leave it",
       {{0, 0, 0}, {4, -3, 0}, {1, 0, 0}, {4, 3, 0}},
       3.0},
      {"U shape on edge",
       {{0, 0, 0}, {0, 3, 0}, {0, 3, 3}, {0, 2, 3}, {0, 2, 1}, {0, 1, 1}, {0, 1, 3}, {0, 0, 3}},
       7.0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    std::vector<std::uint32_t> corners(c.polygon.size());
    std::iota(corners.begin(), corners.end(), 0U);
    const auto triangles = triangulated(c.polygon, corners);
    EXPECT_EQ(triangles.size(), c.polygon.size() - 2);
    // Vector sum and sum of sizes are both the area only if no triangle is turned over.
    Point sum = Point::Zero();
    double sizes = 0.0;
    for (const auto& t : triangles) {
      const Point area =
          0.5 * (c.polygon[t[1]] - c.polygon[t[0]]).cross(c.polygon[t[2]] - c.polygon[t[0]]);
      sum += area;
      sizes += area.norm();
    }
    EXPECT_NEAR(sum.norm(), c.area, 1e-12);
    EXPECT_NEAR(sizes, c.area, 1e-12);
  }
}

TEST(Triangulated, EndsOnPolygonsThatAreNone) {
  const std::vector<Point> vertices = {{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  EXPECT_TRUE(triangulated(vertices, std::vector<std::uint32_t>{}).empty());
  EXPECT_TRUE(triangulated(vertices, std::vector<std::uint32_t>{0, 1}).empty());
  const std::vector<std::uint32_t> crossing = {0, 1, 2, 3};
  const std::vector<std::uint32_t> in_one_place = {0, 0, 4, 4, 0};
  EXPECT_EQ(triangulated(vertices, crossing).size(), 2U);
  EXPECT_EQ(triangulated(vertices, in_one_place).size(), 3U);
}

}  // namespace
}  // namespace g31::parts::triangulate_test

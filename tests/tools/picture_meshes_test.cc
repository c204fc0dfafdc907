// Meshes as pictures show them: with fewer triangles, and the lines of their edges.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tools/picture/feature_edges.h"
#include "tools/picture/folds.h"
#include "tools/picture/thinned.h"

namespace g31::picture::picture_meshes_test {
namespace {

/// A closed cylinder about Z, far from the origin as parts of a machine are.
parts::Mesh cylinder(std::uint32_t sides, std::uint32_t rings, double radius, double height) {
  const Point at(700.0, -300.0, -450.0);
  parts::Mesh mesh;
  for (std::uint32_t ring = 0; ring <= rings; ++ring) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      mesh.vertices.emplace_back(
          at + Point(radius * std::cos(angle), radius * std::sin(angle), height * ring / rings));
    }
  }
  const std::uint32_t bottom = (rings + 1) * sides;
  mesh.vertices.emplace_back(at);
  mesh.vertices.emplace_back(at + Point(0, 0, height));
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    for (std::uint32_t ring = 0; ring < rings; ++ring) {
      const std::uint32_t low = ring * sides;
      const std::uint32_t high = low + sides;
      mesh.triangles.push_back({low + i, low + next, high + next});
      mesh.triangles.push_back({low + i, high + next, high + i});
    }
    mesh.triangles.push_back({bottom, next, i});
    mesh.triangles.push_back({bottom + 1, rings * sides + i, rings * sides + next});
  }
  return mesh;
}

TEST(FeatureEdges, OfACylinderAreItsTwoCircles) {
  const parts::Mesh mesh = cylinder(72, 3, 20.0, 30.0);
  const auto edges = feature_edges(mesh);
  EXPECT_EQ(edges.size(), 2U * 72U);
  for (const Segment& edge : edges) {
    EXPECT_EQ(edge.p_from.z(), edge.p_to.z());
  }
  // Its facets bend by 5 degrees.
  EXPECT_EQ(feature_edges(mesh, 5.1).size(), 2U * 72U);
  EXPECT_EQ(feature_edges(mesh, 4.9).size(), 2U * 72U + 72U * 3U);
}

TEST(FeatureEdges, WhereASurfaceEndsIsAnEdge) {
  parts::Mesh square;
  square.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(feature_edges(square).size(), 4U);
  square.triangles[1] = {0, 3, 2};  // turned over: still flat
  EXPECT_EQ(feature_edges(square).size(), 4U);
}

/// Pythagoras in three dimensions, the nearest point of a triangle by dense sampling.
double distance_to(const parts::Mesh& mesh, const Point& p) {
  double nearest = std::numeric_limits<double>::infinity();
  constexpr int kSteps = 40;
  for (const auto& t : mesh.triangles) {
    const Point& a = mesh.vertices[t[0]];
    const Point ab = mesh.vertices[t[1]] - a;
    const Point ac = mesh.vertices[t[2]] - a;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; k + i <= kSteps; ++k) {
        nearest = std::min(nearest, (a + ab * i / kSteps + ac * k / kSteps - p).norm());
      }
    }
  }
  return nearest;
}

TEST(Thinned, AMeshThatIsSmallEnoughIsTheSame) {
  const parts::Mesh mesh = cylinder(16, 2, 20.0, 30.0);
  const auto same = thinned(mesh, mesh.triangles.size(), 0.01);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->vertices, mesh.vertices);
  EXPECT_EQ(same->triangles, mesh.triangles);
}

TEST(Thinned, FewerTrianglesStayNearTheSurface) {
  if (!can_thin()) {
    GTEST_SKIP() << "built without meshoptimizer";
  }
  // 15 000 triangles, nearly all of which say nothing.
  const parts::Mesh mesh = cylinder(72, 100, 20.0, 30.0);
  constexpr double kError = 0.1;
  const auto few = thinned(mesh, 1000, kError);
  ASSERT_TRUE(few);
  EXPECT_LE(few->triangles.size(), 1000U);
  for (const Point& p : few->vertices) {
    EXPECT_NE(std::ranges::find(mesh.vertices, p), mesh.vertices.end());
  }
  const double grid = 30.0 / 40.0;  // of the sampling
  for (std::size_t v = 0; v < mesh.vertices.size(); v += 97) {
    EXPECT_LT(distance_to(*few, mesh.vertices[v]), std::hypot(2.0 * kError, grid)) << v;
  }
  EXPECT_EQ(thinned(mesh, 1000, kError)->triangles, few->triangles);
}

/// A sphere about the origin in rings of facets, as named shapes have it.
parts::Mesh sphere(std::uint32_t sides, double radius) {
  const std::uint32_t rings = sides / 2;
  parts::Mesh mesh;
  mesh.vertices = {{0, 0, -radius}, {0, 0, radius}};
  for (std::uint32_t ring = 1; ring < rings; ++ring) {
    const double polar = std::numbers::pi * ring / rings;
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      mesh.vertices.emplace_back(radius * std::sin(polar) * std::cos(angle),
                                 radius * std::sin(polar) * std::sin(angle),
                                 -radius * std::cos(polar));
    }
  }
  const auto corner = [&](std::uint32_t ring, std::uint32_t i) {
    return 2 + (ring - 1) * sides + i % sides;
  };
  for (std::uint32_t i = 0; i < sides; ++i) {
    mesh.triangles.push_back({0, corner(1, i + 1), corner(1, i)});
    mesh.triangles.push_back({1, corner(rings - 1, i), corner(rings - 1, i + 1)});
    for (std::uint32_t ring = 1; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({corner(ring, i), corner(ring, i + 1), corner(ring + 1, i + 1)});
      mesh.triangles.push_back({corner(ring, i), corner(ring + 1, i + 1), corner(ring + 1, i)});
    }
  }
  return mesh;
}

TEST(Thinned, ASphereHasNoEdgesAndFacesOutwards) {
  if (!can_thin()) {
    GTEST_SKIP() << "built without meshoptimizer";
  }
  for (const std::uint32_t sides : {300U, 352U, 353U}) {
    constexpr double kRadius = 12.5;
    const auto few = thinned(sphere(sides, kRadius), 40'000, 0.05);
    ASSERT_TRUE(few) << sides;
    EXPECT_LE(few->triangles.size(), 40'000U) << sides;
    EXPECT_EQ(feature_edges(*few).size(), 0U) << sides;
    double lowest = kRadius;
    for (const auto& [a, b, c] : few->triangles) {
      const Point& p = few->vertices[a];
      const Point n = (few->vertices[b] - p).cross(few->vertices[c] - p);
      const Point middle = (p + few->vertices[b] + few->vertices[c]) / 3.0;
      ASSERT_GT(n.dot(middle), 0.0) << sides;
      lowest = std::min(lowest, middle.norm());
    }
    EXPECT_LT(kRadius - lowest, 0.05) << sides;
  }
}

TEST(Folds, AreMendedByTheOtherDiagonalOrWithoutACorner) {
  // A flat square, one of whose corners is a hair beside the diagonal: the flat triangle stands up.
  parts::Mesh square;
  square.vertices = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {5, 4.999, 0.01}};
  square.triangles = {{0, 1, 4}, {1, 2, 4}, {0, 4, 2}, {0, 2, 3}};
  EXPECT_GT(count_folds(square).seen, 4U) << "its four sides, and more";
  mend_folds(square, 0.05);
  EXPECT_EQ(count_folds(square).seen, 4U);
  // Two triangles of the same corners are a fin.
  square.triangles.push_back({0, 1, 3});
  square.triangles.push_back({1, 0, 3});
  mend_folds(square, 0.05);
  EXPECT_EQ(square.triangles.size(), 4U);
  // The edges of a cube stay.
  const parts::Mesh whole = cylinder(4, 1, 20.0, 30.0);
  parts::Mesh cube = whole;
  mend_folds(cube, 0.05);
  EXPECT_EQ(cube.triangles, whole.triangles);
}

TEST(Thinned, WhatCannotBeShownHonestlyIsNotShown) {
  // A cylinder of twelve triangles is no cylinder.
  EXPECT_FALSE(thinned(cylinder(72, 100, 20.0, 30.0), 12, 0.01).has_value());
}

}  // namespace
}  // namespace g31::picture::picture_meshes_test

// Facets of meshes become the round walls that they stand for.

#include "parts/features/faceted_walls.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "parts/features/recognise.h"

namespace g31::parts::faceted_walls_test {
namespace {

constexpr double kRadius = 10.0;
constexpr double kDepth = 18.0;
const Point kAxis(30.0, 85.0, 0.0);

Point on_circle(double turns, double z) {
  const double angle = 2.0 * std::numbers::pi * turns;
  return kAxis + Point(kRadius * std::cos(angle), kRadius * std::sin(angle), z);
}

/// A wall between two places of the circle, given in turns; the removed volume is inside of it, or
/// around it.
RemovedFace facet(double from, double to, bool is_hollow) {
  RemovedFace face;
  const double angle = std::numbers::pi * (from + to);
  face.normal_P = (is_hollow ? 1.0 : -1.0) * Point(std::cos(angle), std::sin(angle), 0.0);
  for (const double z : {-kDepth, 0.0}) {
    face.border_P.push_back(on_circle(from, z));
    face.border_P.push_back(on_circle(to, z));
  }
  face.at_P = (face.border_P.front() + face.border_P.back()) / 2;
  face.area_mm2 = kDepth * (face.border_P[1] - face.border_P[0]).norm();
  return face;
}

/// A prism of so many sides, the first from an angle.
RemovedVolume prism(int sides, double first, bool is_hollow = true) {
  RemovedVolume volume;
  for (int i = 0; i < sides; ++i) {
    volume.faces.push_back(facet(first + static_cast<double>(i) / sides,
                                 first + static_cast<double>(i + 1) / sides, is_hollow));
  }
  return volume;
}

TEST(FacetedWalls, OfManySidesAreOneCylinder) {
  for (const bool is_hollow : {true, false}) {
    for (const double first : {0.0, 0.013}) {
      RemovedVolume volume = prism(24, first, is_hollow);
      find_round_walls(volume);
      ASSERT_EQ(volume.faces.size(), 1U);
      const RemovedFace& wall = volume.faces.front();
      EXPECT_EQ(wall.surface, FaceSurface::Cylinder);
      EXPECT_EQ(wall.radius_mm, kRadius);
      EXPECT_EQ(wall.axis_at_P.x(), 30.0);
      EXPECT_EQ(wall.axis_at_P.y(), 85.0);
      EXPECT_NEAR(wall.area_mm2, 2.0 * std::numbers::pi * kRadius * kDepth, 1e-9);
      EXPECT_NEAR(wall.facet_error_mm, kRadius * (1.0 - std::cos(std::numbers::pi / 24)), 1e-12);
      const Point out = (wall.at_P - wall.axis_at_P).normalized();
      EXPECT_NEAR(wall.normal_P.dot(out), is_hollow ? 1.0 : -1.0, 1e-12);
    }
  }
}

TEST(FacetedWalls, OfAnOctagonStayWalls) {
  RemovedVolume volume = prism(8, 0.0);
  find_round_walls(volume);
  ASSERT_EQ(volume.faces.size(), 8U);
  EXPECT_EQ(volume.faces.front().surface, FaceSurface::Plane);
}

// A quarter between two straight walls, which touch the circle and are none of it.
TEST(FacetedWalls, OfACornerEndAtTheStraightWalls) {
  RemovedVolume volume;
  RemovedFace straight;
  straight.normal_P = Point::UnitX();
  straight.at_P = kAxis + Point(kRadius, -20.0, -9.0);
  straight.area_mm2 = 40.0 * kDepth;
  for (const double z : {-kDepth, 0.0}) {
    straight.border_P.push_back(kAxis + Point(kRadius, -40.0, z));
    straight.border_P.push_back(kAxis + Point(kRadius, 0.0, z));
  }
  volume.faces.push_back(straight);
  for (int i = 0; i < 6; ++i) {
    volume.faces.push_back(facet(i / 24.0, (i + 1) / 24.0, true));
  }
  find_round_walls(volume);
  ASSERT_EQ(volume.faces.size(), 2U);
  EXPECT_EQ(volume.faces[0].surface, FaceSurface::Cylinder);
  EXPECT_NEAR(volume.faces[0].area_mm2, 0.5 * std::numbers::pi * kRadius * kDepth, 1e-9);
  EXPECT_EQ(volume.faces[1].surface, FaceSurface::Plane);
}

}  // namespace
}  // namespace g31::parts::faceted_walls_test

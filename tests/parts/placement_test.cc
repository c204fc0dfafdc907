#include "parts/geometry/placement.h"

#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace g31::parts::placement_test {
namespace {

TEST(PlacedMesh, TurnsAboutFixedXThenYThenZThenShifts) {
  struct Case {
    const char* name;
    Point at;
    Point rotate_deg;
    Point p_P;
    Point p_M;
  };
  const Case kCases[] = {
      {"untouched", {0, 0, 0}, {0, 0, 0}, {0.1, 0.2, 0.3}, {0.1, 0.2, 0.3}},
      {"shifted", {1, 2, 3}, {0, 0, 0}, {0.5, 0.25, 4}, {1.5, 2.25, 7}},
      {"quarter turn about X", {0, 0, 0}, {90, 0, 0}, {1, 2, 3}, {1, -3, 2}},
      {"quarter turn about Y", {0, 0, 0}, {0, 90, 0}, {1, 2, 3}, {3, 2, -1}},
      {"quarter turn about Z", {0, 0, 0}, {0, 0, 90}, {1, 2, 3}, {-2, 1, 3}},
      {"three quarters backwards", {0, 0, 0}, {0, 0, -270}, {1, 2, 3}, {-2, 1, 3}},
      {"a full turn", {0, 0, 0}, {360, -720, 0}, {1, 2, 3}, {1, 2, 3}},
      {"half turn about Y", {0, 0, 0}, {0, 180, 0}, {1, 2, 3}, {-1, 2, -3}},
      {"first about X, then about Z", {10, 0, 0}, {90, 0, 90}, {1, 2, 3}, {13, 1, 2}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    Mesh mesh;
    mesh.vertices = {c.p_P};
    const Mesh placed = placed_mesh(mesh, {c.at, c.rotate_deg});
    EXPECT_EQ(placed.vertices[0], c.p_M);  // exact, not nearly
    const Sphere sphere = placed_sphere({c.p_P, 12.5}, {c.at, c.rotate_deg});
    EXPECT_EQ(sphere.centre, c.p_M);
    EXPECT_EQ(sphere.radius, 12.5);
  }
}

TEST(PlacedSphere, GrowsFromThePartsOrigin) {
  const Sphere sphere = placed_sphere({{100, 0, 0}, 20.0}, {{1, 2, 3}, {0, 0, 90}, 0.01});
  EXPECT_NEAR((sphere.centre - Point(1, 103, 3)).norm(), 0.0, 1e-13);
  EXPECT_NEAR(sphere.radius, 20.2, 1e-14);
}

TEST(RotationToMachine, AgreesWithQuaternions) {
  for (int i = 0; i < 200; ++i) {
    const Point angles(-400.0 + 3.7 * i, 123.4 - 5.1 * i, 7.7 * i);
    const auto about = [&](Eigen::Index axis) {
      return Eigen::AngleAxisd(angles[axis] * std::numbers::pi / 180.0, Point::Unit(axis));
    };
    const Eigen::Matrix3d expected = (about(2) * about(1) * about(0)).toRotationMatrix();
    EXPECT_NEAR((rotation_to_machine({Point::Zero(), angles}) - expected).norm(), 0.0, 1e-13);
  }
}

}  // namespace
}  // namespace g31::parts::placement_test

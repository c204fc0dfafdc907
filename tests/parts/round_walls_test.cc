#include "parts/import/round_walls.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "parts/geometry/mesh_defects.h"

namespace g31::parts::round_walls_test {
namespace {

constexpr double kRadius = 10.0;
constexpr double kTurn = 2.0 * std::numbers::pi;
const Point kAxis(30.0, 85.0, 0.0);

/// A cup: a round wall of this many facets from Z -18 to 0, closed by discs.
struct Pin {
  explicit Pin(int facets, double first_angle) {
    wall.axis_at = kAxis;
    wall.radius_mm = kRadius;
    const auto n = static_cast<std::uint32_t>(facets);
    for (const double z : {-18.0, 0.0}) {
      for (int i = 0; i < facets; ++i) {
        const double angle = first_angle + kTurn * i / facets;
        mesh.vertices.emplace_back(kAxis.x() + kRadius * std::cos(angle),
                                   kAxis.y() + kRadius * std::sin(angle), z);
      }
    }
    mesh.vertices.emplace_back(kAxis.x(), kAxis.y(), -18.0);
    mesh.vertices.emplace_back(kAxis.x(), kAxis.y(), 0.0);
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t next = (i + 1) % n;
      mesh.triangles.push_back({i, next, n + next});
      mesh.triangles.push_back({i, n + next, n + i});
    }
    wall.last = mesh.triangles.size();
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t next = (i + 1) % n;
      mesh.triangles.push_back({next, i, 2 * n});
      mesh.triangles.push_back({n + i, n + next, 2 * n + 1});
    }
  }

  Mesh mesh;
  RoundWall wall;
};

/// How far a ball of this radius inside of the wall comes along a direction from the axis, in the
/// polygon of the wall: as far as the nearest side lets it, by the closed form of lines and
/// corners.
double reach_in_hole(const Mesh& mesh, const Point& direction, double ball) {
  double reach = 1e9;
  for (const auto& triangle : mesh.triangles) {
    std::vector<Point> low;
    for (const auto vertex : triangle) {
      const Point p = mesh.vertices[vertex] - kAxis;
      if (p.z() < -17.0 && std::hypot(p.x(), p.y()) > 1.0) {
        low.push_back({p.x(), p.y(), 0.0});
      }
    }
    if (low.size() != 2) {
      continue;
    }
    const Point along = (low[1] - low[0]).normalized();
    Point out(along.y(), -along.x(), 0.0);
    out *= out.dot(low[0]) < 0.0 ? -1.0 : 1.0;
    if (out.dot(direction) <= 0.0) {
      continue;
    }
    const double s = (out.dot(low[0]) - ball) / out.dot(direction);
    const double foot = along.dot(s * direction + ball * out - low[0]);
    if (foot > -1e-12 && foot < (low[1] - low[0]).norm() + 1e-12) {
      reach = std::min(reach, s);
    }
  }
  return reach;
}

TEST(RoundWalls, ABallTouchesThemAtTheirExtremesWhereTheyTrulyAre) {
  for (const double first_angle : {0.0, 0.013, 0.04}) {
    Pin pin(70, first_angle);
    const Mesh coarse = pin.mesh;
    refine_round_walls(pin.mesh, {pin.wall});
    for (const Point& direction :
         {Point(1, 0, 0), Point(0, 1, 0), Point(-1, 0, 0), Point(0, -1, 0)}) {
      for (const double ball : {0.5, 3.0, 6.0, 9.0}) {
        EXPECT_NEAR(reach_in_hole(pin.mesh, direction, ball), kRadius - ball, kSagittaAtExtremesMm)
            << first_angle << " " << direction.transpose() << " " << ball;
      }
    }
    // Without it the same ball is off by a thousand times as much: the test can fail.
    EXPECT_LT(reach_in_hole(coarse, {std::cos(0.7), std::sin(0.7), 0.0}, 3.0),
              kRadius - 3.0 - 1e-4);
  }
}

TEST(RoundWalls, StayTheSurfaceOfASolid) {
  Pin pin(70, 0.013);
  refine_round_walls(pin.mesh, {pin.wall});
  const MeshDefects defects = defects_of(pin.mesh);
  EXPECT_EQ(defects.open_edges.count, 0U);
  EXPECT_EQ(defects.flipped_facets.count, 0U);
  EXPECT_EQ(defects.inward_shells.count, 0U);
  EXPECT_EQ(defects.self_contacts.count, 0U);
  EXPECT_EQ(defects.flat_facets.count, 0U);
}

TEST(RoundWalls, AWallWithVerticesBetweenItsEndsStaysAsItIs) {
  Pin pin(70, 0.0);
  pin.mesh.vertices[0].z() = -9.0;
  const Mesh before = pin.mesh;
  refine_round_walls(pin.mesh, {pin.wall});
  EXPECT_EQ(pin.mesh.triangles, before.triangles);
}

}  // namespace
}  // namespace g31::parts::round_walls_test

// The normal of the surface that facets stand for: of bores and bosses it is the radius.

#include "probe/contact/smooth_normal.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace g31::probe::smooth_normal_test {
namespace {

/// The wall of a cylinder about Z, of height 20, with a ring of corners in the middle and a lid.
parts::Mesh cylinder(int facets, double radius) {
  parts::Mesh mesh;
  const auto n = static_cast<std::uint32_t>(facets);
  for (const double z : {-10.0, 0.0, 10.0}) {
    for (int i = 0; i < facets; ++i) {
      const double angle = 2.0 * std::numbers::pi * (i + 0.3) / facets;
      mesh.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }
  const std::uint32_t middle = 3 * n;
  mesh.vertices.push_back({0.0, 0.0, 10.0});
  for (std::uint32_t ring = 0; ring < 2; ++ring) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = ring * n + i;
      const std::uint32_t b = ring * n + (i + 1) % n;
      mesh.triangles.push_back({a, b, b + n});
      mesh.triangles.push_back({a, b + n, a + n});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({2 * n + i, 2 * n + (i + 1) % n, middle});
  }
  return mesh;
}

double angle_between(const Point& a, const Point& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

TEST(SmoothNormal, IsTheRadiusThroughTheBallInBoresAndOnBosses) {
  std::mt19937_64 random(20260918);
  std::uniform_real_distribution<double> beside(-15.0, 15.0);
  std::uniform_real_distribution<double> height(-6.0, 6.0);
  for (const int facets : {24, 72, 1440}) {
    const ContactMesh mesh(cylinder(facets, 20.0));
    for (const double ball : {0.5, 3.0}) {
      const MeshSweeper sweeper(cylinder(facets, 20.0), ball);
      for (int i = 0; i < 40; ++i) {
        const double y = beside(random);
        const double z = height(random);
        const bool is_bore = i % 2 == 0;
        const SweepHit hit = is_bore ? sweeper.sweep({0.0, y, z}, {30.0, y, z})
                                     : sweeper.sweep({40.0, y, z}, {0.0, y, z});
        ASSERT_EQ(hit.status, SweepStatus::Contact);
        const Point radius(hit.p_M_centre.x(), hit.p_M_centre.y(), 0.0);
        const Point expected = (is_bore ? -1.0 : 1.0) * radius.normalized();
        EXPECT_LT(angle_between(smooth_normal(mesh, hit), expected), kSmoothNormalError)
            << facets << " facets, ball " << ball << ", y " << y << (is_bore ? " bore" : " boss");
      }
    }
  }
}

TEST(SmoothNormal, OfAPlaneAndASharpEdgeIsTheContactsOwn) {
  const parts::Mesh mesh = cylinder(72, 20.0);
  const MeshSweeper sweeper(mesh, 3.0);
  const SweepHit lid = sweeper.sweep({3.0, 4.0, 30.0}, {3.0, 4.0, 0.0});
  EXPECT_LT(angle_between(smooth_normal(ContactMesh(mesh), lid), Point::UnitZ()), 1e-12);
  const SweepHit edge = sweeper.sweep({21.5, 0.0, 30.0}, {21.5, 0.0, 0.0});
  ASSERT_EQ(edge.status, SweepStatus::Contact);
  EXPECT_EQ(smooth_normal(ContactMesh(mesh), edge), edge.n_M);
}

}  // namespace
}  // namespace g31::probe::smooth_normal_test

#include "probe/contact/sweep_curve.h"

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/probe/test_meshes.h"

namespace g31::probe::sweep_curve_test {
namespace {

using testing::between;

constexpr double kPi = std::numbers::pi;

/// A helix around an axis through `centre` along a unit vector.
struct Helix {
  Point centre;
  Point first;   ///< unit vector, where t = 0 points
  Point second;  ///< unit vector at right angles
  double radius = 0.0;
  double turned_rad = 0.0;
  Point rise = Point::Zero();

  [[nodiscard]] Point at(double t) const {
    const double angle = turned_rad * t;
    return centre + radius * (std::cos(angle) * first + std::sin(angle) * second) + t * rise;
  }
  [[nodiscard]] Curve curve() const {
    return {[*this](double t) { return at(t); }, radius * turned_rad * turned_rad};
  }
};

/// The block's top is at z = 0; the ball comes down to it on an arc in the XZ plane.
TEST(SweepCurve, MeetsAFaceWhereTheArcIsAsHighAsTheRadius) {
  const parts::Mesh block = testing::moved_by(testing::box_mesh({200, 200, 50}), {-100, -100, -50});
  const MeshSweeper sweeper(block, 3.0);
  for (const double radius : {0.5, 10.0, 60.0, 90.0}) {
    for (const double above : {0.0, 1e-6, 0.1 * radius, 0.9 * radius}) {
      // From the top of the circle down; its centre is `above` over the height of the contact.
      const Helix arc{{0, 0, 3.0 + above}, Point::UnitZ(), Point::UnitX(), radius, 1.5 * kPi};
      const CurveHit found = sweep_curve(sweeper, arc.curve());
      ASSERT_EQ(found.hit.status, SweepStatus::Contact);
      const double angle = std::acos(-above / radius);
      const double slope = radius * std::sin(angle);
      EXPECT_NEAR(found.t * arc.turned_rad, angle, 2.0 * kCurveErrorMm / slope);
      EXPECT_NEAR(found.hit.p_M_centre.z(), 3.0, 1e-7);
      EXPECT_NEAR((found.hit.p_M_centre - arc.at(found.t)).norm(), 0.0, 1e-7);
      EXPECT_NEAR((found.hit.n_M - Point::UnitZ()).norm(), 0.0, 1e-7);
    }
  }
}

TEST(SweepCurve, PassesByAFaceThatTheArcJustDoesNotReach) {
  const parts::Mesh block = testing::moved_by(testing::box_mesh({200, 200, 50}), {-100, -100, -50});
  const MeshSweeper sweeper(block, 3.0);
  for (const double gap : {1.0, 1e-3, 1e-6, 1e-7, -1e-7, -1e-6, -1e-3}) {
    const Helix arc{{0, 0, 23.0 + gap}, Point::UnitZ(), Point::UnitX(), 20.0, 2.0 * kPi};
    const CurveHit found = sweep_curve(sweeper, arc.curve());
    EXPECT_EQ(found.hit.status, gap > 0.0 ? SweepStatus::Miss : SweepStatus::Contact) << gap;
    if (gap < 0.0) {
      EXPECT_NEAR(found.t * arc.turned_rad, kPi - std::acos(1.0 + gap / 20.0),
                  2.0 * kCurveErrorMm / std::sqrt(-2.0 * 20.0 * gap));
    }
  }
}

/// How deep in the mesh a ball is at the deepest of many places of the curve up to t, mm.
double deepest_before(const parts::Mesh& mesh, double radius, const Curve& curve, double t) {
  constexpr int kPlaces = 3000;
  const ContactMesh contact(mesh);
  double deepest = 0.0;
  for (int i = 0; i <= kPlaces; ++i) {
    if (const auto touch = contact.nearest_within(curve.at(t * i / kPlaces), radius)) {
      deepest = std::max(deepest, radius - touch->distance);
    }
  }
  return deepest;
}

TEST(SweepCurve, NeverGoesDeeperThanItSays) {
  const parts::Mesh kMeshes[] = {
      testing::box_mesh({30.0, 20.0, 10.0}), testing::loose_triangles(3, 30),
      testing::shaken(testing::sphere_mesh(12.0, 8), 1.5, 11), testing::sphere_mesh(15.0, 30)};
  std::mt19937_64 random(4);
  int contacts = 0;
  int misses = 0;
  for (const parts::Mesh& mesh : kMeshes) {
    const MeshSweeper sweeper(mesh, 1.5);
    for (int i = 0; i < 100; ++i) {
      const Point first = testing::any_direction(random);
      const Point second = first.cross(testing::any_direction(random)).normalized();
      const Helix helix{testing::point_between(random, -25.0, 25.0),
                        first,
                        second,
                        between(random, 0.1, 40.0),
                        between(random, 0.1, 2.0 * kPi),
                        testing::point_between(random, -9.0, 9.0)};
      const Curve curve = helix.curve();
      const CurveHit found = sweep_curve(sweeper, curve);
      if (found.hit.status == SweepStatus::StartInContact) {
        continue;
      }
      EXPECT_LE(deepest_before(mesh, 1.5, curve, found.t), 2e-8);
      if (found.hit.status == SweepStatus::Miss) {
        EXPECT_EQ(found.t, 1.0);
        ++misses;
        continue;
      }
      ++contacts;
      EXPECT_NEAR((found.hit.p_M_centre - found.hit.p_M_point).norm(), 1.5, 2e-8);
      EXPECT_NEAR((found.hit.p_M_centre - curve.at(found.t)).norm(), 0.0, 3e-8);
    }
  }
  EXPECT_GT(contacts, 50);
  EXPECT_GT(misses, 50);
}

/// The table turns by C while X moves: in the part's frame the ball goes along a spiral.
TEST(SweepCurve, FollowsLinearAndRotaryAxesTogether) {
  const double kTurnRad = 0.5 * kPi;
  const Point from(60, 20, 5);
  const Point to(0, 8, 5);
  const parts::Mesh block = testing::moved_by(testing::box_mesh({20, 20, 10}), {-10, -10, 0});
  const MeshSweeper sweeper(block, 3.0);
  // |x'' | <= |rotation|^2 |p| + 2 |rotation| |p'|.
  const double bend = kTurnRad * kTurnRad * from.norm() + 2.0 * kTurnRad * (to - from).norm();
  const Curve curve{
      [&](double t) {
        return Point(Eigen::AngleAxisd(-kTurnRad * t, Point::UnitZ()) * (from + t * (to - from)));
      },
      bend};
  const CurveHit found = sweep_curve(sweeper, curve);
  ASSERT_EQ(found.hit.status, SweepStatus::Contact);
  // Bisection on the distance from the box, which is closed form.
  const auto gap = [&](double t) {
    const Point p = curve.at(t);
    return (p - p.cwiseMax(Point(-10, -10, 0)).cwiseMin(Point(10, 10, 10))).norm() - 3.0;
  };
  double free = 0.0;
  double touching = 0.0;
  while (gap(touching) > 0.0) {
    free = touching;
    touching += 1e-4;
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (free + touching);
    (gap(middle) > 0.0 ? free : touching) = middle;
  }
  EXPECT_NEAR(found.t * (to - from).norm(), free * (to - from).norm(), 1e-7);
}

TEST(SweepCurve, LeavesAContactOnAnArcAndMeetsTheNextOne) {
  const MeshSweeper sweeper(testing::sphere_mesh(20.0, 60), 3.0);
  // Round the sphere, 0.1 mm in it: the arc stays at that depth, give or take the facets.
  const Helix around{Point::Zero(), Point::UnitX(), Point::UnitY(), 22.9, kPi};
  EXPECT_EQ(
      first_contact_leaving_on_curve(
          sweeper, Helix{{0.2, 0, 0}, Point::UnitX(), Point::UnitY(), 22.7, 0.1 * kPi}.curve())
          .hit.status,
      SweepStatus::Contact)
      << "this arc goes deeper";
  // Away from it in a wide bend, and back to it from the other side.
  const Helix away{{40.0, 0, 0}, -Point::UnitX(), Point::UnitY(), 40.0 - 22.9, 1.5 * kPi};
  EXPECT_EQ(first_contact_leaving_on_curve(sweeper, away.curve()).hit.status, SweepStatus::Miss);
  const Helix full{{40.0, 0, 0}, -Point::UnitX(), Point::UnitY(), 40.0 - 22.9, 2.0 * kPi};
  const CurveHit back = first_contact_leaving_on_curve(sweeper, full.curve());
  ASSERT_EQ(back.hit.status, SweepStatus::Contact);
  EXPECT_NEAR((back.hit.p_M_centre - full.at(back.t)).norm(), 0.0, 1e-7);
  EXPECT_NEAR(back.hit.p_M_centre.norm(), 23.0, 0.03);
  EXPECT_GT(back.t, 0.9);
  EXPECT_EQ(sweep_curve(sweeper, around.curve()).hit.status, SweepStatus::StartInContact);
}

TEST(SweepCurve, TakesAFullCircleAndAPointForWhatTheyAre) {
  const MeshSweeper sweeper(testing::box_mesh({10, 10, 10}), 1.0);
  const Helix round{{5, 5, 5}, Point::UnitX(), Point::UnitY(), 8.5, 2.0 * kPi};
  EXPECT_EQ(sweep_curve(sweeper, round.curve()).hit.status, SweepStatus::Miss);
  const Helix closer{{5, 5, 5}, Point::UnitX(), Point::UnitY(), 7.5, 2.0 * kPi};
  EXPECT_EQ(sweep_curve(sweeper, closer.curve()).hit.status, SweepStatus::Contact);
  const Curve still{[](double) { return Point(20, 5, 5); }, 0.0};
  EXPECT_EQ(sweep_curve(sweeper, still).hit.status, SweepStatus::Miss);
  EXPECT_EQ(first_contact_leaving_on_curve(sweeper, still).hit.status, SweepStatus::Miss);
}

}  // namespace
}  // namespace g31::probe::sweep_curve_test

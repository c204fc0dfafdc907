// A mesh that stands for a true sphere is met as that sphere, however coarse its facets: contacts
// against the roots of the quadratic equation in long double.

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "parts/geometry/placement.h"
#include "probe/contact/first_surface.h"
#include "probe/contact/smooth_normal.h"
#include "probe/contact/sweep_curve.h"
#include "probe/contact/sweep_mesh.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::true_sphere_test {
namespace {

using testing::any_direction;
using testing::between;

constexpr double kRad = std::numbers::pi / 180.0;
constexpr double kBall = 3.0;

/// 25 mm, facets up to 0.05 mm off.
std::shared_ptr<const ContactMesh> sphere_at(const Point& p_M_at, double growth = 0.0) {
  parts::PartSetup setup;
  setup.name = "ball";
  setup.shape = "sphere";
  setup.sizes = {{"diameter", 25.0}, {"sagitta", 0.05}};
  const parts::Placement place{p_M_at, {10.0, 20.0, 30.0}, growth};
  return std::make_shared<const ContactMesh>(
      parts::placed_mesh(parts::make_artefact(setup).value(), place),
      parts::placed_sphere(parts::exact_sphere(setup).value(), place));
}

constexpr double kRadius = 12.5;
const Point kAt(321.25, -170.5, 88.125);

/// mm along the line from `from` until its distance from `centre` is first `distance`; the start
/// is farther away.  nullopt: it never is.
std::optional<double> first_at_distance(const Point& from, const Point& direction,
                                        const Point& centre, double distance) {
  using Real = long double;
  Real b = 0.0L;
  Real c = -static_cast<Real>(distance) * distance;
  Real a = 0.0L;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Real offset = static_cast<Real>(from[i]) - centre[i];
    const Real along = direction[i];
    a += along * along;
    b += along * offset;
    c += offset * offset;
  }
  const Real discriminant = b * b - a * c;
  if (discriminant < 0.0L || b > 0.0L) {
    return std::nullopt;
  }
  return static_cast<double>((-b - std::sqrt(discriminant)) / a);
}

TEST(TrueSphere, IsMetWhereTheQuadraticEquationSays) {
  std::mt19937_64 random(1);
  const auto mesh = sphere_at(kAt);
  for (const double ball : {0.5, 3.0, 40.0}) {
    const MeshSweeper sweeper(mesh, ball);
    int contacts = 0;
    for (int i = 0; i < 2000; ++i) {
      const Point from = kAt + between(random, kRadius + ball + 1.0, 200.0) * any_direction(random);
      const Point aim = kAt + between(random, 0.0, kRadius + ball + 2.0) * any_direction(random);
      const Point to = from + 500.0 * (aim - from).normalized();
      const Point along = (to - from).normalized();
      const auto expected = first_at_distance(from, along, kAt, kRadius + ball);
      const SweepHit hit = sweeper.sweep(from, to);
      ASSERT_EQ(hit.status, expected ? SweepStatus::Contact : SweepStatus::Miss) << i;
      if (!expected) {
        continue;
      }
      ++contacts;
      EXPECT_NEAR(hit.s, *expected, kContactErrorMm / std::max(hit.cos_incidence, 1e-5)) << i;
      EXPECT_NEAR((hit.p_M_centre - kAt).norm(), kRadius + ball, kContactErrorMm);
      EXPECT_NEAR((hit.p_M_point - kAt).norm(), kRadius, kContactErrorMm);
      EXPECT_NEAR((hit.p_M_point + ball * hit.n_M - hit.p_M_centre).norm(), 0.0, kContactErrorMm);
      EXPECT_NEAR(hit.cos_incidence, -along.dot(hit.n_M), 1e-15);
      EXPECT_EQ(hit.triangle, kNoTriangle);
      EXPECT_EQ(smooth_normal(*mesh, hit), hit.n_M);
      EXPECT_EQ(sweeper.first_contact_leaving(from, to).s, hit.s);
    }
    EXPECT_GT(contacts, 1000);
  }
}

TEST(TrueSphere, GrowsWithWarmth) {
  constexpr double kGrowth = 2e-4;
  const MeshSweeper sweeper(sphere_at(Point::Zero(), kGrowth), kBall);
  const SweepHit hit = sweeper.sweep({40, 30, 0}, {0, 0, 0});
  EXPECT_NEAR(hit.s, 50.0 - kRadius * (1.0 + kGrowth) - kBall, kContactErrorMm);
}

TEST(TrueSphere, TangencyTouchesAndAHairsBreadthMisses) {
  const MeshSweeper sweeper(sphere_at(Point::Zero()), kBall);
  const double out = kRadius + kBall;
  EXPECT_EQ(sweeper.sweep({-50, 0, out}, {50, 0, out}).status, SweepStatus::Contact);
  EXPECT_NEAR(sweeper.sweep({-50, 0, out}, {50, 0, out}).s, 50.0, 1e-6);
  EXPECT_EQ(sweeper.sweep({-50, 0, out + 1e-9}, {50, 0, out + 1e-9}).status, SweepStatus::Miss);
  // Where a corner of a facet stands out by up to 0.05 mm it would have touched.
  EXPECT_EQ(sweeper.sweep({0, 0, 60}, {0, 0, out + 1e-9}).status, SweepStatus::Miss);
  EXPECT_EQ(sweeper.sweep({0, 0, 60}, {0, 0, out}).status, SweepStatus::Contact);
}

TEST(TrueSphere, KnowsHowDeepABallStands) {
  const MeshSweeper sweeper(sphere_at(kAt), kBall);
  std::mt19937_64 random(2);
  for (const double depth : {0.001, 0.5, 2.9, 3.5, 9.0}) {
    const Point out = any_direction(random);
    const Point at = kAt + (kRadius + kBall - depth) * out;
    const SweepHit hit = sweeper.sweep(at, at + out);
    EXPECT_EQ(hit.status, SweepStatus::StartInContact);
    EXPECT_NEAR((hit.n_M - out).norm(), 0.0, 1e-12);
    EXPECT_NEAR((hit.p_M_point - (kAt + kRadius * out)).norm(), 0.0, 1e-12);
    EXPECT_NEAR(sweeper.distance_if_touching(at).value(), kBall - depth, 1e-12);
    EXPECT_EQ(sweeper.first_contact_leaving(at, at + 20.0 * out).status, SweepStatus::Miss);
    const SweepHit pushed = sweeper.first_contact_leaving(at, at - 2.0 * out);
    EXPECT_EQ(pushed.status, SweepStatus::Contact);
    EXPECT_NEAR(pushed.s, kTouchBandMm, 1e-12);
  }
  EXPECT_EQ(sweeper.distance_if_touching(kAt + (kRadius + kBall + 1e-6) * Point::UnitX()),
            std::nullopt);
}

TEST(TrueSphere, IsLeftAtEveryAngle) {
  const MeshSweeper sweeper(sphere_at(kAt), kBall);
  std::mt19937_64 random(3);
  for (const double depth : {0.0, 0.001, 0.05, 0.3}) {
    for (const double exit_deg : {0.25, 1.0, 8.0, 45.0, 90.0}) {
      for (int i = 0; i < 20; ++i) {
        const Point out = any_direction(random);
        const Point aside = out.cross(any_direction(random)).normalized();
        const Point from = kAt + (kRadius + kBall - depth) * out;
        const Point way = std::cos(exit_deg * kRad) * aside + std::sin(exit_deg * kRad) * out;
        EXPECT_EQ(sweeper.first_contact_leaving(from, from + 40.0 * way).status, SweepStatus::Miss)
            << depth << " mm deep, " << exit_deg << " degrees";
        EXPECT_EQ(sweeper.leave(from, from + 40.0 * way, kBall - depth, kLeaveFreely).hit.status,
                  SweepStatus::Miss);
      }
    }
  }
}

/// A ball on a circle of radius a about a point that is d from the sphere's centre comes to the
/// distance e from it where a^2 + d^2 - 2 a d cos(angle) = e^2.
TEST(TrueSphere, IsMetOnArcs) {
  const MeshSweeper sweeper(sphere_at(kAt), kBall);
  std::mt19937_64 random(4);
  for (int i = 0; i < 100; ++i) {
    const Point towards = any_direction(random);
    const Point aside = towards.cross(any_direction(random)).normalized();
    const double d = between(random, 30.0, 80.0);
    const double a = between(random, d - 14.0, d + 14.0);
    const double e = kRadius + kBall;
    const double angle = std::acos((a * a + d * d - e * e) / (2.0 * a * d));
    const Point middle = kAt - d * towards;
    const Curve curve{[&](double t) {
                        const double from_sphere = (1.0 - t) * std::numbers::pi;
                        return Point(middle + a * (std::cos(from_sphere) * towards +
                                                   std::sin(from_sphere) * aside));
                      },
                      a * std::numbers::pi * std::numbers::pi};
    const CurveHit hit = sweep_curve(sweeper, curve);
    ASSERT_EQ(hit.hit.status, SweepStatus::Contact);
    EXPECT_NEAR((1.0 - hit.t) * std::numbers::pi, angle,
                2.0 * kCurveErrorMm / (hit.hit.cos_incidence * a));
  }
}

TEST(TrueSphere, IsSeenByRaysAndTouchedByBodiesAsItsFacets) {
  const auto mesh = sphere_at(kAt);
  std::mt19937_64 random(5);
  for (int i = 0; i < 500; ++i) {
    const Point from = kAt + between(random, 13.0, 100.0) * any_direction(random);
    const Point aim = kAt + between(random, 0.0, 14.0) * any_direction(random);
    const Point along = (aim - from).normalized();
    const auto expected = first_at_distance(from, along, kAt, kRadius);
    const auto seen = first_surface(*mesh, {from, along, 300.0});
    ASSERT_EQ(seen.has_value(), expected.has_value());
    if (seen) {
      EXPECT_NEAR(*seen, *expected, 1e-7);
      EXPECT_NEAR((from + *seen * along - kAt).norm(), kRadius, kRayErrorMm);
      EXPECT_EQ(first_surface(*mesh, {from, along, *seen - 1e-6}), std::nullopt);
    }
  }
  EXPECT_NEAR(first_surface(*mesh, {kAt, Point::UnitX(), 20.0}).value(), kRadius, kRayErrorMm);
  EXPECT_EQ(mesh->triangles().size(), sphere_at(Point::Zero())->mesh().triangles.size());
  EXPECT_GT(mesh->triangles().size(), 100U);
}

}  // namespace
}  // namespace g31::probe::true_sphere_test

#include "probe/contact/sweep_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/probe/exact_sweep.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe {
namespace {

using testing::any_direction;
using testing::between;
using testing::ExactSweep;
using testing::point_between;

struct Way {
  Point from;
  Point to;
};

Point any_point_on(const parts::Mesh& mesh, std::mt19937_64& random) {
  const auto& t = mesh.triangles[random() % mesh.triangles.size()];
  // A third each: a vertex, a point of an edge, a point of the face.
  const auto kind = random() % 3;
  const double a = kind == 0 ? 0.0 : between(random, 0.0, 1.0);
  const double b = kind == 2 ? between(random, 0.0, 1.0 - a) : 0.0;
  return (1.0 - a - b) * mesh.vertices[t[0]] + a * mesh.vertices[t[1]] + b * mesh.vertices[t[2]];
}

/// A direction that makes things difficult: along an edge, in the plane of a face, along an axis,
/// each sometimes off by a tiny angle.
Point awkward_direction(const parts::Mesh& mesh, std::mt19937_64& random) {
  const auto& t = mesh.triangles[random() % mesh.triangles.size()];
  const Point ab = mesh.vertices[t[1]] - mesh.vertices[t[0]];
  const Point ac = mesh.vertices[t[2]] - mesh.vertices[t[0]];
  Point direction = any_direction(random);
  const double along_ab = between(random, -1.0, 1.0);
  const double along_ac = between(random, -1.0, 1.0);
  const double tilt = std::pow(10.0, between(random, -16.0, -1.0));
  switch (random() % 4) {
    case 0:
      direction = ab;
      break;
    case 1:
      direction = along_ab * ab + along_ac * ac;
      break;
    case 2:
      direction = Point::Unit(static_cast<Eigen::Index>(random() % 3));
      break;
    default:
      break;
  }
  if (direction.norm() < 1e-6) {
    direction = Point::UnitX();
  }
  direction.normalize();
  if (random() % 2 == 0) {
    direction += tilt * any_direction(random);
  }
  return direction.normalized();
}

/// Half aimed at the mesh, half passing it at about the radius: grazing within 1e-1..1e-14 mm.
Way next_way(const parts::Mesh& mesh, double radius, std::mt19937_64& random) {
  const double length =
      random() % 8 == 0 ? between(random, 100.0, 500.0) : between(random, 5.0, 40.0);
  const Point direction =
      random() % 2 == 0 ? any_direction(random) : awkward_direction(mesh, random);
  Point through = any_point_on(mesh, random);
  if (random() % 2 == 0) {
    const Point aside = direction.cross(any_direction(random)).normalized();
    const double off = random() % 4 == 0 ? 0.0 : std::pow(10.0, between(random, -14.0, -1.0));
    through += aside * (radius + (random() % 2 == 0 ? off : -off));
  }
  const Point from = through - between(random, 0.3, 1.3) * length * direction;
  return {from, from + length * direction};
}

struct Worst {
  double gap = 0.0;
  double steep_s = 0.0;
  int contacts = 0;
  int misses = 0;
  int starts_in_contact = 0;
};

/// One sweep against the judge.  @param error_mm  allowed in the radius
void judge(const parts::Mesh& mesh, const MeshSweeper& sweeper, double radius, const Way& way,
           double error_mm, Worst& worst) {
  const ExactSweep exact(mesh, way.from, way.to);
  const double start_gap = exact.gap_at(0.0, radius);
  const SweepHit hit = sweeper.sweep(way.from, way.to);
  if (start_gap < -kTouchBandMm - error_mm) {
    EXPECT_EQ(hit.status, SweepStatus::StartInContact);
    EXPECT_NEAR((hit.p_M_centre - hit.p_M_point).norm() - radius, start_gap, error_mm);
    ++worst.starts_in_contact;
    return;
  }
  if (start_gap < kTouchBandMm + error_mm) {
    return;  // in touch: the tests of the start below
  }
  const double s = hit.status == SweepStatus::Miss ? ExactSweep::kMiss : hit.s;
  // A slightly bigger ball touches earlier, a slightly smaller one later: the answer must lie
  // between the two, however the ball grazes.
  ASSERT_GE(s, exact.first_contact(radius, error_mm) - 1e-12);
  ASSERT_LE(s, exact.first_contact(radius, -error_mm) + 1e-12);
  if (hit.status == SweepStatus::Miss) {
    ++worst.misses;
    return;
  }
  ++worst.contacts;
  ASSERT_EQ(hit.status, SweepStatus::Contact);
  worst.gap = std::max(worst.gap, std::fabs(exact.gap_at(s, radius)));
  const double exact_s = exact.first_contact(radius, 0.0);
  if (hit.cos_incidence > 0.01 && exact_s < ExactSweep::kMiss) {
    worst.steep_s = std::max(worst.steep_s, std::fabs(s - exact_s));
  }
  EXPECT_NEAR(hit.n_M.norm(), 1.0, 1e-12);
  EXPECT_NEAR((hit.p_M_centre - hit.p_M_point - radius * hit.n_M).norm(), 0.0, 1e-10);
  EXPECT_GE(hit.cos_incidence, -1e-6);
}

TEST(MeshSweeper, AgreesWithQuadruplePrecisionOverAllTriangles) {
  struct Case {
    const char* name;
    parts::Mesh mesh;
    double radius;
    int sweeps;
    double error_mm;
  };
  const Case kCases[] = {
      {"closed box", testing::box_mesh({30.0, 20.0, 10.0}), 3.0, 5000, kContactErrorMm},
      {"sphere of 180 triangles", testing::sphere_mesh(15.0, 10), 1.0, 5000, kContactErrorMm},
      {"60 loose triangles", testing::loose_triangles(1, 60), 2.0, 5000, kContactErrorMm},
      {"60 loose triangles, tiny ball", testing::loose_triangles(2, 60), 0.05, 2500,
       kContactErrorMm},
      // The rule for slivers lets the ball stand too low by up to (5e-6)^2 / (2 r).
      {"60 slivers", testing::slivers(3, 60), 0.5, 5000, kContactErrorMm + 2.5e-11},
      {"60 slivers, bigger ball", testing::slivers(4, 60), 3.0, 2500, kContactErrorMm + 5e-12},
  };
  std::mt19937_64 random(20240607);
  int starts_in_contact = 0;
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const MeshSweeper sweeper(c.mesh, c.radius);
    Worst worst;
    for (int i = 0; i < c.sweeps && !HasFatalFailure(); ++i) {
      SCOPED_TRACE(i);
      judge(c.mesh, sweeper, c.radius, next_way(c.mesh, c.radius, random), c.error_mm, worst);
    }
    EXPECT_LE(worst.gap, c.error_mm);
    EXPECT_LE(worst.steep_s, 1e-9);
    // The generator must keep producing all three outcomes, or this test tests less than it says.
    EXPECT_GT(worst.contacts, c.sweeps / 10);
    EXPECT_GT(worst.misses, c.sweeps / 50);
    starts_in_contact += worst.starts_in_contact;
    std::printf("[ measured ] %-32s gap %.1e mm, s %.1e mm; %d contacts %d misses %d in contact\n",
                c.name, worst.gap, worst.steep_s, worst.contacts, worst.misses,
                worst.starts_in_contact);
  }
  EXPECT_GT(starts_in_contact, 1000);
}

/// One triangle in the plane z = 0 under a 3 mm ball, and where the ball must stop.
TEST(MeshSweeper, TouchesFaceEdgeAndVertexWhereFormulasSay) {
  parts::Mesh mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}, {0.0, 10.0, 0.0}};
  mesh.triangles = {{0, 1, 2}};
  const MeshSweeper sweeper(mesh, 3.0);
  struct Case {
    const char* name;
    Point from;
    Point to;
    double s;
    Point n_M;
  };
  const double r5 = std::sqrt(5.0);
  const Case kCases[] = {
      {"onto the face from above", {2, 2, 20}, {2, 2, 0}, 17.0, {0, 0, 1}},
      {"onto the face from below: open meshes have two sides",
       {2, 2, -20},
       {2, 2, 0},
       17.0,
       {0, 0, -1}},
      {"onto an edge, 2 mm outside it",
       {5, -2, 20},
       {5, -2, -20},
       20.0 - r5,
       {0, -2 / 3.0, r5 / 3}},
      {"onto a vertex, 2 mm outside it",
       {-2, 0, 20},
       {-2, 0, -20},
       20.0 - r5,
       {-2 / 3.0, 0, r5 / 3}},
      {"in the plane of the face, onto its edge", {5, -20, 0}, {5, 20, 0}, 17.0, {0, -1, 0}},
      {"along the edge's own line, onto its end", {30, 0, 0}, {0, 0, 0}, 17.0, {1, 0, 0}},
      {"exact tangency to an edge", {5, -3, 20}, {5, -3, -20}, 20.0, {0, -1, 0}},
      {"tangent glide over the face: its edge is touched first",
       {2, -20, 3},
       {2, 20, 3},
       20.0,
       {0, 0, 1}},
      {"reaching the face at the very end", {2, 2, 20}, {2, 2, 3}, 17.0, {0, 0, 1}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const SweepHit hit = sweeper.sweep(c.from, c.to);
    ASSERT_EQ(hit.status, SweepStatus::Contact);
    EXPECT_NEAR(hit.s, c.s, 1e-14 * 20);
    EXPECT_NEAR((hit.n_M - c.n_M).norm(), 0.0, 1e-13);
    EXPECT_EQ(hit.triangle, 0U);
  }
  EXPECT_EQ(sweeper.sweep({2, 2, 20}, {2, 2, 3.0 + 1e-9}).status, SweepStatus::Miss);
  EXPECT_EQ(sweeper.sweep({5, -3 - 1e-9, 20}, {5, -3 - 1e-9, -20}).status, SweepStatus::Miss);
}

TEST(MeshSweeper, KnowsHowAMoveBegins) {
  const MeshSweeper sweeper(testing::box_mesh({20.0, 20.0, 20.0}), 3.0);
  const Point above(7.0, 8.0, 23.0);  // touching the top face
  const Point up = Point::UnitZ();
  struct Case {
    const char* name;
    Point from;
    Point to;
    SweepStatus status;
  };
  const Case kCases[] = {
      {"touching, goes in", above, above - up, SweepStatus::Contact},
      {"touching, goes in at a very flat angle", above, above + Point(10, 0, -1e-6),
       SweepStatus::Contact},
      {"touching, goes away", above, above + up, SweepStatus::Miss},
      {"touching, goes along", above, above + Point(3.0, 0, 0), SweepStatus::Miss},
      {"half a nanometre deep, goes away", above - 0.5e-9 * up, above + up, SweepStatus::Miss},
      {"half a nanometre deep, goes in", above - 0.5e-9 * up, above - up, SweepStatus::Contact},
      {"0.1 mm deep, goes away", above - 0.1 * up, above + up, SweepStatus::StartInContact},
      {"0.1 mm deep, goes in", above - 0.1 * up, above - up, SweepStatus::StartInContact},
      {"no length, free", above + up, above + up, SweepStatus::Miss},
      {"no length, touching", above, above, SweepStatus::Miss},
      {"no length, 0.1 mm deep", above - 0.1 * up, above - 0.1 * up, SweepStatus::StartInContact},
      {"centre on the surface", {7, 8, 20}, {7, 8, 50}, SweepStatus::StartInContact},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const SweepHit hit = sweeper.sweep(c.from, c.to);
    EXPECT_EQ(hit.status, c.status);
    EXPECT_EQ(hit.s, 0.0);
    if (hit.status != SweepStatus::Miss) {
      EXPECT_EQ(hit.n_M, up);
    }
  }
}

TEST(MeshSweeper, LetsABallLeaveButNotPush) {
  const parts::Mesh mesh = testing::box_mesh({20.0, 20.0, 20.0});
  const MeshSweeper sweeper(mesh, 3.0);
  const Point deep(7.0, 8.0, 22.9);  // 0.1 mm in the top face
  struct Case {
    const char* name;
    Point from;
    Point to;
    std::optional<double> s;  ///< none: free
  };
  const Case kCases[] = {
      {"free way in the air", {7, 8, 30}, {0, 0, 30}, std::nullopt},
      {"from the air onto the face", {7, 8, 30}, {7, 8, 0}, 7.0},
      {"leaves upwards", deep, {7, 8, 60}, std::nullopt},
      {"leaves at a flat angle", deep, {12, 6, 22.91}, std::nullopt},
      {"rubs along at the same depth", deep, {10, 5, 22.9}, std::nullopt},
      {"pushes straight in", deep, {7, 8, 22}, 1e-9},
      {"pushes in at 1:1000", deep, {8, 8, 22.899}, 1e-9 * std::sqrt(1e6 + 1)},
      {"only touching, pushes in", {7, 8, 23}, {7, 8, 20}, 1e-9},
      {"only touching, goes along", {7, 8, 23}, {9, 8, 23}, std::nullopt},
      {"deep at the edge of the block, leaves slantwise", {21, 8, 22.7}, {31, 8, 32}, std::nullopt},
      {"deep at the edge of the block, pushes under it",
       {21, 8, 22.7},
       {21, 8, 12},
       1e-9 * std::hypot(1.0, 2.7) / 2.7},
      {"no length", deep, deep, std::nullopt},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const SweepHit hit = sweeper.first_contact_leaving(c.from, c.to);
    EXPECT_EQ(hit.status, c.s ? SweepStatus::Contact : SweepStatus::Miss);
    if (c.s) {
      EXPECT_NEAR(hit.s, *c.s, 1e-12 + 1e-4 * (*c.s < 1e-3 ? *c.s : 0.0));
    }
  }
}

TEST(MeshSweeper, LeavesOneWallAndMeetsTheOther) {
  // Two walls 20 mm apart; the ball overlaps the left one and moves to the right.
  parts::Mesh mesh;
  for (const double x : {0.0, 20.0}) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(),
                         {{x, -50.0, -50.0}, {x, 50.0, -50.0}, {x, 0.0, 60.0}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const MeshSweeper sweeper(mesh, 3.0);
  const SweepHit hit = sweeper.first_contact_leaving({2.5, 0, 0}, {40, 0, 0});
  ASSERT_EQ(hit.status, SweepStatus::Contact);
  EXPECT_NEAR(hit.s, 14.5, 1e-13);
  EXPECT_EQ(hit.triangle, 1U);
  EXPECT_EQ(hit.n_M, Point(-1, 0, 0));
}

TEST(MeshSweeper, OfNothingIsAlwaysAMiss) {
  const MeshSweeper sweeper(parts::Mesh{}, 3.0);
  EXPECT_EQ(sweeper.sweep({0, 0, 0}, {1, 2, 3}).status, SweepStatus::Miss);
  EXPECT_EQ(sweeper.first_contact_leaving({0, 0, 0}, {1, 2, 3}).status, SweepStatus::Miss);
}

TEST(MeshSweeper, GivesTheSameFromManyThreads) {
  const MeshSweeper sweeper(testing::sphere_mesh(15.0, 20), 1.0);
  const auto run = [&] {
    std::mt19937_64 random(5);
    std::vector<double> found;
    for (int i = 0; i < 2000; ++i) {
      const Point from = 25.0 * any_direction(random);
      found.push_back(sweeper.sweep(from, point_between(random, -15.0, 15.0)).s);
    }
    return found;
  };
  const std::vector<double> alone = run();
  std::vector<std::vector<double>> together(4);
  std::vector<std::thread> threads;
  for (auto& result : together) {
    threads.emplace_back([&result, &run] { result = run(); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const auto& result : together) {
    EXPECT_EQ(result, alone);
  }
}

}  // namespace
}  // namespace g31::probe

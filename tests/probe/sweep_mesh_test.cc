#include "probe/contact/sweep_mesh.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/probe/test_meshes.h"

namespace g31::probe::sweep_mesh_test {
namespace {

using testing::any_direction;
using testing::point_between;

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
      {"rubs along and 0.001 mm deeper", deep, {8, 8, 22.89901}, std::nullopt},
      {"pushes in at 1:100", deep, {8, 8, 22.89}, 1e-3 * std::sqrt(1e4 + 1)},
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

/// The first contact by looking at all triangles one after the other.
double first_of_every_triangle(const std::vector<ContactTriangle>& triangles, double radius,
                               const Point& from, const Point& to) {
  const parts::Path path{from, (to - from).normalized(), (to - from).norm()};
  double first = kNoContact;
  for (const ContactTriangle& triangle : triangles) {
    first = std::min(first, sweep_triangle(path, triangle, radius));
  }
  return first;
}

TEST(MeshSweeper, FindsInFineMeshesWhatATestOfEveryTriangleFinds) {
  struct Case {
    const char* name;
    parts::Mesh mesh;
    double radius;
  };
  const Case kCases[] = {
      {"fine sphere", testing::sphere_mesh(20.0, 40), 3.0},
      {"fine sphere, finely dented", testing::shaken(testing::sphere_mesh(20.0, 36), 0.05, 4), 3.0},
      {"fine sphere, unshared and turned over at random",
       testing::unshared(testing::turned_at_random(testing::sphere_mesh(20.0, 36), 7)), 1.0},
      {"fine sphere with holes", testing::without_every(testing::sphere_mesh(20.0, 36), 20), 0.5},
      {"spiked fan of many spokes", testing::spiked_fan(20.0, 1500), 2.0},
  };
  std::mt19937_64 random(8);
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const MeshSweeper sweeper(c.mesh, c.radius);
    std::vector<ContactTriangle> triangles;
    for (const auto& t : c.mesh.triangles) {
      triangles.emplace_back(c.mesh.vertices[t[0]], c.mesh.vertices[t[1]], c.mesh.vertices[t[2]]);
    }
    int contacts = 0;
    for (int i = 0; i < 120; ++i) {
      // From outside, from inside, and almost along the surface.
      const Point from = (i % 3 == 1 ? 10.0 : 35.0) * any_direction(random);
      const Point aim = i % 3 == 2 ? Point((20.0 + c.radius) * any_direction(random))
                                   : point_between(random, -14.0, 14.0);
      const Point to = from + 40.0 * (aim - from).normalized();
      const SweepHit hit = sweeper.sweep(from, to);
      if (hit.status == SweepStatus::StartInContact) {
        continue;
      }
      const double expected = first_of_every_triangle(triangles, c.radius, from, to);
      ASSERT_EQ(hit.status == SweepStatus::Miss, expected == kNoContact);
      if (hit.status == SweepStatus::Contact) {
        ++contacts;
        EXPECT_NEAR(hit.s, expected, 1e-11 / std::max(hit.cos_incidence, 1e-5));
      }
    }
    EXPECT_GT(contacts, 50);
  }
}

TEST(MeshSweeper, GivesTheSameFromManyThreads) {
  const auto mesh = std::make_shared<const ContactMesh>(testing::sphere_mesh(15.0, 20));
  const auto run = [](const MeshSweeper& sweeper) {
    std::mt19937_64 random(5);
    std::vector<double> found;
    for (int i = 0; i < 2000; ++i) {
      const Point from = 25.0 * any_direction(random);
      found.push_back(sweeper.sweep(from, point_between(random, -15.0, 15.0)).s);
    }
    return found;
  };
  const std::vector<double> alone = run(MeshSweeper(testing::sphere_mesh(15.0, 20), 1.0));
  // Its patches are made by whoever asks first.
  const MeshSweeper shared(mesh, 1.0);
  std::vector<std::vector<double>> together(4);
  std::vector<std::thread> threads;
  for (auto& result : together) {
    threads.emplace_back([&] { result = run(shared); });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const auto& result : together) {
    EXPECT_EQ(result, alone);
  }
}

}  // namespace
}  // namespace g31::probe::sweep_mesh_test

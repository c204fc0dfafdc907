// Stem, bodies and holder against meshes: closed forms, and FCL as a second witness.
// Compile without AVX or with EIGEN_MAX_ALIGN_BYTES=16, as the packaged FCL was.

#include "probe/collision/rigid_touch.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <fcl/geometry/shape/cylinder.h>
#include <gtest/gtest.h>

#include "tests/probe/fcl_witness.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::rigid_touch_test {
namespace {

/// A block 40 x 40 x 20 whose middle is the origin: faces at +-20, top at 10, bottom at -10.
parts::Mesh block() {
  return testing::moved_by(testing::box_mesh({40.0, 40.0, 20.0}), {-20.0, -20.0, -10.0});
}

struct Case {
  const char* what;
  ProbeSection section;
  CentreWay way;
  double touched_after_mm;  ///< closed form; < 0: never
};

const ProbeSection kStem = {"stem", 0.0, 50.0, 2.0, 2.0, 0.0};
const ProbeSection kBody = {"body", 50.0, 90.0, 20.0, 20.0, 0.0};

TEST(RigidTouch, ComesWhereTheClosedFormSays) {
  const double root2 = std::sqrt(2.0);
  const std::vector<Case> cases = {
      {"a stem meets a face", kStem, {{-60, 0, -30}, {0, 0, -30}}, 40.0 - 2.0},
      {"a stem passes above", kStem, {{-60, 0, 10.01}, {60, 0, 10.01}}, -1.0},
      {"a stem below the block stands through it", kStem, {{-60, 0, -40}, {0, 0, -40}}, 38.0},
      {"a stem ends below the block", kStem, {{-60, 0, -60.01}, {60, 0, -60.01}}, -1.0},
      {"a body meets the top face from above", kBody, {{0, 0, 0}, {0, 0, -100}}, 50.0 - 10.0},
      {"a body meets a face", kBody, {{-100, 0, -70}, {0, 0, -70}}, 80.0 - 20.0},
      {"a body passes the corner of the block",
       kBody,
       {{-60, -20 - 20.01, -70}, {60, -20 - 20.01, -70}},
       -1.0},
      {"a body meets the upright edge diagonally",
       kBody,
       {{-60, -60, -70}, {0, 0, -70}},
       40.0 * root2 - 20.0},
      // Radius 10 at 50, 30 at 90: at the height of the top edge, 65, it is 17.5.
      {"a cone meets the top edge with its slope",
       {"cone", 50.0, 90.0, 10.0, 30.0, 0.0},
       {{-100, 0, -55}, {0, 0, -55}},
       80.0 - 17.5},
      {"a capsule meets a face with its middle",
       {"capsule", 55.0, 85.0, 0.0, 0.0, 5.0},
       {{-100, 0, -70}, {0, 0, -70}},
       80.0 - 5.0},
      {"a capsule comes down on the top face with its end",
       {"capsule", 55.0, 85.0, 0.0, 0.0, 5.0},
       {{0, 0, 0}, {0, 0, -100}},
       50.0 - 10.0},
      // Its lower centre passes 3 above the edge: the ball of radius 5 meets it 4 before.
      {"the end of a capsule meets an edge",
       {"capsule", 55.0, 85.0, 0.0, 0.0, 5.0},
       {{-100, 0, -42}, {0, 0, -42}},
       80.0 - 4.0},
      {"what overlaps at the start touches there", kStem, {{0, 0, -30}, {60, 0, -30}}, 0.0},
  };
  const std::vector<CollisionMesh> parts = {CollisionMesh(block())};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.what);
    const auto touch = first_touch({&c.section, 1}, parts, c.way);
    ASSERT_EQ(touch.has_value(), c.touched_after_mm >= 0.0);
    if (touch) {
      const double length = (c.way.p_M_to - c.way.p_M_from).norm();
      EXPECT_NEAR(touch->touch.fraction * length, c.touched_after_mm, kSectionTouchErrorMm);
      EXPECT_EQ(touch->section, c.section.name);
      EXPECT_EQ(touch->part, 0U);
    }
  }
}

TEST(RigidTouch, TakesTheFirstSectionAndThePartThatItMeets) {
  const std::vector<CollisionMesh> parts = {
      CollisionMesh(testing::moved_by(block(), {200.0, 0.0, 0.0})), CollisionMesh(block())};
  const std::vector<ProbeSection> sections = {kStem, kBody};
  // Deep enough for both: the wide body comes first, at the nearer block.
  const auto touch = first_touch(sections, parts, {{-100, 0, -50}, {300, 0, -50}, 0.0});
  ASSERT_TRUE(touch.has_value());
  EXPECT_EQ(touch->section, "body");
  EXPECT_EQ(touch->part, 1U);
  EXPECT_NEAR(touch->touch.fraction * 400.0, 60.0, kSectionTouchErrorMm);
  EXPECT_NEAR(touch->touch.n_M.dot(Point(-1, 0, 0)), 1.0, 1e-12);
  EXPECT_NEAR(touch->touch.p_M_point.x(), -20.0, 1e-9);
}

TEST(RigidTouch, DoesNotStepOverAThinWallOnALongWay) {
  // A wall without thickness, 2 mm wide, met after 900 of 1000 mm.
  parts::Mesh wall;
  wall.vertices = {{0, -1, -5}, {0, 1, -5}, {0, 0, 5}};
  wall.triangles = {{0, 1, 2}};
  const std::vector<CollisionMesh> parts = {CollisionMesh(wall)};
  const auto touch = first_touch({&kStem, 1}, parts, {{-902, 0, -20}, {98, 0, -20}, 0.0});
  ASSERT_TRUE(touch.has_value());
  EXPECT_NEAR(touch->touch.fraction * 1000.0, 900.0, kSectionTouchErrorMm);
}

using testing::FclMesh;

bool collides(const std::shared_ptr<FclMesh>& mesh, const ProbeSection& section, double growth,
              const Point& p_M) {
  const double height = section.z_top - section.z_bottom;
  const auto shape =
      std::make_shared<fcl::Cylinderd>(section.radius_bottom + growth, height + 2.0 * growth);
  return testing::fcl_collides(mesh, shape, p_M + Point(0, 0, section.z_bottom + 0.5 * height));
}

TEST(RigidTouch, AgreesWithFcl) {
  constexpr double kBandMm = 3e-5;  // of both: ours stops within 1e-5
  const ProbeSection section = {"body", 2.0, 12.0, 3.0, 3.0, 0.0};
  std::mt19937_64 random(78);
  int touches = 0;
  for (int round = 0; round < 60; ++round) {
    const parts::Mesh mesh = testing::loose_triangles(static_cast<std::uint64_t>(round), 12);
    const std::shared_ptr<FclMesh> model = testing::fcl_mesh(mesh);
    const std::vector<CollisionMesh> parts = {CollisionMesh(mesh)};
    for (int i = 0; i < 20; ++i) {
      const Point from = 60.0 * testing::any_direction(random);
      const Point to = testing::point_between(random, -15.0, 15.0);
      if (collides(model, section, kBandMm, from)) {
        continue;
      }
      const auto touch = first_touch({&section, 1}, parts, {from, to, 0.0});
      const double end = touch ? touch->touch.fraction : 1.0;
      for (int step = 0; step <= 40; ++step) {
        EXPECT_FALSE(collides(model, section, -kBandMm, from + end * step / 40.0 * (to - from)));
      }
      if (touch) {
        ++touches;
        EXPECT_TRUE(collides(model, section, kBandMm, from + end * (to - from)));
      }
    }
  }
  EXPECT_GT(touches, 300);
}

}  // namespace
}  // namespace g31::probe::rigid_touch_test

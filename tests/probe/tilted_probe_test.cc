// A probe that is turned against the part: what a tilting table does.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::tilted_probe_test {
namespace {

using machine::LinearMove;
using machine::MachineSetup;
using machine::MachiningCentre;
using machine::Traverse;
using testing::kUpright;

constexpr double kDegree = std::numbers::pi / 180.0;

Eigen::Quaterniond about(const Point& axis, double angle_rad) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis));
}

AxisPositions axes(double x, double y, double z, double a = 0.0, double c = 0.0) {
  AxisPositions q;
  q << x, y, z, a, 0.0, c;
  return q;
}

ProbeSection cylinder(const char* name, double radius, double z_bottom, double z_top) {
  return {name, z_bottom, z_top, radius, radius, 0.0};
}

TEST(TiltedProbe, MeetsWhatAnUprightOneMeetsOfAPartTurnedBack) {
  const ProbeSection section = cylinder("body", 3.0, 2.0, 12.0);
  std::mt19937_64 random(41);
  int touches = 0;
  for (int round = 0; round < 200; ++round) {
    const parts::Mesh mesh = testing::loose_triangles(static_cast<std::uint64_t>(round), 12);
    const Eigen::Quaterniond tilt = about(testing::any_direction(random), 3.0 * round);
    parts::Mesh turned_back = mesh;
    for (Point& vertex : turned_back.vertices) {
      vertex = tilt.conjugate() * vertex;
    }
    const std::vector<CollisionMesh> upright_parts = {CollisionMesh(turned_back)};
    const std::vector<CollisionMesh> tilted_parts = {CollisionMesh(mesh)};
    const Point from = 60.0 * testing::any_direction(random);
    const Point to = testing::point_between(random, -15.0, 15.0);
    const auto upright = first_touch({&section, 1}, upright_parts, {from, to});
    const auto tilted =
        first_touch({&section, 1}, tilted_parts, {tilt * from, tilt * to, 0.0, tilt, tilt});
    ASSERT_EQ(upright.has_value(), tilted.has_value()) << round;
    if (!upright) {
      continue;
    }
    ++touches;
    EXPECT_NEAR(upright->touch.fraction, tilted->touch.fraction, 1e-6) << round;
    EXPECT_LT((tilt * upright->touch.n_M - tilted->touch.n_M).norm(), 1e-6) << round;
  }
  EXPECT_GT(touches, 50);
}

TEST(TiltedProbe, AStemThatSwingsTouchesWhereTheSineSays) {
  // A capsule 100 mm long with a radius of 2 swings about its lower end at the origin: over the
  // wall x = 30 at 100 sin(angle) + 2 = 30.
  ProbeSection stem = cylinder("stem", 0.0, 0.0, 100.0);
  stem.rounding = 2.0;
  const double touching_rad = std::asin(0.28);
  const std::vector<CollisionMesh> parts = {
      CollisionMesh(testing::moved_by(testing::box_mesh({10, 400, 400}), {30, -200, -200}))};
  for (const double step_deg : {0.01, 0.1, 1.0}) {
    for (const double share : {0.0, 0.1, 0.5, 0.9}) {
      const double begin_rad = touching_rad - share * step_deg * kDegree;
      CentreWay way{Point::Zero(), Point::Zero()};
      way.turn_from = about(Point::UnitY(), begin_rad);
      way.turn_to = about(Point::UnitY(), begin_rad + step_deg * kDegree);
      const auto touch = first_touch({&stem, 1}, parts, way);
      ASSERT_TRUE(touch) << step_deg << ' ' << share;
      // The chord's bulge is taken as a margin: it may stop too early by that, never too late.
      const double step_rad = step_deg * kDegree;
      const double sag = 102.0 * step_rad * step_rad / 8.0;
      EXPECT_LE(touch->touch.fraction, share + 1e-6) << step_deg;
      EXPECT_GE(touch->touch.fraction, share - (sag + 1e-6) / (95.0 * step_rad)) << step_deg;
      EXPECT_LT((touch->touch.n_M + Point::UnitX()).norm(), 1e-9);
    }
    // One step before there is nothing.
    CentreWay way{Point::Zero(), Point::Zero()};
    way.turn_to = about(Point::UnitY(), touching_rad - 1.01 * step_deg * kDegree);
    way.turn_from = about(Point::UnitY(), touching_rad - 2.01 * step_deg * kDegree);
    EXPECT_FALSE(first_touch({&stem, 1}, parts, way)) << step_deg;
  }
}

/// A small ball under a body of 20 mm radius from 50 to 120 mm above it; no stem.
ProbeSetup probe_with_body() {
  ProbeSetup setup;
  setup.ball_diameter_mm = 4.0;
  setup.length_mm = 120.0;
  setup.bodies = {cylinder("probe body", 20.0, 50.0, 120.0)};
  return setup;
}

/// Table-table: A about X through the origin, C on it.
MachineSetup tilting_table(const ProbeSetup& probe) {
  MachineSetup setup;
  setup.chain.table_side = "CA";
  setup.axes[3].present = setup.axes[5].present = true;
  setup.p_T_tip = Point(0, 0, -probe.length_mm);
  setup.q_M_start = axes(0, 0, 100.0 + probe.length_mm);
  return setup;
}

/// The ball goes round X at 100 mm, the body with it; a wall of the part begins at y = 50.  The
/// body's upper rim, 20 mm beside and 220 mm up, comes there first: 20 cos t + 220 sin t = 50.
const std::vector<ProbedPart> kWall = {
    {"wall", testing::moved_by(testing::box_mesh({400, 50, 400}), {-200, 50, 0})}};
const double kWallAtDeg =
    (std::asin(50.0 / std::hypot(20.0, 220.0)) - std::atan2(20.0, 220.0)) / kDegree;

TEST(TiltedProbe, ATableThatTiltsBringsAWallToTheBody) {
  const ProbeSetup probe = probe_with_body();
  TouchProbe world(probe, kWall, 0);
  MachiningCentre centre(tilting_table(probe), &world);
  const LinearMove tilting{axes(0, 0, 220, -30.0), Traverse::Feed, 1000.0};
  const auto outcome = centre.move(tilting);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error().what, "probe body touches wall");
  EXPECT_NEAR(centre.position()[3], -kWallAtDeg, 1e-4);
}

TEST(TiltedProbe, ASkipMoveThatTiltsBreaksTheBodyToo) {
  const ProbeSetup probe = probe_with_body();
  TouchProbe world(probe, kWall, 0);
  MachiningCentre centre(tilting_table(probe), &world);
  const LinearMove tilting{axes(0, 0, 220, -8.5), Traverse::Feed, 100.0};
  const auto outcome = centre.move_until_skip(tilting);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error().what, "probe body touches wall");
  EXPECT_NEAR(centre.position()[3], -kWallAtDeg, 1e-3);
}

TEST(TiltedProbe, TouchesWithTheBallsThatAreOffTheAxis) {
  // Turned by -90 degrees about X, a ball 30 mm beside the main one in +Y is 30 mm below it.
  ProbeSetup setup;
  setup.ball_diameter_mm = 6.0;
  setup.length_mm = 120.0;
  setup.further_balls = {{Point(0, 30, 0), 4.0}};
  TouchProbe probe(
      setup, {{"plate", testing::moved_by(testing::box_mesh({400, 400, 10}), {-200, -200, 0})}}, 0);
  const Eigen::Quaterniond tilt = about(Point::UnitX(), -90.0 * kDegree);
  // The main ball from z = 100 to 0: the other one touches z = 10 with its 2 mm when it is at 42.
  const auto trigger = testing::touch_on(probe, {axes(0, 0, 220.0), axes(0, 0, 120.0), tilt, tilt});
  ASSERT_TRUE(trigger);
  EXPECT_NEAR(trigger->fraction, 0.58, 1e-12);
  ASSERT_TRUE(trigger->contact);
  EXPECT_LT((trigger->contact->p_M_point - Point(0, 0, 10)).norm(), 1e-9);
  EXPECT_NEAR(probe.tool_extent().signal_mm, 30.0, 1e-12);
}

TEST(TiltedProbe, GivesWayAsItsSwitchDoesInTheDirectionsOfTheTool) {
  // Only along its axis does this mono probe give a signal; tilted by 90 degrees the axis is Y.
  ProbeSetup setup;
  setup.ball_diameter_mm = 6.0;
  setup.length_mm = 120.0;
  setup.at_switch.type = ProbeType::Mono;
  setup.at_switch.mono_direction_deg = 0.0;
  TouchProbe probe(
      setup, {{"plate", testing::moved_by(testing::box_mesh({400, 400, 10}), {-200, -200, 0})}}, 0);
  const AxisPositions from = axes(0, 0, 220.0);
  const AxisPositions to = axes(0, 0, 120.0);
  EXPECT_TRUE(testing::touch_on(probe, {from, to}));
  const Eigen::Quaterniond aside = about(Point::UnitX(), -90.0 * kDegree);
  EXPECT_FALSE(testing::touch_on(probe, {from, to, aside, aside}));
  // Turned about Y its direction +X looks down.
  const Eigen::Quaterniond down = about(Point::UnitY(), 90.0 * kDegree);
  EXPECT_TRUE(testing::touch_on(probe, {from, to, down, down}));
}

}  // namespace
}  // namespace g31::probe::tilted_probe_test

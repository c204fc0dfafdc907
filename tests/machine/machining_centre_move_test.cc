#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/expect_violated.h"
#include "tests/support/scripted_surroundings.h"

namespace g31::machine::machining_centre_move_test {
namespace {

using testing::ScriptedSurroundings;

AxisPositions axes(double x, double y, double z, double a = 0) {
  return (AxisPositions() << x, y, z, a, 0, 0).finished();
}

LinearMove rapid(const AxisPositions& q_M_end) {
  return {q_M_end, Traverse::Rapid, 0.0};
}

LinearMove feed(const AxisPositions& q_M_end, double feed_mm_min) {
  return {q_M_end, Traverse::Feed, feed_mm_min};
}

/// Feed 600 is 10 mm/s; with 100 mm/s^2 the ramps take 0.1 s and 0.5 mm.
MachineSetup round_numbers() {
  MachineSetup setup;
  for (std::size_t i = 0; i < 4; ++i) {
    setup.axes[i].present = true;
    setup.axes[i].rapid_per_min = 6000.0;
    setup.axes[i].acceleration_per_s2 = 100.0;
  }
  return setup;
}

Obstacle obstacle_at(double fraction) {
  return {fraction, "stylus ball touches ring", {Point(1, 2, 3), Point(0, 0, 1), "ring"}};
}

TEST(MachiningCentreMove, TakesItsTimeAndReachesTheEnd) {
  struct Case {
    const char* name;
    double seconds;
    LinearMove move;
  };
  const Case kCases[] = {
      {"feed 600 over 10 mm", 1.1, feed(axes(10, 0, 0), 600)},
      {"feed in the plane, each axis at its acceleration",
       7 * std::sqrt(2.0) / 10 + 0.1 / std::sqrt(2.0), feed(axes(7, 7, 0), 600)},
      {"rapid over 1 mm never gets fast", 0.2, rapid(axes(0, 0, -1))},
      {"rapid over 400 mm: 100 mm/s", 5, rapid(axes(400, 0, 0))},
      {"rapid: the longest way decides", 5, rapid(axes(400, 100, -50, 7))},
      {"rotary axis alone: degrees a minute", 1.1, feed(axes(0, 0, 0, 10), 600)},
      {"no way at all", 0, feed(axes(0, 0, 0), 600)},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    MachiningCentre centre(round_numbers(), nullptr);
    const auto reached = centre.move(c.move);
    ASSERT_TRUE(reached.ok());
    EXPECT_EQ(reached.value(), c.move.q_M_end);
    EXPECT_EQ(centre.position(), c.move.q_M_end);
    EXPECT_NEAR(centre.time_s(), c.seconds, 1e-13);
  }
}

TEST(MachiningCentreMove, EndsAreExactBitForBitAndTimesAddUp) {
  MachiningCentre centre(round_numbers(), nullptr);
  std::mt19937 random(9);
  std::normal_distribution<double> gauss(0.0, 300.0);
  double seconds = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const AxisPositions q_M_end = axes(gauss(random), gauss(random), gauss(random), gauss(random));
    const double before_s = centre.time_s();
    ASSERT_TRUE(centre.move(rapid(q_M_end)).ok());
    ASSERT_EQ(centre.position(), q_M_end);
    ASSERT_GT(centre.time_s(), before_s);
    seconds += centre.time_s() - before_s;
  }
  centre.dwell(2.5);
  EXPECT_NEAR(centre.time_s(), seconds + 2.5, 1e-7);
}

TEST(MachiningCentreMove, StartsWhereTheSetUpSays) {
  MachineSetup setup = round_numbers();
  setup.q_M_start = axes(1, 2, 3, 4);
  const MachiningCentre centre(setup, nullptr);
  EXPECT_EQ(centre.position(), axes(1, 2, 3, 4));
  EXPECT_EQ(centre.time_s(), 0.0);
}

TEST(MachiningCentreMove, ASoftLimitStopsTheMoveBeforeItBegins) {
  MachineSetup setup = round_numbers();
  setup.axes[1].travel_max = 50.0;
  ScriptedSurroundings world;
  MachiningCentre centre(setup, &world);
  ASSERT_TRUE(centre.move(rapid(axes(5, 50, 0))).ok());
  const double before_s = centre.time_s();

  const auto moved = centre.move(rapid(axes(0, 50.5, 0)));
  const auto skipped = centre.move_until_skip(feed(axes(0, 50.5, 0), 600));

  ASSERT_FALSE(moved.ok());
  ASSERT_FALSE(skipped.ok());
  for (const MachineFault& fault : {moved.error(), skipped.error()}) {
    EXPECT_EQ(fault.kind, FaultKind::SoftLimit);
    EXPECT_EQ(fault.what, "axis Y asked to go to 50.5 mm: upper limit is 50 mm");
    EXPECT_EQ(fault.q_M_at, axes(5, 50, 0));
    EXPECT_FALSE(fault.contact.has_value());
  }
  EXPECT_EQ(centre.position(), axes(5, 50, 0));
  EXPECT_EQ(centre.time_s(), before_s);
  EXPECT_EQ(world.move_sweeps().size(), 1U);
  EXPECT_TRUE(world.skip_sweeps().empty());
}

TEST(MachiningCentreMove, ComesBackFromOutsideTheLimits) {
  MachineSetup setup = round_numbers();
  setup.axes[0].travel_max = 50.0;
  setup.q_M_start = axes(60, 0, 0);
  MachiningCentre centre(setup, nullptr);
  EXPECT_FALSE(centre.move(rapid(axes(55, 0, 0))).ok());
  EXPECT_TRUE(centre.move(rapid(axes(50, 0, 0))).ok());
}

TEST(MachiningCentreMove, StopsAtAnObstacle) {
  struct Case {
    const char* name;
    double fraction;
    AxisPositions q_M_at;
    double seconds;
  };
  const Case kCases[] = {
      // 10 mm along (0.6, 0, -0.8), acceleration 100 / 0.8 = 125 mm/s^2
      {"at once", 0.0, axes(0, 0, 0), 0},
      {"halfway", 0.5, axes(3, 0, -4), 0.54},
      {"in the acceleration", 0.01, axes(0.06, 0, -0.08), 0.04},
      {"at the very end", 1.0, axes(6, 0, -8), 1.08},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    ScriptedSurroundings world({}, {obstacle_at(c.fraction)});
    MachiningCentre centre(round_numbers(), &world);
    const auto reached = centre.move(feed(axes(6, 0, -8), 600));
    ASSERT_FALSE(reached.ok());
    const MachineFault& fault = reached.error();
    EXPECT_EQ(fault.kind, FaultKind::Collision);
    EXPECT_EQ(fault.what, "stylus ball touches ring");
    EXPECT_LT((fault.q_M_at - c.q_M_at).norm(), 1e-14);
    EXPECT_EQ(fault.q_M_at, centre.position());
    ASSERT_TRUE(fault.contact.has_value());
    EXPECT_EQ(fault.contact->part, "ring");
    EXPECT_EQ(fault.contact->p_M_point, Point(1, 2, 3));
    EXPECT_NEAR(centre.time_s(), c.seconds, 1e-14);
  }
}

TEST(MachiningCentreMove, AsksTheWorldOnlyAboutRealMoves) {
  ScriptedSurroundings world;
  MachiningCentre centre(round_numbers(), &world);
  ASSERT_TRUE(centre.move(rapid(axes(0, 0, 0))).ok());
  ASSERT_TRUE(world.move_sweeps().empty());
  ASSERT_TRUE(centre.move(rapid(axes(1, 2, 3))).ok());
  ASSERT_TRUE(centre.move(rapid(axes(1, 2, 3))).ok());
  ASSERT_TRUE(centre.move(rapid(axes(1, 2, 4))).ok());
  ASSERT_EQ(world.move_sweeps().size(), 2U);
  EXPECT_EQ(world.move_sweeps()[1].q_M_from, axes(1, 2, 3));
  EXPECT_EQ(world.move_sweeps()[1].q_M_to, axes(1, 2, 4));
  EXPECT_TRUE(world.skip_sweeps().empty());
}

TEST(MachiningCentreDeathTest, NumbersThatNoCallerMayPass) {
  MachiningCentre centre(round_numbers(), nullptr);
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  const double kInfinity = std::numeric_limits<double>::infinity();
  testing::expect_violated([&] { (void)centre.move(rapid(axes(kNan, 0, 0))); }, "all_finite");
  testing::expect_violated([&] { (void)centre.move(rapid(axes(0, kInfinity, 0))); }, "all_finite");
  testing::expect_violated([&] { (void)centre.move(feed(axes(1, 0, 0), 0.0)); },
                           "feed_mm_min > 0.0");
  testing::expect_violated([&] { (void)centre.move(feed(axes(1, 0, 0), -1.0)); },
                           "feed_mm_min > 0.0");
  testing::expect_violated([&] { (void)centre.move(feed(axes(1, 0, 0), kNan)); },
                           "feed_mm_min > 0.0");
  testing::expect_violated([&] { (void)centre.move_until_skip(feed(axes(1, 0, 0), 0.0)); },
                           "feed_mm_min > 0.0");
  testing::expect_violated([&] { (void)centre.move_until_skip(rapid(axes(0, 0, kNan))); },
                           "all_finite");
  testing::expect_violated([&] { centre.dwell(-1.0); }, "seconds >= 0.0");
  testing::expect_violated([&] { centre.dwell(kInfinity); }, "isfinite");
}

TEST(MachiningCentreDeathTest, AxesWithoutRatesAndAnswersOutsideTheSweep) {
  MachineSetup setup = round_numbers();
  setup.axes[2].acceleration_per_s2 = 0.0;
  testing::expect_violated([&] { MachiningCentre(setup, nullptr); }, "acceleration_per_s2 > 0.0");

  ScriptedSurroundings world({}, {obstacle_at(1.5)});
  MachiningCentre centre(round_numbers(), &world);
  testing::expect_violated([&] { (void)centre.move(rapid(axes(1, 0, 0))); }, "is_fraction");
}

}  // namespace
}  // namespace g31::machine::machining_centre_move_test

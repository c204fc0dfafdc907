#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/scripted_surroundings.h"

namespace g31::machine::machining_centre_arc_test {
namespace {

using testing::ScriptedSurroundings;

constexpr double kPi = std::numbers::pi;

AxisPositions axes(double x, double y, double z) {
  return (AxisPositions() << x, y, z, 0, 0, 0).finished();
}

/// Starts at (100, 0, 0); the arcs are about the origin.
MachineSetup at_three_o_clock() {
  MachineSetup setup;
  setup.q_M_start = axes(100, 0, 0);
  return setup;
}

ArcMove arc_to(const AxisPositions& q_M_end, Turn turn) {
  ArcMove arc;
  arc.q_M_end = q_M_end;
  arc.turn = turn;
  arc.feed_mm_min = 600.0;
  return arc;
}

double trapezoid_s(double length) {
  return length / 10.0 + 10.0 / (2000.0 / std::sqrt(2.0));
}

TEST(MachiningCentreArc, TakesItsTimeAndReachesTheEnd) {
  struct Case {
    const char* name;
    double length;
    ArcMove arc;
  };
  const Case kCases[] = {
      {"quarter", 50 * kPi, arc_to(axes(0, 100, 0), Turn::Counterclockwise)},
      {"three quarters", 150 * kPi, arc_to(axes(0, 100, 0), Turn::Clockwise)},
      {"full circle", 200 * kPi, arc_to(axes(100, 0, 0), Turn::Clockwise)},
      {"helix: the feed counts the arc", 200 * kPi, arc_to(axes(100, 0, -5), Turn::Clockwise)},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    MachiningCentre centre(at_three_o_clock(), nullptr);
    const auto reached = centre.move(c.arc);
    ASSERT_TRUE(reached.ok());
    EXPECT_EQ(reached.value(), c.arc.q_M_end);
    EXPECT_EQ(centre.position(), c.arc.q_M_end);
    EXPECT_NEAR(centre.time_s(), trapezoid_s(c.length), 1e-12);
  }
}

TEST(MachiningCentreArc, ACircleOfNoRadiusIsAStraightMove) {
  ArcMove arc = arc_to(axes(100, 0, -20), Turn::Clockwise);
  arc.centre_first = 100.0;
  MachiningCentre centre(at_three_o_clock(), nullptr);
  ASSERT_TRUE(centre.move(arc).ok());
  EXPECT_EQ(centre.position(), axes(100, 0, -20));
  EXPECT_NEAR(centre.time_s(), 2.005, 1e-13);
}

TEST(MachiningCentreArc, TheWholeArcMustLieWithinTheLimits) {
  struct Case {
    const char* name;
    Turn turn;
    double y_max;
    const char* fault;  // null: none
  };
  const Case kCases[] = {
      // from (100, 0) to (-100, 0)
      {"over the top, enough room", Turn::Counterclockwise, 100.0, nullptr},
      {"over the top, too low", Turn::Counterclockwise, 99.0, "upper limit is 99 mm"},
      {"underneath", Turn::Clockwise, 1.0, nullptr},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    MachineSetup setup = at_three_o_clock();
    setup.axes[1].travel_max = c.y_max;
    MachiningCentre centre(setup, nullptr);
    const auto reached = centre.move(arc_to(axes(-100, 0, 0), c.turn));
    ASSERT_EQ(reached.ok(), c.fault == nullptr);
    if (c.fault != nullptr) {
      EXPECT_EQ(reached.error().kind, FaultKind::SoftLimit);
      EXPECT_NE(reached.error().what.find(c.fault), std::string::npos) << reached.error().what;
      EXPECT_EQ(centre.position(), axes(100, 0, 0));
      EXPECT_EQ(centre.time_s(), 0.0);
    }
  }
}

TEST(MachiningCentreArc, AsksTheWorldChordByChord) {
  ScriptedSurroundings world;
  MachiningCentre centre(at_three_o_clock(), &world);
  const ArcMove arc = arc_to(axes(100, 0, 0), Turn::Counterclockwise);
  ASSERT_TRUE(centre.move(arc).ok());

  const auto& sweeps = world.move_sweeps();
  ASSERT_GT(sweeps.size(), 100U);
  EXPECT_EQ(sweeps.front().q_M_from, axes(100, 0, 0));
  EXPECT_EQ(sweeps.back().q_M_to, axes(100, 0, 0));
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    ASSERT_NE(sweeps[i].q_M_from, sweeps[i].q_M_to);
    ASSERT_NEAR(sweeps[i].q_M_to.head<2>().norm(), 100.0, 1e-12);
    if (i > 0) {
      ASSERT_EQ(sweeps[i].q_M_from, sweeps[i - 1].q_M_to);
    }
  }
}

TEST(MachiningCentreArc, NeverAsksAboutASweepThatGoesNowhere) {
  // So far out doubles are 1.2e-7 mm apart, and the four chords of this quarter are shorter.
  const double far = 1e9;
  const double next = std::nextafter(far, 2e9);
  MachineSetup setup;
  setup.q_M_start = axes(next, far, 0);
  ArcMove arc = arc_to(axes(far, next, 0), Turn::Counterclockwise);
  arc.centre_first = far;
  arc.centre_second = far;
  ScriptedSurroundings world;
  MachiningCentre centre(setup, &world);
  ASSERT_TRUE(centre.move(arc).ok());
  EXPECT_FALSE(world.move_sweeps().empty());
  for (const Sweep& sweep : world.move_sweeps()) {
    EXPECT_NE(sweep.q_M_from, sweep.q_M_to);
  }
}

TEST(MachiningCentreArc, StopsAtAnObstacle) {
  const ArcMove arc = arc_to(axes(-100, 0, 0), Turn::Counterclockwise);
  ScriptedSurroundings counting;
  MachiningCentre free_centre(at_three_o_clock(), &counting);
  ASSERT_TRUE(free_centre.move(arc).ok());
  const std::size_t all = counting.move_sweeps().size();

  // Free until the obstacle at the end of some chord, about a quarter of the way.
  const std::size_t travelled = all / 4;
  ScriptedSurroundings::Obstacles obstacles(travelled);
  obstacles.back() =
      Obstacle{1.0, "ball touches bore", {Point(0, 100, 0), Point(0, -1, 0), "bore"}};
  ScriptedSurroundings world({}, obstacles);
  MachiningCentre centre(at_three_o_clock(), &world);
  const auto reached = centre.move(arc);

  ASSERT_FALSE(reached.ok());
  EXPECT_EQ(reached.error().kind, FaultKind::Collision);
  EXPECT_EQ(reached.error().contact->part, "bore");
  const double share = static_cast<double>(travelled) / static_cast<double>(all);
  const AxisPositions q_M_expected =
      axes(100 * std::cos(kPi * share), 100 * std::sin(kPi * share), 0);
  EXPECT_LT((centre.position() - q_M_expected).norm(), 1e-12);
  // Cruising: half a ramp later than at full speed from the start.
  EXPECT_NEAR(centre.time_s(), 100 * kPi * share / 10.0 + 0.5 * 10.0 * std::sqrt(2.0) / 2000.0,
              1e-12);
}

}  // namespace
}  // namespace g31::machine::machining_centre_arc_test

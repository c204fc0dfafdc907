#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/expect_violated.h"
#include "tests/support/scripted_surroundings.h"

namespace g31::machine::machining_centre_skip_test {
namespace {

using testing::ScriptedSignal;
using testing::ScriptedSurroundings;

AxisPositions axes(double x, double y, double z, double a = 0) {
  return (AxisPositions() << x, y, z, a, 0, 0).finished();
}

LinearMove feed(const AxisPositions& q_M_end, double feed_mm_min) {
  return {q_M_end, Traverse::Feed, feed_mm_min};
}

/// Feed 600 is 10 mm/s; with 100 mm/s^2 the ramps take 0.1 s and 0.5 mm.
MachineSetup round_numbers(Stopping stopping = Stopping::Braking) {
  MachineSetup setup;
  for (std::size_t i = 0; i < 4; ++i) {
    setup.axes[i].present = true;
    setup.axes[i].rapid_per_min = 6000.0;
    setup.axes[i].acceleration_per_s2 = 100.0;
  }
  setup.stopping = stopping;
  return setup;
}

TEST(MachiningCentreSkip, GoesOnToItsEndWhenOnlyThePositionIsWanted) {
  MachineSetup lagging = round_numbers();
  for (std::size_t i = 0; i < 4; ++i) {
    lagging.axes[i].servo_gain = 1.0;
  }
  for (const MachineSetup& setup : {round_numbers(), lagging}) {
    ScriptedSurroundings world({{'X', 5.0, 0.02, false, {}}, {'X', 5.0, 0.02, false, {}}});
    MachiningCentre centre(setup, &world);
    SkipMove move(feed(axes(10, 0, 0), 600));
    move.after = AfterSignal::GoOn;
    const auto outcome = centre.move_until_skip(move);
    ASSERT_TRUE(outcome.ok());
    const auto& touched = std::get<Touched>(outcome.value());
    // 0.02 s later at 10 mm/s, which a lagging axis has nearly reached.
    EXPECT_NEAR(touched.q_M_latched[0], 5.2, 1e-3);
    EXPECT_EQ(touched.q_M_stopped[0], 10.0);
    EXPECT_EQ(centre.position()[0], 10.0);
  }
}

TEST(MachiningCentreSkip, LatchesAndStops) {
  struct Case {
    const char* name;
    double at, delay_s;
    Stopping stopping;
    double latched, stopped, seconds;
  };
  const Case kCases[] = {
      // from X0 towards X10 at 10 mm/s
      {"ideal", 5, 0, Stopping::Ideal, 5, 5, 0.55},
      {"delay only", 5, 0.02, Stopping::Ideal, 5.2, 5.2, 0.57},
      {"braking only", 5, 0, Stopping::Braking, 5, 5.5, 0.65},
      {"delay and braking", 5, 0.02, Stopping::Braking, 5.2, 5.7, 0.67},
      {"in the acceleration", 0.125, 0, Stopping::Braking, 0.125, 0.25, 0.1},
      {"just before the end: stops there", 9.9, 0, Stopping::Braking, 9.9, 10, 1.1},
      {"just before the end, the delay outlasts the move", 9.9, 0.3, Stopping::Braking, 10, 10,
       1.1 - std::sqrt(2 * 0.1 / 100) + 0.3},
      {"at the very end", 10, 0, Stopping::Ideal, 10, 10, 1.1},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const Contact contact{Point(5, 0, 0), Point(-1, 0, 0), "block"};
    ScriptedSurroundings world({{'X', c.at, c.delay_s, false, contact}});
    MachiningCentre centre(round_numbers(c.stopping), &world);
    const auto outcome = centre.move_until_skip(feed(axes(10, 0, 0), 600));
    ASSERT_TRUE(outcome.ok());
    const auto* touched = std::get_if<Touched>(&outcome.value());
    ASSERT_NE(touched, nullptr);
    EXPECT_LT((touched->q_M_latched - axes(c.latched, 0, 0)).norm(), 1e-14);
    EXPECT_LT((touched->q_M_stopped - axes(c.stopped, 0, 0)).norm(), 1e-14);
    EXPECT_LE(touched->q_M_stopped[0], 10.0);
    EXPECT_EQ(centre.position(), touched->q_M_stopped);
    EXPECT_NEAR(centre.time_s(), c.seconds, 1e-14);
    ASSERT_TRUE(touched->contact.has_value());
    EXPECT_EQ(touched->contact->part, "block");
  }
}

TEST(MachiningCentreSkip, StopsExactlyAtTheEndWhenAlreadyBrakingTowardsIt) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> coordinate(-1000.0, 1000.0);
  for (int i = 0; i < 10'000; ++i) {
    MachineSetup setup = round_numbers();
    setup.q_M_start = axes(coordinate(random), coordinate(random), coordinate(random));
    const AxisPositions q_M_end = axes(coordinate(random), coordinate(random), 5);
    // A thousandth of a millimetre before the end: the last ramp is half a millimetre and more.
    const AxisPositions q_back = setup.q_M_start - q_M_end;
    const double at = q_M_end[0] + 1e-3 * q_back[0] / q_back.norm();
    ScriptedSurroundings world({{'X', at, 0.0, false, {}}});
    MachiningCentre centre(setup, &world);
    const auto outcome = centre.move_until_skip(feed(q_M_end, 600));
    ASSERT_TRUE(std::holds_alternative<Touched>(outcome.value()));
    ASSERT_EQ(centre.position(), q_M_end);
  }
}

TEST(MachiningCentreSkip, SeveralAxesMoveTogether) {
  // 10 mm along (0.6, 0, -0.8): acceleration 125 mm/s^2, braking 0.4 mm.
  ScriptedSurroundings world({{'Z', -4.0, 0.02, false, {}}});
  MachiningCentre centre(round_numbers(), &world);
  const auto outcome = centre.move_until_skip(feed(axes(6, 0, -8), 600));
  const auto& touched = std::get<Touched>(outcome.value());
  EXPECT_LT((touched.q_M_latched - axes(3.12, 0, -4.16)).norm(), 1e-14);
  EXPECT_LT((touched.q_M_stopped - axes(3.36, 0, -4.48)).norm(), 1e-14);
  EXPECT_FALSE(touched.contact.has_value());
}

TEST(MachiningCentreSkip, ARotaryAxisCanSkip) {
  ScriptedSurroundings world({{'A', 45.0, 0.0, false, {}}});
  MachiningCentre centre(round_numbers(), &world);
  const auto outcome = centre.move_until_skip(feed(axes(0, 0, 0, 90), 600));
  EXPECT_NEAR(std::get<Touched>(outcome.value()).q_M_stopped[3], 45.5, 1e-13);
}

TEST(MachiningCentreSkip, WithoutASignalItReachesTheEnd) {
  ScriptedSurroundings silent({{'X', std::nullopt, 0.0, false, {}}});
  for (ScriptedSurroundings* world : {&silent, static_cast<ScriptedSurroundings*>(nullptr)}) {
    MachiningCentre centre(round_numbers(), world);
    const auto outcome = centre.move_until_skip(feed(axes(0.1, 10, 0.3), 600));
    ASSERT_TRUE(outcome.ok());
    EXPECT_TRUE(std::holds_alternative<NoTouch>(outcome.value()));
    EXPECT_EQ(centre.position(), axes(0.1, 10, 0.3));
    EXPECT_NEAR(centre.time_s(), 1.1, 1e-3);
  }
  ASSERT_EQ(silent.skip_sweeps().size(), 1U);
  EXPECT_TRUE(silent.move_sweeps().empty());
}

TEST(MachiningCentreSkip, ASignalThatIsAlreadyHighMovesNothing) {
  const Contact contact{Point(5, 0, 0), Point(-1, 0, 0), "block"};
  ScriptedSurroundings world({{'X', 5.0, 0.01, true, contact}});
  MachiningCentre centre(round_numbers(), &world);
  const auto outcome = centre.move_until_skip(feed(axes(10, 0, 0), 600));
  ASSERT_TRUE(outcome.ok());
  const auto* touching = std::get_if<NoEdge>(&outcome.value());
  ASSERT_NE(touching, nullptr);
  EXPECT_EQ(touching->contact->part, "block");
  EXPECT_EQ(centre.position(), axes(0, 0, 0));
  EXPECT_EQ(centre.time_s(), 0.0);
}

TEST(MachiningCentreSkip, AZeroLengthMoveIsNoTouchAndAsksNobody) {
  ScriptedSurroundings world({{'X', 0.0, 0.0, true, {}}});
  MachiningCentre centre(round_numbers(), &world);
  const auto outcome = centre.move_until_skip(feed(axes(0, 0, 0), 600));
  ASSERT_TRUE(outcome.ok());
  EXPECT_TRUE(std::holds_alternative<NoTouch>(outcome.value()));
  EXPECT_EQ(centre.time_s(), 0.0);
  EXPECT_TRUE(world.skip_sweeps().empty());
}

TEST(MachiningCentreSkip, AnIdealStopIsTheScriptedCoordinateAndNothingElseMoves) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> coordinate(-1000.0, 1000.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    MachineSetup setup = round_numbers(Stopping::Ideal);
    setup.q_M_start = axes(coordinate(random), coordinate(random), coordinate(random));
    const int axis = i % 3;
    AxisPositions q_M_end = setup.q_M_start;
    q_M_end[axis] = coordinate(random);
    const double from = setup.q_M_start[axis];
    // Whole microns, not from + share * way: that formula would only undo the machine's own.
    const double at = std::round(1000.0 * std::lerp(from, q_M_end[axis], share(random))) / 1000.0;
    if ((at - from) * (at - q_M_end[axis]) > 0.0) {
      continue;
    }
    ScriptedSurroundings world({{kAxisLetters[axis], at, 0.0, false, {}}});
    MachiningCentre centre(setup, &world);

    const auto outcome = centre.move_until_skip(feed(q_M_end, 300));

    const auto& touched = std::get<Touched>(outcome.value());
    ASSERT_EQ(touched.q_M_latched, touched.q_M_stopped);
    for (int other = 0; other < 6; ++other) {
      if (other != axis) {
        ASSERT_EQ(touched.q_M_latched[other], setup.q_M_start[other]);
      }
    }
    worst = std::max(worst, std::abs(touched.q_M_latched[axis] - at));
  }
  std::printf("worst %.2e mm\n", worst);
  EXPECT_LT(worst, kSkipPositionErrorMm);
  EXPECT_GT(worst, 0.0) << "the coordinates are too easy";
}

TEST(MachiningCentreSkip, NeitherPointLiesBeyondTheEnd) {
  std::mt19937 random(13);
  std::normal_distribution<double> gauss(0.0, 20.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 20'000; ++i) {
    const AxisPositions q_M_end = axes(gauss(random), gauss(random), gauss(random));
    ScriptedSurroundings world(
        {{'Y', share(random) * q_M_end[1], 0.05 * share(random), false, {}}});
    MachiningCentre centre(round_numbers(), &world);
    const auto outcome = centre.move_until_skip(LinearMove{q_M_end, Traverse::Rapid, 0.0});
    const auto& touched = std::get<Touched>(outcome.value());
    ASSERT_TRUE(
        (touched.q_M_latched.cwiseAbs().array() <= touched.q_M_stopped.cwiseAbs().array()).all());
    ASSERT_TRUE((touched.q_M_stopped.cwiseAbs().array() <= q_M_end.cwiseAbs().array()).all());
  }
}

TEST(MachiningCentreDeathTest, ATriggerOutsideTheSweepOrBeforeItsTime) {
  ScriptedSurroundings world({{'X', 5.0, -0.01, false, {}}});
  MachiningCentre centre(round_numbers(), &world);
  testing::expect_violated([&] { (void)centre.move_until_skip(feed(axes(10, 0, 0), 600)); },
                           "delay_s >= 0.0");
}

}  // namespace
}  // namespace g31::machine::machining_centre_skip_test

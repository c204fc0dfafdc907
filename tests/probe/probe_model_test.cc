// What the probe's own errors do to a touch: deflection, eccentricity and spindle angle, further
// balls, and the states of a probe that is not well.

#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "parts/geometry/placement.h"
#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::probe_model_test {
namespace {

/// Ring gauge with its axis in the machine's Z axis; the ball centre 10 mm deep when Z is 110.
constexpr double kLength = 120.0;
constexpr double kWay = 39.996 / 2 - 3.0;

ProbedPart ring() {
  parts::PartSetup setup;
  setup.name = "ring";
  setup.shape = "ring";
  return {"ring", parts::make_artefact(setup).value()};
}

AxisPositions at(double x, double y, double z) {
  AxisPositions q = AxisPositions::Zero();
  q.head<3>() = Point(x, y, z);
  return q;
}

/// mm from the ring's axis to the signal in that direction; nullopt without a signal.
std::optional<double> reading(TouchProbe& probe, double direction_deg) {
  constexpr double kReach = 20.0;
  const double angle = direction_deg * std::numbers::pi / 180.0;
  const auto trigger = testing::touch_on(
      probe, {at(0, 0, 110), at(kReach * std::cos(angle), kReach * std::sin(angle), 110)});
  return trigger ? std::optional(kReach * trigger->fraction) : std::nullopt;
}

TEST(ProbeModel, AConstantPreTravelAsksForTheSameCorrectionEverywhere) {
  ProbeSetup setup;
  setup.at_switch.pre_travel_mm = 0.013;
  TouchProbe probe(setup, {ring()}, 0);
  for (const double direction : {0.0, 90.0, 180.0, 270.0}) {
    EXPECT_NEAR(reading(probe, direction).value(), kWay + 0.013, 1e-11);
  }
  for (int direction = 0; direction < 360; direction += 7) {
    EXPECT_NEAR(reading(probe, direction).value(), kWay + 0.013, 1e-4) << "facets";
  }
}

TEST(ProbeModel, TheContactIsWhereTheBallTouchesAndTheSignalComesLater) {
  ProbeSetup setup;
  setup.at_switch.pre_travel_mm = 0.25;
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  const auto trigger = testing::touch_on(probe, {at(5, 5, 143), at(5, 5, 123)});
  ASSERT_TRUE(trigger.has_value());
  EXPECT_NEAR(20.0 * trigger->fraction, 10.25, 1e-12);
  EXPECT_NEAR((trigger->contact->p_M_point - Point(5, 5, 10)).norm(), 0.0, 1e-12);
}

TEST(ProbeModel, AtAnAngleTheDeflectionIsAlongTheNormal) {
  ProbeSetup setup;
  setup.at_switch.pre_travel_mm = 0.1;
  TouchProbe probe(setup, {{"block", testing::box_mesh({200, 200, 10})}}, 0);
  // 30 degrees to the face: half of the way goes in.
  const double down = 20.0;
  const double along = down * std::sqrt(3.0);
  const auto trigger =
      testing::touch_on(probe, {at(20, 100, 143), at(20 + along, 100, 143 - down)});
  ASSERT_TRUE(trigger.has_value());
  EXPECT_NEAR(down * trigger->fraction, 10.1, 1e-12);
}

TEST(ProbeModel, ATripodMeasuresTheRingWithThreeLobes) {
  ProbeSetup setup;
  setup.at_switch.seats = Seats::Tripod;
  setup.at_switch.trigger_force_n = 0.5;
  setup.at_switch.stem_stiffness_n_mm = 40.0;
  TouchProbe probe(setup, {ring()}, 0);
  EXPECT_NEAR(reading(probe, 0).value(), kWay + 0.0125, 1e-11);
  EXPECT_NEAR(reading(probe, 180).value(), kWay + 0.025, 1e-11);
  EXPECT_NEAR(reading(probe, 90).value(), kWay + 0.0125 / std::cos(std::numbers::pi / 6), 1e-11);
  for (int direction = 0; direction < 120; direction += 5) {
    const double here = reading(probe, direction).value();
    EXPECT_NEAR(here, reading(probe, direction + 120).value(), 1e-4);
    EXPECT_NEAR(here, reading(probe, direction + 240).value(), 1e-4);
  }
}

TEST(ProbeModel, AnEccentricBallTurnsWithTheSpindle) {
  ProbeSetup setup;
  setup.eccentricity_mm = {0.02, -0.03};
  TouchProbe probe(setup, {ring()}, 0);
  const auto offsets = [&] {
    return Point(0.5 * (reading(probe, 180).value() - reading(probe, 0).value()),
                 0.5 * (reading(probe, 270).value() - reading(probe, 90).value()), 0.0);
  };
  // A ball that stands off by e towards a wall touches it e sooner, and the other one e later; off
  // the axis the chord is shorter by e^2 / 2R, the same on both sides.
  EXPECT_NEAR((offsets() - Point(0.02, -0.03, 0)).norm(), 0.0, 1e-6);
  probe.take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, 180.0});
  EXPECT_NEAR((offsets() - Point(-0.02, 0.03, 0)).norm(), 0.0, 1e-6);
  probe.take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, 90.0});
  EXPECT_NEAR((offsets() - Point(0.03, 0.02, 0)).norm(), 0.0, 1e-6);
  probe.take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, -360.0});
  EXPECT_NEAR((offsets() - Point(0.02, -0.03, 0)).norm(), 0.0, 1e-6);
}

TEST(ProbeModel, ASpindleThatHasTurnedStandsWhereTheSeedDraws) {
  constexpr int kSeeds = 400;
  ProbeSetup setup;
  setup.eccentricity_mm = {0.02, 0.0};
  // Two flat walls: each shows one component of where the ball's centre is.
  constexpr double kWall = 16.0;
  const ProbedPart right{"right",
                         testing::moved_by(testing::box_mesh({9, 90, 90}), {kWall, -45, -45})};
  const ProbedPart back{"back",
                        testing::moved_by(testing::box_mesh({90, 9, 90}), {-45, kWall, -45})};
  int quadrants[4] = {};
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    TouchProbe probe(setup, {right, back}, seed);
    TouchProbe again(setup, {right, back}, seed);
    for (TouchProbe* const one : {&probe, &again}) {
      one->take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, {}});
      ASSERT_TRUE(one->sensor_state(1)->angle_known);  // it has not turned
      one->take(machine::SpindleTurn{machine::Rotation::Clockwise, 500.0, {}});
      ASSERT_FALSE(one->sensor_state(1)->angle_known);
      one->take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, {}});
      ASSERT_FALSE(one->sensor_state(1)->angle_known);
    }
    const double x = kWall - 3.0 - reading(probe, 0).value();
    const double y = kWall - 3.0 - reading(probe, 90).value();
    EXPECT_NEAR(std::hypot(x, y), 0.02, 1e-11);
    EXPECT_EQ(reading(again, 0), reading(probe, 0));
    ++quadrants[(x < 0.0 ? 1 : 0) + (y < 0.0 ? 2 : 0)];
    probe.take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, 0.0});
    ASSERT_TRUE(probe.sensor_state(1)->angle_known);
  }
  for (const int count : quadrants) {  // 100 +- 8.7 each: five standard deviations
    EXPECT_NEAR(count, kSeeds / 4, 44);
  }
}

TEST(ProbeModel, WhatIsTheSameAllAroundNeedsNoAngle) {
  TouchProbe probe({}, {ring()}, 0);
  probe.take(machine::SpindleTurn{machine::Rotation::Clockwise, 500.0, {}});
  probe.take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, {}});
  EXPECT_TRUE(probe.sensor_state(1)->angle_known);
}

TEST(ProbeModel, LobesAndMonoDirectionTurnWithTheSpindle) {
  ProbeSetup setup;
  setup.at_switch.type = ProbeType::Mono;
  TouchProbe probe(setup, {ring()}, 0);
  EXPECT_TRUE(reading(probe, 0).has_value());
  EXPECT_FALSE(reading(probe, 90).has_value());
  probe.take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, 90.0});
  EXPECT_FALSE(reading(probe, 0).has_value());
  EXPECT_TRUE(reading(probe, 90).has_value());
}

TEST(ProbeModel, AMoveThatEndsBeforeTheDeflectionGivesNoSignalAndTheNextOneDoes) {
  ProbeSetup setup;
  setup.at_switch.pre_travel_mm = 0.1;
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  EXPECT_FALSE(testing::touch_on(probe, {at(5, 5, 143), at(5, 5, 132.95)}).has_value());
  // The stylus is 0.05 mm in: the signal is not on, it comes after 0.05 mm more.
  const auto onwards = testing::touch_on(probe, {at(5, 5, 132.95), at(5, 5, 131.95)});
  ASSERT_TRUE(onwards.has_value());
  EXPECT_FALSE(onwards->on_at_start);
  EXPECT_NEAR(onwards->fraction, 0.05, 1e-11);
  EXPECT_FALSE(testing::touch_on(probe, {at(5, 5, 132.95), at(5, 5, 140)}).has_value());
  // 0.15 mm in, it is on, whatever the direction.
  EXPECT_TRUE(testing::touch_on(probe, {at(5, 5, 132.85), at(5, 5, 140)})->on_at_start);
}

TEST(ProbeModel, TheSignalGoesOffWhereTheDeflectionIsBelowThePreTravelAgain) {
  ProbeSetup setup;
  setup.at_switch.pre_travel_mm = 0.1;
  setup.trigger_delay_s = 0.002;
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  // The ball touches the top face at Z133; the signal is on up to 132.9.
  EXPECT_TRUE(probe.signals_at({0.0, at(5, 5, 132.85)}, {1}));
  EXPECT_TRUE(probe.signals_at({0.0, at(5, 5, 132.9)}, {1}));
  EXPECT_FALSE(probe.signals_at({0.0, at(5, 5, 132.91)}, {1}));
  const machine::Waypoint way[] = {
      {0.0, at(5, 5, 132.5)}, {0.4, at(5, 5, 132.7)}, {1.0, at(5, 5, 133.5)}};
  const auto trigger = testing::release_along(probe, way);
  ASSERT_TRUE(trigger.has_value());
  EXPECT_FALSE(trigger->on_at_start);
  EXPECT_NEAR(trigger->fraction, 0.4 + 0.6 * 0.25, 1e-8);
  EXPECT_EQ(trigger->delay_s, 0.002);
  EXPECT_EQ(trigger->contact->part, "block");
  // Deeper in, or too short to come free: no edge.  From outside: none can come.
  EXPECT_FALSE(testing::release_along(probe, std::span(way).first(2)).has_value());
  const machine::Waypoint free[] = {{0.0, at(5, 5, 133.0)}, {1.0, at(5, 5, 135.0)}};
  EXPECT_TRUE(testing::release_along(probe, free)->on_at_start);
}

TEST(ProbeModel, FromTheDeflectionOfOneWallTheOtherOneIsFound) {
  ProbeSetup setup;
  setup.at_switch.pre_travel_mm = 0.0125;
  TouchProbe probe(setup, {ring()}, 0);
  const double stopped = kWay + 0.0125;
  const auto across = testing::touch_on(probe, {at(stopped, 0, 110), at(-20, 0, 110)});
  ASSERT_TRUE(across.has_value());
  EXPECT_FALSE(across->on_at_start) << "the stylus is as far out as the signal takes, not farther";
  EXPECT_NEAR(across->fraction * (stopped + 20.0), 2.0 * stopped, 1e-8);
}

TEST(ProbeModel, OnACrookedWayTheSignalComesAtTheSameDepth) {
  ProbeSetup setup;
  setup.at_switch.pre_travel_mm = 0.1;
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  // Down to the face in three pieces; the touch is 0.5 mm before the end of the second one.
  const std::vector<machine::Waypoint> way = {
      {0.0, at(5, 5, 143)}, {0.4, at(5.1, 5, 137)}, {0.7, at(5.1, 5, 132.5)}, {1.0, at(5, 5, 130)}};
  const auto trigger = testing::touch_along(probe, way);
  ASSERT_TRUE(trigger.has_value());
  EXPECT_NEAR(trigger->fraction, 0.4 + 0.3 * (137.0 - 132.9) / 4.5, 1e-9);
  const std::vector<machine::Waypoint> short_way = {{0.0, at(5, 5, 143)}, {1.0, at(5, 5, 132.95)}};
  EXPECT_FALSE(testing::touch_along(probe, short_way).has_value());
}

TEST(ProbeModel, AStarStylusTouchesWithTheBallThatComesFirst) {
  ProbeSetup setup;
  for (const Point& arm :
       {Point(20, 0, 15), Point(-20, 0, 15), Point(0, 20, 15), Point(0, -20, 15)}) {
    setup.further_balls.push_back({arm, 4.0});
  }
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  // Main ball high above the block's height, the arm ball beside it: only that one touches.
  const auto side = testing::touch_on(probe, {at(-50, 5, 110), at(-20, 5, 110)});
  ASSERT_TRUE(side.has_value());
  EXPECT_NEAR(30.0 * side->fraction, 50.0 - 20.0 - 2.0, 1e-12);
  EXPECT_NEAR((side->contact->p_M_point - Point(0, 5, 5)).norm(), 0.0, 1e-12);
  // A quarter of a turn later it is another arm.
  probe.take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, 90.0});
  EXPECT_NEAR(30.0 * testing::touch_on(probe, {at(-50, 5, 110), at(-20, 5, 110)})->fraction, 28.0,
              1e-12);
  EXPECT_FALSE(testing::collision_on(probe, {at(-50, 5, 110), at(-23, 5, 110)}).has_value());
  EXPECT_EQ(testing::collision_on(probe, {at(-50, 5, 110), at(-20, 5, 110)})->what,
            "stylus ball touches block");
}

TEST(ProbeModel, AnLStylusIsABallFarOffTheSpindleAxis) {
  ProbeSetup setup;
  setup.eccentricity_mm = {30.0, 0.0};
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  const machine::Sweep sweep{at(-60, 5, 125), at(-20, 5, 125)};
  EXPECT_NEAR(40.0 * testing::touch_on(probe, sweep)->fraction, 60.0 - 30.0 - 3.0, 1e-12);
  probe.take(machine::SpindleTurn{machine::Rotation::Stopped, 0.0, 180.0});
  EXPECT_FALSE(testing::touch_on(probe, sweep).has_value());
}

TEST(ProbeModel, ADeadProbeNeverTriggersAndStillCollides) {
  ProbeSetup setup;
  setup.state = ProbeState::Dead;
  TouchProbe probe(setup, {ring()}, 0);
  EXPECT_FALSE(reading(probe, 0).has_value());
  EXPECT_TRUE(testing::collision_on(probe, {at(0, 0, 110), at(20, 0, 110)}).has_value());
  EXPECT_FALSE(testing::touch_on(probe, {at(17, 0, 110), at(20, 0, 110)}).has_value());
}

TEST(ProbeModel, OnlyADoubleTriggerGivesTwoSignalsAndTheFirstIsTheSame) {
  for (const auto& [state, name] : kProbeStateNames) {
    if (state == ProbeState::Dead) {
      continue;
    }
    SCOPED_TRACE(std::string(name));
    ProbeSetup setup;
    setup.state = state;
    TouchProbe probe(setup, {ring()}, 0);
    const auto trigger = testing::touch_on(probe, {at(0, 0, 110), at(20, 0, 110)});
    ASSERT_TRUE(trigger.has_value());
    EXPECT_NEAR(20.0 * trigger->fraction, kWay, 1e-12);
    EXPECT_EQ(trigger->signals, state == ProbeState::DoubleTrigger ? 2 : 1);
  }
}

}  // namespace
}  // namespace g31::probe::probe_model_test

#include "probe/sensor/pre_travel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace g31::probe::pre_travel_test {
namespace {

/// The normal of a wall that the probe moves against in this direction.
Point wall_against(double motion_deg) {
  const double angle = motion_deg * std::numbers::pi / 180.0;
  return {-std::cos(angle), -std::sin(angle), 0.0};
}

SwitchSetup tripod() {
  SwitchSetup setup;
  setup.seats = Seats::Tripod;
  setup.weak_direction_deg = 30.0;
  setup.trigger_force_n = 0.5;
  setup.axial_force_n = 6.0;
  setup.stem_stiffness_n_mm = 40.0;
  return setup;
}

TEST(PreTravel, IsNothingForAnIdealProbe) {
  for (const Point& n : {Point(1, 0, 0), Point(0, -1, 0), Point(0, 0, 1), Point(0, 0, -1)}) {
    EXPECT_EQ(deflection_to_trigger({}, n), 0.0);
  }
}

TEST(PreTravel, OfEvenSeatsIsTheSameAllAround) {
  SwitchSetup setup = tripod();
  setup.seats = Seats::Even;
  setup.pre_travel_mm = 0.01;
  for (int motion = 0; motion < 360; motion += 7) {
    // 0.5 N bend a stem of 40 N/mm by 12.5 um.
    EXPECT_NEAR(deflection_to_trigger(setup, wall_against(motion)).value(), 0.0225, 1e-15);
  }
  EXPECT_EQ(deflection_to_trigger(setup, {0, 0, 1}), 0.01) << "the stem does not bend lengthwise";
}

TEST(PreTravel, OfATripodHasThreeLobes) {
  const SwitchSetup setup = tripod();
  const double weakest = 0.5 / 40.0;
  EXPECT_NEAR(deflection_to_trigger(setup, wall_against(30)).value(), weakest, 1e-15);
  EXPECT_NEAR(deflection_to_trigger(setup, wall_against(90)).value(), 2.0 * weakest, 1e-15);
  for (int motion = -180; motion < 180; ++motion) {
    const double here = deflection_to_trigger(setup, wall_against(motion)).value();
    EXPECT_NEAR(here, deflection_to_trigger(setup, wall_against(motion + 120)).value(), 1e-15)
        << "a period of 120 degrees";
    EXPECT_GE(here, weakest * (1.0 - 1e-15));
    EXPECT_LE(here, 2.0 * weakest * (1.0 + 1e-14));
    // Only every 60 degrees does the opposite direction feel the same.
    const double opposite = deflection_to_trigger(setup, wall_against(motion + 180)).value();
    EXPECT_EQ(std::fabs(here - opposite) < 1e-12, (motion + 360) % 60 == 0) << motion;
  }
}

/// The tilting carrier, from its moments: three seats 1 mm from the axis, pressed down by the
/// spring, tilt about the edge between two of them that gives way first.
double force_to_tilt(double motion_deg, double theta, double weak_force, double axial_force) {
  const double inradius = 0.5;
  const double stem = axial_force * inradius / weak_force;  // weak_force * stem = spring * inradius
  double least = std::numeric_limits<double>::infinity();
  for (const double edge_deg : {0.0, 120.0, 240.0}) {
    const double lean = (motion_deg - edge_deg) * std::numbers::pi / 180.0;
    const double moment = std::sin(theta) * std::cos(lean) * stem + std::cos(theta) * inradius;
    if (moment > 0.0) {
      least = std::min(least, axial_force * inradius / moment);
    }
  }
  return least;
}

TEST(PreTravel, OfATripodFollowsFromItsMoments) {
  SwitchSetup setup = tripod();
  setup.weak_direction_deg = 0.0;
  for (int motion = 0; motion < 360; motion += 11) {
    for (const double theta : {0.1, 0.7, 1.2, 1.5707, 1.6}) {
      const Point n = std::sin(theta) * wall_against(motion) + std::cos(theta) * Point::UnitZ();
      const double force = force_to_tilt(motion, theta, 0.5, 6.0);
      EXPECT_NEAR(deflection_to_trigger(setup, n).value(),
                  force * std::sin(theta) * std::sin(theta) / 40.0, 1e-13);
    }
  }
}

TEST(PreTravel, PullingATripodIntoItsSeatsGivesNoSignal) {
  SwitchSetup setup = tripod();
  EXPECT_FALSE(deflection_to_trigger(setup, {0, 0, -1}).has_value());
  EXPECT_FALSE(deflection_to_trigger(setup, Point(0.05, 0, -1).normalized()).has_value());
  EXPECT_TRUE(deflection_to_trigger(setup, Point(-1, 0, -0.05).normalized()).has_value());
  setup.seats = Seats::Even;
  EXPECT_TRUE(deflection_to_trigger(setup, {0, 0, -1}).has_value());
}

TEST(PreTravel, AMonoProbeKnowsOneDirectionAndAbove) {
  SwitchSetup setup;
  setup.type = ProbeType::Mono;
  setup.mono_direction_deg = 90.0;
  for (int motion = 0; motion < 360; ++motion) {
    const bool reached = motion >= 45 && motion <= 135;
    if (motion != 45 && motion != 135) {
      EXPECT_EQ(deflection_to_trigger(setup, wall_against(motion)).has_value(), reached) << motion;
    }
  }
  EXPECT_TRUE(deflection_to_trigger(setup, {0, 0, 1}).has_value());
  EXPECT_FALSE(deflection_to_trigger(setup, {0, 0, -1}).has_value());
}

}  // namespace
}  // namespace g31::probe::pre_travel_test

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "machine/sim/motion_profile.h"

namespace g31::machine::jerk_limited_profile_test {
namespace {

TEST(JerkLimitedProfile, ClosedForms) {
  struct Case {
    const char* name;
    double length, speed, acceleration, jerk;
    double duration_s, peak_speed;
  };
  const double kPeak = std::sqrt(13.0) - 1.0;
  const Case kCases[] = {
      {"all seven phases: ramps of v/a + a/j = 1.5 s", 100, 10, 10, 20, 100.0 / 10 + 1.5, 10},
      {"no time at full acceleration: ramps of 2 sqrt(v/j)", 100, 10, 100, 10, 10.0 + 2.0, 10},
      {"two ramps that never get to full acceleration", 2, 10, 100, 8, 4.0 * std::cbrt(2.0 / 16),
       std::cbrt(4.0 * 8 / 4)},
      {"two ramps with full acceleration: v^2/2 + v = 6", 6, 100, 2, 2, 2 * (kPeak / 2 + 1), kPeak},
      {"no way", 0, 10, 100, 8, 0, 0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const MotionProfile profile(c.length, c.speed, c.acceleration, c.jerk);
    EXPECT_NEAR(profile.duration_s(), c.duration_s, 1e-13);
    EXPECT_NEAR(profile.peak_speed(), c.peak_speed, 1e-13);
  }
}

// The second way: integrate what phases() says, and look at the limits on the way.
TEST(JerkLimitedProfile, PhasesGoAllTheWayWithinTheLimits) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> exponent(-1.0, 2.0);
  const auto number = [&] { return std::pow(10.0, exponent(random)); };
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double length = number(), speed = number(), acceleration = number(), jerk = number();
    const MotionProfile profile(length, speed, acceleration, jerk);
    const MotionPhases phases = profile.phases();
    ASSERT_NEAR(phases.duration_s(), profile.duration_s(), 1e-12 * profile.duration_s());
    worst = std::max(worst, std::abs(phases.length() - length) / length);
    for (int k = 0; k <= 20; ++k) {
      const double time_s = std::min(k / 20.0 * profile.duration_s(), profile.duration_s());
      const MotionState state = phases.at(time_s);
      ASSERT_LE(state.speed, speed * (1.0 + 1e-12));
      ASSERT_LE(std::abs(state.acceleration), acceleration * (1.0 + 1e-12));
      worst = std::max(worst, std::abs(profile.distance_at(time_s) - state.distance) / length);
      ASSERT_NEAR(profile.speed_at(time_s), state.speed, 1e-12 * speed);
      const double back = profile.time_at(profile.distance_at(time_s));
      ASSERT_NEAR(profile.distance_at(back), profile.distance_at(time_s), 1e-13 * length);
    }
  }
  EXPECT_LT(worst, kJerkLimitedError);
}

TEST(JerkLimitedProfile, BrakingEndsAtStandstillWithinTheLimitsAndBeforeTheEnd) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> exponent(-1.0, 2.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto number = [&] { return std::pow(10.0, exponent(random)); };
  for (int i = 0; i < 2000; ++i) {
    const double length = number(), speed = number(), acceleration = number(), jerk = number();
    const MotionProfile profile(length, speed, acceleration, jerk);
    const double time_s = share(random) * profile.duration_s();
    const MotionPhases braking = profile.phases_braking_at(time_s);
    const MotionPhase& last = braking.phases().back();
    ASSERT_NEAR(last.speed_after(last.duration_s), 0.0, 1e-11 * speed);
    ASSERT_NEAR(last.acceleration_after(last.duration_s), 0.0, 1e-11 * acceleration);
    ASSERT_LE(braking.length(), length * (1.0 + 1e-12));
    ASSERT_LE(profile.distance_at(time_s), braking.length() * (1.0 + 1e-12));
    for (const MotionPhase& phase : braking.phases()) {
      ASSERT_LE(std::abs(phase.acceleration), acceleration * (1.0 + 1e-12));
      ASSERT_GE(phase.speed_after(0.5 * phase.duration_s), -1e-12 * speed);
    }
  }
}

TEST(JerkLimitedProfile, AVeryLargeJerkIsTheTrapezoid) {
  const MotionProfile smooth(20.0, 5.0, 100.0, 1e12);
  const MotionProfile trapezoid(20.0, 5.0, 100.0);
  EXPECT_NEAR(smooth.duration_s(), trapezoid.duration_s(), 1e-9);
  EXPECT_NEAR(smooth.distance_at(0.03), trapezoid.distance_at(0.03), 1e-9);
  EXPECT_NEAR(smooth.time_at(19.9), trapezoid.time_at(19.9), 1e-9);
}

}  // namespace
}  // namespace g31::machine::jerk_limited_profile_test

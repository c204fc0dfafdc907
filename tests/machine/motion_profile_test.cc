#include "machine/sim/motion_profile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

namespace g31::machine::motion_profile_test {
namespace {

TEST(MotionProfile, ClosedForms) {
  struct Case {
    const char* name;
    double length, speed, acceleration;
    double duration_s, peak_speed;
  };
  const Case kCases[] = {
      {"long way: ramp 0.1 s, cruise 0.9 s, ramp 0.1 s", 10, 10, 100, 1.1, 10},
      {"exactly two ramps", 1, 10, 100, 0.2, 10},
      {"short way: half the ramp in each direction", 0.25, 10, 100, 0.1, 5},
      {"feed 300 mm/min over 20 mm at 2000 mm/s^2", 20, 5, 2000, 4.0025, 5},
      {"rapid 20 m/min over 1 mm never gets fast", 1, 20000.0 / 60, 2000, 0.0447213595499958,
       44.7213595499958},
      {"no way", 0, 10, 100, 0, 0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const MotionProfile profile(c.length, c.speed, c.acceleration);
    EXPECT_NEAR(profile.duration_s(), c.duration_s, 1e-14 * c.duration_s);
    EXPECT_NEAR(profile.peak_speed(), c.peak_speed, 1e-14 * c.peak_speed);
    EXPECT_EQ(profile.distance_at(profile.duration_s()), c.length);
    EXPECT_EQ(profile.time_at(c.length), profile.duration_s());
    EXPECT_EQ(profile.time_at(0.0), 0.0);
    EXPECT_EQ(profile.speed_at(0.0), 0.0);
    EXPECT_EQ(profile.speed_at(profile.duration_s()), 0.0);
    EXPECT_EQ(profile.distance_at(profile.duration_s() + 1.0), c.length);
    EXPECT_EQ(profile.speed_at(profile.duration_s() + 1.0), 0.0);
  }
}

TEST(MotionProfile, SpeedAndPlaceInEachPhase) {
  const MotionProfile profile(10.0, 10.0, 100.0);  // 0.1 s ramps of 0.5 mm, 9 mm cruise
  struct Case {
    const char* name;
    double time_s, distance, speed;
    bool slows_down;
  };
  const Case kCases[] = {
      {"half the acceleration", 0.05, 0.125, 5, false},
      {"begin of the cruise", 0.1, 0.5, 10, false},
      {"middle of the cruise", 0.55, 5, 10, false},
      {"half the deceleration", 1.05, 9.875, 5, true},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_NEAR(profile.distance_at(c.time_s), c.distance, 1e-14);
    EXPECT_NEAR(profile.time_at(c.distance), c.time_s, 1e-15);
    EXPECT_NEAR(profile.speed_at(c.time_s), c.speed, 1e-13);
    EXPECT_EQ(profile.slows_down_at(c.time_s), c.slows_down);
  }
}

struct Numbers {
  double length, speed, acceleration;
};

Numbers random_numbers(std::mt19937& random) {
  std::uniform_real_distribution<double> exponent(-3.0, 3.0);
  return {std::pow(10.0, exponent(random)), std::pow(10.0, exponent(random)),
          std::pow(10.0, exponent(random) + 1.0)};
}

// The judge knows no phases: in tiny steps it goes as fast as the speed, the acceleration and the
// need to stand still at the end allow.
TEST(MotionProfile, AgreesWithStepwiseIntegration) {
  constexpr int kSteps = 20'000;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(-1.0, 0.5);
  for (int i = 0; i < 100; ++i) {
    Numbers n = random_numbers(random);
    // From a pure triangle to ramps of a hundredth of the time: 200 steps, enough for the judge.
    n.speed = std::sqrt(n.length * n.acceleration) * std::pow(10.0, share(random));
    const MotionProfile profile(n.length, n.speed, n.acceleration);
    const long double step_s = static_cast<long double>(profile.duration_s()) / kSteps;
    long double distance = 0.0L;
    long double speed = 0.0L;
    double worst_distance = 0.0;
    double worst_speed = 0.0;
    for (int k = 1; k <= kSteps; ++k) {
      // The greatest speed after this step from which the rest of the way is enough to stop:
      // next^2 / 2a + (speed + next) / 2 * step = length - distance.
      const long double half_gain = n.acceleration * step_s / 2;
      const long double rest = std::max(0.0L, n.length - distance - speed * step_s / 2);
      const long double can_stop =
          std::sqrt(half_gain * half_gain + 2.0L * n.acceleration * rest) - half_gain;
      const long double next =
          std::min({static_cast<long double>(n.speed), speed + n.acceleration * step_s, can_stop});
      distance += 0.5L * (speed + next) * step_s;
      speed = next;
      const double time_s = static_cast<double>(k * step_s);
      worst_distance = std::max(
          worst_distance, std::abs(static_cast<double>(distance) - profile.distance_at(time_s)));
      worst_speed =
          std::max(worst_speed, std::abs(static_cast<double>(speed) - profile.speed_at(time_s)));
    }
    // The judge may turn each of the three corners one step late.
    EXPECT_LT(worst_distance, 2e-4 * n.length) << n.length << ' ' << n.speed;
    EXPECT_LT(worst_speed, 3.0 * n.acceleration * static_cast<double>(step_s))
        << n.length << ' ' << n.speed;
  }
}

struct WideProfile {
  long double length, speed, acceleration, ramp_s, duration_s;

  explicit WideProfile(const Numbers& n)
      : length(n.length), speed(n.speed), acceleration(n.acceleration) {
    speed = std::min(speed, std::sqrt(length * acceleration));
    ramp_s = speed / acceleration;
    duration_s = length / speed + ramp_s;
  }
  // The area under the speed: cruise speed all the time, minus a triangle at either end.
  [[nodiscard]] long double distance_at(long double t) const {
    const long double missing = std::min(t, ramp_s);
    const long double late = std::max(0.0L, t - (duration_s - ramp_s));
    return speed * t - acceleration * (ramp_s * missing - missing * missing / 2) -
           acceleration * late * late / 2;
  }
};

TEST(MotionProfile, WorstErrorAgainstLongDouble) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const Numbers n = random_numbers(random);
    const MotionProfile profile(n.length, n.speed, n.acceleration);
    const WideProfile wide(n);
    const double time_s = share(random) * profile.duration_s();
    const double distance = share(random) * n.length;

    const long double duration_error = profile.duration_s() - wide.duration_s;
    const long double distance_error = profile.distance_at(time_s) - wide.distance_at(time_s);
    long double low = 0.0L;
    long double high = wide.duration_s;
    for (int step = 0; step < 80; ++step) {
      const long double middle = (low + high) / 2;
      (wide.distance_at(middle) < distance ? low : high) = middle;
    }
    const long double time_error = profile.time_at(distance) - low;
    worst = std::max({worst, static_cast<double>(std::abs(duration_error / wide.duration_s)),
                      static_cast<double>(std::abs(distance_error / wide.length)),
                      static_cast<double>(std::abs(time_error / wide.duration_s))});
  }
  std::printf("worst %.2e\n", worst);
  EXPECT_LT(worst, kMotionProfileError);
}

}  // namespace
}  // namespace g31::machine::motion_profile_test

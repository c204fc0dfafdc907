#include "machine/sim/skip_stop.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

namespace g31::machine::skip_stop_test {
namespace {

// Speed 10, acceleration 100: ramps of 0.1 s and 0.5 mm, 9 mm of cruise, 1.1 s in all.
TEST(StopAfterContact, ClosedForms) {
  const MotionProfile profile(10.0, 10.0, 100.0);
  struct Case {
    const char* name;
    double contact, delay_s;
    Stopping stopping;
    double latched_after, stopped_after, duration_s;
  };
  const double kAtQuarter = std::sqrt(2.0 * 0.125 / 100.0);  // 0.05 s, speed 5
  const Case kCases[] = {
      {"cruise, no delay: brakes v^2/2a", 5, 0, Stopping::Braking, 0, 0.5, 0.55 + 0.1},
      {"cruise, delay: v * delay more", 5, 0.02, Stopping::Braking, 0.2, 0.7, 0.57 + 0.1},
      {"cruise, no delay, ideal", 5, 0, Stopping::Ideal, 0, 0, 0.55},
      {"cruise, delay, ideal: stops at the latch", 5, 0.02, Stopping::Ideal, 0.2, 0.2, 0.57},
      {"at the start, no delay: no speed yet", 0, 0, Stopping::Braking, 0, 0, 0},
      {"at the start, delay: the ramp begun", 0, 0.02, Stopping::Braking, 0.02, 0.04, 0.04},
      {"in the acceleration: the way out again", 0.125, 0, Stopping::Braking, 0, 0.125,
       kAtQuarter + 0.05},
      {"delay from the acceleration into the cruise", 0.125, 0.07, Stopping::Braking,
       0.375 + 10 * 0.02, 0.375 + 0.2 + 0.5, 0.12 + 0.1},
      {"delay from the cruise into the deceleration", 9.4, 0.06, Stopping::Braking,
       0.1 + 0.5 - 100 * 0.05 * 0.05 / 2, 0.6, 1.1},
      {"in the deceleration: the programmed end", 9.875, 0, Stopping::Braking, 0, 0.125, 1.1},
      {"in the deceleration, ideal", 9.875, 0, Stopping::Ideal, 0, 0, 1.05},
      {"the delay outlasts the move", 9.875, 0.2, Stopping::Braking, 0.125, 0.125, 1.25},
      {"at the very end", 10, 0, Stopping::Braking, 0, 0, 1.1},
      {"at the very end, delay", 10, 0.5, Stopping::Ideal, 0, 0, 1.6},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const SkipStop stop = stop_after_contact(profile, c.contact, {c.delay_s, 0.0}, c.stopping);
    EXPECT_NEAR(stop.latched_after, c.latched_after, 1e-14);
    EXPECT_NEAR(stop.stopped_after, c.stopped_after, 1e-14);
    EXPECT_NEAR(stop.duration_s, c.duration_s, 1e-14);
  }
}

struct Numbers {
  double length, speed, acceleration, contact, delay_s;
};

Numbers random_numbers(std::mt19937& random) {
  std::uniform_real_distribution<double> exponent(-1.0, 2.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  Numbers n{};
  n.length = std::pow(10.0, exponent(random));
  n.speed = std::pow(10.0, exponent(random));
  n.acceleration = 10.0 * std::pow(10.0, exponent(random));
  n.contact = share(random) * n.length;
  n.delay_s = share(random) < 0.2 ? 0.0 : 0.1 * share(random) * n.length / n.speed;
  return n;
}

struct Stop {
  long double latched, stopped;
};

// Knows no phases: goes as fast as it may in tiny steps, then brakes in tiny steps.
Stop stop_by_steps(const Numbers& n) {
  const long double step_s = static_cast<long double>(n.length) / n.speed / 20'000;
  long double distance = 0.0L;
  long double speed = 0.0L;
  long double since_contact_s = 0.0L;
  while (distance < n.contact || since_contact_s < n.delay_s) {
    if (distance >= n.contact) {
      since_contact_s += step_s;
    }
    const long double to_go = std::max(0.0L, n.length - distance);
    const long double next =
        std::min({static_cast<long double>(n.speed), speed + n.acceleration * step_s,
                  std::sqrt(2.0L * n.acceleration * to_go)});
    distance += 0.5L * (speed + next) * step_s;
    speed = next;
  }
  const long double latched = distance;
  while (speed > 0.0L) {
    const long double next = std::max(0.0L, speed - n.acceleration * step_s);
    distance += 0.5L * (speed + next) * step_s;
    speed = next;
  }
  return {latched, distance};
}

TEST(StopAfterContact, AgreesWithStepwiseIntegration) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    Numbers n = random_numbers(random);
    // The steps creep up to the end for ever; the closed forms above cover the last per cent.
    n.contact *= 0.99;
    n.delay_s *= 0.05;
    const MotionProfile profile(n.length, n.speed, n.acceleration);
    const SkipStop stop =
        stop_after_contact(profile, n.contact, {n.delay_s, 0.0}, Stopping::Braking);
    const Stop judge = stop_by_steps(n);
    const double tolerance = 2e-3 * n.length;
    EXPECT_NEAR(n.contact + stop.latched_after, static_cast<double>(judge.latched), tolerance);
    EXPECT_NEAR(n.contact + stop.stopped_after, static_cast<double>(judge.stopped), tolerance);
  }
}

Stop wide_stop(const Numbers& n) {
  const long double length = n.length;
  const long double a = n.acceleration;
  const long double v = std::min<long double>(n.speed, std::sqrt(length * a));
  const long double ramp_s = v / a;
  const long double duration_s = length / v + ramp_s;
  const auto distance_at = [&](long double t) {
    const long double early = std::min(t, ramp_s);
    const long double late = std::max(0.0L, t - (duration_s - ramp_s));
    return v * t - a * (ramp_s * early - early * early / 2) - a * late * late / 2;
  };
  long double low = 0.0L;
  long double high = duration_s;
  for (int step = 0; step < 80; ++step) {
    const long double middle = (low + high) / 2;
    (distance_at(middle) < n.contact ? low : high) = middle;
  }
  const long double latch_s = std::min(low + n.delay_s, duration_s);
  const long double speed = std::min({v, a * latch_s, a * (duration_s - latch_s)});
  const long double latched = distance_at(latch_s);
  return {latched, latched + speed * speed / (2 * a)};
}

TEST(StopAfterContact, WorstErrorAgainstLongDouble) {
  std::mt19937 random(5);
  double worst = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const Numbers n = random_numbers(random);
    const MotionProfile profile(n.length, n.speed, n.acceleration);
    const SkipStop stop =
        stop_after_contact(profile, n.contact, {n.delay_s, 0.0}, Stopping::Braking);
    const Stop judge = wide_stop(n);
    const long double latched_error = n.contact - judge.latched + stop.latched_after;
    const long double stopped_error = n.contact - judge.stopped + stop.stopped_after;
    worst = std::max({worst, static_cast<double>(std::abs(latched_error) / n.length),
                      static_cast<double>(std::abs(stopped_error) / n.length)});
    ASSERT_LE(stop.latched_after, stop.stopped_after);
    ASSERT_LE(stop.stopped_after, n.length - n.contact);
  }
  std::printf("worst %.2e\n", worst);
  EXPECT_LT(worst, kSkipStopError);
}

}  // namespace
}  // namespace g31::machine::skip_stop_test

// What a control says of its axes: windows of the exact stop, jerk, curves at corners, compensation
// tables.  Expected times are closed forms, printed values those of the specification of motions.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/axis_dynamics.h"
#include "machine/sim/machining_centre.h"
#include "tests/support/trace_samples.h"

namespace g31::machine::control_data_test {
namespace {

using testing::TraceSamples;

AxisPositions axes(double x, double y, double z) {
  return (AxisPositions() << x, y, z, 0, 0, 0).finished();
}

LinearMove feed(const AxisPositions& q_M_end, double mm_min, BlockEnd ends) {
  return {q_M_end, Traverse::Feed, mm_min, ends};
}

MachineSetup lagging(double acceleration) {
  MachineSetup setup;
  for (std::size_t i = 0; i < 3; ++i) {
    setup.axes[i].servo_gain = 1.0;
    setup.axes[i].acceleration_per_s2 = acceleration;
  }
  return setup;
}

constexpr double kLagS = 0.06;  // of a gain of 1

/// What is left of the lag at the end of a command that has braked from a speed.
double left_by(double speed, double acceleration) {
  return acceleration * kLagS * kLagS * (1.0 - std::exp(-speed / acceleration / kLagS));
}

// One block, and one at the end of blocks that passed on.
TEST(StopWindows, TimesAreThoseOfTheLagUntilItIsWithinTheWindow) {
  constexpr double kAcceleration = 1000.0;
  const double lag = left_by(100.0, kAcceleration);
  struct Case {
    BlockEnd ends;
    double waits_s;
  };
  const Case kCases[] = {{BlockEnd::ExactStop, kLagS * std::log(lag / 0.003)},
                         {BlockEnd::CoarseStop, kLagS * std::log(lag / 0.2)},
                         {BlockEnd::CommandStop, 0.0}};
  for (const Case& c : kCases) {
    for (const bool passes : {false, true}) {
      MachiningCentre centre(lagging(kAcceleration), nullptr);
      AxisData data = centre.axis_data();
      data.stop_fine[0] = 0.003;
      data.stop_coarse[0] = 0.2;
      centre.set_axis_data(data);
      LinearMove first = feed(axes(50, 0, 0), 6000.0, BlockEnd::PassOn);
      LinearMove last = feed(axes(100, 0, 0), 6000.0, c.ends);
      first.contour_control = last.contour_control = ContourControl::LookAhead;
      if (passes) {
        ASSERT_TRUE(centre.move(first).ok());
      }
      ASSERT_TRUE(centre.move(last).ok());
      EXPECT_NEAR(centre.time_s(), 1.0 + 0.1 + c.waits_s, 1e-6) << static_cast<int>(c.ends);
    }
  }
}

TEST(StopWindows, AreThoseOfTheSheetUntilTheControlSaysOtherwise) {
  MachineSetup setup;
  setup.in_position = 0.005;
  const MachiningCentre centre(setup, nullptr);
  EXPECT_EQ(centre.axis_data().stop_fine, AxisPositions::Constant(0.005));
  EXPECT_EQ(centre.axis_data().stop_coarse, AxisPositions::Constant(0.02));
}

/// Where an axis is that lags behind a command with this acceleration, from rest.
double behind(double acceleration, double t) {
  const double fades = 1.0 - std::exp(-t / kLagS);
  return t <= 0.0 ? 0.0 : acceleration * (t * t / 2.0 - kLagS * t + kLagS * kLagS * fades);
}

/// How near the corner between a move along X that has braked and one along Y, which goes on at the
/// speed when it has reached it, the axes come.
double missed_by(double speed, double acceleration) {
  double least = 1e9;
  const double left = left_by(speed, acceleration);
  for (double t = 0.0; t < 0.2; t += 1e-5) {
    const double y = behind(acceleration, t) - behind(acceleration, t - speed / acceleration);
    least = std::min(least, std::hypot(left * std::exp(-t / kLagS), y));
  }
  return least;
}

TEST(StopWindows, AtTheEndOfTheCommandTheLagPassesTheCorner) {
  struct Case {
    BlockEnd ends;
    double missed, within;
  };
  const Case kCases[] = {{BlockEnd::CommandStop, missed_by(50.0, 2000.0), 1e-6},
                         {BlockEnd::ExactStop, 0.0, 0.01}};
  for (const Case& c : kCases) {
    TraceSamples samples;
    MachiningCentre centre(lagging(2000.0), nullptr);
    centre.trace(25e-6, samples);
    ASSERT_TRUE(centre.move(feed(axes(50, 0, 0), 3000.0, c.ends)).ok());
    ASSERT_TRUE(centre.move(feed(axes(50, 12, 0), 3000.0, c.ends)).ok());
    double least = 1e9;
    for (const TraceSample& sample : samples.list) {
      least = std::min(least, std::hypot(sample.q_M_true[0] - 50.0, sample.q_M_true[1]));
    }
    EXPECT_NEAR(least, c.missed, c.within);
  }
  EXPECT_GT(missed_by(50.0, 2000.0), 0.1);
}

MachineSetup lively(double jerk) {
  MachineSetup setup;
  for (std::size_t i = 0; i < 3; ++i) {
    setup.axes[i].acceleration_per_s2 = 5000.0;
    setup.axes[i].jerk_per_s3 = jerk;
  }
  return setup;
}

constexpr double kWithJerkS = 2.0 + 0.0632455532033676;  // 2 sqrt(v / j)
constexpr double kWithoutJerkS = 2.01;

TEST(Smoothness, WithoutItTheJerkOfTheAxesIsNotLimited) {
  for (const BlockEnd ends : {BlockEnd::ExactStop, BlockEnd::PassOn}) {
    for (const Traverse traverse : {Traverse::Feed, Traverse::Rapid}) {
      MachineSetup setup = lively(50000.0);
      setup.axes[0].rapid_per_min = 3000.0;
      for (const bool limits_jerk : {true, false}) {
        MachiningCentre centre(setup, nullptr);
        LinearMove move{axes(100, 0, 0), traverse, 3000.0, ends};
        move.smoothness.limits_jerk = limits_jerk;
        ASSERT_TRUE(centre.move(move).ok());
        EXPECT_NEAR(centre.time_s(), limits_jerk ? kWithJerkS : kWithoutJerkS, 1e-9);
      }
    }
  }
}

TEST(Smoothness, OfAnArcIsThatOfBothAxesOfItsPlane) {
  for (const bool limits_jerk : {true, false}) {
    MachiningCentre centre(lively(50000.0), nullptr);
    ArcMove circle;
    circle.q_M_end = axes(0, 0, 0);
    circle.centre_first = 50.0;
    circle.feed_mm_min = 3000.0;
    circle.smoothness.limits_jerk = limits_jerk;
    ASSERT_TRUE(centre.move(circle).ok());
    const double way_s = 100.0 * std::numbers::pi / 50.0;
    const double share = 1.0 / std::numbers::sqrt2;
    const double ramp_s =
        limits_jerk ? 2.0 * std::sqrt(50.0 / (50000.0 * share)) : 50.0 / (5000.0 * share);
    EXPECT_NEAR(centre.time_s(), way_s + ramp_s, 1e-9);
  }
}

TEST(AxisDataOfAControl, ItsJerkTakesThePlaceOfTheSheets) {
  struct Case {
    double sheet, control, seconds;
  };
  const Case kCases[] = {
      {50000.0, 0.0, kWithoutJerkS}, {0.0, 50000.0, kWithJerkS}, {1e6, 50000.0, kWithJerkS}};
  for (const Case& c : kCases) {
    MachiningCentre centre(lively(c.sheet), nullptr);
    AxisData data = centre.axis_data();
    EXPECT_EQ(data.jerk_per_s3, axes(c.sheet, c.sheet, c.sheet));
    data.jerk_per_s3.head<3>().setConstant(c.control);
    centre.set_axis_data(data);
    ASSERT_TRUE(centre.move(feed(axes(100, 0, 0), 3000.0, BlockEnd::ExactStop)).ok());
    EXPECT_NEAR(centre.time_s(), c.seconds, 1e-9);
  }
}

AxisDynamics dynamics_of(double x_per_s2, double y_per_s2) {
  MachineSetup setup;
  setup.axes[0].acceleration_per_s2 = x_per_s2;
  setup.axes[1].acceleration_per_s2 = y_per_s2;
  return AxisDynamics(setup);
}

// 90 degrees: R = d cos 45 / (1 - cos 45), v = sqrt(a R), a being that of an axis.
TEST(CornerCurve, HasTheRadiusOfItsToleranceAtARightAngle) {
  const AxisDynamics dynamics = dynamics_of(5000.0, 5000.0);
  for (const auto& [tolerance, speed] : {std::pair(0.01, 10.99), {0.05, 24.57}, {0.2, 49.13}}) {
    EXPECT_NEAR(dynamics.curve_speed(axes(1, 0, 0), axes(0, 1, 0), {tolerance, 1e3}), speed, 0.005);
  }
  EXPECT_EQ(dynamics.curve_speed(axes(1, 0, 0), axes(-1, 0, 0), {0.1, 1.0}), 0.0);
  EXPECT_TRUE(std::isinf(dynamics.curve_speed(axes(1, 0, 0), axes(1, 0, 0), {1, 1})));
}

// Arcs of all directions on axes of different accelerations: looked at in 20,000 places, no axis
// exceeds its own, and one reaches it.
TEST(CornerCurve, NoAxisExceedsItsAcceleration) {
  constexpr double kX = 3000.0;
  constexpr double kY = 700.0;
  const AxisDynamics dynamics = dynamics_of(kX, kY);
  for (double from = 0.05; from < 6.3; from += 0.37) {
    for (double turn = -3.0; turn < 3.1; turn += 0.43) {
      const double speed =
          dynamics.curve_speed(axes(std::cos(from), std::sin(from), 0),
                               axes(std::cos(from + turn), std::sin(from + turn), 0),
                               {1e9, std::tan(std::abs(turn) / 2.0)});
      double most = 0.0;  // of an axis' acceleration, on the arc of radius 1
      for (int i = 0; i <= 20'000; ++i) {
        const double at = from + turn * i / 20'000;
        most = std::max({most, speed * speed * std::abs(std::sin(at)) / kX,
                         speed * speed * std::abs(std::cos(at)) / kY});
      }
      EXPECT_NEAR(most, 1.0, 1e-7) << from << " " << turn;
    }
  }
}

// The arc whose speed it is, point by point: no farther from the lines than the tolerance, nor
// longer than half of them; and one of both it makes use of.
TEST(CornerCurve, KeepsItsToleranceAndHalfOfTheLines) {
  constexpr double kAcceleration = 1234.0;
  const AxisDynamics dynamics = dynamics_of(kAcceleration, 1e12);
  for (double degrees = 0.1; degrees < 175.0; degrees *= 1.7) {
    for (const double tolerance : {0.001, 0.1}) {
      for (const double half : {0.02, 5.0}) {
        const double turn = degrees * std::numbers::pi / 180.0;
        // Symmetrical about Y: at its ends the arc has sin(turn / 2) of X, in the middle none; so X
        // has most there, or all where it turns by more than 180 degrees.
        const double half_turn = turn / 2.0;
        const double speed = dynamics.curve_speed(
            axes(std::cos(half_turn), -std::sin(half_turn), 0),
            axes(std::cos(half_turn), std::sin(half_turn), 0), {tolerance, half});
        const double radius = speed * speed * std::sin(half_turn) / kAcceleration;
        const double leg = radius * std::tan(turn / 2.0);
        double farthest = 0.0;
        for (int i = 0; i <= 1000; ++i) {
          // About a centre above the line before, from where the arc begins on.
          const double at = turn * i / 1000;
          const double x = -leg + radius * std::sin(at);
          const double y = radius * (1.0 - std::cos(at));
          const double along = x * std::cos(turn) + y * std::sin(turn);
          const double beside = std::abs(y * std::cos(turn) - x * std::sin(turn));
          const double to_before = x <= 0.0 ? y : std::hypot(x, y);
          const double to_behind = along >= 0.0 ? beside : std::hypot(x, y);
          farthest = std::max(farthest, std::min(to_before, to_behind));
        }
        EXPECT_LE(farthest, tolerance * (1.0 + 1e-9));
        EXPECT_LE(leg, half * (1.0 + 1e-9));
        const double off_corner = radius * (1.0 / std::cos(turn / 2.0) - 1.0);
        EXPECT_NEAR(std::max(off_corner / tolerance, leg / half), 1.0, 1e-6);
      }
    }
  }
}

/// A circle of radius 50 in 720 chords at 2 m/min, an axis may jump by 0.1 mm/s.
double polygon_s(double tolerance) {
  MachineSetup setup;
  for (AxisSetup& axis : setup.axes) {
    axis.corner_jump_per_min = 6.0;
  }
  setup.q_M_start = axes(50, 0, 0);
  MachiningCentre centre(setup, nullptr);
  for (int i = 1; i <= 720; ++i) {
    const double at = i * std::numbers::pi / 360.0;
    LinearMove chord =
        feed(axes(50.0 * std::cos(at), 50.0 * std::sin(at), 0), 2000.0, BlockEnd::PassOn);
    chord.smoothness.corner_tolerance = tolerance;
    EXPECT_TRUE(centre.move(chord).ok());
  }
  return centre.time_s();
}

// The way is 314.1583 mm.  Arcs from the middle of one chord to that of the next have the radius of
// the circle, which can be gone at 265 mm/s, and are 0.5 um beside it: 2 m/min is not slowed.
TEST(CornerCurve, JoinsShortLinesWithoutSlowing) {
  EXPECT_NEAR(polygon_s(0.0), 13.5704, 1e-4);
  EXPECT_NEAR(polygon_s(0.1), 9.4414, 1e-4);
  EXPECT_NEAR(polygon_s(0.001), 9.4414, 1e-4);
  EXPECT_GT(polygon_s(1e-9), 13.0);
}

TEST(Compensation, MovesTheTrueAxisByItsTables) {
  MachineSetup setup;
  setup.q_M_start = axes(-100, 0, 0);
  MachiningCentre centre(setup, nullptr);
  const CompensationTable along{0, {{0, {{0.0, 0.01}, {50.0, 0.03}}, 0.0}}};
  const CompensationTable across{1, {{0, {{0.0, 0.0}, {20.0, 0.004}, {40.0, 0.0}}, 40.0}}};
  const CompensationTable product{
      2, {{0, {{0.0, 0.0}, {100.0, 0.1}}, 0.0}, {1, {{0.0, 1.0}, {10.0, 3.0}}, 0.0}}};
  centre.compensate({along, across, product});
  TraceSamples samples;
  centre.trace(0.01, samples);
  ASSERT_TRUE(centre.move(feed(axes(100, 20, 0), 20000.0, BlockEnd::ExactStop)).ok());
  ASSERT_GT(samples.list.size(), 50U);
  for (const TraceSample& sample : samples.list) {
    const double x = sample.q_M_encoder[0];
    const double y = sample.q_M_encoder[1];
    const double in_period = std::fmod(x + 400.0, 40.0);
    const double dx = 0.01 + 0.02 * std::clamp(x / 50.0, 0.0, 1.0);
    const double dy = 0.004 * (in_period < 20.0 ? in_period / 20.0 : 2.0 - in_period / 20.0);
    const double dz =
        0.1 * std::clamp(x / 100.0, 0.0, 1.0) * (1.0 + 2.0 * std::clamp(y / 10.0, 0.0, 1.0));
    EXPECT_NEAR((sample.q_M_true - sample.q_M_encoder - axes(dx, dy, dz)).norm(), 0.0, 1e-12);
  }
  EXPECT_EQ(centre.position(), axes(100, 20, 0)) << "what the control shows is the command";
  samples.list.clear();
  centre.compensate({});
  ASSERT_TRUE(centre.move(feed(axes(0, 0, 0), 20000.0, BlockEnd::ExactStop)).ok());
  EXPECT_EQ(samples.list.back().q_M_true, samples.list.back().q_M_encoder);
}

}  // namespace
}  // namespace g31::machine::control_data_test

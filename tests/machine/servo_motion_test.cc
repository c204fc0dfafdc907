// How the axes follow their commands: braking distance, corners, waiting.  Expected numbers are
// closed forms, written out here, of the differential equation T q' + q = command.

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/scripted_surroundings.h"
#include "tests/support/trace_samples.h"

namespace g31::machine::servo_motion_test {
namespace {

using testing::ScriptedSurroundings;
using testing::TraceSamples;

AxisPositions axes(double x, double y, double z) {
  return (AxisPositions() << x, y, z, 0, 0, 0).finished();
}

LinearMove feed(const AxisPositions& q_M_end, double mm_min, BlockEnd ends = BlockEnd::ExactStop) {
  LinearMove move{q_M_end, Traverse::Feed, mm_min, ends};
  move.contour_control = ContourControl::LookAhead;
  return move;
}

MachineSetup lagging(double servo_gain, double acceleration) {
  MachineSetup setup;
  for (std::size_t i = 0; i < 3; ++i) {
    setup.axes[i].servo_gain = servo_gain;
    setup.axes[i].acceleration_per_s2 = acceleration;
  }
  return setup;
}

// The worked example of a controller manual: v = 6 m/min, a = 1 m/s^2, t = 16 ms, Kv = 1.
TEST(BrakingDistance, IsLagBrakingAndDelayOneAfterTheOther) {
  struct Case {
    const char* name;
    double servo_gain, stop_delay_s, overtravel;
  };
  const Case kCases[] = {
      {"braking alone, v^2/2a", 0.0, 0.0, 5.0},
      {"and 16 ms until it begins", 0.0, 0.016, 5.0 + 1.6},
      {"and 1 m/min per mm: v/Kv", 1.0, 0.0, 5.0 + 6.0},
      {"all three", 1.0, 0.016, 6.0 + 5.0 + 1.6},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    MachineSetup setup = lagging(c.servo_gain, 1000.0);
    setup.stop_delay_s = c.stop_delay_s;
    ScriptedSurroundings world({{'X', 300.0, 0.0, false, {}}});
    MachiningCentre centre(setup, &world);
    const auto outcome = centre.move_until_skip(feed(axes(500, 0, 0), 6000.0));
    const auto& touched = std::get<Touched>(outcome.value());
    EXPECT_NEAR(touched.q_M_latched[0], 300.0, 1e-6) << "latched at once, on the fly";
    EXPECT_NEAR(touched.q_M_stopped[0] - 300.0, c.overtravel, 1e-6);
    EXPECT_EQ(centre.position(), touched.q_M_stopped);
  }
}

TEST(BrakingDistance, IsLongerWithLimitedJerk) {
  MachineSetup setup = lagging(0.0, 1000.0);
  setup.axes[0].jerk_per_s3 = 10'000.0;
  ScriptedSurroundings world({{'X', 300.0, 0.0, false, {}}});
  MachiningCentre centre(setup, &world);
  const auto outcome = centre.move_until_skip(feed(axes(500, 0, 0), 6000.0));
  // v = 100, a/j = 0.1 s: braking takes v/a + a/j = 0.2 s at v/2 on average.
  EXPECT_NEAR(std::get<Touched>(outcome.value()).q_M_stopped[0] - 300.0, 0.5 * 100.0 * 0.2, 1e-9);
}

TEST(ServoMotion, ASteadyAxisIsSpeedOverGainBehindItsCommand) {
  TraceSamples samples;
  MachiningCentre centre(lagging(1.5, 2000.0), nullptr);
  centre.trace(0.25, samples);
  ASSERT_TRUE(centre.move(feed(axes(200, 0, 0), 3000.0)).ok());  // 4 s
  ASSERT_GT(samples.list.size(), 12U);
  for (std::size_t i = 6; i < 16; ++i) {
    EXPECT_NEAR(samples.list[i].q_M_commanded[0] - samples.list[i].q_M_encoder[0], 3.0 / 1.5, 1e-9)
        << samples.list[i].time_s;
  }
}

/// The corner of two moves along X and Y at a speed, decelerating with a and lagging by T: how far
/// the tool stays away from it, by a fine search over the closed forms.
double missed_by(double v, double a, double t_lag) {
  const double ramp = v / a;
  // Lag at the end of the ramp down, from steady lag v T; and from there on.
  const double lag_x = a * t_lag * t_lag * (1.0 - std::exp(-ramp / t_lag));
  double least = 1e9;
  for (double t = 0.0; t < 10.0 * t_lag; t += t_lag * 1e-4) {
    const double x = lag_x * std::exp(-t / t_lag);
    const auto lag_in_ramp = [&](double s) {
      return a * t_lag * (s - t_lag * (1.0 - std::exp(-s / t_lag)));
    };
    const double in_ramp = std::min(t, ramp);
    double y = 0.5 * a * in_ramp * in_ramp - lag_in_ramp(in_ramp);
    if (t > ramp) {
      const double lag =
          v * t_lag + (lag_in_ramp(ramp) - v * t_lag) * std::exp(-(t - ramp) / t_lag);
      y = 0.5 * a * ramp * ramp + v * (t - ramp) - lag;
    }
    least = std::min(least, std::hypot(x, y));
  }
  return least;
}

double least_distance(const std::vector<TraceSample>& samples, const Point& p_M_corner) {
  double least = 1e9;
  for (const TraceSample& sample : samples) {
    least = std::min(least, (linear_axes(sample.q_M_true) - p_M_corner).norm());
  }
  return least;
}

TEST(ServoMotion, WithoutExactStopTheCornerIsRoundedByLag) {
  for (const double gain : {1.0, 2.5}) {
    for (const double acceleration : {2000.0}) {
      SCOPED_TRACE(gain * 1e4 + acceleration);
      for (const BlockEnd ends : {BlockEnd::PassOn, BlockEnd::ExactStop}) {
        TraceSamples samples;
        MachineSetup setup = lagging(gain, acceleration);
        setup.in_position = 0.002;
        setup.axes[0].corner_jump_per_min = 0.0;
        MachiningCentre centre(setup, nullptr);
        centre.trace(25e-6, samples);
        ASSERT_TRUE(centre.move(feed(axes(50, 0, 0), 3000.0, ends)).ok());
        ASSERT_TRUE(centre.move(feed(axes(50, 12, 0), 3000.0, ends)).ok());
        centre.stand_still();
        const double missed = least_distance(samples.list, {50.0, 0.0, 0.0});
        if (ends == BlockEnd::PassOn) {
          EXPECT_NEAR(missed, missed_by(50.0, acceleration, 0.06 / gain), 1e-6);
          EXPECT_GT(missed, 0.05);
        } else {
          EXPECT_LT(missed, 0.002);
          EXPECT_GT(missed, 0.0);
        }
      }
    }
  }
}

TEST(ServoMotion, AnExactStopWaitsUntilTheAxesHaveFollowed) {
  MachineSetup setup = lagging(1.0, 1000.0);
  setup.in_position = 0.01;
  MachiningCentre waits(setup, nullptr);
  MachiningCentre passes(setup, nullptr);
  ASSERT_TRUE(waits.move(feed(axes(100, 0, 0), 6000.0)).ok());
  ASSERT_TRUE(passes.move(feed(axes(100, 0, 0), 6000.0, BlockEnd::PassOn)).ok());
  EXPECT_NEAR(passes.time_s(), 100.0 / 100.0 + 0.1, 1e-12);
  const double lag = 1000.0 * 0.06 * 0.06 * (1.0 - std::exp(-0.1 / 0.06));
  EXPECT_NEAR(waits.time_s() - passes.time_s(), 0.06 * std::log(lag / 0.01), 1e-6);
}

// A circle at a steady speed comes out smaller: r / sqrt(1 + (w T)^2).
TEST(ServoMotion, ACircleShrinks) {
  TraceSamples samples;
  MachineSetup setup = lagging(1.0, 4000.0);
  setup.q_M_start = axes(20, 0, 0);
  MachiningCentre centre(setup, nullptr);
  centre.trace(0.01, samples);
  ArcMove circle;
  circle.q_M_end = axes(20, 0, 0);
  circle.feed_mm_min = 3000.0;
  ASSERT_TRUE(centre.move(circle).ok());
  const double w = 50.0 / 20.0;
  int compared = 0;
  for (const TraceSample& sample : samples.list) {
    if (sample.time_s > 1.2 && sample.time_s < 2.4) {  // of 2.5 s
      EXPECT_NEAR(linear_axes(sample.q_M_commanded).norm(), 20.0, 2e-8);
      EXPECT_NEAR(linear_axes(sample.q_M_encoder).norm(), 20.0 / std::hypot(1.0, w * 0.06), 2e-6);
      ++compared;
    }
  }
  EXPECT_GT(compared, 100);
}

// Unequal gains: on a slope the axes are at a steady distance beside the line.
TEST(ServoMotion, UnequalGainsLeaveTheLineAndTheTouchKnows) {
  MachineSetup setup = lagging(1.0, 2000.0);
  setup.axes[1].servo_gain = 2.0;
  ScriptedSurroundings world({{'Y', 60.0, 0.0, false, {}}});
  MachiningCentre centre(setup, &world);
  const auto outcome = centre.move_until_skip(feed(axes(100, 100, 0), 3000.0));
  const auto& touched = std::get<Touched>(outcome.value());
  // Each axis goes v / sqrt 2 = 35.4 mm/s; X lags by twice as long as Y, 0.06 s against 0.03 s.
  EXPECT_NEAR(touched.q_M_latched[1] - touched.q_M_latched[0], 50.0 / std::numbers::sqrt2 * 0.03,
              1e-6);
}

// The second way: the same equation stepped by Heun's method, a hundred thousand steps a second.
TEST(ServoMotion, FollowsAnSCurveAsAStepByStepSolutionDoes) {
  const StraightPath path(axes(1, 2, 3), axes(41, -18, 3));
  const MotionProfile profile(path.length(), 80.0, 900.0, 9000.0);
  AxisPositions time_constants;
  time_constants << 0.03, 0.05, 0.0, 0.0, 0.0, 0.0;
  const AxisPositions lag = axes(0.3, -0.2, 0.0);
  const ServoMotion motion(path, profile.phases(), {lag, {}}, {time_constants});
  const double h = 1e-5;
  AxisPositions q = path.from() - lag;
  const auto command = [&](double t) {
    return path.at(std::min(1.0, profile.distance_at(t) / path.length()));
  };
  const int steps = static_cast<int>((profile.duration_s() + 0.1) / h);
  for (int i = 0; i < steps; ++i) {
    for (int axis = 0; axis < 2; ++axis) {
      const double t_lag = time_constants[axis];
      const double slope = (command(i * h)[axis] - q[axis]) / t_lag;
      const double ahead = q[axis] + h * slope;
      q[axis] += 0.5 * h * (slope + (command((i + 1) * h)[axis] - ahead) / t_lag);
    }
    if (i % 997 == 0) {
      ASSERT_NEAR((motion.encoder_at((i + 1) * h) - q).head<2>().norm(), 0.0, 2e-6) << i;
      ASSERT_NEAR((motion.commanded_at((i + 1) * h) - command((i + 1) * h)).norm(), 0.0, 1e-10);
    }
  }
}

TEST(MotionSampler, TakesWholeMultiplesOfThePeriodThroughAllMotions) {
  TraceSamples samples;
  MachiningCentre centre(MachineSetup(), nullptr);
  const double period_s = 182.32e-6;
  centre.trace(period_s, samples);
  ASSERT_TRUE(centre.move(feed(axes(10, 0, 0), 3000.0)).ok());
  centre.dwell(0.1);
  ASSERT_TRUE(centre.move(feed(axes(10, 10, 0), 3000.0)).ok());
  ASSERT_EQ(samples.list.size(),
            static_cast<std::size_t>(std::floor(centre.time_s() / period_s)) + 1U);
  centre.end_trace();
  centre.end_trace();
  EXPECT_EQ(samples.list.back().time_s, centre.time_s());
  EXPECT_EQ(samples.list.back().q_M_true, centre.position());
  samples.list.pop_back();
  ASSERT_EQ(samples.list.size(),
            static_cast<std::size_t>(std::floor(centre.time_s() / period_s)) + 1U)
      << "there is one end";
  const double ramp_s = 50.0 / 2000.0;
  for (std::size_t i = 0; i < samples.list.size(); ++i) {
    const TraceSample& sample = samples.list[i];
    EXPECT_EQ(sample.time_s, static_cast<double>(i) * period_s);
    EXPECT_EQ(sample.q_M_true, sample.q_M_encoder);
    if (sample.time_s < ramp_s) {
      EXPECT_NEAR(sample.q_M_commanded[0], 1000.0 * sample.time_s * sample.time_s, 1e-12);
    } else if (sample.time_s < 0.2) {
      EXPECT_NEAR(sample.q_M_commanded[0], 0.625 + 50.0 * (sample.time_s - ramp_s), 1e-12);
    }
  }
}

TEST(MotionSampler, ATracedIdealMachineGivesTheSameNumbersBitForBit) {
  TraceSamples samples;
  ScriptedSurroundings world({{'X', 1.0 / 3.0, 0.013, false, {}}});
  ScriptedSurroundings plain_world({{'X', 1.0 / 3.0, 0.013, false, {}}});
  MachiningCentre traced(MachineSetup(), &world);
  MachiningCentre plain(MachineSetup(), &plain_world);
  traced.trace(1e-3, samples);
  for (MachiningCentre* centre : {&traced, &plain}) {
    ASSERT_TRUE(centre->move_until_skip(feed(axes(0.7, 0.1, 0.3), 600.0)).ok());
    ArcMove arc;
    arc.q_M_end = axes(4, 0, 1);
    arc.centre_first = 2.0;
    arc.feed_mm_min = 700.0;
    ASSERT_TRUE(centre->move(arc).ok());
  }
  EXPECT_EQ(traced.position(), plain.position());
  EXPECT_EQ(traced.time_s(), plain.time_s());
  EXPECT_NEAR((samples.list.back().q_M_commanded - plain.position()).norm(), 0.0, 0.02);
}

}  // namespace
}  // namespace g31::machine::servo_motion_test

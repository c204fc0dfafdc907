#include "machine/sim/axis_dynamics.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace g31::machine::axis_dynamics_test {
namespace {

AxisPositions axes(double x, double y, double z, double a = 0) {
  return (AxisPositions() << x, y, z, a, 0, 0).finished();
}

/// X and Y alike, Z half as fast and half as lively, A in degrees.
MachineSetup four_axes() {
  MachineSetup setup;
  const double kRapids[] = {24000, 24000, 12000, 3600};
  const double kAccelerations[] = {2000, 2000, 1000, 500};
  for (std::size_t i = 0; i < 4; ++i) {
    setup.axes[i].present = true;
    setup.axes[i].rapid_per_min = kRapids[i];
    setup.axes[i].acceleration_per_s2 = kAccelerations[i];
  }
  return setup;
}

TEST(AxisDynamics, StraightMoves) {
  const LinearMove kRapid{AxisPositions::Zero(), Traverse::Rapid, 0.0};
  const LinearMove kF300{AxisPositions::Zero(), Traverse::Feed, 300.0};
  const LinearMove kF60000{AxisPositions::Zero(), Traverse::Feed, 60000.0};
  struct Case {
    const char* name;
    AxisPositions q_M_to;
    LinearMove move;
    double speed, acceleration;
  };
  const Case kCases[] = {
      {"rapid in X", axes(1000, 0, 0), kRapid, 400, 2000},
      {"rapid in X and Y: both at full rate", axes(1000, 1000, 0), kRapid, 400 * std::sqrt(2.0),
       2000 * std::sqrt(2.0)},
      {"rapid in X and Z: Z is the slowest", axes(300, 0, 400), kRapid, 200 * 5 / 4.0,
       1000 * 5 / 4.0},
      {"rapid in X and Z, little Z: X is the slowest", axes(400, 0, 30), kRapid,
       400 * std::hypot(400, 30) / 400, 2000 * std::hypot(400, 30) / 400},
      {"rapid in A: degrees", axes(0, 0, 0, -90), kRapid, 60, 500},
      {"rapid in X and A: A is the slowest", axes(100, 0, 0, 90), kRapid, 60 * 100 / 90.0,
       500 * 100 / 90.0},
      {"feed in space", axes(100, 100, 100), kF300, 5, 1000 * std::sqrt(3.0)},
      {"feed in A: degrees a minute", axes(0, 0, 0, 90), kF300, 5, 500},
      {"feed counts mm where X and A move", axes(100, 0, 0, 90), kF300, 5, 500 * 100 / 90.0},
      {"a feed above the rapid rate is clamped", axes(0, 0, -500), kF60000, 200, 1000},
  };
  const AxisDynamics dynamics(four_axes());
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    // A hundred times as far, so that the speed is surely reached.
    const MotionProfile profile =
        dynamics.profile(StraightPath(axes(0, 0, 0), 100.0 * c.q_M_to), c.move);
    EXPECT_NEAR(profile.peak_speed(), c.speed, 1e-12 * c.speed);
    EXPECT_NEAR(profile.acceleration(), c.acceleration, 1e-12 * c.acceleration);
  }
}

TEST(AxisDynamics, Arcs) {
  ArcMove half_circle;  // about the origin, from +X to -X
  half_circle.turn = Turn::Counterclockwise;
  struct Case {
    const char* name;
    double radius, helix_z, feed_mm_min;
    double speed, acceleration;
  };
  const double kInPlane = 2000 / std::sqrt(2.0);
  const Case kCases[] = {
      {"the feed", 100, 0, 3000, 50, kInPlane},
      {"a small circle is slow: v^2/r in the plane", 0.5, 0, 24000, std::sqrt(0.5 * kInPlane),
       kInPlane},
      {"a great circle runs at the rapid rate", 1e4, 0, 60000, 400, kInPlane},
      {"a steep helix: Z is the slowest", 1e3, 2e3 * 3.14159265358979, 60000, 100, 1000 / 2.0},
  };
  const AxisDynamics dynamics(four_axes());
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    half_circle.q_M_end = axes(-c.radius, 0, c.helix_z);
    const ArcPath path(axes(c.radius, 0, 0), half_circle);
    const MotionProfile profile = dynamics.profile(path, c.feed_mm_min);
    EXPECT_NEAR(profile.acceleration(), c.acceleration, 1e-12 * c.acceleration);
    // The smallest arc is too short to get to full speed from standstill.
    const double reachable = std::sqrt(path.length() * c.acceleration);
    EXPECT_NEAR(profile.peak_speed(), std::min(c.speed, reachable), 1e-12 * c.speed);
  }
}

// The second way: positions by time, differenced twice, axis by axis.
TEST(AxisDynamics, NoAxisExceedsItsRateOrAcceleration) {
  const MachineSetup setup = four_axes();
  const AxisDynamics dynamics(setup);
  std::mt19937 random(2);
  std::normal_distribution<double> gauss;
  const auto expect_within = [&](const MotionProfile& profile, const auto& path) {
    constexpr int kSteps = 400;
    const double h = profile.duration_s() / kSteps;
    const auto at = [&](double time_s) -> AxisPositions {
      return path.at(profile.distance_at(time_s) / profile.length());
    };
    for (int k = 1; k < kSteps - 1; ++k) {
      const double t = k * h;
      const AxisPositions speed = (at(t + h) - at(t - h)) / (2 * h);
      const AxisPositions acceleration = (at(t + h) - 2 * at(t) + at(t - h)) / (h * h);
      for (std::size_t i = 0; i < 4; ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        ASSERT_LE(std::abs(speed[row]), setup.axes[i].rapid_per_min / 60 * 1.000001);
        ASSERT_LE(std::abs(acceleration[row]), setup.axes[i].acceleration_per_s2 * 1.0001);
      }
    }
  };
  for (int i = 0; i < 300; ++i) {
    const AxisPositions q_M_to =
        axes(100 * gauss(random), 100 * gauss(random), 100 * gauss(random), 90 * gauss(random));
    const StraightPath line(axes(0, 0, 0), q_M_to);
    expect_within(dynamics.profile(line, {AxisPositions::Zero(), Traverse::Rapid, 0.0}), line);

    ArcMove arc;
    arc.turn = i % 2 == 0 ? Turn::Clockwise : Turn::Counterclockwise;
    arc.first_axis = i % 3;
    arc.second_axis = (i + 1) % 3;
    arc.q_M_end = q_M_to;
    // The centre on the bisector of start and end, so that both are equally far from it.
    const double along = q_M_to[arc.first_axis];
    const double across = q_M_to[arc.second_axis];
    const double side = gauss(random);
    arc.centre_first = along / 2 - side * across;
    arc.centre_second = across / 2 + side * along;
    const ArcPath path(axes(0, 0, 0), arc);
    expect_within(dynamics.profile(path, 100'000.0), path);
  }
}

}  // namespace
}  // namespace g31::machine::axis_dynamics_test

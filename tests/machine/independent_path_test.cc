// Rapids on which each axis goes on its own.  Positions are closed forms of one axis each: half the
// acceleration by the square of the time, jerk by its cube.

#include "machine/sim/independent_path.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/scripted_surroundings.h"

namespace g31::machine::independent_path_test {
namespace {

AxisPositions axes(double x, double y, double z, double a = 0, double b = 0, double c = 0) {
  return (AxisPositions() << x, y, z, a, b, c).finished();
}

struct AxisLimits {
  double rapid_per_min, acceleration_per_s2, jerk_per_s3;
};

MachineSetup machine_of(const std::vector<AxisLimits>& limits) {
  MachineSetup setup;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    setup.axes[i].present = limits[i].rapid_per_min > 0.0;
    if (setup.axes[i].present) {
      setup.axes[i].rapid_per_min = limits[i].rapid_per_min;
      setup.axes[i].acceleration_per_s2 = limits[i].acceleration_per_s2;
      setup.axes[i].jerk_per_s3 = limits[i].jerk_per_s3;
    }
  }
  return setup;
}

// As machine/library has them.
MachineSetup ideal() {
  const AxisLimits axis{20000, 2000, 0};
  return machine_of({axis, axis, axis});
}
MachineSetup v55() {
  const AxisLimits axis{50000, 5000, 50000};
  return machine_of({axis, axis, axis});
}
MachineSetup five_axis() {
  const AxisLimits axis{40000, 4000, 0};
  return machine_of({axis, axis, axis, {9000, 500, 0}, {0, 0, 0}, {18000, 1000, 0}});
}

LinearMove independent(const AxisPositions& q_M_end) {
  return {q_M_end, Traverse::Rapid, 0.0, BlockEnd::ExactStop, 0.0, RapidPath::Independent};
}

IndependentPath path_of(const MachineSetup& setup, const AxisPositions& q_M_from,
                        const AxisPositions& q_M_end) {
  const auto path =
      AxisDynamics(setup).independent_path(StraightPath(q_M_from, q_M_end), independent(q_M_end));
  G31_EXPECTS(path.has_value());
  return *path;
}

struct Worked {
  const char* name;
  MachineSetup setup;
  AxisPositions q_M_end;
  double duration_s;
  std::vector<std::pair<double, AxisPositions>> places;  ///< at a time, s
};

const std::vector<Worked>& worked() {
  static const std::vector<Worked> kWorked = {
      {"ideal, X 100 and Y 20",
       ideal(),
       axes(100, 20, 0),
       0.466667,
       {{0.05, axes(2.5, 2.5, 0)},
        {0.10, axes(10, 10, 0)},
        {0.13, axes(16.9, 15.1, 0)},
        {0.15, axes(22.5, 17.5, 0)},
        {0.20, axes(38.8889, 20, 0)},
        {0.30, axes(72.2222, 20, 0)},
        {0.40, axes(95.5556, 20, 0)}}},
      {"ideal, three axes",
       ideal(),
       axes(100, 60, 20),
       0.466667,
       {{0.10, axes(10, 10, 10)},
        {0.15, axes(22.5, 22.5, 17.5)},
        {0.20, axes(38.8889, 38.4889, 20)},
        {0.25, axes(55.5556, 50.6556, 20)},
        {0.30, axes(72.2222, 57.8222, 20)},
        {0.346667, axes(85.6, 60, 20)}}},
      {"V55, limited jerk",
       v55(),
       axes(300, -60, 0),
       0.626667,
       {{0.05, axes(1.0417, -1.0417, 0)},
        {0.10, axes(8.3333, -8.2694, 0)},
        {0.15, axes(27.0833, -23.4078, 0)},
        {0.20, axes(58.0247, -40.8820, 0)},
        {0.25, axes(97.2608, -54.4420, 0)},
        {0.30, axes(138.8889, -59.5650, 0)},
        {0.40, axes(221.6889, -60, 0)},
        {0.50, axes(283.2222, -60, 0)}}},
      {"five axes, X and C",
       five_axis(),
       axes(200, 0, 0, 0, 0, 90),
       0.6,
       {{0.1, axes(20, 0, 0, 0, 0, 5)},
        {0.2, axes(77.7778, 0, 0, 0, 0, 20)},
        {0.3, axes(144.4444, 0, 0, 0, 0, 45)},
        {0.4, axes(191.1111, 0, 0, 0, 0, 70)},
        {0.466667, axes(200, 0, 0, 0, 0, 81.1111)}}},
      {"five axes, X, A and C",
       five_axis(),
       axes(100, 0, 0, -45, 0, 180),
       0.9,
       {{0.1, axes(20, 0, 0, -2.5, 0, 5)},
        {0.2, axes(72.9822, 0, 0, -10, 0, 20)},
        {0.3, axes(99.4733, 0, 0, -22.5, 0, 45)},
        {0.4, axes(100, 0, 0, -35, 0, 75)},
        {0.6, axes(100, 0, 0, -45, 0, 135)}}},
  };
  return kWorked;
}

TEST(IndependentPath, IsAtTheWorkedPlaces) {
  for (const Worked& w : worked()) {
    SCOPED_TRACE(w.name);
    const IndependentPath path = path_of(w.setup, axes(0, 0, 0), w.q_M_end);
    EXPECT_NEAR(path.length(), w.duration_s, 5e-7);
    for (const auto& [time_s, q_M] : w.places) {
      // The times are printed with six digits, at a few hundred mm/s.
      EXPECT_NEAR((path.at(time_s / path.length()) - q_M).norm(), 0.0, 3e-4) << time_s;
    }
    EXPECT_EQ(path.at(0.0), axes(0, 0, 0));
    EXPECT_EQ(path.at(1.0), w.q_M_end);
    MachiningCentre centre(w.setup, nullptr);
    ASSERT_TRUE(centre.move(independent(w.q_M_end)).ok());
    EXPECT_EQ(centre.position(), w.q_M_end);
    EXPECT_EQ(centre.time_s(), path.length());
  }
}

TEST(IndependentPath, TakesTheTimeOfTheStraightRapidWhereOneAxisLimitsBoth) {
  for (const Worked& w : worked()) {
    SCOPED_TRACE(w.name);
    LinearMove straight = independent(w.q_M_end);
    straight.rapid_path = RapidPath::Straight;
    MachiningCentre centre(w.setup, nullptr);
    ASSERT_TRUE(centre.move(straight).ok());
    EXPECT_NEAR(centre.time_s(), w.duration_s, 5e-7);
  }
}

TEST(IndependentPath, IsStraightWhereOneAxisMovesOrTheMoveSaysSo) {
  const AxisDynamics dynamics(ideal());
  const StraightPath both(axes(1, 2, 3), axes(4, 5, 3));
  LinearMove move = independent(both.to());
  EXPECT_TRUE(dynamics.independent_path(both, move));
  EXPECT_FALSE(dynamics.independent_path(StraightPath(axes(1, 2, 3), axes(4, 2, 3)), move));
  move.rapid_path = RapidPath::Straight;
  EXPECT_FALSE(dynamics.independent_path(both, move));
  move = {both.to(), Traverse::Feed, 100.0, BlockEnd::ExactStop, 0.0, RapidPath::Independent};
  EXPECT_FALSE(dynamics.independent_path(both, move));
}

// The second way: central differences of the way itself.
TEST(IndependentPath, IsNowhereMoreBentThanItSays) {
  for (const Worked& w : worked()) {
    SCOPED_TRACE(w.name);
    const IndependentPath path = path_of(w.setup, axes(1, 2, 3), axes(1, 2, 3) + w.q_M_end);
    const double h = 1e-4;
    double most = 0.0;
    for (double f = h; f < 1.0 - h; f += 0.4 * h) {
      const AxisPositions second = path.at(f + h) - 2.0 * path.at(f) + path.at(f - h);
      most = std::max(most, linear_axes(second).norm() / (h * h));
    }
    EXPECT_LE(most, path.bend() * (1.0 + 1e-6));
    EXPECT_GT(most, 0.4 * path.bend()) << "no needless pieces";
    const auto chords = static_cast<double>(path.chord_count());
    EXPECT_LE(path.bend() / (8.0 * chords * chords), kChordErrorMm);
  }
}

/// Keeps what a machine shows.
class Shown final : public TraceSink {
 public:
  void on_sample(const TraceSample& sample) override { list.push_back(sample); }
  std::vector<TraceSample> list;
};

// The second way: each axis alone, on a straight path of its own.
TEST(IndependentPath, EachAxisGoesAndLagsAsIfItWereAlone) {
  std::mt19937 random(31);
  std::uniform_real_distribution<double> way(-150.0, 150.0);
  MachineSetup setup = v55();
  setup.axes[0].servo_gain = 1.8;
  setup.axes[1].servo_gain = 1.2;
  setup.in_position = 0.5;  // so that the moves leave a lag behind
  for (int i = 0; i < 20; ++i) {
    const AxisPositions q_M_first = axes(way(random), way(random), way(random));
    const AxisPositions q_M_end = axes(way(random), way(random), way(random));
    Shown together;
    MachiningCentre centre(setup, nullptr);
    centre.trace(0.003, together);
    ASSERT_TRUE(centre.move(independent(q_M_first)).ok());
    const double done_s = centre.time_s();
    ASSERT_TRUE(centre.move(independent(q_M_end)).ok());
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      Shown alone;
      MachiningCentre one(setup, nullptr);
      one.trace(0.003, alone);
      AxisPositions q_M_one = axes(0, 0, 0);
      q_M_one[axis] = q_M_first[axis];
      ASSERT_TRUE(one.move(independent(q_M_one)).ok());
      one.dwell(std::max(0.0, done_s - one.time_s()));  // the clock rounds
      q_M_one[axis] = q_M_end[axis];
      ASSERT_TRUE(one.move(independent(q_M_one)).ok());
      ASSERT_GT(alone.list.size(), 100U);
      for (std::size_t k = 0; k < alone.list.size(); ++k) {
        ASSERT_NEAR(together.list[k].q_M_commanded[axis], alone.list[k].q_M_commanded[axis], 1e-9);
        ASSERT_NEAR(together.list[k].q_M_encoder[axis], alone.list[k].q_M_encoder[axis], 1e-9);
      }
    }
  }
}

TEST(IndependentPath, ATraceOfAnIdealMachineShowsTheWayAndChangesNothing) {
  Shown shown;
  MachiningCentre traced(ideal(), nullptr);
  MachiningCentre plain(ideal(), nullptr);
  traced.trace(0.01, shown);
  ASSERT_TRUE(traced.move(independent(axes(100, 20, 5))).ok());
  ASSERT_TRUE(plain.move(independent(axes(100, 20, 5))).ok());
  EXPECT_EQ(traced.time_s(), plain.time_s());
  const IndependentPath path = path_of(ideal(), axes(0, 0, 0), axes(100, 20, 5));
  ASSERT_EQ(shown.list.size(), 47U);
  for (const TraceSample& sample : shown.list) {
    EXPECT_NEAR((sample.q_M_true - path.at(sample.time_s / path.length())).norm(), 0.0, 1e-12);
  }
}

// Linear axes that have arrived stand while the table goes on turning: at each place of the way the
// angle of C says the time, C(t) = 500 t^2 until 45 degrees, and that where X is, which is how far
// the tip is from the axis of the table.
TEST(IndependentPath, ThePartTurnsByTheTimeNotByTheShareOfTheWay) {
  MachineSetup setup = five_axis();
  setup.chain = {"CA", "XYZ", {}};
  setup.chain.rotary = AxisChainSetup().rotary;
  testing::ScriptedSurroundings world;
  MachiningCentre centre(setup, &world);
  ASSERT_TRUE(centre.move(independent(axes(200, 0, 0, 0, 0, 90))).ok());
  EXPECT_NEAR(centre.time_s(), 0.6, 1e-12);
  int turning = 0;
  for (const Sweep& sweep : world.move_sweeps()) {
    const double c_deg = sweep.q_M_to[5];
    const double time_s = std::sqrt(c_deg / 500.0);
    if (c_deg <= 45.0) {
      const double x = time_s < 1.0 / 6.0 ? 2000.0 * time_s * time_s
                                          : 2000.0 / 36.0 + 2000.0 / 3.0 * (time_s - 1.0 / 6.0);
      EXPECT_NEAR(std::hypot(sweep.q_M_to[0], sweep.q_M_to[1]), x, 1e-6) << c_deg;
      ++turning;
    } else if (c_deg > 82.0) {
      EXPECT_NEAR(std::hypot(sweep.q_M_to[0], sweep.q_M_to[1]), 200.0, 1e-6) << c_deg;
    }
  }
  EXPECT_GT(turning, 100);
}

TEST(IndependentPath, WhatIsInTheWayEndsItThereAndThen) {
  for (const bool is_traced : {false, true}) {
    testing::ScriptedSurroundings::Obstacles script(
        100, Obstacle{0.0, "ball touches pillar", {Point(1, 2, 3), Point(0, 0, 1), "pillar"}});
    testing::ScriptedSurroundings world({}, script);
    MachiningCentre centre(ideal(), &world);
    Shown shown;
    if (is_traced) {
      centre.trace(0.001, shown);
    }
    const auto moved = centre.move(independent(axes(100, 20, 0)));
    ASSERT_FALSE(moved.ok());
    EXPECT_EQ(centre.position(), axes(0, 0, 0));
    EXPECT_EQ(centre.time_s(), 0.0);
  }
}

}  // namespace
}  // namespace g31::machine::independent_path_test

// Moves that pass on: times, places over time, and what ends them.  Expected times are closed
// forms.

#include "machine/sim/continuous_path.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/scripted_surroundings.h"

namespace g31::machine::continuous_path_test {
namespace {

AxisPositions axes(double x, double y, double z) {
  return (AxisPositions() << x, y, z, 0, 0, 0).finished();
}

LinearMove feed(const AxisPositions& q_M_end, BlockEnd ends = BlockEnd::PassOn) {
  return {q_M_end, Traverse::Feed, 3000.0, ends};
}
LinearMove rapid(const AxisPositions& q_M_end) {
  return {q_M_end, Traverse::Rapid, 0.0};
}

class Samples final : public TraceSink {
 public:
  void on_sample(const TraceSample& sample) override { list.push_back(sample); }
  std::vector<TraceSample> list;
};

MachineSetup lively(double acceleration, double jerk) {
  MachineSetup setup;
  for (std::size_t i = 0; i < 3; ++i) {
    setup.axes[i].acceleration_per_s2 = acceleration;
    setup.axes[i].jerk_per_s3 = jerk;
  }
  return setup;
}

void run_line(MachiningCentre& centre, int blocks, BlockEnd ends) {
  for (int i = 1; i <= blocks; ++i) {
    ASSERT_TRUE(centre.move(feed(axes(100.0 * i / blocks, 0, 0), ends)).ok());
  }
}

TEST(ContinuousPath, AThousandBlocksInARowTakeTheTimeOfOne) {
  struct Case {
    MachineSetup setup;
    double passing_s, stopping_s;
  };
  const Case kCases[] = {{lively(2000, 0), 2.025, 14.142136},
                         {lively(5000, 50000), 2.063246, 40.0},
                         {lively(5000, 0), 2.01, 8.944272}};
  for (const Case& c : kCases) {
    for (const int blocks : {1, 1000}) {
      MachiningCentre passes(c.setup, nullptr);
      run_line(passes, blocks, BlockEnd::PassOn);
      EXPECT_NEAR(passes.time_s(), c.passing_s, 1e-6);
    }
    MachiningCentre stops(c.setup, nullptr);
    run_line(stops, 1000, BlockEnd::ExactStop);
    EXPECT_NEAR(stops.time_s(), c.stopping_s, 1e-6);
  }
}

// An axis may change its speed by its acceleration times 1 ms at once: 2 mm/s here.
TEST(ContinuousPath, CornersAreTakenAtTheSpeedOfTheirAxes) {
  MachiningCentre centre(MachineSetup(), nullptr);
  ASSERT_TRUE(centre.move(feed(axes(100, 0, 0))).ok());
  ASSERT_TRUE(centre.move(feed(axes(100, 100, 0))).ok());
  EXPECT_NEAR(centre.time_s(), 4.0 + 0.025 + (1.0 - 2.0 / 50.0) * 0.024, 1e-12);
}

// A line goes over into an arc, and that into a line, at the speed of the arc: (a / sqrt 2) in its
// plane, half of it (in squares) towards the centre.
TEST(ContinuousPath, TangentialArcsArePassedAtTheirOwnSpeed) {
  MachiningCentre centre(MachineSetup(), nullptr);
  ASSERT_TRUE(centre.move(feed(axes(50, 0, 0))).ok());
  ArcMove arc;
  arc.q_M_end = axes(60, 10, 0);
  arc.centre_first = 50.0;
  arc.centre_second = 10.0;
  arc.turn = Turn::Counterclockwise;
  arc.feed_mm_min = 3000.0;
  arc.ends = BlockEnd::PassOn;
  ASSERT_TRUE(centre.move(arc).ok());
  ASSERT_TRUE(centre.move(feed(axes(60, 60, 0))).ok());
  const double way = 100.0 + 5.0 * std::numbers::pi;
  EXPECT_NEAR(centre.time_s(), way / 50.0 + 50.0 / 2000.0, 1e-9);
}

TEST(ContinuousPath, EndsAtRestWhereSomethingWaitsForIt) {
  const auto two_lines = [](const auto& between) {
    MachiningCentre centre(MachineSetup(), nullptr);
    EXPECT_TRUE(centre.move(feed(axes(100, 0, 0))).ok());
    between(centre);
    EXPECT_TRUE(centre.move(feed(axes(200, 0, 0))).ok());
    return centre.time_s();
  };
  const double kStops = 2.0 * 2.025;
  EXPECT_NEAR(two_lines([](MachiningCentre&) {}), 4.025, 1e-12);
  EXPECT_NEAR(two_lines([](MachiningCentre& m) { (void)m.time_s(); }), 4.025, 1e-12)
      << "who looks changes nothing";
  EXPECT_NEAR(two_lines([](MachiningCentre& m) { m.stand_still(); }), kStops, 1e-12);
  EXPECT_NEAR(two_lines([](MachiningCentre& m) { m.dwell(0.5); }), kStops + 0.5, 1e-12);
  EXPECT_NEAR(two_lines([](MachiningCentre& m) { m.auxiliary_code({8}); }), kStops, 1e-12);
  const double up_s = 2.0 * std::sqrt(1.0 / 2000.0);
  EXPECT_NEAR(two_lines([](MachiningCentre& m) {
                EXPECT_TRUE(m.move(rapid(axes(100, 0, 1))).ok());
                EXPECT_TRUE(m.move(rapid(axes(100, 0, 0))).ok());
              }),
              kStops + 2.0 * up_s, 1e-12);
}

TEST(ContinuousPath, AnExactStopEndsThePathThatLedIntoIt) {
  MachiningCentre centre(MachineSetup(), nullptr);
  ASSERT_TRUE(centre.move(feed(axes(100, 0, 0))).ok());
  ASSERT_TRUE(centre.move(feed(axes(200, 0, 0), BlockEnd::ExactStop)).ok());
  EXPECT_NEAR(centre.time_s(), 4.025, 1e-12);
  ASSERT_TRUE(centre.move(feed(axes(300, 0, 0))).ok());
  EXPECT_NEAR(centre.time_s(), 4.025 + 2.025, 1e-12);
}

TEST(ContinuousPath, OneMoveAloneIsWhatItWasBitForBit) {
  for (const double jerk : {0.0, 50000.0}) {
    MachiningCentre passes(lively(3333, jerk), nullptr);
    MachiningCentre stops(lively(3333, jerk), nullptr);
    for (const double x : {7.1, 93.7, 93.9, -12.0}) {
      ASSERT_TRUE(passes.move(feed(axes(x, 2 * x, 0))).ok());
      passes.stand_still();
      ASSERT_TRUE(stops.move(feed(axes(x, 2 * x, 0), BlockEnd::ExactStop)).ok());
      EXPECT_EQ(passes.time_s(), stops.time_s());
    }
  }
}

// The second way: the speed between samples of the path, and the same clock with and without them.
TEST(ContinuousPath, ATraceShowsTheWayAtItsSpeedAndChangesNothing) {
  Samples samples;
  MachiningCentre traced(MachineSetup(), nullptr);
  MachiningCentre plain(MachineSetup(), nullptr);
  const double period_s = 0.001;
  traced.trace(period_s, samples);
  const auto run = [](MachiningCentre& centre) {
    for (int i = 1; i <= 300; ++i) {
      const double angle = i * std::numbers::pi / 150.0;
      ASSERT_TRUE(
          centre.move(feed(axes(20.0 * std::sin(angle), 20.0 - 20.0 * std::cos(angle), 0))).ok());
    }
    centre.stand_still();
  };
  run(traced);
  run(plain);
  EXPECT_EQ(traced.time_s(), plain.time_s());
  ASSERT_EQ(samples.list.size(),
            static_cast<std::size_t>(std::floor(traced.time_s() / period_s)) + 1U);
  double way = 0.0;
  for (std::size_t i = 1; i < samples.list.size(); ++i) {
    const double step = distance_mm(samples.list[i - 1].q_M_true, samples.list[i].q_M_true);
    EXPECT_LE(step, 50.0 * period_s + 1e-9);
    const double radius = (linear_axes(samples.list[i].q_M_true) - Point(0.0, 20.0, 0.0)).norm();
    EXPECT_NEAR(radius, 20.0, 0.0012) << "on the chords";
    way += step;
  }
  EXPECT_NEAR(way, 600.0 * 20.0 * std::sin(std::numbers::pi / 300.0), 0.05);
  // Each corner turns by 1.2 degrees: 2 mm/s over 0.0209 are 95 mm/s, so the feed is kept.
  EXPECT_NEAR(traced.time_s(), 600.0 * 20.0 * std::sin(std::numbers::pi / 300.0) / 50.0 + 0.025,
              5e-4);
}

TEST(ContinuousPath, ACollisionComesAtItsMoveOnlyItsTimeIsThatOfThePath) {
  testing::ScriptedSurroundings::Obstacles script(3);
  script[2] = Obstacle{0.5, "ball touches ring", {Point(1, 2, 3), Point(0, 0, 1), "ring"}};
  for (const bool is_traced : {false, true}) {
    testing::ScriptedSurroundings world({}, script);
    MachiningCentre centre(MachineSetup(), &world);
    Samples samples;
    if (is_traced) {
      centre.trace(0.01, samples);
    }
    ASSERT_TRUE(centre.move(feed(axes(100, 0, 0))).ok());
    ASSERT_TRUE(centre.move(feed(axes(200, 0, 0))).ok());
    const auto hit = centre.move(feed(axes(300, 0, 0)));
    ASSERT_FALSE(hit.ok());
    EXPECT_EQ(hit.error().q_M_at, axes(250, 0, 0));
    EXPECT_EQ(centre.position(), axes(250, 0, 0));
    EXPECT_NEAR(centre.time_s(), 0.0125 + 250.0 / 50.0, 1e-12);
    if (is_traced) {
      ASSERT_EQ(samples.list.size(), 502U);
      EXPECT_NEAR(samples.list.back().q_M_true[0], 250.0, 0.5);
    }
  }
}

// Lagging axes depend on the speed in their way: they stop at each block as before.
TEST(ContinuousPath, LaggingAxesStopAtTheEndOfEachCommand) {
  MachineSetup setup;
  setup.axes[0].servo_gain = 1.8;
  MachiningCentre centre(setup, nullptr);
  ASSERT_TRUE(centre.move(feed(axes(100, 0, 0))).ok());
  ASSERT_TRUE(centre.move(feed(axes(200, 0, 0))).ok());
  EXPECT_NEAR(centre.time_s(), 2.0 * 2.025, 1e-12);
}

}  // namespace
}  // namespace g31::machine::continuous_path_test

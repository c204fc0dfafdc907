// Moves that pass on: times, places over time, and what ends them.  Expected times are closed
// forms.

#include "machine/sim/continuous_path.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/scripted_surroundings.h"
#include "tests/support/trace_samples.h"
#include "tests/support/world_of_pieces.h"

namespace g31::machine::continuous_path_test {
namespace {

using testing::TraceSamples;

AxisPositions axes(double x, double y, double z) {
  return (AxisPositions() << x, y, z, 0, 0, 0).finished();
}

LinearMove feed(const AxisPositions& q_M_end, BlockEnd ends = BlockEnd::PassOn) {
  return {q_M_end, Traverse::Feed, 3000.0, ends};
}
LinearMove rapid(const AxisPositions& q_M_end) {
  return {q_M_end, Traverse::Rapid, 0.0};
}

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
  TraceSamples samples;
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
    TraceSamples samples;
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

class Wall final : public testing::WorldOfPieces {
 public:
  explicit Wall(double x) : x_(x) {}

 private:
  std::optional<Obstacle> obstacle_on(const Sweep& sweep) override {
    const double from = sweep.q_M_from[0];
    const double to = sweep.q_M_to[0];
    if (to < x_ || from == to) {
      return std::nullopt;
    }
    return Obstacle{std::max(0.0, (x_ - from) / (to - from)),
                    "wall",
                    {Point(x_, 0, 0), Point(-1, 0, 0), "wall"}};
  }
  double x_;
};

MachineSetup lagging(double time_constant_s) {
  MachineSetup setup = lively(5000, 50000);
  for (std::size_t i = 0; i < 3; ++i) {
    setup.axes[i].servo_gain = 0.06 / time_constant_s;
  }
  return setup;
}

LinearMove contour(const AxisPositions& q_M_end, ContourControl control,
                   BlockEnd ends = BlockEnd::PassOn) {
  LinearMove move = feed(q_M_end, ends);
  move.contour_control = control;
  return move;
}

void run_contour(MachiningCentre& centre, int blocks, ContourControl control, BlockEnd last) {
  for (int i = 1; i <= blocks; ++i) {
    ASSERT_TRUE(centre
                    .move(contour(axes(100.0 * i / blocks, 0, 0), control,
                                  i == blocks ? last : BlockEnd::PassOn))
                    .ok());
  }
  centre.stand_still();
}

// The command is planned as for axes without lag; an exact stop waits 0.1414 s more, until the lag
// of 0.6953 mm is 0.01 mm.
TEST(ContinuousPath, LaggingAxesFollowACommandThatPassesOn) {
  for (const int blocks : {1, 7, 1000}) {
    MachiningCentre passes(lagging(1.0 / 30.0), nullptr);
    run_contour(passes, blocks, ContourControl::LookAhead, BlockEnd::PassOn);
    EXPECT_NEAR(passes.time_s(), 2.063245553, 1e-9);
    MachiningCentre stops(lagging(1.0 / 30.0), nullptr);
    run_contour(stops, blocks, ContourControl::LookAhead, BlockEnd::ExactStop);
    EXPECT_NEAR(stops.time_s(), 2.20463748367786, 1e-9);
  }
}

// Without contour control the command steps to the feed and from it: 2 + T ln(v T / 0.01).
TEST(ContinuousPath, WithoutContourControlEachBlockKeepsItsFeed) {
  const double t_lag = 0.03579;
  for (const int blocks : {2, 1000}) {
    MachiningCentre centre(lagging(t_lag), nullptr);
    run_contour(centre, blocks, ContourControl::Off, BlockEnd::ExactStop);
    EXPECT_NEAR(centre.time_s(), 2.0 + t_lag * std::log(50.0 * t_lag / 0.01), 1e-9);
    EXPECT_NEAR(centre.time_s(), 2.185645, 2e-6) << "with T rounded to 10 us";
  }
}

struct CornerSeen {
  double missed = 0.0;  ///< along the diagonal, where the way crosses it
  double least_speed = 1e9;
};

/// A way along X to (100, 0) and on along Y.
CornerSeen corner_of(const MachineSetup& setup, ContourControl control) {
  TraceSamples samples;
  MachiningCentre centre(setup, nullptr);
  const double period_s = 5e-5;
  centre.trace(period_s, samples);
  EXPECT_TRUE(centre.move(contour(axes(100, 0, 0), control)).ok());
  EXPECT_TRUE(centre.move(contour(axes(100, 100, 0), control)).ok());
  centre.stand_still();
  CornerSeen seen;
  for (std::size_t i = 1; i < samples.list.size(); ++i) {
    const Point p = linear_axes(samples.list[i].q_M_true);
    const Point before = linear_axes(samples.list[i - 1].q_M_true);
    const double to_go = 100.0 - p.x() - p.y();  // > 0 before the diagonal
    const double to_go_before = 100.0 - before.x() - before.y();
    if (to_go <= 0.0 && to_go_before > 0.0) {
      const double share = to_go_before / (to_go_before - to_go);
      seen.missed = std::numbers::sqrt2 * (before.y() + share * (p.y() - before.y()));
    }
    if (p.x() > 90.0 && p.y() < 10.0) {
      seen.least_speed = std::min(seen.least_speed, (p - before).norm() / period_s);
    }
  }
  return seen;
}

// v T / e and v / sqrt 2: a first-order lag with steady speed through the corner.
TEST(ContinuousPath, WithoutContourControlLagRoundsTheCorner) {
  for (const double t_lag : {1.0 / 30.0, 0.03579}) {
    const CornerSeen seen = corner_of(lagging(t_lag), ContourControl::Off);
    EXPECT_NEAR(seen.missed, std::numbers::sqrt2 * 50.0 * t_lag / std::numbers::e, 1e-6);
    EXPECT_NEAR(seen.least_speed, 50.0 / std::numbers::sqrt2, 1e-3);
  }
}

/// What a lag T with the feed-forward 1 - b misses where the command brakes to rest with a and
/// sets off again: on the diagonal X's dying lag meets Y's rise, 2 b exp(-u) = u^2 / 2 - b u + b.
double missed_at_rest(double b, double a, double t_lag) {
  double low = 0.0;
  double high = 10.0;
  for (int i = 0; i < 100; ++i) {
    const double u = 0.5 * (low + high);
    (2.0 * b * std::exp(-u) > 0.5 * u * u - b * u + b ? low : high) = u;
  }
  return std::numbers::sqrt2 * b * std::exp(-low) * a * t_lag * t_lag;
}

TEST(ContinuousPath, WithContourControlTheCommandStopsAtTheCorner) {
  const double t_lag = 0.03579;
  for (const double feed_forward : {0.0, 0.5, 0.95}) {
    MachineSetup setup = lagging(t_lag);
    for (std::size_t i = 0; i < 3; ++i) {
      setup.axes[i].jerk_per_s3 = 0.0;
      setup.axes[i].feed_forward = feed_forward;
      setup.axes[i].contour_acceleration_per_s2 = 222.7;
      setup.axes[i].corner_jump_per_min = 0.0;
    }
    const CornerSeen ahead = corner_of(setup, ContourControl::FeedForward);
    // The ramp lasts 6.3 T: what is not steady before it ends is exp(-6.3) of it.
    EXPECT_NEAR(ahead.missed / missed_at_rest(1.0 - feed_forward, 222.7, t_lag), 1.0, 2e-3);
    const CornerSeen without = corner_of(setup, ContourControl::LookAhead);
    EXPECT_NEAR(without.missed / missed_at_rest(1.0, 222.7, t_lag), 1.0, 2e-3);
    if (feed_forward == 0.95) {
      EXPECT_NEAR(ahead.missed, 0.0152, 0.0001);
      EXPECT_LT(ahead.least_speed, 1.0);
    }
  }
}

// A circle at a steady speed shrinks by v^2 T^2 (1 - a^2) / 2R, here to first order.
TEST(ContinuousPath, FeedForwardKeepsTheRadius) {
  for (const double feed_forward : {0.0, 0.9}) {
    MachineSetup setup = lagging(0.03579);
    for (std::size_t i = 0; i < 2; ++i) {
      setup.axes[i].feed_forward = feed_forward;
    }
    setup.q_M_start = axes(50, 0, 0);
    TraceSamples samples;
    MachiningCentre centre(setup, nullptr);
    centre.trace(0.01, samples);
    ArcMove circle;
    circle.q_M_end = axes(50, 0, 0);
    circle.feed_mm_min = 2000.0;
    circle.ends = BlockEnd::PassOn;
    circle.contour_control = ContourControl::FeedForward;
    ASSERT_TRUE(centre.move(circle).ok());
    centre.stand_still();
    const double w_t = 2000.0 / 60.0 / 50.0 * 0.03579;
    const double expected = 50.0 * std::hypot(1.0, feed_forward * w_t) / std::hypot(1.0, w_t);
    for (const TraceSample& sample : samples.list) {
      if (sample.time_s > 1.0 && sample.time_s < 9.0) {
        EXPECT_NEAR(linear_axes(sample.q_M_true).norm(), expected, 1e-6);
      }
    }
  }
}

/// The block of 1 mm that is commanded when the axis, behind its command, has come to a place.
int commanded_block(const std::vector<TraceSample>& samples, double place) {
  for (const TraceSample& sample : samples) {
    if (sample.q_M_true[0] >= place) {
      return static_cast<int>(std::ceil(sample.q_M_commanded[0]));
    }
  }
  return 0;
}

// The command stands at 100 mm, the axis is v T behind and comes while the program waits.
TEST(ContinuousPath, WhatLagsBehindMayMeetSomethingDuringADwell) {
  const double t_lag = 1.0 / 30.0;
  const double lag = 50.0 * t_lag * (1.0 - std::exp(-2.0 / t_lag));
  struct Case {
    double wall, dwell_s;
    bool meets;
  };
  for (const Case& c :
       {Case{99.5, 1.0, true}, {99.9, 1.0, true}, {99.5, 0.01, false}, {100.001, 1.0, false}}) {
    Wall wall(c.wall);
    MachiningCentre centre(lagging(t_lag), &wall);
    LinearMove move = contour(axes(100, 0, 0), ContourControl::Off);
    move.tag = {7, 8, 9};
    ASSERT_TRUE(centre.move(move).ok());
    centre.dwell(c.dwell_s);
    const auto fault = centre.take_late_fault();
    ASSERT_EQ(fault.has_value(), c.meets) << c.wall;
    if (c.meets) {
      const double met_s = 2.0 + t_lag * std::log(lag / (100.0 - c.wall));
      EXPECT_NEAR(centre.time_s(), met_s, 4e-4);
      EXPECT_NEAR(fault->q_M_at[0], c.wall, 1e-3);
      EXPECT_EQ(fault->tag, move.tag) << "the program only waits";
    } else {
      EXPECT_EQ(centre.time_s(), 2.0 + c.dwell_s);
    }
  }
}

// Somewhere in each of 200 blocks the axis meets a wall: the fault says which one was commanded
// then, wherever it is found.
TEST(ContinuousPath, AFaultThatIsFoundLateSaysWhoseItIs) {
  constexpr int kBlocks = 200;
  TraceSamples samples;
  MachiningCentre free(lagging(1.0 / 30.0), nullptr);
  free.trace(1e-4, samples);
  int late = 0;
  for (int block = 0; block <= kBlocks - 2; ++block) {
    Wall world(block - 0.2);
    MachiningCentre centre(lagging(1.0 / 30.0), block > 0 ? &world : nullptr);
    MachiningCentre& used = block > 0 ? centre : free;
    MaybeFault fault;
    int i = 0;
    while (!fault && ++i <= kBlocks) {
      LinearMove move = contour(axes(i, 0, 0), ContourControl::LookAhead);
      move.tag = {static_cast<std::uint64_t>(i), 0, 0};
      const auto reached = used.move(move);
      fault = reached ? std::nullopt : MaybeFault(reached.error());
    }
    used.stand_still();
    if (block == 0) {
      continue;
    }
    late += i > block + 10 ? 1 : 0;
    centre.dwell(1.0);  // does not take place
    fault = fault ? fault : centre.take_late_fault();
    ASSERT_TRUE(fault && fault->tag);
    EXPECT_EQ((*fault->tag)[0], commanded_block(samples.list, block - 0.2)) << block;
    EXPECT_NEAR(fault->q_M_at[0], block - 0.2, 1e-6);
    EXPECT_LT(centre.time_s(), 4.1);
    EXPECT_EQ(centre.position(), fault->q_M_at);
    EXPECT_FALSE(centre.take_late_fault());
  }
  EXPECT_GT(late, 100);
}

// What is behind is given out of a long straight way: nothing of its motion changes.
TEST(ContinuousPath, ALongWayIsGivenOutAsItIsTravelled) {
  TraceSamples samples;
  MachiningCentre traced(lagging(1.0 / 30.0), nullptr);
  MachiningCentre plain(lagging(1.0 / 30.0), nullptr);
  traced.trace(0.001, samples);
  for (int i = 1; i <= 3000; ++i) {
    for (MachiningCentre* centre : {&traced, &plain}) {
      ASSERT_TRUE(centre->move(contour(axes(0.7 * i, 0, 0), ContourControl::LookAhead)).ok());
    }
  }
  EXPECT_GT(samples.list.size(), 20'000U) << "what is known is travelled";
  traced.stand_still();
  plain.stand_still();
  EXPECT_EQ(traced.time_s(), plain.time_s());
  EXPECT_NEAR(plain.time_s(), 2100.0 / 50.0 + 0.063245553, 1e-9);
  for (std::size_t i = 1000; i + 500 < samples.list.size(); ++i) {
    const double behind = samples.list[i].q_M_commanded[0] - samples.list[i].q_M_true[0];
    ASSERT_NEAR(behind, 50.0 / 30.0, 1e-6);
  }
}

}  // namespace
}  // namespace g31::machine::continuous_path_test

// Where a picture has the ball at every time, against closed forms and the trace of the machine.

#include "tools/picture/track.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/trace_samples.h"
#include "tools/picture/way_recorder.h"

namespace g31::picture::track_test {
namespace {

using machine::MachiningCentre;

AxisPositions at(double x, double y, double z) {
  AxisPositions q = AxisPositions::Zero();
  q.head<3>() << x, y, z;
  return q;
}

machine::LinearMove rapid_to(const AxisPositions& q_M,
                             machine::RapidPath path = machine::RapidPath::Straight) {
  machine::LinearMove move;
  move.q_M_end = q_M;
  move.rapid_path = path;
  return move;
}

machine::LinearMove feed_to(const AxisPositions& q_M, double feed_mm_min,
                            machine::BlockEnd ends = machine::BlockEnd::ExactStop) {
  machine::LinearMove move;
  move.q_M_end = q_M;
  move.traverse = machine::Traverse::Feed;
  move.feed_mm_min = feed_mm_min;
  move.ends = ends;
  return move;
}

machine::ArcMove arc_to(const AxisPositions& q_M, double centre_x, double centre_y) {
  machine::ArcMove arc;
  arc.q_M_end = q_M;
  arc.centre_first = centre_x;
  arc.centre_second = centre_y;
  arc.turn = machine::Turn::Counterclockwise;
  arc.feed_mm_min = 3000.0;
  return arc;
}

/// A machine that a recorder of its gauge point and a trace of every 0.7 ms watch.
struct Watched {
  explicit Watched(const machine::MachineSetup& setup = {})
      : machine(setup, nullptr), recorder(machine, setup, Point::Zero(), budget) {
    machine.tell_motions_to(recorder);
    machine.trace(0.0007, trace);
  }

  void expect_track_as_traced() {
    machine.stand_still();
    ASSERT_GT(trace.list.size(), 100U);
    double most = 0.0;
    for (const machine::TraceSample& sample : trace.list) {
      const Point p = recorder.track().at(sample.time_s);
      most = std::max(most, (p - sample.q_M_encoder.head<3>()).norm());
    }
    EXPECT_LE(most, kTrackErrorMm);
  }

  runtime::OutputBudget budget;
  testing::TraceSamples trace;
  MachiningCentre machine;
  WayRecorder recorder;
};

TEST(Track, OfARapidIsItsAcceleration) {
  Watched run;
  run.recorder.dwell(0.3);
  ASSERT_TRUE(run.recorder.move(rapid_to(at(0, 0, 188))).ok());
  // 20 m/min and 2000 mm/s2.
  constexpr double kSpeed = 20000.0 / 60.0;
  constexpr double kRamp_s = kSpeed / 2000.0;
  constexpr double kAll_s = 188.0 / kSpeed + kRamp_s;
  const auto z_at = [](double t) {
    return t < kRamp_s            ? 1000.0 * t * t
           : t < kAll_s - kRamp_s ? kSpeed * (t - kRamp_s / 2.0)
                                  : 188.0 - 1000.0 * (kAll_s - t) * (kAll_s - t);
  };
  for (double t = 0.0; t <= kAll_s; t += 0.001) {
    const Point p = run.recorder.track().at(0.3 + t);
    EXPECT_NEAR((p - Point(0.0, 0.0, z_at(t))).norm(), 0.0, 1e-9) << t;
  }
  EXPECT_NEAR(run.recorder.track().at(0.44).z(), 19.6, 1e-9);
  EXPECT_EQ(run.recorder.track().at(0.1), Point::Zero());
  EXPECT_EQ(run.recorder.track().at(9.0), Point(0, 0, 188));
  EXPECT_EQ(run.recorder.track().knots().size(), 5U) << "of rest, and where its phases end";
}

TEST(Track, IsThatOfTheTraceOnWaysOfAllKinds) {
  Watched run;
  ASSERT_TRUE(run.recorder.move(rapid_to(at(90, 20, 5), machine::RapidPath::Independent)).ok());
  ASSERT_TRUE(run.recorder.move(arc_to(at(30, 20, 9), 60, 20)).ok());
  ASSERT_TRUE(run.recorder.move_until_skip({feed_to(at(30, 0, 9), 3000.0)}).ok());
  run.recorder.dwell(0.05);
  for (const double x : {40.0, 60.0, 61.0}) {
    ASSERT_TRUE(
        run.recorder.move(feed_to(at(x, x / 3, 9), 6000.0, machine::BlockEnd::PassOn)).ok());
  }
  run.expect_track_as_traced();
  EXPECT_LE(run.recorder.track().knots().size(), 60U) << "and has few knots";
}

TEST(Track, IsThatOfTheTraceWhereAxesLagAndJerkIsLimited) {
  machine::MachineSetup setup;
  for (machine::AxisSetup& axis : setup.axes) {
    axis.servo_gain = 1.8;
    axis.jerk_per_s3 = 20000.0;
  }
  Watched run(setup);
  ASSERT_TRUE(run.recorder.move(rapid_to(at(90, 20, 5))).ok());
  ASSERT_TRUE(run.recorder.move(arc_to(at(30, 20, 9), 60, 20)).ok());
  ASSERT_TRUE(run.recorder.move_until_skip({feed_to(at(30, 0, 9), 600.0)}).ok());
  run.expect_track_as_traced();
}

TEST(Track, StepsWhereAnotherToolIsCalledInNoTime) {
  Track track;
  track.stand(1.0, {0, 0, 0});
  track.go({1.0, 2.0}, [](double time_s) { return Point(time_s - 1.0, 0, 0); });
  track.go({2.0, 3.0}, [](double) { return Point(1, 0, -50); });
  track.stand(7.0, {1, 0, -50});
  EXPECT_NEAR((track.at(1.5) - Point(0.5, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(track.at(2.5), Point(1, 0, -50));
  EXPECT_EQ(track.at(6.0), Point(1, 0, -50));
}

}  // namespace
}  // namespace g31::picture::track_test

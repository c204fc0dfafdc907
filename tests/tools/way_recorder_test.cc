// The ways that pictures are made of: of which moves, along what, and when.

#include "tools/picture/way_recorder.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/runtime/budget_spent.h"
#include "machine/sim/machining_centre.h"
#include "tests/support/scripted_surroundings.h"
#include "tools/picture/tip.h"

namespace g31::picture::way_recorder_test {
namespace {

using machine::MachiningCentre;

/// Axes that reach any speed in no time worth speaking of: times are lengths over feeds.
machine::MachineSetup quick_axes() {
  machine::MachineSetup setup;
  for (machine::AxisSetup& axis : setup.axes) {
    axis.acceleration_per_s2 = 1e12;
  }
  return setup;
}

AxisPositions at(double x, double y, double z) {
  AxisPositions q = AxisPositions::Zero();
  q.head<3>() << x, y, z;
  return q;
}

machine::LinearMove feed_to(const AxisPositions& q_M, double feed_mm_min) {
  machine::LinearMove move;
  move.q_M_end = q_M;
  move.traverse = machine::Traverse::Feed;
  move.feed_mm_min = feed_mm_min;
  return move;
}

machine::LinearMove rapid_to(const AxisPositions& q_M, machine::RapidPath path) {
  machine::LinearMove move;
  move.q_M_end = q_M;
  move.rapid_path = path;
  return move;
}

struct Recorded {
  explicit Recorded(const machine::MachineSetup& setup = quick_axes(),
                    const Point& p_S_tip = Point::Zero(),
                    machine::Surroundings* surroundings = nullptr)
      : machine(setup, surroundings), recorder(machine, setup, p_S_tip, budget) {}

  runtime::OutputBudget budget;
  MachiningCentre machine;
  WayRecorder recorder;
};

TEST(WayRecorder, KeepsKindPlaceAndTimeInOrder) {
  Recorded run(quick_axes(), {0.0, 0.0, -100.0});
  ASSERT_TRUE(run.recorder.move(rapid_to(at(30, 40, 0), machine::RapidPath::Straight)).ok());
  run.recorder.dwell(2.0);
  ASSERT_TRUE(run.recorder.move(feed_to(at(30, 40, -60), 600.0)).ok());
  ASSERT_TRUE(run.recorder.move(feed_to(at(30, 40, -60), 600.0)).ok());
  ASSERT_TRUE(run.recorder.move_until_skip(feed_to(at(30, 10, -60), 60.0)).ok());
  const auto& ways = run.recorder.ways();
  ASSERT_EQ(ways.size(), 3U) << "what does not move leaves no way";
  EXPECT_EQ(ways[0].kind, PathKind::Rapid);
  EXPECT_EQ(ways[1].kind, PathKind::Feed);
  EXPECT_EQ(ways[2].kind, PathKind::Skip);
  EXPECT_EQ(ways[0].points, (std::vector<Point>{{0, 0, -100}, {30, 40, -100}}));
  EXPECT_EQ(ways[1].points, (std::vector<Point>{{30, 40, -100}, {30, 40, -160}}));
  EXPECT_EQ(ways[2].points, (std::vector<Point>{{30, 40, -160}, {30, 10, -160}}));
  // 20 m/min limits Y with its 40 mm; then 60 mm at 10 mm/s and 30 mm at 1 mm/s.
  constexpr double kRapid_s = 40.0 / 20000.0 * 60.0;
  EXPECT_EQ(ways[0].time_from_s, 0.0);
  EXPECT_NEAR(ways[0].time_to_s, kRapid_s, 1e-6);
  EXPECT_NEAR(ways[1].time_from_s, kRapid_s + 2.0, 1e-6);
  EXPECT_NEAR(ways[1].time_to_s, kRapid_s + 8.0, 1e-6);
  EXPECT_NEAR(ways[2].time_to_s, kRapid_s + 38.0, 1e-6);
  EXPECT_EQ(ways[2].time_to_s, run.machine.time_s());
}

TEST(WayRecorder, AnArcIsChordsOfFiveDegreesAtMost) {
  Recorded run;
  machine::ArcMove arc;
  arc.q_M_end = at(-50, 50, 9);
  arc.centre_first = -50.0;
  arc.turn = machine::Turn::Counterclockwise;
  arc.feed_mm_min = 1000.0;
  ASSERT_TRUE(run.recorder.move(arc).ok());
  ASSERT_EQ(run.recorder.ways().size(), 1U);
  const Way& way = run.recorder.ways().front();
  ASSERT_EQ(way.points.size(), 20U);
  for (std::size_t i = 0; i < way.points.size(); ++i) {
    const double share = static_cast<double>(i) / 19.0;
    const double angle = share * std::numbers::pi / 2.0;
    const Point expected(-50.0 + 50.0 * std::cos(angle), 50.0 * std::sin(angle), 9.0 * share);
    EXPECT_NEAR((way.points[i] - expected).norm(), 0.0, 1e-12) << i;
  }
}

TEST(WayRecorder, AxesOfARapidThatGoOnTheirOwnArriveOneByOne) {
  Recorded run;
  ASSERT_TRUE(run.recorder.move(rapid_to(at(20, 80, 0), machine::RapidPath::Independent)).ok());
  const Way& way = run.recorder.ways().front();
  ASSERT_EQ(way.points.size(), 49U);
  for (std::size_t i = 0; i < way.points.size(); ++i) {
    const double gone = 80.0 * static_cast<double>(i) / 48.0;
    EXPECT_NEAR((way.points[i] - Point(std::min(gone, 20.0), gone, 0.0)).norm(), 0.0, 1e-4) << i;
  }
}

TEST(WayRecorder, TheSpindleTurnsTheBall) {
  Recorded run(quick_axes(), {0.5, 0.0, -100.0});
  machine::SpindleTurn half;
  half.angle_deg = 180.0;
  run.recorder.turn_spindle(half);
  ASSERT_TRUE(run.recorder.move(feed_to(at(10, 0, 0), 600.0)).ok());
  const Point& end = run.recorder.ways().front().points.back();
  EXPECT_NEAR((end - Point(9.5, 0.0, -100.0)).norm(), 0.0, 1e-12);
}

TEST(WayRecorder, AWayThatTheBudgetDoesNotHaveIsNotKept) {
  const machine::MachineSetup setup = quick_axes();
  runtime::OutputBudget budget(200);
  MachiningCentre machine(setup, nullptr);
  WayRecorder recorder(machine, setup, Point::Zero(), budget);
  ASSERT_TRUE(recorder.move(feed_to(at(1, 0, 0), 600.0)).ok());
  EXPECT_THROW((void)recorder.move(feed_to(at(2, 0, 0), 600.0)), runtime::BudgetSpent);
  EXPECT_EQ(recorder.ways().size(), 1U);
}

TEST(WayRecorder, ATableThatTurnsIsTheFrameOfAll) {
  setup::Job job;
  job.machine = quick_axes();
  job.machine.axes[5].present = true;
  job.machine.chain.table_side = "C";
  runtime::OutputBudget budget;
  MachiningCentre machine(job.machine, nullptr);
  WayRecorder recorder(machine, job, budget);
  AxisPositions q_M = at(10, 0, 0);
  ASSERT_TRUE(recorder.move(feed_to(q_M, 600.0)).ok());
  q_M[5] = 90.0;
  ASSERT_TRUE(recorder.move(feed_to(q_M, 600.0)).ok());
  ASSERT_EQ(recorder.ways().size(), 2U) << "the tool stands, the part turns under it";
  const Way& turn = recorder.ways().back();
  EXPECT_EQ(turn.points.size(), 20U);
  for (const Point& p : turn.points) {
    EXPECT_NEAR(p.norm(), 10.0, 1e-9);
  }
  // ISO 841: C counts the tool against the part.
  EXPECT_NEAR((turn.points.back() - Point(0, 10, 0)).norm(), 0.0, 1e-9);
}

TEST(WayRecorder, InATurretNoSpindleTurnsTheBall) {
  setup::Job job;
  job.machine = quick_axes();
  job.probe.emplace();
  job.probe->eccentricity_mm = {0.5, 0.0};
  job.probe->in_turret = true;
  runtime::OutputBudget budget;
  MachiningCentre machine(job.machine, nullptr);
  WayRecorder recorder(machine, job, budget);
  machine::SpindleTurn half;
  half.angle_deg = 180.0;
  recorder.turn_spindle(half);
  EXPECT_EQ(recorder.stylus().p_M, Point(0.5, 0.0, -120.0));
}

TEST(WayRecorder, FollowsTheToolThatIsCalled) {
  setup::Job job;
  job.machine = quick_axes();
  job.tools.emplace_back();
  job.tools.back().number = 7;
  job.tools.back().length_mm = 80.0;
  runtime::OutputBudget budget;
  MachiningCentre machine(job.machine, nullptr);
  WayRecorder recorder(machine, job, budget);
  EXPECT_EQ(recorder.stylus().p_M, Point::Zero());
  recorder.change_tool({{7, 79.0, 5.0}, 1});
  EXPECT_EQ(recorder.stylus().p_M, Point(0.0, 0.0, -80.0)) << "where it truly is";
  EXPECT_EQ(recorder.stylus().tool, 7);
  recorder.change_tool({{8, 50.0, 5.0}, 1});
  EXPECT_EQ(recorder.stylus().tool, 0);
}

/// Who watches changes nothing: a control gives its data to the machine behind.
TEST(WayRecorder, GivesTheMachineWhatTheControlSaysOfItsAxes) {
  Recorded run;
  machine::AxisData data = run.recorder.axis_data();
  EXPECT_EQ(data.stop_fine, run.machine.axis_data().stop_fine);
  data.jerk_per_s3 = AxisPositions::Constant(400.0);
  data.stop_fine = AxisPositions::Constant(0.5);
  run.recorder.set_axis_data(data);
  EXPECT_EQ(run.machine.axis_data().jerk_per_s3, data.jerk_per_s3);
  EXPECT_EQ(run.recorder.axis_data().stop_fine, data.stop_fine);

  MachiningCentre alone(quick_axes(), nullptr);
  alone.set_axis_data(data);
  ASSERT_TRUE(run.recorder.move(rapid_to(at(100, 30, 0), machine::RapidPath::Independent)).ok());
  ASSERT_TRUE(alone.move(rapid_to(at(100, 30, 0), machine::RapidPath::Independent)).ok());
  EXPECT_EQ(run.recorder.time_s(), alone.time_s());
}

TEST(WayRecorder, GivesTheMachineTheTablesOfTheControl) {
  const Point p_M_face(40.0, 0.0, 0.0);
  testing::ScriptedSurroundings world({{'X', p_M_face.x(), 0.0, false, {}}});
  Recorded run(quick_axes(), Point::Zero(), &world);
  run.recorder.compensate({{0, {{0, {{0.0, 0.02}, {100.0, 0.02}}}}}});
  const auto outcome = run.recorder.move_until_skip(feed_to(at(60, 0, 0), 60.0));
  ASSERT_TRUE(outcome.ok());
  // The axis stands 0.02 further than its control has it.
  EXPECT_NEAR(std::get<machine::Touched>(outcome.value()).q_M_latched[0], p_M_face.x() - 0.02,
              1e-9);
}

TEST(TipOf, IsTheBallOrTheGaugePoint) {
  setup::Job job;
  EXPECT_EQ(tip_of(job), Point::Zero());
  job.probe.emplace();
  job.probe->length_mm = 145.0;
  job.probe->eccentricity_mm = {0.02, -0.03};
  EXPECT_EQ(tip_of(job), Point(0.02, -0.03, -145.0));
}

}  // namespace
}  // namespace g31::picture::way_recorder_test

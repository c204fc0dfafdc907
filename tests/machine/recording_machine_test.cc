#include "tests/support/recording_machine.h"

#include <gtest/gtest.h>

namespace g31::testing::recording_machine_test {
namespace {

AxisPositions axes(double x, double y, double z, double a = 0, double c = 0) {
  return (AxisPositions() << x, y, z, a, 0, c).finished();
}

TEST(RecordingMachine, WritesEachCallAsALine) {
  using machine::Traverse;
  RecordingMachine recorder;
  machine::ArcMove arc;
  arc.q_M_end = axes(10, 0, 0);
  arc.first_axis = 2;
  arc.second_axis = 0;
  arc.centre_first = -1e-9;
  arc.centre_second = 5;
  arc.turn = machine::Turn::Counterclockwise;
  arc.feed_mm_min = 304.8;

  (void)recorder.move(machine::LinearMove{axes(12.5, -1e-7, -5), Traverse::Rapid, 0.0});
  (void)recorder.move(machine::LinearMove{axes(0, 0, 0, 30, -0.5), Traverse::Feed, 12.7});
  (void)recorder.move_until_skip(machine::LinearMove{axes(20, 0, -5), Traverse::Feed, 300.0});
  (void)recorder.move(arc);
  recorder.dwell(0.5);

  const std::vector<std::string> kExpected = {
      "move 12.500 0.000 -5.000 rapid",
      "move 0.000 0.000 0.000 A30.000 C-0.500 F12.7",
      "skip 20.000 0.000 -5.000 F300",
      "arc ccw 10.000 0.000 0.000 centre Z0.000 X5.000 F304.8",
      "dwell 0.5",
  };
  EXPECT_EQ(recorder.log(), kExpected);
  EXPECT_EQ(recorder.position(), axes(10, 0, 0));
  EXPECT_EQ(recorder.time_s(), 0.0);
}

TEST(RecordingMachine, PlaysTouchesInOrderThenNone) {
  RecordingMachine recorder({axes(12.5, 0, -5)}, axes(1, 2, 3));
  EXPECT_EQ(recorder.position(), axes(1, 2, 3));
  const machine::LinearMove probe_plus_x{axes(20, 0, -5), machine::Traverse::Feed, 300};

  const auto first = recorder.move_until_skip(probe_plus_x);
  const auto& touched = std::get<machine::Touched>(first.value());
  EXPECT_EQ(touched.q_M_latched, axes(12.5, 0, -5));
  EXPECT_EQ(touched.q_M_stopped, axes(12.5, 0, -5));
  EXPECT_EQ(recorder.position(), axes(12.5, 0, -5));

  const auto second = recorder.move_until_skip(probe_plus_x);
  EXPECT_TRUE(std::holds_alternative<machine::NoTouch>(second.value()));
  EXPECT_EQ(recorder.position(), axes(20, 0, -5));
}

}  // namespace
}  // namespace g31::testing::recording_machine_test

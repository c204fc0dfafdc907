#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::testing::measure_tool_test {
namespace {

using Lines = std::vector<std::string>;

/// Tool offset 1 is 120 mm; G37 is slow from 10 mm in front and takes signals within 2 mm.
runtime::ControlSetup setup() {
  runtime::ControlSetup given;
  given.tools[1] = {120.0, 0.25, 0.0, 0.0};
  given.parameters = {{"6241", 80.0}, {"6251", 10.0}, {"6254", 2.0}};
  return given;
}

/// One signal when Z is here in machine coordinates.
std::vector<AxisPositions> signal_at(double z) {
  AxisPositions q_M = AxisPositions::Zero();
  q_M[2] = z;
  return {q_M};
}

TEST(MeasureTool, WearTakesWhatTheAxisStandsBeyondThePosition) {
  ControlRun run("fanuc-16i", "H1\nG37 Z-50.\n#100=#5003", setup(), signal_at(-51.5));
  ASSERT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.machine().log(),
            (Lines{"move 0.000 0.000 -40.000 rapid", "skip 0.000 0.000 -52.000 F80"}));
  EXPECT_NEAR(run.value("#10001").value(), 0.25 - 1.5, 1e-9);
  EXPECT_NEAR(run.value("#11001").value(), 120.0, 1e-9);
  EXPECT_NEAR(run.value("#100").value(), -51.5, 1e-9);
  EXPECT_NEAR(run.value("#5063").value(), 0.0, 1e-9);
}

// One value: the difference goes onto the whole length.
TEST(MeasureTool, OfMemoryAIsTheWholeLength) {
  runtime::ControlSetup given = setup();
  given.offset_memory = runtime::OffsetMemory::A;
  given.tools[1] = {120.0, 0.0, 0.0, 0.0};
  ControlRun run("fanuc-16i", "H1\nG37 Z-50.", given, signal_at(-51.5));
  ASSERT_EQ(run.alarm(), 0);
  EXPECT_NEAR(run.value("#2001").value(), 120.0 - 1.5, 1e-9);
}

TEST(MeasureTool, UpwardsAndAlongAnotherAxis) {
  AxisPositions q_M = AxisPositions::Zero();
  q_M[0] = 31.0;
  ControlRun run("fanuc-16i", "H1\nG37 X30.", setup(), {q_M});
  EXPECT_EQ(run.machine().log(),
            (Lines{"move 20.000 0.000 0.000 rapid", "skip 32.000 0.000 0.000 F80"}));
  EXPECT_NEAR(run.value("#10001").value(), 1.25, 1e-9);
}

TEST(MeasureTool, PositionIsThatOfTheWorkSystemWithTheOffsetInForce) {
  // Z of the machine at the position: -50 + 10 of G54 + 120.25 of H1; G43 has moved it above that.
  ControlRun run("fanuc-16i", "G10 L2 P1 Z10.\nG43 H1\nG37 Z-50.", setup(), signal_at(80.75));
  ASSERT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.machine().log().back(), "skip 0.000 0.000 78.250 F80");
  EXPECT_NEAR(run.value("#10001").value(), 0.25 + 0.5, 1e-9);
}

TEST(MeasureTool, StartsAtTheMeasuringFeedInsideTheApproach) {
  const ControlRun run("fanuc-16i", "H1\nG37 Z-8.", setup(), signal_at(-8.0));
  EXPECT_EQ(run.machine().log(), (Lines{"skip 0.000 0.000 -10.000 F80"}));
}

TEST(MeasureTool, FeedInForceWithoutTheParameter) {
  runtime::ControlSetup given = setup();
  given.parameters.erase("6241");
  EXPECT_EQ(ControlRun("fanuc-16i", "H1\nG37 Z-8. F50.", given, signal_at(-8.0)).machine().log(),
            (Lines{"skip 0.000 0.000 -10.000 F50"}));
  EXPECT_EQ(ControlRun("fanuc-16i", "H1\nG37 Z-8.", given, signal_at(-8.0)).alarm(), 11);
}

TEST(MeasureTool, Alarms) {
  struct Case {
    const char* name;
    const char* blocks;
    std::vector<AxisPositions> touches;
    int number;
    int meldas;
  };
  const Case kCases[] = {
      {"no signal", "H1\nG37 Z-50.", {}, 80, 607},
      {"signal in front of the zone", "H1\nG37 Z-50.", signal_at(-47.9), 80, 607},
      {"signal at the edge of the zone", "H1\nG37 Z-50.", signal_at(-48.0), 0, 0},
      {"no H before it", "G37 Z-50.", signal_at(-50.0), 81, 606},
      {"H0", "H0\nG37 Z-50.", signal_at(-50.0), 81, 606},
      {"H in its block", "H1\nG37 Z-50. H1", signal_at(-50.0), 82, 605},
      {"two axes", "H1\nG37 X0. Z-50.", signal_at(-50.0), 83, 604},
      {"no axis", "H1\nG37", signal_at(-50.0), 83, 604},
      {"a rotary axis", "H1\nG37 A10.", signal_at(-50.0), 83, 604},
      {"incremental", "H1\nG91 G37 Z-50.", signal_at(-50.0), 83, 604},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(ControlRun("fanuc-16i", c.blocks, setup(), c.touches).alarm(), c.number);
    EXPECT_EQ(ControlRun("fanuc-30i", c.blocks, setup(), c.touches).alarm(), c.number);
    EXPECT_EQ(ControlRun("meldas", c.blocks, setup(), c.touches).alarm(), c.meldas);
  }
}

TEST(MeasureTool, OffsetStaysAsItIsAfterAnAlarm) {
  ControlRun run("fanuc-16i", "H1\nG37 Z-50.", setup(), signal_at(-47.9));
  EXPECT_NEAR(run.value("#10001").value(), 0.25, 1e-12);
}

}  // namespace
}  // namespace g31::testing::measure_tool_test

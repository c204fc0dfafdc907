// G93: FANUC operator's manual B-62764EN/01, 5; M700V programming manual, 7.5; Haas mill operator's
// manual 96-8000, G93.

#include <gtest/gtest.h>

#include "tests/support/last_moves.h"

namespace g31::fanuc::inverse_time_test {
namespace {

using testing::ControlRun;
using testing::expect_last_moves;
using testing::LastMoveOn;
using Lines = std::vector<std::string>;

TEST(InverseTime, FTimesTheWayIsTheFeed) {
  constexpr LastMoveOn kCases[] = {
      {"50 mm six times in a minute", "fanuc-16i", "G93G1X30.Y40.F6.",
       "move 30.000 40.000 0.000 F300"},
      {"from where the block before ended", "fanuc-30i", "G93G1X30.F2.\nX40.F3.",
       "move 40.000 0.000 0.000 F30"},
      {"a degree counts as a millimetre", "fanuc-16i", "G93G1X30.C40.F6.",
       "move 30.000 0.000 0.000 C40.000 F300"},
      {"a rotary axis alone", "haas", "G93G1C40.F6.", "move 0.000 0.000 0.000 C40.000 F240"},
      {"two inches, in mm", "fanuc-16i", "G20G93G1X2.F3.", "move 50.800 0.000 0.000 F152.4"},
      {"behind G51 the way that is gone", "fanuc-16i", "G51P2000\nG93G1X30.F2.",
       "move 60.000 0.000 0.000 F120"},
      {"G53 where it goes at feed", "haas", "G0X10.\nG93G1G53X30.F2.",
       "move 30.000 0.000 0.000 F40"},
      {"a block without a way", "fanuc-16i", "G93G1X0F2.", "move 0.000 0.000 0.000 F2"},
      {"F1 is a thousandth", "fanuc-16i", "G93G1X50.F4000", "move 50.000 0.000 0.000 F200"},
      {"on MELDAS F5 is five", "meldas", "G93G1X50.F5", "move 50.000 0.000 0.000 F250"},
      {"G31 goes its whole way in 1/F minutes", "haas", "G93G31X50.F2.",
       "skip 50.000 0.000 0.000 F100"},
  };
  expect_last_moves(kCases);
}

TEST(InverseTime, OfAnArcIsTheFeedOverTheRadiusOrTheTime) {
  constexpr LastMoveOn kCases[] = {
      {"the radius, 10", "fanuc-16i", "G93G2X10.Y10.R10.F5.",
       "arc cw 10.000 10.000 0.000 centre X10.000 Y0.000 F50"},
      {"a full circle as well", "meldas", "G93G3I10.F5.",
       "arc ccw 0.000 0.000 0.000 centre X10.000 Y0.000 F50"},
      {"a quarter of 62.832 mm five times in a minute", "haas", "G93G2X10.Y10.R10.F5.",
       "arc cw 10.000 10.000 0.000 centre X10.000 Y0.000 F78.5398"},
      {"62.832 mm", "haas", "G93G3I10.F5.",
       "arc ccw 0.000 0.000 0.000 centre X10.000 Y0.000 F314.159"},
      {"a helix along its plane", "haas", "G93G3I10.Z7.F5.",
       "arc ccw 0.000 0.000 7.000 centre X10.000 Y0.000 F314.159"},
  };
  expect_last_moves(kCases);
}

TEST(InverseTime, CountsForFeedsOnly) {
  ControlRun run("fanuc-16i", "G93G0X10.\nG1X60.F2.\nG0X0\nG94G1X10.F100.\n#100=#4005\n#101=#4109");
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.machine().log(),
            (Lines{"move 10.000 0.000 0.000 rapid", "move 60.000 0.000 0.000 F100",
                   "move 0.000 0.000 0.000 rapid", "move 10.000 0.000 0.000 F100"}));
  EXPECT_EQ(run.value("#100"), 94.0);
  EXPECT_EQ(run.value("#101"), 100.0);
  ControlRun modal("fanuc-16i", "G93G1X60.F2.5\n#100=#4005\n#101=#4109");
  EXPECT_EQ(modal.value("#100"), 93.0);
  EXPECT_EQ(modal.value("#101"), 2.5);
}

TEST(InverseTime, OverrideChangesTheTime) {
  runtime::ControlSetup setup;
  setup.feed_switches.override_percent = 50.0;
  constexpr LastMoveOn kCases[] = {
      {"half as fast", "fanuc-16i", "G93G1X50.F2.", "move 50.000 0.000 0.000 F50"}};
  expect_last_moves(kCases, setup);
}

/// The example of the M700V programming manual, 7.5, with its table: beside the contour the tool
/// goes at 550, 450 and 550 mm/min, so that the contour is cut at 500.
TEST(InverseTime, BesideTheContourAnArcTakesTheSameTime) {
  runtime::ControlSetup setup;
  setup.tools[11] = {0.0, 0.0, 10.0, 0.0};
  ControlRun run("meldas",
                 "G90G0X60.Y-80.\nG1G41X80.Y-80.D11F500\nX180.\nG93G2Y-280.R100.F5\n"
                 "G3Y-480.R100.F5\nG2Y-680.R100.F5\nG94G1X80.F500\nG40X0",
                 setup);
  EXPECT_EQ(run.alarm(), 0);
  Lines feeds;
  for (const std::string& line : run.machine().log()) {
    if (line.starts_with("arc")) {
      feeds.push_back(line.substr(line.rfind(' ') + 1));
    }
  }
  EXPECT_EQ(feeds, (Lines{"F550", "F450", "F550"}));
  EXPECT_TRUE(run.machine().log().back().ends_with(" F500"));
}

TEST(InverseTime, ACornerGoesOnAtTheFeedInFrontOfIt) {
  ControlRun run("fanuc-16i", "G93G1X50.F2.,C5.\nY50.F4.");
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.machine().log(),
            (Lines{"move 45.000 0.000 0.000 F100", "move 50.000 5.000 0.000 F100",
                   "move 50.000 50.000 0.000 F200"}));
}

TEST(InverseTime, WhatItDoesNotTakeIsAnAlarm) {
  struct Wrong {
    const char* name;
    const char* control;
    const char* program;
    int alarm;
  };
  constexpr Wrong kCases[] = {
      {"no F", "fanuc-16i", "G93G1X10.", 11},
      {"no F, 30i", "fanuc-30i", "G93G1X10.", 1202},
      {"no F, MELDAS", "meldas", "G93G1X10.", 62},
      {"F of the block before", "fanuc-30i", "G93G1X10.F2.\nX20.", 1202},
      {"F in a block of its own", "fanuc-30i", "G93F2.\nG1X20.", 1202},
      {"the feed from before", "fanuc-16i", "F100.\nG93G1X10.", 11},
      {"an arc, too", "fanuc-30i", "G93G2X10.R5.", 1202},
      {"F0", "meldas", "G93G1X10.F0", 62},
      {"less than a thousandth", "fanuc-16i", "#1=.0009\nG93G1X10.F#1", 11},
      {"too much", "fanuc-16i", "G93G1X10.F10000.", 3},
      {"too much, MELDAS", "meldas", "G93G1X10.F1000000.", 35},
      {"G94 has no feed from G93", "meldas", "G93G1X10.F2.\nG94X20.", 62},
      {"neither has G95", "fanuc-16i", "S100\nG93G1X10.F2.\nG95X20.", 11},
      {"a canned cycle", "fanuc-16i", "G93G81X10.Z-5.R1.F2.", 10},
      {"a canned cycle, MELDAS", "meldas", "G93G81X10.Z-5.R1.F2.", 125},
      {"in a canned cycle", "meldas", "G81X10.Z-5.R1.F200\nG93X20.F2.", 125},
      {"G31, MELDAS", "meldas", "G93G31X10.F2.", 125},
      {"G36", "haas", "G93G36X10.F2.", 10},
  };
  for (const Wrong& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(ControlRun(c.control, c.program).alarm(), c.alarm);
  }
  EXPECT_EQ(ControlRun("meldas", "G93G1X10.F9999.999").alarm(), 0);
  EXPECT_EQ(ControlRun("fanuc-16i", "G93G1X10.F9999.999").alarm(), 0);
}

}  // namespace
}  // namespace g31::fanuc::inverse_time_test

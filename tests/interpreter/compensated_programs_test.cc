#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::testing::compensated_programs_test {
namespace {

using Lines = std::vector<std::string>;

/// Along the X axis to (0, 0), the tool on the left of the path.
const std::string kAlongX = "G90 G17 G0 X-30. Y0.\nG41 D1 G1 X-20. F100.\nX0.\n";

runtime::ControlSetup radius(double geometry_mm, double wear_mm = 0.0) {
  runtime::ControlSetup setup;
  setup.tools[1] = {120.0, 0.0, geometry_mm, wear_mm};
  return setup;
}

/// The moves after the two that lead to the start of the line along X.
Lines moves(const std::string& blocks, const runtime::ControlSetup& setup = radius(5.0)) {
  const ControlRun run("fanuc-16i", kAlongX + blocks, setup);
  EXPECT_EQ(run.alarm(), 0);
  const Lines& log = run.machine().log();
  EXPECT_EQ(log.front(), "move -30.000 0.000 0.000 rapid");
  return {log.begin() + 2, log.end()};
}

TEST(CompensatedProgram, RadiusIsGeometryAndWearOfD) {
  EXPECT_EQ(moves("Y20.", radius(5.5, -0.5)),
            (Lines{"move -5.000 5.000 0.000 F100", "move -5.000 20.000 0.000 F100"}));
}

TEST(CompensatedProgram, OffsetMayComeFromItsVariables) {
  EXPECT_EQ(moves("Y20.", {}).back(), "move 0.000 20.000 0.000 F100");
  const ControlRun run("fanuc-16i", "#13001=4.\n#12001=1.\n" + kAlongX + "Y20.");
  EXPECT_EQ(run.machine().log().back(), "move -5.000 20.000 0.000 F100");
}

TEST(CompensatedProgram, NegativeRadiusIsTheOtherSide) {
  EXPECT_EQ(moves("Y20.", radius(-5.0)),
            (Lines{"move 5.000 -5.000 0.000 F100", "move 5.000 20.000 0.000 F100"}));
  EXPECT_EQ(moves("G42 D1 Y20.", radius(-5.0)).back(), "move -5.000 20.000 0.000 F100");
}

TEST(CompensatedProgram, PlanesOfG18AndG19) {
  const ControlRun zx("fanuc-16i", "G18 G0 Z-30.\nG41 D1 G1 Z-20. F100.\nZ0.\nX20.", radius(5.0));
  EXPECT_EQ(zx.machine().log().back(), "move 20.000 0.000 -5.000 F100");
  const ControlRun yz("fanuc-16i",
                      "G19 G0 Y-30.\nG41 D1 G1 Y-20. F100.\nY0.\nG3 Y-13. Z13. J-13. K0.",
                      radius(5.0));
  EXPECT_EQ(yz.machine().log().back(), "arc ccw 0.000 -13.000 8.000 centre Y-13.000 Z0.000 F100");
}

TEST(CompensatedProgram, ParametersTakeEffect) {
  struct Case {
    const char* name;
    const char* parameter;
    double value;
    std::string blocks;
    Lines expected;
  };
  const Case kCases[] = {
      {"5003.0 = 0: cancel straight from beside the end",
       "5003.0",
       0.0,
       "G40 Y-20.",
       {"move 0.000 5.000 0.000 F100", "move 0.000 -20.000 0.000 F100"}},
      {"5003.0 = 1: cancel around the corner",
       "5003.0",
       1.0,
       "G40 Y-20.",
       {"move 5.000 5.000 0.000 F100", "move 5.000 0.000 0.000 F100",
        "move 0.000 -20.000 0.000 F100"}},
      {"5010: the second point is too near",
       "5010",
       5.1,
       "X-20. Y-20.",
       {"move 5.000 5.000 0.000 F100", "move -16.464 -23.536 0.000 F100"}},
      {"19625 = 0: one block is read past, two are not",
       "19625",
       0.0,
       "S100\nS200\nY20.",
       {"move 0.000 5.000 0.000 F100", "move -5.000 20.000 0.000 F100"}},
      {"19625 = 4: two blocks are read past",
       "19625",
       4.0,
       "S100\nS200\nY20.",
       {"move -5.000 5.000 0.000 F100", "move -5.000 20.000 0.000 F100"}},
      {"5008.0 = 1: backwards without an alarm",
       "5008.0",
       1.0,
       "Y8.\nX-20.",
       {"move -5.000 5.000 0.000 F100", "move -5.000 3.000 0.000 F100",
        "move -20.000 3.000 0.000 F100"}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    runtime::ControlSetup setup = radius(5.0);
    setup.parameters[c.parameter] = c.value;
    EXPECT_EQ(moves(c.blocks, setup), c.expected);
  }
}

TEST(CompensatedProgram, MeldasReadsFiveBlocks) {
  const std::string program = kAlongX + "S100\nS200\nS300\nY20.";
  const ControlRun meldas("meldas", program, radius(5.0));
  EXPECT_EQ(meldas.machine().log()[2], "move -5.000 5.000 0.000 F100");
  const ControlRun fanuc("fanuc-16i", program, radius(5.0));
  EXPECT_EQ(fanuc.machine().log()[2], "move 0.000 5.000 0.000 F100");
}

TEST(CompensatedProgram, WhatEndsTheReadAhead) {
  struct Case {
    const char* name;
    std::string block;
    const char* corner;
  };
  const Case kCases[] = {
      {"an ordinary M code does not", "M8", "move -5.000 5.000 0.000 F100"},
      {"macro statements do not, however many", "#1=1\n#2=2\nIF [#1 EQ 1] GOTO 5\nN5 #3=#5021",
       "move -5.000 5.000 0.000 F100"},
      {"a macro call does not", "M98 P9001", "move -5.000 5.000 0.000 F100"},
      {"a dwell does not", "G4 P500", "move -5.000 5.000 0.000 F100"},
      {"G10", "G10 L2 P1 Z1.", "move 0.000 5.000 0.000 F100"},
      {"M00", "M0", "move 0.000 5.000 0.000 F100"},
      {"M01", "M1", "move 0.000 5.000 0.000 F100"},
      {"#3006", "#3006=1(LOOK)", "move 0.000 5.000 0.000 F100"},
      {"an M code of parameter 3411", "M50", "move 0.000 5.000 0.000 F100"},
      {"an M code between 3421 and 3422", "M61", "move 0.000 5.000 0.000 F100"},
      {"an M code outside of them", "M63", "move -5.000 5.000 0.000 F100"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    runtime::ControlSetup setup = radius(5.0);
    setup.parameters = {{"3411", 50.0}, {"3421", 60.0}, {"3422", 62.0}};
    const ControlRun run("fanuc-16i", kAlongX + c.block + "\nY20.\nM30\nO9001\nM99", setup);
    ASSERT_EQ(run.alarm(), 0);
    EXPECT_EQ(run.machine().log()[2], c.corner);
  }
}

TEST(CompensatedProgram, LastBlockIsDoneBeforeTheEndAndBeforeAMacroAlarm) {
  EXPECT_EQ(moves(""), (Lines{"move 0.000 5.000 0.000 F100"}));
  const ControlRun run("fanuc-16i", kAlongX + "#3000=1(STOP)", radius(5.0));
  EXPECT_EQ(run.alarm(), 3001);
  EXPECT_EQ(run.machine().log().back(), "move 0.000 5.000 0.000 F100");
}

TEST(CompensatedProgram, PositionVariables) {
  ControlRun run("fanuc-16i",
                 "G10 L2 P1 X100.\n" + kAlongX +
                     "#101=#5001\n#102=#5002\n#103=#5021\n#104=#5022\n#105=#5041\n#106=#5042\nY20.",
                 radius(5.0));
  EXPECT_EQ(run.machine().log()[2], "move 95.000 5.000 0.000 F100");
  const double expected[] = {0.0, 0.0, 100.0, 5.0, 0.0, 5.0};
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(run.value("#" + std::to_string(101 + i)).value(), expected[i], 1e-9) << i;
  }
}

TEST(CompensatedProgram, DwellAndOtherAxesAreAtTheCorner) {
  EXPECT_EQ(moves("G4 P500\nX-20. Y-20."),
            (Lines{"move 5.000 5.000 0.000 F100", "dwell 0.5", "move 7.071 0.000 0.000 F100",
                   "move -16.464 -23.536 0.000 F100"}));
  EXPECT_EQ(moves("Z-3.\nY20."),
            (Lines{"move -5.000 5.000 0.000 F100", "move -5.000 5.000 -3.000 F100",
                   "move -5.000 20.000 -3.000 F100"}));
}

TEST(CompensatedProgram, FeedOfACornerLineIsThatOfTheBlockBehindIt) {
  EXPECT_EQ(moves("X-20. Y-20. F200."),
            (Lines{"move 5.000 5.000 0.000 F100", "move 7.071 0.000 0.000 F200",
                   "move -16.464 -23.536 0.000 F200"}));
}

TEST(CompensatedProgram, CancelAloneAndD0) {
  const Lines expected{"move 0.000 5.000 0.000 F100", "move 0.000 5.000 10.000 F100",
                       "move 0.000 20.000 10.000 F100"};
  EXPECT_EQ(moves("G40\nZ10.\nY20."), expected);
  EXPECT_EQ(moves("G40 Z10.\nY20."), expected);
  EXPECT_EQ(moves("D0\nZ10.\nY20."), expected);
  EXPECT_EQ(moves("G40 Y20.\nX1."),
            (Lines{"move 0.000 5.000 0.000 F100", "move 0.000 20.000 0.000 F100",
                   "move 1.000 20.000 0.000 F100"}));
}

TEST(CompensatedProgram, MirroredPathHasThePartOnTheOtherSide) {
  const ControlRun run("fanuc-16i", "G51.1 Y0.\n" + kAlongX + "Y20.\nG3 X-13. Y33. I-13. J0.",
                       radius(5.0));
  ASSERT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.machine().log()[2], "move -5.000 -5.000 0.000 F100");
  EXPECT_EQ(run.machine().log().back(),
            "arc cw -13.000 -28.000 0.000 centre X-13.000 Y-20.000 F100");
}

TEST(CompensatedProgram, TurnedPathIsCompensatedBehindTheRotation) {
  const ControlRun run("fanuc-16i", "G68 X0. Y0. R90.\n" + kAlongX + "Y20.", radius(5.0));
  ASSERT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.machine().log()[2], "move -5.000 -5.000 0.000 F100");
  EXPECT_EQ(run.machine().log().back(), "move -20.000 -5.000 0.000 F100");
}

TEST(CompensatedProgram, Alarms) {
  struct Case {
    const char* name;
    std::string blocks;
    int number;
    int meldas;
    int line;
  };
  const Case kCases[] = {
      {"start-up on an arc", "G41 D1 G2 X10. Y10. J10. F100.", 34, 151, 2},
      {"cancel on an arc", kAlongX + "G40 G3 X5. Y5. J5.", 34, 151, 5},
      {"offset arcs do not meet",
       "G0 X-20. Y-13.\nG41 D1 G1 X0. F100.\nG3 X12. Y5. J13.\nG3 X24. Y-13. I12. J-5.", 33, 152,
       5},
      {"another plane", kAlongX + "G18", 37, 112, 5},
      {"arc of the tool's size", kAlongX + "G3 X5. Y5. J5.", 38, 153, 5},
      {"arc smaller than the tool", kAlongX + "G3 X4. Y4. J4.", 41, 153, 5},
      {"narrow groove: at the block that cannot be cut", kAlongX + "Y8.\nX-20.", 41, 153, 5},
      {"G31", kAlongX + "G31 X5.", 35, 608, 5},
      {"G28", kAlongX + "G28 X5.", 35, 608, 5},
      {"G30", kAlongX + "G30 X5.", 35, 608, 5},
      {"G53", kAlongX + "G53 X5.", 35, 608, 5},
      {"G37", kAlongX + "H1\nG37 Z5.", 35, 608, 6},
      {"canned cycle", kAlongX + "G81 X5. Z-5. R1.", 35, 608, 5},
      {"D beyond the table", "G41 D1000 G1 X0. F100.", 30, 170, 2},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const ControlRun fanuc("fanuc-16i", c.blocks, radius(5.0));
    EXPECT_EQ(fanuc.alarm(), c.number);
    EXPECT_EQ(ControlRun("fanuc-30i", c.blocks, radius(5.0)).alarm(), c.number);
    EXPECT_EQ(ControlRun("meldas", c.blocks, radius(5.0)).alarm(), c.meldas);
    ASSERT_TRUE(fanuc.outcome().alarm.has_value());
    EXPECT_EQ(fanuc.line_of(fanuc.outcome().alarm->where), c.line);
  }
}

TEST(CompensatedProgram, SkipAfterG40InItsBlockStartsWhereTheToolStands) {
  EXPECT_EQ(moves("G40 G31 Y-10."),
            (Lines{"move 0.000 5.000 0.000 F100", "skip 0.000 -10.000 0.000 F100"}));
}

TEST(CompensatedProgram, DThatTheSheetDoesNotHaveIsAMismatch) {
  const ControlRun run("fanuc-16i", "G41 D2 G1 X0. F100.", radius(5.0));
  EXPECT_EQ(run.outcome().status, runtime::Status::Setup);
}

}  // namespace
}  // namespace g31::testing::compensated_programs_test

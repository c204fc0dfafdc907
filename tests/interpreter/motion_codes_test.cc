// Motion, dwell, reference points, coordinate settings and data input: MB-255 to MB-317 apart from
// transforms and canned cycles.

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::fanuc::motion_codes_test {
namespace {

using testing::ControlRun;

AxisPositions at(double x, double y, double z) {
  AxisPositions q = AxisPositions::Zero();
  q.head<3>() << x, y, z;
  return q;
}

struct Case {
  const char* name;
  const char* program;
  std::vector<std::string> log;  ///< all that the machine was asked for
};

void expect_logs(std::span<const Case> cases, const runtime::ControlSetup& setup = {}) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    ControlRun run("fanuc-16i", c.program, setup);
    EXPECT_EQ(run.alarm(), 0);
    EXPECT_EQ(run.machine().log(), c.log);
  }
}

TEST(ReferencePoints, AreReachedThroughAnIntermediatePoint) {
  runtime::ControlSetup setup;
  setup.parameters = {
      {"1240.X", 1.0}, {"1240.Z", 3.0}, {"1241.Z", -50.0}, {"1242", 7.0}, {"1243", 8.0}};
  const Case kCases[] = {
      {"G28 moves the named axes",
       "G28X20.",
       {"move 20.000 0.000 0.000 rapid", "move 1.000 0.000 0.000 rapid"}},
      {"without axes nothing moves", "G28", {}},
      {"G91 G28 Z0 goes straight up",
       "G91G28Z0",
       {"move 0.000 0.000 0.000 rapid", "move 0.000 0.000 3.000 rapid"}},
      {"G30 is the second point",
       "G30Z10.",
       {"move 0.000 0.000 10.000 rapid", "move 0.000 0.000 -50.000 rapid"}},
      {"G30 P3", "G30P3X0Y0", {"move 0.000 0.000 0.000 rapid", "move 7.000 7.000 0.000 rapid"}},
      {"G30 P4", "G30P4Y0", {"move 0.000 0.000 0.000 rapid", "move 0.000 8.000 0.000 rapid"}},
      {"an axis without a value of its own stands at 0",
       "G28Y5.",
       {"move 0.000 5.000 0.000 rapid", "move 0.000 0.000 0.000 rapid"}},
      {"G29 comes back through the point of G28",
       "G28X20.\nG29X30.",
       {"move 20.000 0.000 0.000 rapid", "move 1.000 0.000 0.000 rapid",
        "move 20.000 0.000 0.000 rapid", "move 30.000 0.000 0.000 rapid"}},
      {"under G91 its end counts from that point",
       "G28X20.\nG91G29X5.",
       {"move 20.000 0.000 0.000 rapid", "move 1.000 0.000 0.000 rapid",
        "move 20.000 0.000 0.000 rapid", "move 25.000 0.000 0.000 rapid"}},
      {"that point moves with the work offset",
       "G28X20.\nG10L2P1X100.\nG29X30.",
       {"move 20.000 0.000 0.000 rapid", "move 1.000 0.000 0.000 rapid",
        "move 120.000 0.000 0.000 rapid", "move 130.000 0.000 0.000 rapid"}},
      {"G27 at the point is content", "G27X1.", {"move 1.000 0.000 0.000 rapid"}},
  };
  expect_logs(kCases, setup);
}

TEST(ReferencePoints, AreThoseOfTheMachineUnlessParametersSayOtherwise) {
  runtime::ControlSetup setup;
  setup.q_M_reference = at(0.0, 0.0, 100.0);
  const Case marks[] = {{"the machine's",
                         "G91G28Z0",
                         {"move 0.000 0.000 0.000 rapid", "move 0.000 0.000 100.000 rapid"}}};
  expect_logs(marks, setup);
  setup.parameters["1240"] = 5.0;
  const Case parameters[] = {{"the parameter's",
                              "G91G28Z0",
                              {"move 0.000 0.000 0.000 rapid", "move 0.000 0.000 5.000 rapid"}}};
  expect_logs(parameters, setup);
}

TEST(Arcs, LieInThePlaneInForce) {
  const Case kCases[] = {
      {"XY", "G3X10.Y10.J10.F100", {"arc ccw 10.000 10.000 0.000 centre X0.000 Y10.000 F100"}},
      {"ZX", "G18G3Z10.X10.I10.F100", {"arc ccw 10.000 0.000 10.000 centre Z0.000 X10.000 F100"}},
      {"YZ", "G19G3Y10.Z10.K10.F100", {"arc ccw 0.000 10.000 10.000 centre Y0.000 Z10.000 F100"}},
      {"a third axis makes a helix",
       "G3X10.Y10.Z4.J10.F100",
       {"arc ccw 10.000 10.000 4.000 centre X0.000 Y10.000 F100"}},
      {"a missing distance is 0",
       "G2X20.I10.F100",
       {"arc cw 20.000 0.000 0.000 centre X10.000 Y0.000 F100"}},
      {"distances are incremental under G90 as well",
       "G0X5.\nG2X25.I10.F100",
       {"move 5.000 0.000 0.000 rapid", "arc cw 25.000 0.000 0.000 centre X15.000 Y0.000 F100"}},
      {"the shorter way with R above 0",
       "G2X10.Y10.R10.F100",
       {"arc cw 10.000 10.000 0.000 centre X10.000 Y0.000 F100"}},
      {"the longer way with R below 0",
       "G2X10.Y10.R-10.F100",
       {"arc cw 10.000 10.000 0.000 centre X0.000 Y10.000 F100"}},
      {"R wins over I J",
       "G2X10.Y10.R10.I3.J4.F100",
       {"arc cw 10.000 10.000 0.000 centre X10.000 Y0.000 F100"}},
      {"a full circle by I",
       "G2X0Y0I10.F100",
       {"arc cw 0.000 0.000 0.000 centre X10.000 Y0.000 F100"}},
      {"by R to where it stands: no arc", "G2X0Y0R10.F100", {"move 0.000 0.000 0.000 F100"}},
      {"neither R nor I J: a line", "G2X10.F100", {"move 10.000 0.000 0.000 F100"}},
      {"a radius that differs within 3410",
       "G2X10.Y0I5.004F100",
       {"arc cw 10.000 0.000 0.000 centre X5.004 Y0.000 F100"}},
  };
  expect_logs(kCases);
}

TEST(Arcs, AreNotCheckedWithTolerance0) {
  runtime::ControlSetup setup;
  setup.parameters["3410"] = 0.0;
  const Case kCases[] = {
      {"any radius", "G2X10.Y0I7.F100", {"arc cw 10.000 0.000 0.000 centre X7.000 Y0.000 F100"}}};
  expect_logs(kCases, setup);
}

TEST(Feed, IsPerMinuteOrPerTurn) {
  const Case kCases[] = {
      {"per minute", "G94G1X1.F120.", {"move 1.000 0.000 0.000 F120"}},
      {"per turn of the spindle", "G95S600G1X1.F0.2", {"move 1.000 0.000 0.000 F120"}},
      {"per turn, counted in hundredths", "G95S600G1X1.F20", {"move 1.000 0.000 0.000 F120"}},
      {"per turn of a speed that comes later",
       "G95G1F0.1\nS1000X1.",
       {"move 1.000 0.000 0.000 F100"}},
      {"in inches", "G20G1X1.F10.", {"move 25.400 0.000 0.000 F254"}},
      {"exact stop in one block is still its motion",
       "G9G1X1.F100",
       {"move 1.000 0.000 0.000 F100"}},
      {"so are the modes of the corner",
       "G61G1X1.F100\nG62X2.\nG63X3.\nG64X4.",
       {"move 1.000 0.000 0.000 F100", "move 2.000 0.000 0.000 F100", "move 3.000 0.000 0.000 F100",
        "move 4.000 0.000 0.000 F100"}},
      {"G53 is a rapid, whatever group 01 says",
       "G10L2P1X50.\nG1G53X3.F100",
       {"move 3.000 0.000 0.000 rapid"}},
      {"G53 under G91 is nothing", "G91G53X3.", {}},
      {"G22 moves nothing", "G22X-10.Y-10.I-20.J-20.", {}},
  };
  expect_logs(kCases);
}

TEST(Feed, OfThousandthsPerTurnByParameter) {
  runtime::ControlSetup setup;
  setup.parameters["1405.1"] = 1;
  const Case kCases[] = {{"thousandths", "G95S600G1X1.F200", {"move 1.000 0.000 0.000 F120"}}};
  expect_logs(kCases, setup);
}

TEST(Dwell, CountsSecondsOrMilliseconds) {
  const Case kCases[] = {
      {"X in seconds", "G4X1.5", {"dwell 1.5"}},
      {"X counted in milliseconds", "G4X1500", {"dwell 1.5"}},
      {"U as X", "G4U0.25", {"dwell 0.25"}},
      {"P in milliseconds", "G4P250", {"dwell 0.25"}},
      {"per turn feed alone changes nothing", "G95S120G4X1.", {"dwell 1"}},
  };
  expect_logs(kCases);
}

TEST(Dwell, CountsTurnsUnderG95ByParameter) {
  runtime::ControlSetup setup;
  setup.parameters["3405.1"] = 1;
  const Case kCases[] = {
      {"two turns of 120 a minute", "G95S120G4X2.", {"dwell 1"}},
      {"not under G94", "S120G4X2.", {"dwell 2"}},
  };
  expect_logs(kCases, setup);
  EXPECT_EQ(ControlRun("fanuc-16i", "G95G4X2.", setup).alarm(), 11);
}

TEST(Coordinates, AreShiftedByTheirCodes) {
  const Case kCases[] = {
      {"G52 shifts every system",
       "G10L2P2X50.\nG52X10.\nG55G0X0",
       {"move 60.000 0.000 0.000 rapid"}},
      {"a second G52 replaces the first",
       "G52X10.\nG52X4.\nG0X0",
       {"move 4.000 0.000 0.000 rapid"}},
      {"G52 X0 ends it", "G52X10.\nG52X0\nG0X0Y1.", {"move 0.000 1.000 0.000 rapid"}},
      {"G92 declares the present point",
       "G0X10.\nG92X3.\nG0X4.",
       {"move 10.000 0.000 0.000 rapid", "move 11.000 0.000 0.000 rapid"}},
      {"G92 shifts every system",
       "G10L2P2X50.\nG0X10.\nG92X0\nG55G0X0",
       {"move 10.000 0.000 0.000 rapid", "move 60.000 0.000 0.000 rapid"}},
      {"G92 takes G52 over",
       "G52X10.\nG0X0\nG92X5.\nG52X0\nG0X5.",
       {"move 10.000 0.000 0.000 rapid", "move 10.000 0.000 0.000 rapid"}},
      {"G92.1 takes both away",
       "G52X10.\nG0X0\nG92X5.\nG92.1X0\nG0X5.",
       {"move 10.000 0.000 0.000 rapid", "move 5.000 0.000 0.000 rapid"}},
      {"G92.1 only of the named axes",
       "G52X10.Y20.\nG92.1X0\nG0X0Y0",
       {"move 0.000 20.000 0.000 rapid"}},
      {"G54 P is G54.1", "#7001=7.\nG54P1G0X0", {"move 7.000 0.000 0.000 rapid"}},
      {"the external offset counts in all",
       "G10L2P0X1.\nG10L2P3X2.\nG56G0X0",
       {"move 3.000 0.000 0.000 rapid"}},
      {"G44 subtracts", "#11002=30.\nG44H2G0Z100.", {"move 0.000 0.000 70.000 rapid"}},
      {"G49 alone moves down by the length",
       "#11002=30.\nG43H2G0Z10.\nG49\nX5.",
       {"move 0.000 0.000 40.000 rapid", "move 0.000 0.000 10.000 rapid",
        "move 5.000 0.000 10.000 rapid"}},
      {"G43 alone and another H move by the change, at the feed under G1",
       "#11001=20.\n#11002=30.\nG43H1\nG1F50\nH2",
       {"move 0.000 0.000 20.000 rapid", "move 0.000 0.000 30.000 F50"}},
      {"the same H again moves nothing",
       "#11002=30.\nG43H2\nG43H2\nH2",
       {"move 0.000 0.000 30.000 rapid"}},
      {"beside a code of its own it waits for the next move",
       "#11002=30.\nG43H2G4P10\nX1.",
       {"dwell 0.01", "move 1.000 0.000 30.000 rapid"}},
      {"along an arc, too", "#11002=30.\nG2F50\nG43H2\nG0X1.", {"move 1.000 0.000 30.000 rapid"}},
  };
  expect_logs(kCases);
}

TEST(Skip, ListensToTheSignalsThatExist) {
  const Case plain[] = {
      {"P99 as without P", "G31P99X10.F100", {"skip 10.000 0.000 0.000 F100"}},
      {"P98 is a plain move", "G31P98X10.F100", {"move 10.000 0.000 0.000 F100"}}};
  expect_logs(plain);
  runtime::ControlSetup setup;
  setup.parameters = {{"6202.0", 1}, {"6204", 4}};
  const Case selected[] = {{"P1 by a bit", "G31P1X10.F100", {"skip 10.000 0.000 0.000 F100"}},
                           {"P3 by a value", "G31P3X10.F100", {"skip 10.000 0.000 0.000 F100"}}};
  expect_logs(selected, setup);
  EXPECT_EQ(ControlRun("fanuc-16i", "G31P2X10.F100", setup).alarm(), 370);
  EXPECT_EQ(ControlRun("fanuc-16i", "G31P5X10.F100", setup).alarm(), 370);
  EXPECT_EQ(ControlRun("fanuc-16i", "G31P1X10.F100").alarm(), 370);
  EXPECT_EQ(ControlRun("fanuc-16i", "G31P98X10.Y1.F100").alarm(), 369);
}

TEST(Skip, LeavesWhatTheMacroReads) {
  struct Read {
    const char* name;
    const char* program;
    double value;  ///< of #100
  };
  const Read kCases[] = {
      {"the skip position in work coordinates", "G10L2P1X5.\nG31X50.F100\n#100=#5061", 25.0},
      {"an axis that was not named", "G0Y7.\nG31X50.F100\n#100=#5062", 4.0},
      {"an incremental move goes on from the stop", "G31X50.F100\nG91G0X1.\n#100=#5041", 31.0},
      {"an absolute one goes to its point", "G31X50.F100\nG0X1.\n#100=#5041", 1.0},
      {"group 01 stays", "G0\nG31X50.F100\n#100=#4001", 0.0},
      {"F is modal", "F50\nG31X50.F100\n#100=#4109", 100.0},
  };
  for (const Read& c : kCases) {
    SCOPED_TRACE(c.name);
    ControlRun run("fanuc-16i", c.program, {}, {at(30.0, 4.0, 0.0)});
    EXPECT_EQ(run.alarm(), 0);
    ASSERT_TRUE(run.value("#100").has_value());
    EXPECT_NEAR(*run.value("#100"), c.value, 1e-12);
  }
}

TEST(DataInput, SetsParameters) {
  struct Effect {
    const char* name;
    const char* program;
    double value;  ///< of #100
  };
  const Effect kCases[] = {
      {"a value counts least increments", "G10L50\nN1240R-5000\nG11\nG28X0\n#100=#5021", -5.0},
      {"a value with a point", "G10L50\nN1240R-5.5\nG11\nG28X0\n#100=#5021", -5.5},
      {"of one axis", "G10L50\nN1240P2R3.\nG11\nG28X0Y0\n#100=#5021*10+#5022", 3.0},
      {"bits are digits, bit 0 the last", "G10L50\nN3401R00000001\nG11\nG0X3\n#100=#5021", 3.0},
      {"a bit that is 0 goes off", "G10L50\nN6004R1\nN6004R0\nG11\n#100=ATAN[-1]/[-1]", 225.0},
      {"a call by code", "G10L50\nN6050R111\nG11\nG111\n#100=1\nM30\nO9010\n#500=1\nM99", 1.0},
      {"what follows G11 is a block again", "G10L50\nG11\nG0X2.\n#100=#5021", 2.0},
  };
  for (const Effect& c : kCases) {
    SCOPED_TRACE(c.name);
    ControlRun run("fanuc-16i", c.program);
    EXPECT_EQ(run.alarm(), 0);
    ASSERT_TRUE(run.value("#100").has_value());
    EXPECT_NEAR(*run.value("#100"), c.value, 1e-12);
  }
}

TEST(DataInput, PassesOverToolLifeWithAWarning) {
  ControlRun run("fanuc-16i", "G10L3P1\nP1L50\nT1H1D1\nG11\nG0X2.\n#100=#4120");
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.value("#100"), 0);
  EXPECT_EQ(run.machine().log().size(), 1u);
  ASSERT_EQ(run.outcome().diagnostics.size(), 1u);
  EXPECT_EQ(run.outcome().diagnostics[0].code, "PRB304");
}

TEST(NotSimulated, IsSaidOnceForEachThing) {
  ControlRun run("haas", "G12X1.\nG13X1.\nG12X1.");
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.outcome().diagnostics.size(), 2u);
}

TEST(ModalGroups, ShowTheCodesOfTheseFunctions) {
  struct Shown {
    const char* program;
    const char* variable;
    double value;
  };
  const Shown kCases[] = {
      {"G18", "#4002", 18}, {"G23", "#4004", 23}, {"G95", "#4005", 95}, {"G99", "#4010", 99},
      {"G96", "#4013", 96}, {"G61", "#4015", 61}, {"G63", "#4015", 63}, {"G9", "#4015", 64},
  };
  for (const Shown& c : kCases) {
    SCOPED_TRACE(c.program);
    ControlRun run("fanuc-16i", c.program);
    EXPECT_EQ(run.value(c.variable), c.value);
  }
}

TEST(MotionCodes, AreRefusedWithTheControlsAlarm) {
  struct Refused {
    const char* name;
    const char* control;
    const char* program;
    int alarm;
  };
  const Refused kCases[] = {
      {"G27 off the reference point", "fanuc-16i", "G27X5.", 92},
      {"G30 has points 2 to 4", "fanuc-16i", "G30P5X0", 46},
      {"G29 before any G28", "fanuc-16i", "G29X5.", 305},
      {"G29 of an axis that had none", "fanuc-16i", "G28X0\nG29X5.Y5.", 305},
      {"end farther than twice R", "fanuc-16i", "G2X10.R4.F100", 20},
      {"radii that differ", "fanuc-16i", "G2X10.I5.02F100", 20},
      {"a centre outside the plane", "fanuc-16i", "G2X10.I5.K1.F100", 21},
      {"per turn without a speed", "fanuc-16i", "G95G1X1.F0.2", 11},
      {"an arc without feed", "fanuc-16i", "G2X10.R5.", 11},
      {"a dwell below 0", "fanuc-16i", "G4X-1.", 6},
      {"a dwell P with a point", "fanuc-16i", "G4P1.5", 7},
      {"G10 L2 beyond G59", "fanuc-16i", "G10L2P7X1.", 31},
      {"G10 L20 P0", "fanuc-16i", "G10L20P0X1.", 31},
      {"an offset number out of the table", "fanuc-16i", "G10L10P1000R1.", 31},
      {"an offset that is too long", "fanuc-16i", "G10L10P1R1000.", 32},
      {"the series 30i takes it", "fanuc-30i", "G10L10P1R1000.", 0},
      {"not ten times that", "fanuc-30i", "G10L10P1R10000.", 32},
      {"in inches", "fanuc-16i", "G20\nG10L10P1R100.", 32},
      {"under G91 the sum counts", "fanuc-16i", "G10L10P1R600.\nG91G10L10P1R600.", 32},
      {"no P", "fanuc-16i", "G10L10R1.", 31},
      {"no P on the series 30i", "fanuc-30i", "G10L10R1.", 1144},
      {"no such L", "fanuc-30i", "G10L77P1R1.", 1144},
      {"a parameter block without N", "fanuc-30i", "G10L50\nR1", 1144},
      {"other words in it", "fanuc-30i", "G10L50\nN3410R1X1.", 1144},
      {"bits that are none", "fanuc-30i", "G10L50\nN3401R2", 1144},
      {"a code that no group has", "fanuc-16i", "G199", 10},
  };
  for (const Refused& c : kCases) {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(ControlRun(c.control, c.program).alarm(), c.alarm);
  }
}

TEST(MotionCodes, AnArcNeedsItsRadiusWhereTheParameterSaysSo) {
  runtime::ControlSetup setup;
  setup.parameters["3403.5"] = 1;
  EXPECT_EQ(ControlRun("fanuc-16i", "G2X10.F100", setup).alarm(), 22);
}

}  // namespace
}  // namespace g31::fanuc::motion_codes_test

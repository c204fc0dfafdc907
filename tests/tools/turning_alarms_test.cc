// CYCLE973, CYCLE974 and CYCLE994: each digit of their variants that there is none of, and every
// alarm; behind it no offset, tool or calibration is another one.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/turning_run.h"

namespace g31::testing::turning_alarms_test {
namespace {

const std::string kShaft = part("shaft", 0.0, 0.0, 200.0, "diameter = 50.04\nheight = 100.0");
const std::string kAtShaft = "G54 DIAMON G0 X100\nZ-10\n";

/// What cycles write, as the sheets have it.
std::vector<ExpectedValue> untouched() {
  return {{"$TC_DP12[2,1]", 0.0},
          {"$TC_DP3[2,1]", 90.0},
          {"$TC_DP4[1,1]", 30.0},
          {"$TC_DP3[1,1]", 100.0},
          {"$TC_DP6[1,1]", 3.0},
          {"$P_UIFR[1,X,TR]", 0.0},
          {"$P_UIFR[1,X,FI]", 0.0},
          {"$P_UIFR[1,Z,TR]", 200.0},
          {"$SNS_MEA_WP_BALL_DIAM[0]", 6.0},
          {"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]", -3.0},
          {"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]", 3.0},
          {"$SNS_MEA_WP_FEED[0]", 0.0}};
}

struct Case {
  const char* name;
  std::string program;
  int alarm = 0;
  std::string sheet = {};
};

void expect_alarms(std::span<const Case> rows, const std::string& probe = kProbeToMinusX) {
  std::vector<std::string> names = {"_OVI[9]"};
  for (const ExpectedValue& row : untouched()) {
    names.push_back(row.name);
  }
  for (const Case& row : rows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run =
        run_turning(row.program, {probe, kCalibrated, kShaft, row.sheet}, names);
    EXPECT_EQ(run.output.exit_code, 3) << run.output.errors;
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at("_OVI[9]"), row.alarm);
    for (const ExpectedValue& value : untouched()) {
      EXPECT_EQ(run.at(value.name), value.value) << value.name;
    }
  }
}

TEST(TurningAlarms, VariantsThatThereAreNot) {
  std::vector<Case> rows;
  for (const char* variant : {"3", "9", "10", "12", "300", "302", "1002", "3002", "20002", "10102",
                              "-1", "100002", "110002"}) {
    rows.push_back({variant,
                    fmt::format("{}CYCLE974({},1,1,1,50,2,3,5,,1,\"ROUGHER\")", kAtShaft, variant),
                    61307});
  }
  for (const char* variant : {"0", "3", "12", "302", "4002", "11002", "-2"}) {
    rows.push_back(
        {variant, fmt::format("{}CYCLE994({},1,1,1,50,2,9,9,3,5)", kAtShaft, variant), 61307});
  }
  for (const char* variant : {"4", "10", "3001", "2000", "2001", "2002", "22003", "100001",
                              "1001001", "1000003", "2001000", "-1"}) {
    rows.push_back(
        {variant, fmt::format("{}CYCLE973({},1,1,50,2,1,3,5)", kAtShaft, variant), 61307});
  }
  expect_alarms(rows);
}

TEST(TurningAlarms, WhatTheCallSaysWrong) {
  const std::string tool_call = "CYCLE974(202,,{},1,50,2,3,5,,1,\"{}\",{})";
  const auto corrected = [&](const char* target, const char* tool, const char* dl) {
    return kAtShaft + fmt::format(fmt::runtime(tool_call), target, tool, dl);
  };
  expect_alarms(std::vector<Case>{
      {"no measuring path", kAtShaft + "CYCLE974(2,,,1,50,2,0,5)", 61308},
      {"record 41", kAtShaft + "CYCLE974(2,,,41,50,2,3,5)", 61313},
      {"axis 4", kAtShaft + "CYCLE974(2,,,1,50,4,3,5)", 61325},
      {"axis 0", kAtShaft + "CYCLE974(2,,,1,50,0,3,5)", 61325},
      {"Y without MD52740 bit 1", kAtShaft + "CYCLE974(2,,,1,50,3,3,5)", 61325},
      {"round Y without it", kAtShaft + "CYCLE994(3002,,,1,50,2,9,9,3,5)", 61325},
      {"round the measured axis", kAtShaft + "CYCLE994(2002,,,1,50,2,9,9,3,5)", 61325},
      {"round it by S_MA", kAtShaft + "CYCLE994(2,,,1,50,202,9,9,3,5)", 61325},
      {"calibration, axis 4", kAtShaft + "CYCLE973(1001,1,1,50,4,1,3,5)", 61325},
      {"calibration, direction 2", kAtShaft + "CYCLE973(1001,1,1,50,2,2,3,5)", 61326},
      {"an offset that there is none of", kAtShaft + "CYCLE974(102,4001,,1,50,2,3,5)", 61321},
      {"no such tool", corrected("1", "NOBODY", "0"), 61343},
      {"component 5", corrected("500001", "ROUGHER", "0"), 61404},
      {"additive offset without a number", corrected("1000001", "ROUGHER", "0"), 61404},
      {"a locked tool", "$TC_TP8[2]=6\n" + corrected("1", "ROUGHER", "0"), 61404},
      {"two active tools of the name",
       "$TC_TP1[4]=2 $TC_TP8[2]=131 $TC_TP8[4]=131\n" + corrected("1", "ROUGHER", "0"), 61344,
       "[tools.4]\nname = \"ROUGHER\"\n"},
      {"a groove in G17", kAtShaft + "G17\nCYCLE973(3,1,1,,,,3,5)", 61307},
      {"a groove in G19", kAtShaft + "CYCLE973(2,1,1,,,,3,5,,,,3)", 61307},
      {"groove 4", kAtShaft + "CYCLE973(3,1,4,,,,3,5)", 61333},
      {"a groove without data", kAtShaft + "CYCLE973(3,1,1,,,,3,5)", 61333},
  });
}

const std::string kGroove =
    "[variables]\n\"$SNS_MEA_CAL_EDGE_BASE_AX2[0]\" = 5.0\n"
    "\"$SNS_MEA_CAL_EDGE_UPPER_AX2[0]\" = 20.0\n\"$SNS_MEA_CAL_EDGE_PLUS_DIR_AX1[0]\" = 120.0\n"
    "\"$SNS_MEA_CAL_EDGE_MINUS_DIR_AX1[0]\" = 80.0\n";

TEST(TurningAlarms, WhatProbeAndWorldDo) {
  const std::string measure = "CYCLE974(202,,1,1,50,2,3,5,,1,\"ROUGHER\")";
  expect_alarms(std::vector<Case>{
      {"nothing there", kAtShaft + "CYCLE974(202,,1,1,60,2,3,5,,1,\"ROUGHER\")", 61301},
      {"nothing there to calibrate on", kAtShaft + "CYCLE973(1001,1,1,60,2,1,3,5)", 61301},
      {"the way there is barred", "G54 DIAMON G0 X100 Z10\nX20\nCYCLE974(202,,1,1,-90,1,3,5)",
       61302},
      {"outside the safe area", kAtShaft + "CYCLE974(202,,1,1,50,2,3,0.03,,1,\"ROUGHER\")", 61303},
      {"outside the safe area, offset", kAtShaft + "CYCLE974(102,1,,1,50,2,3,0.03)", 61303},
      {"calibration, a safe area below the ball", kAtShaft + "CYCLE973(1001,2,1,50,2,1,3,2.9)",
       61303},
      {"another length by more than the safe area", kAtShaft + "CYCLE973(1001000,1,1,48,2,1,3,0.5)",
       61303},
      {"not calibrated", kAtShaft + "CYCLE974(202,,1,2,50,2,3,5,,1,\"ROUGHER\")", 61341},
      {"a scale", kAtShaft + "ASCALE X2\nCYCLE974(202,,1,1,50,2,3,5)", 61310},
      {"a rotation", kAtShaft + "AROT RPL=10\n" + measure, 61330},
      {"no edge", kAtShaft + "D0\n" + measure, 61311},
      {"a turning tool", kAtShaft + measure, 61309, "[tools.1]\ntype = 500.0\n"},
      {"a 710 on a lathe", "G54 DIAMON\n" + measure, 61309, "[tools.1]\ntype = 710.0\n"},
      {"a 710 to calibrate", kAtShaft + "CYCLE973(1001,1,1,50,2,1,3,5)", 61309,
       "[tools.1]\ntype = 710.0\n[machine_data]\n\"$SC_TOOL_LENGTH_CONST\" = 18\n"
       "\"$SC_TOOL_LENGTH_TYPE\" = 2\n"},
      {"edge position 3", kAtShaft + measure, 61315, "[variables]\n\"$TC_DP2[1,1]\" = 3\n"},
      {"edge position 5 in a groove", kAtShaft + "CYCLE973(3,1,1,,,,3,5)", 61315,
       kGroove + "\"$TC_DP2[1,1]\" = 5\n"},
      {"a spindle that cannot be positioned",
       kAtShaft + "CYCLE974(10202,,1,1,50,2,3,5,,1,\"ROUGHER\")", 61372,
       "[machine_data]\n\"$MCS_AXIS_USAGE_ATTRIB[3]\" = 512\n"},
      {"a spindle that is no axis of the machine",
       kAtShaft + "CYCLE974(10202,,1,1,50,2,3,5,,1,\"ROUGHER\")", 61372,
       "[machine_data]\n\"$MA_SPIND_ASSIGN_TO_MACHAX[C]\" = 0\n"},
      {"a master spindle that turns no part",
       kAtShaft + "SETMS(2)\nCYCLE974(10202,,1,1,50,2,3,5,,1,\"ROUGHER\")", 61372},
      {"both walls across the wrong axis", kAtShaft + "CYCLE973(2003,1,1,,2,,3,5)", 61325, kGroove},
      {"a length at a wall", kAtShaft + "CYCLE973(1002,1,1,,1,1,3,5)", 61325, kGroove},
      {"the bottom from below", kAtShaft + "CYCLE973(1002,1,1,,2,0,3,5)", 61326, kGroove},
  });
}

}  // namespace
}  // namespace g31::testing::turning_alarms_test

// CYCLE971: every alarm of its tables once, and nothing is written then.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"

namespace g31::testing::tool_probe_alarms_test {
namespace {

constexpr const char* kWritten[] = {"$TC_DP3[5,1]",  "$TC_DP6[5,1]", "$TC_DP12[5,1]",
                                    "$TC_DP15[5,1]", "$TC_DP3[6,1]", "$TC_DP6[6,1]",
                                    "$TC_DP12[6,1]", "$TC_DP15[6,1]"};
const std::vector<std::string> kTriggers = {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]",
                                            "$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]",
                                            "$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]",
                                            "$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]",
                                            "$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]",
                                            "$SNS_MEA_TP_TRIG_PLUS_DIR_AX3[0]",
                                            "$SNS_MEA_TP_FEED[0]"};

struct AlarmCase {
  const char* name;
  int tool;
  const char* before;
  const char* call;
  int alarm;
};

void expect_alarm(const AlarmCase& row, const std::vector<std::string>& sheets) {
  SCOPED_TRACE(row.name);
  std::vector<std::string> names(std::begin(kWritten), std::end(kWritten));
  names.insert(names.end(), kTriggers.begin(), kTriggers.end());
  const MeasuringRun kept = run_tools(with_tool(row.tool) + row.before, sheets, names);
  names.emplace_back("_OVI[9]");
  const MeasuringRun run =
      run_tools(with_tool(row.tool) + row.before + "\n" + row.call, sheets, names);
  EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
  EXPECT_EQ(run.at("_OVI[9]"), row.alarm);
  names.pop_back();
  for (const std::string& name : names) {
    EXPECT_EQ(run.at(name), kept.at(name)) << name;
  }
}

constexpr AlarmCase kOfTheCall[] = {
    {"a kind that is none", 5, "", "CYCLE971(3,0,1,1,1,0,5,2)", 61307},
    {"coordinates that are none", 5, "", "CYCLE971(21,0,1,1,1,0,5,2)", 61307},
    {"teeth of a standing tool", 5, "", "CYCLE971(101,0,1,1,1,0,5,2)", 61307},
    {"thousands", 5, "", "CYCLE971(1001,0,1,1,1,0,5,2)", 61307},
    {"incremental 2", 5, "", "CYCLE971(20001,0,1,1,1,0,5,2)", 61307},
    {"all sides of a measurement", 5, "", "CYCLE971(100001,0,1,1,1,0,5,2)", 61307},
    {"all sides, incremental", 9, "", "CYCLE971(110000,0,1,0,1,0,5,2)", 61307},
    {"reversal of a measurement", 5, "", "CYCLE971(1000001,0,1,1,1,0,5,2)", 61307},
    {"a correction that is none", 5, "", "CYCLE971(1,2,1,1,1,0,5,2)", 61307},
    {"_AMODE, units", 5, "", "CYCLE971(1,0,1,1,1,0,5,2,,,,,,,,,,,,,,3)", 61307},
    {"_AMODE, thousands", 5, "", "CYCLE971(1,0,1,1,1,0,5,2,,,,,,,,,,,,,,3000)", 61307},
    {"no measuring path", 5, "", "CYCLE971(1,0,1,1,1,0,0,2)", 61308},
    {"no scale in work coordinates", 5, "SCALE X2 Y2 Z2", "CYCLE971(11,0,1,1,1,0,5,2)", 61310},
    {"no edge", 5, "D0", "CYCLE971(1,0,1,1,1,0,5,2)", 61311},
    {"a data set that is none", 5, "", "CYCLE971(1,0,7,1,1,0,5,2)", 61313},
    {"a probe calibrates no tool probe", 5, "$TC_DP1[5,1]=710", "CYCLE971(0,0,1,1,1,0,5,2)", 61314},
    {"a turning tool", 5, "$TC_DP1[5,1]=500", "CYCLE971(1,0,1,1,1,0,5,2)", 61314},
    {"teeth that nobody counted", 6, "", "CYCLE971(102,0,1,1,1,0,5,2)", 61314},
    {"an axis that is none", 5, "", "CYCLE971(1,0,1,4,1,0,5,2)", 61325},
    {"no axis", 5, "", "CYCLE971(1,0,1,0,1,0,5,2)", 61325},
    {"tens of the axes", 5, "", "CYCLE971(1,0,1,11,1,0,5,2)", 61325},
    {"one axis for both", 9, "", "CYCLE971(0,0,1,101,1,0,5,2)", 61325},
    {"a tooth's length without its side", 6, "$TC_DPNT[6,1]=4", "CYCLE971(102,0,1,3,2,0,5,2)",
     61325},
    {"a direction that is none", 5, "", "CYCLE971(1,0,1,1,3,0,5,2)", 61326},
    {"incremental without a direction", 5, "", "CYCLE971(10001,0,1,1,0,0,5,2)", 61326},
    {"all sides but from above", 9, "$SNS_MEA_TP_AX_DIR_AUTO_CAL[0]=33",
     "CYCLE971(100000,0,1,0,0,0,5,2)", 61326},
    {"no speed in the call", 5, "$SNS_MEA_FUNCTION_MASK_TOOL=32", "CYCLE971(2,0,1,1,1,0,5,2)",
     61338},
    {"no speed in the data", 5, "$SNS_MEA_CM_MAX_REVOLUTIONS[0]=0", "CYCLE971(2,0,1,1,1,0,5,2)",
     61338},
    {"a spindle that cannot be positioned", 9, "$MCS_AXIS_USAGE_ATTRIB[6]=512",
     "CYCLE971(1000000,0,1,1,1,0,5,2)", 61372},
    {"data sets 2 to 6 are not calibrated", 5, "", "CYCLE971(1,0,2,1,1,0,5,2)", 61341},
};

TEST(ToolMeasuringAlarms, OfTheCall) {
  for (const AlarmCase& row : kOfTheCall) {
    expect_alarm(row, {kCube, kKnown});
  }
}

constexpr AlarmCase kOfTheTouch[] = {
    {"a tool outside the safe area", 5, "$TC_DP3[5,1]=101 D1", "CYCLE971(1,0,1,103,2,0,5,0.5)",
     61303},
    {"a broken tool, the path reaches it", 5, "$TC_DP3[5,1]=102 D1", "CYCLE971(1,0,1,103,2,0,5,1)",
     61303},
    {"a broken tool that is not reached", 5, "$TC_DP3[5,1]=102 D1", "CYCLE971(1,0,1,103,2,0,1.5,1)",
     61301},
    {"a longer tool than the data say, on the way", 5, "$TC_DP3[5,1]=70 D1",
     "CYCLE971(1,0,1,3,2,0,5,1)", 61302},
    {"a radius outside the safe area", 5, "$TC_DP6[5,1]=9 D1", "CYCLE971(2,0,1,1,1,0,5,0.5)",
     61303},
    {"a calibration outside the safe area", 9, "$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]=-301",
     "CYCLE971(100000,0,1,0,0,0,5,0.5)", 61303},
};

TEST(ToolMeasuringAlarms, OfTheTouch) {
  for (const AlarmCase& row : kOfTheTouch) {
    expect_alarm(row, {kCube, kKnown});
  }
}

/// What the magazine or the plate holds is not what the data say.
TEST(ToolMeasuringAlarms, AnotherToolOrAChipOnThePlateIsToldAndNothingWritten) {
  const auto another = [](double length) {
    return fmt::format("[[tool]]\nnumber = 5\nlength = {}\ndiameter = 16.0\n", length);
  };
  const std::string chip =
      "[[part]]\nname = \"chip\"\nshape = \"block\"\nlength = 4.0\nwidth = 4.0\nheight = 2.0\n"
      "at = [200.0, 0.0, -298.0]\n";
  const char* const measure = "CYCLE971(1,0,1,3,2,0,5,1)";
  expect_alarm({"12 mm too short", 5, "", measure, 61301}, {kCube, kKnown, another(88.0)});
  expect_alarm({"12 mm too long", 5, "", measure, 61302}, {kCube, kKnown, another(112.0)});
  expect_alarm({"3 mm too short", 5, "", measure, 61303}, {kCube, kKnown, another(97.0)});
  expect_alarm({"a chip of 2 mm", 5, "", measure, 61303}, {kCube, kKnown, chip});
  expect_alarm({"a chip, calibration", 9, "", "CYCLE971(100000,0,1,0,0,0,5,1)", 61303},
               {kCube, kKnown, chip});
}

TEST(ToolMeasuringAlarms, WithoutAToolProbeNothingIsTouched) {
  expect_alarm({"length", 5, "", "CYCLE971(1,0,1,3,2,0,5,2)", 61301}, {kKnown});
  expect_alarm({"all sides", 9, "", "CYCLE971(100000,0,1,0,0,0,5,2)", 61301}, {kKnown});
}

TEST(ToolMeasuringAlarms, ABrokenToothIsToldAndTheToolNotCorrected) {
  const std::string broken =
      "[[tool]]\nnumber = 6\nlength = 100.0\ndiameter = 16.0\n"
      "teeth = [{ angle_deg = 20.0 }, { angle_deg = 110.0 }, "
      "{ angle_deg = 200.0, radius = 6.0, length = 98.0 }, { angle_deg = 290.0 }]\n";
  for (const char* const call :
       {"CYCLE971(102,0,1,1,1,0,5,1,,0.001,0.5)", "CYCLE971(102,0,1,103,2,0,5,1,,0.001,0.5)",
        "CYCLE971(102,0,1,1,1,0,1.5,1,,0.001,0.5)"}) {
    expect_alarm({call, 6, "$TC_DPNT[6,1]=4", call, 62320}, {broken, kCube, kKnown});
  }
}

TEST(ToolMeasuringAlarms, BeyondTheDimensionDifferenceTheProgramGoesOn) {
  const MeasuringRun run = run_tools(
      "$TC_DP3[5,1]=100.3\n" + with_tool(5) + "CYCLE971(1,0,1,103,2,0,5,2,,0.001,0.2)\nR1=1",
      {kCube, kKnown}, {"R1", "_OVI[9]", "$TC_DP3[5,1]", "_OVR[9]"});
  EXPECT_EQ(run.alarm(), 0) << run.output.errors;
  EXPECT_EQ(run.at("R1"), 1.0);
  EXPECT_EQ(run.at("_OVI[9]"), 61306.0);
  EXPECT_EQ(run.at("$TC_DP3[5,1]"), 100.3);
  EXPECT_NEAR(run.at("_OVR[9]"), -0.3, 1e-6);
}

}  // namespace
}  // namespace g31::testing::tool_probe_alarms_test

// CYCLE973: the probe in the turret calibrated on faces and in reference grooves, and what CYCLE974
// then reads; the signal is 1 ms late.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/turning_run.h"

namespace g31::testing::lathe_calibration_test {
namespace {

constexpr double kDelay = 0.1 / 60.0;  // mm: 1 ms of 100 mm/min
constexpr double kReached = 3.0 - kDelay;
const std::string kLate = "[probe]\ntrigger_delay_s = 0.001\n";

const std::string kMinusZ = "$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]";
const std::string kPlusZ = "$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]";
const std::string kMinusX = "$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]";
const std::string kPlusX = "$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]";

std::string shaft() {
  return part("shaft", 0.0, 0.0, 200.0, "diameter = 50.0\nheight = 100.0");
}
std::string bushing() {
  return part("ring", 0.0, 0.0, 200.0, "bore = 60.0\nheight = 30.0");
}
/// A face that looks to -Z.
std::string far_face() {
  return part("shaft", 0.0, 0.0, 260.0,
              "diameter = 50.0\nheight = 40.0\nrotate_deg = [0.0, 180.0, 0.0]");
}
/// Of 40 mm, 15 deep, open to +Z: its walls at X 20 and 60, its bottom at Z 85.
std::string groove_along_z() {
  return part("groove", 40.0, 0.0, 100.0, "width = 40.0") +
         "[variables]\n\"$SNS_MEA_CAL_EDGE_BASE_AX1[0]\" = 85.0\n"
         "\"$SNS_MEA_CAL_EDGE_PLUS_DIR_AX2[0]\" = 60.0\n"
         "\"$SNS_MEA_CAL_EDGE_MINUS_DIR_AX2[0]\" = 20.0\n";
}
/// The same open to +X: its walls at Z 80 and 120, its bottom at X 5.
std::string groove_across() {
  return part("groove", 20.0, 0.0, 100.0, "width = 40.0\nrotate_deg = [0.0, 90.0, 0.0]") +
         "[variables]\n\"$SNS_MEA_CAL_EDGE_BASE_AX2[2]\" = 5.0\n"
         "\"$SNS_MEA_CAL_EDGE_UPPER_AX2[2]\" = 20.0\n"
         "\"$SNS_MEA_CAL_EDGE_PLUS_DIR_AX1[2]\" = 120.0\n"
         "\"$SNS_MEA_CAL_EDGE_MINUS_DIR_AX1[2]\" = 80.0\n";
}

struct Case {
  const char* name;
  std::string program;
  std::vector<std::string> sheets;
  std::vector<ExpectedValue> expected;
};

void expect_each(std::span<const Case> rows) {
  for (const Case& row : rows) {
    SCOPED_TRACE(row.name);
    std::vector<std::string> sheets = row.sheets;
    sheets.push_back(kLate);
    std::vector<ExpectedValue> expected = row.expected;
    expected.insert(expected.end(),
                    {{"_OVI[2]", 973}, {"_OVI[5]", 1}, {"_OVI[9]", 0}, {"_OVR[27]", 0}});
    expect_turned("G54 DIAMON\n" + row.program, sheets, expected);
  }
}

TEST(LatheCalibration, OnAFaceInEachDirection) {
  const std::string outside = "G0 X100\nZ-10\n";
  const std::string inside = "G0 X0 Z20\nZ-10\n";
  const std::string at_face = "G0 X20 Z20\n";
  expect_each(std::vector<Case>{
      {"-X as the probe points",
       outside + "CYCLE973(1,1,,50,,,3,5,100)",
       {kProbeToMinusX, shaft()},
       {{kMinusX, -kReached},
        {kPlusX, 0.0},
        {kMinusZ, 0.0},
        {"_OVR[12]", -kReached},
        {"_OVR[13]", -kReached},
        {"_OVR[4]", 6.0},
        {"_OVR[28]", 5.0},
        {"$AA_IW[X]", 62.0},
        {"$TC_DP3[1,1]", 100.0},
        {"$SNS_MEA_WP_FEED[0]", 100.0}}},
      {"-X by axis and direction",
       outside + "CYCLE973(1001,1,,50,2,1,3,5,100)",
       {kProbeToMinusZ, shaft()},
       {{kMinusX, -kReached}, {kPlusX, 0.0}}},
      {"the same in a program in radii",
       "DIAMOF G0 X50\nZ-10\nCYCLE973(1001,1,,50,2,1,3,5,100)",
       {kProbeToMinusZ, shaft()},
       {{kMinusX, -kReached}, {"$AA_IW[X]", 31.0}}},
      {"+X",
       inside + "CYCLE973(1001,1,,60,2,0,3,5,100)",
       {kProbeToMinusZ, bushing()},
       {{kPlusX, kReached}, {kMinusX, 0.0}, {"_OVR[14]", kReached}, {"_OVR[15]", kReached}}},
      {"-Z as the probe points",
       at_face + "CYCLE973(1,1,,0,,,3,5,100)",
       {kProbeToMinusZ, shaft()},
       {{kMinusZ, -kReached}, {"_OVR[8]", -kReached}, {"_OVR[9]", -kReached}}},
      {"+Z as the probe points",
       at_face + "CYCLE973(1,1,,60,,,3,5,100)",
       {kProbeToPlusZ, far_face()},
       {{kPlusZ, kReached}, {"_OVR[10]", kReached}, {"_OVR[11]", kReached}}},
      {"three readings at the usual feed",
       at_face + "CYCLE973(1001,1,,0,1,1,3,5,,3)",
       {kProbeToMinusZ, shaft()},
       {{kMinusZ, -(3.0 - 0.005)}, {"$SNS_MEA_WP_FEED[0]", 300.0}}},
  });
}

/// The data are wrong by 0.2: 100.2 in the place of 100, 149.8 in that of 150.
TEST(LatheCalibration, TheLengthTakesTheDelay) {
  expect_each(std::vector<Case>{
      {"length 1 by X",
       "G0 X100\nZ-10\nCYCLE973(1000000,1,,50,,,3,5,100)",
       {kProbeToMinusX, shaft(), "[tools.1]\nlength = 100.2\n"},
       {{"$TC_DP3[1,1]", 100.0 - kDelay}, {"$TC_DP4[1,1]", 30.0}, {kMinusX, -3.0}}},
      {"length 2 by Z",
       "G0 X20 Z20\nCYCLE973(1000000,1,,0,,,3,5,100)",
       {kProbeToMinusZ, shaft(), "[variables]\n\"$TC_DP4[1,1]\" = 149.8\n"},
       {{"$TC_DP4[1,1]", 150.0 - kDelay}, {"$TC_DP3[1,1]", 20.0}, {kMinusZ, -3.0}}},
      {"the trigger alone",
       "G0 X100\nZ-10\nCYCLE973(0,1,,50,,,3,5,100)",
       {kProbeToMinusX, shaft(), "[tools.1]\nlength = 100.2\n"},
       {{"$TC_DP3[1,1]", 100.2}, {kMinusX, -2.8 + kDelay}}},
      {"in a groove, Z",
       "G0 X80\nZ-30\nCYCLE973(1000002,1,1,,,,5,5,100)",
       {kProbeToMinusZ, groove_along_z(), "[variables]\n\"$TC_DP4[1,1]\" = 149.8\n"},
       {{"$TC_DP4[1,1]", 150.0 - kDelay}, {kMinusZ, -3.0}}},
      {"in a groove, X",
       "G0 X60\nZ-10\nX30\nCYCLE973(1001002,1,3,,2,1,5,5,100)",
       {kProbeToMinusX, groove_across(), "[tools.1]\nlength = 100.2\n"},
       {{"$TC_DP3[1,1]", 100.0 - kDelay}, {kMinusX, -3.0}}},
      {"length 1 as diameter",
       "G0 X100\nZ-10\nCYCLE973(1000000,1,,50,,,3,5,100)",
       {kProbeToMinusX, shaft(),
        "[tools.1]\nlength = 200.4\n[machine_data]\n\"$MC_TOOL_PARAMETER_DEF_MASK\" = 2\n"},
       {{"$TC_DP3[1,1]", 200.0 - 2.0 * kDelay}}},
  });
}

/// The tip's data are 0.02 off the ball across the groove.
TEST(LatheCalibration, BetweenTheWallsOfAGroove) {
  const std::vector<std::string> along = {kProbeToMinusZ, groove_along_z(),
                                          "[tools.1]\nlength = 19.98\n"};
  const std::vector<std::string> across = {kProbeToMinusX, groove_across(),
                                           "[variables]\n\"$TC_DP4[1,1]\" = 29.98\n"};
  const std::string to_z = "G0 X80\nZ-30\n";
  const std::string to_x = "G0 X60\nZ-10\nX30\n";
  expect_each(std::vector<Case>{
      {"both along X",
       to_z + "CYCLE973(2003,1,1,,2,,5,5,100)",
       along,
       {{kPlusX, kReached - 0.02},
        {kMinusX, -kReached - 0.02},
        {kMinusZ, 0.0},
        {"_OVR[4]", 2.0 * kReached},
        {"_OVR[21]", 0.02},
        {"_OVR[20]", 0.0},
        {"$TC_DP6[1,1]", kReached},
        {"$TC_DP3[1,1]", 19.98},
        {"$SNS_MEA_WP_POS_DEV_AX2[0]", 0.02},
        {"$AA_IW[X]", 80.0},
        {"$AA_IW[Z]", -30.0}}},
      {"the printed preset: both, without the deviation",
       to_z + "CYCLE973(12103,1,1,,2,,5,5,100)",
       along,
       {{kPlusX, kReached - 0.02}, {"_OVR[21]", 0.0}, {"$SNS_MEA_WP_POS_DEV_AX2[0]", 0.0}}},
      {"the preset itself",
       to_z + "CYCLE973(,1,1,,2,,5,5,100)",
       along,
       {{kPlusX, kReached - 0.02}, {kMinusX, -kReached - 0.02}, {"_OVI[3]", 12103}}},
      {"one wall",
       to_z + "CYCLE973(1003,1,1,,2,0,5,5,100)",
       along,
       {{kPlusX, kReached - 0.02}, {kMinusX, 0.0}, {"$AA_IW[X]", 2.0 * (60.0 - 3.0 - 5.0)}}},
      {"the bottom as the probe points",
       to_z + "CYCLE973(3,1,1,,,,5,5,100)",
       along,
       {{kMinusZ, -kReached}, {"$AA_IW[Z]", -107.0}, {"$TC_DP4[1,1]", 150.0}}},
      {"both along Z",
       to_x + "CYCLE973(2003,1,3,,1,,5,5,100)",
       across,
       {{kPlusZ, kReached - 0.02},
        {kMinusZ, -kReached - 0.02},
        {kMinusX, 0.0},
        {"_OVR[20]", 0.02},
        {"$AA_IW[X]", 30.0},
        {"$AA_IW[Z]", -10.0}}},
      {"the other wall",
       to_x + "CYCLE973(1003,1,3,,1,1,5,5,100)",
       across,
       {{kMinusZ, -kReached - 0.02}, {kPlusZ, 0.0}}},
      {"the bottom across", to_x + "CYCLE973(3,1,3,,,,5,5,100)", across, {{kMinusX, -kReached}}},
  });
}

/// Worked example D-5 of shared/spec/sinumerik/worked-examples-2.md.
TEST(LatheCalibration, TheWorkedExampleOfTheGroove) {
  const MeasuringRun run = expect_turned(
      "G54 DIAMON G0 X80\nZ-30\nCYCLE973(2003,1,1,,2,,5,5)",
      {kProbeToMinusZ, groove_along_z(),
       "[tools.1]\nlength = 19.98\n[probe]\nball_diameter = 5.98\n"},
      {{"_OVR[4]", 5.98}, {"_OVR[14]", 2.97}, {"_OVR[12]", -3.01}, {"_OVR[21]", 0.02}});
  std::vector<double> latched;
  for (const auto& touch : run.output.document.at("touches")) {
    if (touch.at("triggered").get<bool>()) {
      latched.push_back(touch.at("latched").at(0).get<double>());
    }
  }
  ASSERT_EQ(latched.size(), 2U);
  EXPECT_NEAR(latched[0] - 19.98, 57.03, 1e-6);
  EXPECT_NEAR(latched[1] - 19.98, 23.01, 1e-6);
}

TEST(LatheCalibration, ThenDiametersAreTrue) {
  const std::string calibrate =
      "G54 DIAMON G0 X100\nZ-10\nCYCLE973(1001,1,,50,2,1,3,5,100)\nG0 X100\nZ10\nX20\n"
      "CYCLE973(1001,1,,0,1,1,3,5,100)\nG0 Z10\nX100\n";
  expect_turned(calibrate +
                    "Z-30\nCYCLE974(2,,,1,50.1,2,3,5)\nR1=_OVR[4]\nG0 X100\nZ10\nX20\n"
                    "CYCLE974(0,,,1,0.1,1,3,5)\nR2=_OVR[4]",
                {kProbeToMinusX, shaft(), kLate, "[tools.1]\nlength = 100.05\n"},
                {{"R1", 50.0}, {"R2", 0.0}});
}

}  // namespace
}  // namespace g31::testing::lathe_calibration_test

// Further variants of CYCLE973, CYCLE974 and CYCLE994: a part that runs out, repeated readings,
// replacement tools, Y, a 710 of a machine that mills too, the log.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/turning_run.h"

namespace g31::testing::turning_variants_test {
namespace {

std::string shaft(double diameter = 50.04, double x = 0.0) {
  return part("shaft", x, 0.0, 200.0, fmt::format("diameter = {:.4f}\nheight = 100.0", diameter));
}

const std::string kAtShaft = "G54 DIAMON G0 X100\nZ-10\n";

/// Diameters of 49.98 and 50.06 are read, half a turn apart.
TEST(TurningVariants, ReversalTakesTheRunOutAway) {
  const std::vector<std::string> sheets = {kProbeToMinusX, kCalibrated, shaft(50.02, -0.02)};
  const auto on_part = [&](const std::string& call) { return kAtShaft + call; };
  expect_turned(on_part("CYCLE974(2,,,1,50,2,3,5)"), sheets, {{"_OVR[4]", 49.98}});
  expect_turned(on_part("SPOS=180\nCYCLE974(2,,,1,50,2,3,5)"), sheets, {{"_OVR[4]", 50.06}});
  expect_turned(on_part("CYCLE974(10002,,,1,50,2,3,5,0)"), sheets,
                {{"_OVR[4]", 50.02}, {"_OVR[16]", 0.02}, {"$AA_IM[C]", 180.0}});
  // A quarter turn on, the run-out lies across the touch: 2 sqrt(25.01^2 - 0.02^2) all but.
  expect_turned(on_part("CYCLE974(10002,,,1,50,2,3,5,90)"), sheets,
                {{"_OVR[4]", 50.02}, {"$AA_IM[C]", 270.0}}, 1e-4);
  expect_turned(on_part("CYCLE974(10002,,,1,50,2,3,5,-180)"), sheets,
                {{"_OVR[4]", 50.02}, {"$AA_IM[C]", 0.0}});
}

TEST(TurningVariants, RepeatedReadingsCountAsTheirMean) {
  const MeasuringRun run = expect_turned(
      kAtShaft + "CYCLE974(2,,,1,50,2,3,5,,3)",
      {kProbeToMinusX, kCalibrated, shaft(), "[probe]\nrepeatability_mm = 0.002\n"}, {});
  double sum = 0.0;
  int touches = 0;
  for (const auto& touch : run.output.document.at("touches")) {
    if (touch.at("triggered").get<bool>()) {
      sum += touch.at("latched").at(0).get<double>();
      ++touches;
    }
  }
  ASSERT_EQ(touches, 3);
  const MeasuringRun again = run_turning(
      kAtShaft + "CYCLE974(2,,,1,50,2,3,5,,3)",
      {kProbeToMinusX, kCalibrated, shaft(), "[probe]\nrepeatability_mm = 0.002\n"}, {"_OVR[4]"});
  EXPECT_NEAR(again.at("_OVR[4]"), 2.0 * (sum / 3.0 - 100.0 - 3.0), 1e-6);
}

TEST(TurningVariants, ReplacementToolsAreCorrectedByTheirNumber) {
  expect_turned(
      "$TC_TP1[4]=2\n" + kAtShaft +
          "CYCLE974(202,,100000001,1,50,2,3,5,,1,\"ROUGHER\",,,,,,,,,,,,2)",
      {kProbeToMinusX, kCalibrated, shaft(), "[tools.4]\nname = \"ROUGHER\"\ntype = 500.0\n"},
      {{"$TC_DP12[4,1]", -0.02}, {"$TC_DP12[2,1]", 0.0}, {"_OVI[8]", 4}, {"_OVI[10]", 2}});
}

/// The same by two points: the last argument is the replacement tool's number; without it the one
/// in use is corrected, and a number that there is none of is 61343, with nothing written.
TEST(TurningVariants, TwoPointsCorrectAReplacementTool) {
  const std::vector<std::string> sheets = {kProbeToMinusZ, kCalibrated, shaft(),
                                           "[tools.4]\nname = \"ROUGHER\"\ntype = 500.0\n"};
  const std::string two_points = "$TC_TP1[4]=2 $TC_TP8[2]=129\n" + kAtShaft +
                                 "CYCLE994(1202,,{},1,50,2,20,30,3,5,1,\"ROUGHER\"{})";
  expect_turned(
      fmt::format(fmt::runtime(two_points), "100000001", ",,,,,,,,,,,,2"), sheets,
      {{"$TC_DP12[4,1]", -0.02}, {"$TC_DP12[2,1]", 0.0}, {"_OVI[8]", 4}, {"_OVI[10]", 2}});
  expect_turned(fmt::format(fmt::runtime(two_points), "1", ""), sheets,
                {{"$TC_DP12[4,1]", 0.0}, {"$TC_DP12[2,1]", -0.02}, {"_OVI[8]", 2}});
  const MeasuringRun none =
      run_turning(fmt::format(fmt::runtime(two_points), "100000001", ",,,,,,,,,,,,3"), sheets,
                  {"$TC_DP12[4,1]", "$TC_DP12[2,1]"});
  EXPECT_EQ(none.output.document.at("alarm").at("number"), 61343);
  EXPECT_EQ(none.at("$TC_DP12[4,1]"), 0.0);
  EXPECT_EQ(none.at("$TC_DP12[2,1]"), 0.0);
}

/// A measurement beyond S_TSA is made once more with SD54740 bit 0; CYCLE994 goes round again.
TEST(TurningVariants, ASecondAttemptBeginsAboveTheCentreAgain) {
  const std::string twice = "[machine_data]\n\"$SNS_MEA_FUNCTION_MASK\" = 9\n";
  const MeasuringRun run = run_turning(kAtShaft + "CYCLE994(1002,,,1,50,2,20,30,3,0.01)",
                                       {kProbeToMinusZ, kCalibrated, shaft(), twice}, {"_OVI[9]"});
  EXPECT_EQ(run.alarm(), 61303) << run.output.errors;
  std::vector<double> places;
  for (const auto& touch : run.output.document.at("touches")) {
    if (touch.at("triggered").get<bool>()) {
      places.push_back(touch.at("latched").at(0).get<double>() - 20.0);
    }
  }
  ASSERT_EQ(places.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(places[i], (i % 2 == 0 ? 1.0 : -1.0) * 28.02, 1e-6) << i;
  }
}

const std::string kWithY =
    "[machine]\ntool_side = \"ZXY\"\n[machine_data]\n\"$MCS_TECHNOLOGY\" = 1\n"
    "\"$MCS_MEA_FUNCTION_MASK\" = 65538\n";

TEST(TurningVariants, YIsCalibratedAndCorrectsX) {
  const std::vector<std::string> sheets = {kProbeToMinusZ, kCalibrated, shaft(), kWithY,
                                           "[probe]\ntrigger_delay_s = 0.001\n"};
  const std::string calibrate = "G54 DIAMON G0 X0 Y60\nZ-10\nCYCLE973(1001,1,,50.04,3,1,3,5)\n";
  expect_turned(
      calibrate, sheets,
      {{"$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]", -2.995}, {"_OVR[16]", -2.995}, {"$TC_DP5[1,1]", 0.0}});
  expect_turned(calibrate + "CYCLE974(202,,1,1,50,3,3,5,,1,\"ROUGHER\")", sheets,
                {{"_OVR[4]", 50.04}, {"_OVR[7]", 50.04}, {"$TC_DP12[2,1]", -0.02}});
  expect_turned(calibrate + "CYCLE974(102,1,,1,50,3,3,5)", sheets,
                {{"$P_UIFR[1,X,FI]", 0.02}, {"$P_UIFR[1,Y,FI]", 0.0}});
}

/// CYCLE976 calibrates it in G17 or G19, CYCLE974 and CYCLE994 measure in G18.
TEST(TurningVariants, AProbeOfMillingMeasuresWhatIsTurned) {
  const std::string milling =
      kWithY +
      "\"$SC_TOOL_LENGTH_CONST\" = 18\n\"$SC_TOOL_LENGTH_TYPE\" = 2\n"
      "\"$MNS_MEA_FUNCTION_MASK\" = 27\n[tools.1]\ntype = 710.0\nlength = 20.0\n[variables]\n"
      "\"$TC_DP4[1,1]\" = 150.0\n[probe]\nat = [-20.0, 0.0, -147.0]\ntrigger_delay_s = 0.001\n";
  const std::string bushing =
      part("ring", 0.0, 0.0, 200.0, "bore = 60.02\nouter_diameter = 100.0\nheight = 50.0");
  const std::string calibrate =
      "G54 G17 DIAMOF G0 X0 Y0\nZ-10\nCYCLE976(1,1,60.02,,,,3,5)\nG0 Z20\nX40\nZ6\n"
      "CYCLE976(0,1,0,,3,1,3,5)\nG0 Z20\nG18 DIAMON\n";
  expect_turned(calibrate +
                    "X0\nZ-10\nCYCLE974(1,,,1,60,2,3,5)\nR1=_OVR[4]\n"
                    "CYCLE994(1,,,1,60,2,,,3,5)\nR2=_OVR[4]\nG0 X0\nZ20\nX80\n"
                    "CYCLE974(0,,,1,0.1,1,3,5)\nR3=_OVR[4]",
                {milling, bushing},
                {{"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]", 2.995},
                 {"$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]", 0.005},
                 {"$SNS_MEA_WP_STATUS_GEN[0]", 1},
                 {"R1", 60.02},
                 {"R2", 60.02},
                 {"R3", 0.0}});
}

/// A 710 that points to -X: the bore, whose axis is X, finds the triggers of Y and Z, the face at
/// X60 that of X, each 0.005 mm late.
TEST(TurningVariants, AProbeCalibratedInG19MeasuresInG18) {
  const std::string across =
      kWithY +
      "\"$SC_TOOL_LENGTH_CONST\" = 18\n\"$SC_TOOL_LENGTH_TYPE\" = 2\n"
      "\"$MNS_MEA_FUNCTION_MASK\" = 27\n[tools.1]\ntype = 710.0\nlength = 103.0\n[variables]\n"
      "\"$TC_DP4[1,1]\" = 30.0\n[probe]\nat = [-100.0, 0.0, -30.0]\ntrigger_delay_s = 0.001\n";
  const std::string bushing = part("ring", 60.0, 0.0, 350.0,
                                   "rotate_deg = [0.0, 90.0, 0.0]\nbore = 60.02\n"
                                   "outer_diameter = 100.0\nheight = 50.0");
  // In X from outside; in Y with the ball's centre at the height of the spindle, alone and round
  // the shaft by way of Z.
  expect_turned(
      "G54 G19 DIAMOF G0 X100\nZ150 Y0\nX50\nCYCLE976(1,1,60.02,,,,3,5)\nG0 X80\nY40\nX66\n"
      "CYCLE976(0,1,60,,3,1,3,5)\nG0 X100\nG18 DIAMON\nY0\nZ-10\n"
      "CYCLE974(2,,,1,50,2,3,5)\nR1=_OVR[4]\nG0 X100\nY60\nX-6\n"
      "CYCLE974(2,,,1,50,3,3,5)\nR2=_OVR[4]\nG0 Y40\n"
      "CYCLE994(1002,,,1,50,3,20,30,3,5)\nR3=_OVR[4]",
      {across, bushing + shaft()},
      {{"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]", 2.995},
       {"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]", -2.995},
       {"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]", 2.995},
       {"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]", -2.995},
       {"$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]", 0.005},
       {"$SNS_MEA_WP_STATUS_GEN[0]", 3},
       {"R1", 50.04},
       {"R2", 50.04},
       {"R3", 50.04}});
}

TEST(TurningVariants, TheLogTellsWhatWasMeasured) {
  const MeasuringRun run = run_turning(
      "CYCLE150(0,1001,\"SHAFT.TXT\")\n" + kAtShaft +
          "CYCLE973(1001,1,,50.04,2,1,3,5)\nCYCLE974(2,,,1,50,2,3,5)\nG0 X100\nZ10\nX20\n"
          "CYCLE974(0,,,1,0.1,1,3,5)\n",
      {kProbeToMinusX, kCalibrated, shaft()}, {});
  ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
  const std::string log = run.output.document.at("files").at("SHAFT.TXT");
  for (const char* line :
       {"Calibrate radius on surface / CYCLE973", "Outside diameter / CYCLE974",
        "Diameter        50.0000          50.0400           0.0400 mm", "Front edge / CYCLE974",
        "Z                0.1000           0.0000          -0.1000 mm"}) {
    EXPECT_NE(log.find(line), std::string::npos) << line << "\n" << log;
  }
}

}  // namespace
}  // namespace g31::testing::turning_variants_test

// CYCLE974 and CYCLE994: results as the manual's tables have them, corrections of tools and
// offsets, digit by digit, and every alarm once, behind which nothing is written.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/turning_run.h"

namespace g31::testing::turning_cycle_test {
namespace {

std::string shaft(double diameter = 50.04, double x = 0.0, double z = 200.0) {
  return part("shaft", x, 0.0, z, fmt::format("diameter = {:.4f}\nheight = 100.0", diameter));
}
std::string bushing(double bore = 50.04) {
  return part("ring", 0.0, 0.0, 200.0, fmt::format("bore = {:.4f}\nheight = 50.0", bore));
}

const std::string kAtShaft = "G54 DIAMON G0 X100\nZ-10\n";
const std::string kAtFace = "G54 DIAMON G0 X20 Z10\n";
const std::string kInBore = "G54 DIAMON G0 X0 Z20\nZ-10\n";

struct Case {
  const char* name;
  std::string program;
  std::string sheet;
  std::vector<ExpectedValue> expected;
};

void expect_each(std::span<const Case> rows, const std::string& probe = kProbeToMinusX) {
  for (const Case& row : rows) {
    SCOPED_TRACE(row.name);
    expect_turned(row.program, {probe, kCalibrated, row.sheet}, row.expected);
  }
}

TEST(TurningCycle, ResultsAreThoseOfTheMeasuredAxis) {
  const std::string before =
      "_OVR[1]=77 _OVR[2]=77 _OVR[3]=77 _OVR[5]=77 _OVR[6]=77 _OVR[7]=77 "
      "_OVR[17]=77 _OVR[18]=77 _OVR[19]=77\n";
  const std::vector<ExpectedValue> of_x = {
      {"_OVR[0]", 50.0},  {"_OVR[1]", 77.0},  {"_OVR[2]", 50.0},  {"_OVR[3]", 77.0},
      {"_OVR[4]", 50.04}, {"_OVR[5]", 77.0},  {"_OVR[6]", 50.04}, {"_OVR[7]", 77.0},
      {"_OVR[16]", 0.04}, {"_OVR[17]", 77.0}, {"_OVR[18]", 0.04}, {"_OVR[19]", 77.0},
      {"_OVI[0]", 0},     {"_OVI[5]", 1},     {"_OVI[9]", 0}};
  auto with = [](std::vector<ExpectedValue> rows, const std::vector<ExpectedValue>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
    return rows;
  };
  expect_each(std::vector<Case>{
      {"outside, diameter", kAtShaft + before + "CYCLE974(2,,,1,50,2,3,5)", shaft(),
       with(of_x, {{"_OVI[2]", 974}, {"_OVI[3]", 2}, {"$AA_IW[X]", 62.0}})},
      {"face, Z",
       kAtFace + before + "CYCLE974(0,,,1,0.2,1,3,5)",
       shaft(),
       {{"_OVR[0]", 0.2},
        {"_OVR[1]", 0.2},
        {"_OVR[2]", 77.0},
        {"_OVR[4]", 0.0},
        {"_OVR[5]", 0.0},
        {"_OVR[16]", -0.2},
        {"_OVR[17]", -0.2},
        {"_OVR[18]", 77.0},
        {"$AA_IW[Z]", 6.2}}},
      {"inches",
       kAtShaft + before + "G700\nCYCLE974(2,,,1,1.97,2,0.2,0.2)",
       shaft(),
       {{"_OVR[0]", 1.97}, {"_OVR[4]", 50.04 / 25.4}, {"_OVR[1]", 77.0}}},
      {"plane of the call", kAtShaft + "G17\n" + before + "CYCLE974(2,,,1,50,2,3,5,,,,,,,,,,,,,2)",
       shaft(), with(of_x, {{"$P_GG[6]", 1.0}, {"$P_GG[29]", 2.0}})},
  });
  expect_each(
      std::vector<Case>{
          {"two points", kAtShaft + before + "CYCLE994(1002,,,1,50,2,20,30,3,5)", shaft(),
           with(of_x, {{"_OVI[2]", 994}, {"_OVI[3]", 1002}, {"$AA_IW[X]", -62.0}})},
          {"two points, not calibrated",
           kAtShaft + "$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]=0 $SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]=0\n" +
               before + "_CHBIT[7]=1\nCYCLE994(1002,,,1,50,2,20,30,3,5)",
           shaft(), of_x},
      },
      kProbeToMinusZ);
}

/// SD42940 = 18: the lengths of tools stay those of G18.
TEST(TurningCycle, InOtherPlanesTheMeasuredAxisIsCorrected) {
  const std::string as_g18 =
      "[machine_data]\n\"$SC_TOOL_LENGTH_CONST\" = 18\n"
      "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]\" = -3.0\n"
      "\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX3[0]\" = 3.0\n";
  expect_each(std::vector<Case>{
      {"G19, X, offset",
       kAtShaft + "G19\nCYCLE974(102,1,,1,50,3,3,5)",
       shaft() + as_g18,
       {{"$P_UIFR[1,X,FI]", 0.02}, {"$P_UIFR[1,Y,FI]", 0.0}, {"$P_UIFR[1,Z,FI]", 0.0}}},
      {"G19, X, length",
       kAtShaft + "G19\nCYCLE974(202,,1,1,50,3,3,5,,1,\"ROUGHER\")",
       shaft() + as_g18,
       {{"$TC_DP12[2,1]", -0.02}, {"$TC_DP13[2,1]", 0.0}, {"$TC_DP14[2,1]", 0.0}}},
      {"G17, Z, offset",
       kAtFace + "G17\nCYCLE974(100,1,,1,-0.03,3,3,5)",
       shaft() + as_g18,
       {{"$P_UIFR[1,Z,FI]", 0.03}, {"$P_UIFR[1,X,FI]", 0.0}, {"$P_UIFR[1,Y,FI]", 0.0}}},
      {"G17, Z, length",
       kAtFace + "G17\nCYCLE974(200,,1,1,-0.03,3,3,5,,1,\"ROUGHER\")",
       shaft() + as_g18,
       {{"$TC_DP12[2,1]", 0.0}, {"$TC_DP13[2,1]", -0.03}, {"$TC_DP14[2,1]", 0.0}}},
  });
  expect_each(
      std::vector<Case>{
          {"G19, two points of X, offset",
           kAtShaft + "G19\nCYCLE994(2102,1,,1,50,3,20,30,3,5)",
           shaft(50.04, 0.05) + as_g18,
           {{"$P_UIFR[1,X,FI]", 0.05}, {"$P_UIFR[1,Y,FI]", 0.0}, {"$P_UIFR[1,Z,FI]", 0.0}}},
          {"G19, two points of X, length",
           kAtShaft + "G19\nCYCLE994(2202,,1,1,50,3,20,30,3,5,1,\"ROUGHER\")",
           shaft() + as_g18,
           {{"$TC_DP12[2,1]", -0.02}, {"$TC_DP13[2,1]", 0.0}, {"$TC_DP14[2,1]", 0.0}}},
      },
      kProbeToMinusZ);
}

std::string call(const char* variant, const char* target, const char* name = "ROUGHER",
                 const char* more = "") {
  return fmt::format("CYCLE974({},,{},1,50,2,3,5,,1,\"{}\"{})", variant, target, name, more);
}

/// The tool's X is 0.02 too long where a diameter is 0.04 too large.
TEST(TurningCycle, TheDigitsOfTheTargetChooseWhatIsCorrected) {
  expect_each(std::vector<Case>{
      {"outside, wear",
       kAtShaft + call("202", "1"),
       shaft(),
       {{"$TC_DP12[2,1]", -0.02},
        {"$TC_DP3[2,1]", 90.0},
        {"_OVR[20]", -0.02},
        {"_OVI[0]", 1},
        {"_OVI[8]", 2}}},
      {"outside, geometry",
       kAtShaft + call("202", "4000001"),
       shaft(),
       {{"$TC_DP3[2,1]", 89.98}, {"$TC_DP12[2,1]", 0.0}}},
      {"outside, inverted", kAtShaft + call("202", "10000001"), shaft(), {{"$TC_DP12[2,1]", 0.02}}},
      {"outside, length 2", kAtShaft + call("202", "200001"), shaft(), {{"$TC_DP13[2,1]", -0.02}}},
      {"outside, length 3", kAtShaft + call("202", "300001"), shaft(), {{"$TC_DP14[2,1]", -0.02}}},
      {"outside, radius", kAtShaft + call("202", "400001"), shaft(), {{"$TC_DP15[2,1]", -0.02}}},
      {"outside, additive",
       kAtShaft + call("202", "1000001", "ROUGHER", ",1"),
       shaft(),
       {{"$TC_SCP13[2,1]", -0.02}, {"_OVI[13]", 1}}},
      {"outside, set-up",
       kAtShaft + call("202", "3000001", "ROUGHER", ",1"),
       shaft(),
       {{"$TC_ECP13[2,1]", -0.02}}},
      {"outside, set-up takes the additive one",
       "$TC_SCP13[2,1]=0.005\n" + kAtShaft + call("202", "2000001", "ROUGHER", ",1"),
       shaft(),
       {{"$TC_ECP13[2,1]", -0.015}, {"$TC_SCP13[2,1]", 0.0}}},
      {"nobody named", kAtShaft + call("202", "1", ""), shaft(), {{"_OVR[20]", 0.0}}},
      {"no edge named", kAtShaft + call("202", "0"), shaft(), {{"$TC_DP12[2,1]", 0.0}}},
  });
}

TEST(TurningCycle, ToolsAreCorrectedInTheLengthOfTheMeasuredAxis) {
  const std::string mask =
      "[machine_data]\n\"$MC_TOOL_PARAMETER_DEF_MASK\" = 3\n[tools.1]\nlength = 200.0\n";
  expect_each(std::vector<Case>{
      {"outside with reversal", kAtShaft + call("10202", "1"), shaft(), {{"$TC_DP12[2,1]", -0.02}}},
      {"outside, a drill has X second",
       kAtShaft + call("202", "1", "DRILL"),
       shaft(),
       {{"$TC_DP13[3,1]", -0.02}}},
      {"outside, wear in diameter",
       kAtShaft + call("202", "1"),
       shaft() + mask,
       {{"$TC_DP12[2,1]", -0.04}}},
      {"outside, length in diameter",
       kAtShaft + call("202", "4000001"),
       shaft() + mask,
       {{"$TC_DP3[2,1]", 89.96}}},
      {"face",
       kAtFace + "CYCLE974(200,,1,1,0.2,1,3,5,,1,\"ROUGHER\")",
       shaft(),
       {{"$TC_DP13[2,1]", 0.2}}},
      {"face, a drill has Z third",
       kAtFace + "CYCLE974(200,,1,1,0.2,1,3,5,,1,\"DRILL\")",
       shaft(),
       {{"$TC_DP14[3,1]", 0.2}}},
      {"face on the counter spindle",
       "G55 DIAMON G0 X20 Z10\nCYCLE974(200,,1,1,0.2,1,3,5,,1,\"ROUGHER\")",
       part("shaft", 0.0, 0.0, 700.0, "height = 100.0"),
       {{"$TC_DP13[2,1]", -0.2}}},
  });
  expect_each(
      std::vector<Case>{
          {"inside", kInBore + call("201", "1"), bushing(), {{"$TC_DP12[2,1]", -0.02}}},
          {"inside, radius", kInBore + call("201", "400001"), bushing(), {{"$TC_DP15[2,1]", 0.02}}},
          {"two points",
           kAtShaft + "CYCLE994(1202,,1,1,50,2,20,30,3,5,1,\"ROUGHER\")",
           shaft(),
           {{"$TC_DP12[2,1]", -0.02}}},
      },
      kProbeToMinusZ);
}

TEST(TurningCycle, WorkOffsetsGoToWhatWasMeasured) {
  expect_each(std::vector<Case>{
      {"fine",
       kAtShaft + "CYCLE974(102,1,,1,50,2,3,5)",
       shaft(),
       {{"$P_UIFR[1,X,FI]", 0.02},
        {"$P_UIFR[1,X,TR]", 0.0},
        {"$P_UIFR[1,Z,TR]", 200.0},
        {"_OVI[0]", 1},
        {"_OVI[11]", 0}}},
      {"coarse",
       kAtFace + "CYCLE974(100,10001,,1,0.2,1,3,5)",
       shaft(),
       {{"$P_UIFR[1,Z,TR]", 199.8}, {"$P_UIFR[1,X,TR]", 0.0}}},
      {"the active one",
       kAtFace + "CYCLE974(100,9000,,1,0.2,1,3,5)",
       shaft(),
       {{"$P_UIFR[1,Z,FI]", -0.2}, {"$AA_IW[Z]", 6.4}}},
      {"another one",
       kAtFace + "CYCLE974(100,10003,,1,0.2,1,3,5)",
       shaft(),
       {{"$P_UIFR[3,Z,TR]", 199.8}}},
      {"a basic frame",
       kAtFace + "CYCLE974(100,11002,,1,0.2,1,3,5)",
       shaft(),
       {{"$P_CHBFR[1,Z,TR]", -0.2}}},
      {"a global basic frame",
       kAtFace + "CYCLE974(100,13001,,1,0.2,1,3,5)",
       shaft(),
       {{"$P_NCBFR[0,Z,TR]", -0.2}}},
      {"the basic reference",
       kAtFace + "CYCLE974(100,12000,,1,0.2,1,3,5)",
       shaft(),
       {{"$P_SETFR[Z,TR]", -0.2}}},
      {"none", kAtFace + "CYCLE974(100,0,,1,0.2,1,3,5)", shaft(), {{"$P_UIFR[1,Z,TR]", 200.0}}},
      {"on the counter spindle",
       "G55 DIAMON G0 X20 Z10\nCYCLE974(100,2,,1,0.2,1,3,5)",
       part("shaft", 0.0, 0.0, 700.0, "height = 100.0"),
       {{"$P_UIFR[2,Z,FI]", 0.2}}},
  });
  expect_each(std::vector<Case>{{"the middle of two points",
                                 kAtShaft + "CYCLE994(1102,1,,1,50,2,20,30,3,5)",
                                 shaft(50.04, 0.03),
                                 {{"$P_UIFR[1,X,FI]", 0.03}, {"_OVR[4]", 50.04}}}},
              kProbeToMinusZ);
}

/// S_TZL 0.01, S_TDIF 0.3, limits 0.1 and -0.1, S_TMV 0.06, weight 2, memories 1 and 1.
TEST(TurningCycle, TolerancesAreThoseOfTheDiameter) {
  const auto judged = [](const char* upper, const char* lower, const char* memories) {
    return fmt::format("{}CYCLE974(202,,1,1,50,2,3,5,,1,\"ROUGHER\",,0.01,0.3,{},{},0.06,2,{},,,1)",
                       kAtShaft, upper, lower, memories);
  };
  expect_each(std::vector<Case>{
      {"within the zero range",
       judged("0.1", "-0.1", "0"),
       shaft(50.01),
       {{"$TC_DP12[2,1]", 0.0},
        {"_OVR[8]", 0.1},
        {"_OVR[12]", -0.1},
        {"_OVR[27]", 0.01},
        {"_OVR[28]", 5.0},
        {"_OVR[29]", 0.3},
        {"_OVI[4]", 2}}},
      {"corrected", judged("0.1", "-0.1", "0"), shaft(50.04), {{"$TC_DP12[2,1]", -0.02}}},
      {"limits that are not symmetric",
       judged("0.1", "0", "0"),
       shaft(50.045),
       {{"_OVR[0]", 50.05}, {"_OVR[16]", -0.005}, {"$TC_DP12[2,1]", 0.0}}},
      {"mean value",
       judged("0.1", "-0.1", "10000"),
       shaft(50.04),
       {{"$TC_DP12[2,1]", -0.01}, {"_OVR[31]", 0.02}, {"_OVI[6]", 1}}},
      {"empirical value",
       "$SCS_MEA_EMPIRIC_VALUE[0]=0.02\n" + judged("0.1", "-0.1", "1"),
       shaft(50.04),
       {{"$TC_DP12[2,1]", -0.01}, {"_OVR[30]", 0.02}, {"_OVI[7]", 1}}},
      {"oversize",
       judged("0.1", "-0.1", "0"),
       shaft(50.2),
       {{"_OVI[9]", 61304}, {"$TC_DP12[2,1]", -0.1}}},
      {"undersize",
       judged("0.1", "-0.1", "0"),
       shaft(49.8),
       {{"_OVI[9]", 61305}, {"$TC_DP12[2,1]", 0.1}}},
      {"dimension difference", judged("0.1", "-0.1", "0"), shaft(50.4), {{"_OVI[9]", 61306}}},
  });
}

}  // namespace
}  // namespace g31::testing::turning_cycle_test

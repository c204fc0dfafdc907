// CYCLE976: a late signal (0.005 mm at 300 mm/min) and an eccentric ball (0.02, -0.03), found on
// ring, ball and edges; afterwards the other cycles read true sizes.

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::calibration_cycle_test {
namespace {

constexpr double kDelay = 0.005;  // mm: 300 mm/min for 1 ms
constexpr double kEffective = 3.0 - kDelay;
constexpr double kX = 0.02;
constexpr double kY = -0.03;
constexpr double kNear = 1e-4;

const std::string kMinus1 = "$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]";
const std::string kPlus1 = "$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]";
const std::string kMinus2 = "$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]";
const std::string kPlus2 = "$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]";
const std::string kMinus3 = "$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]";
const std::string kDiameter = "$SNS_MEA_WP_BALL_DIAM[0]";
const std::string kOff1 = "$SNS_MEA_WP_POS_DEV_AX1[0]";
const std::string kOff2 = "$SNS_MEA_WP_POS_DEV_AX2[0]";

std::string ball() {
  return part("sphere", 99.8, 50.3, -300.0, "diameter = 25.0");
}
std::string groove(double turned = 0.0) {
  return part("groove", 100.0, 50.0, -300.0,
              fmt::format("width = 30.0\nrotate_deg = [0.0, 0.0, {:.1f}]", turned));
}

std::vector<ExpectedValue> first_axis() {
  return {{kMinus1, -kEffective}, {kPlus1, kEffective}, {kOff1, kX}};
}
std::vector<ExpectedValue> second_axis() {
  return {{kMinus2, -kEffective}, {kPlus2, kEffective}, {kOff2, kY}};
}
std::vector<ExpectedValue> joined(std::vector<ExpectedValue> all,
                                  const std::vector<ExpectedValue>& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}
std::vector<ExpectedValue> both_axes() {
  return joined(joined(first_axis(), second_axis()), {{kDiameter, 2.0 * kEffective}});
}

TEST(CalibrationCycle, RingBallAndEdgesGiveTheSameProbe) {
  const MeasuringCase kRows[] = {
      {"ring, centre not known", ring_aside(), "Z-5\nCYCLE976(2,1,40,,,,5,5)",
       joined(both_axes(), {{"_OVR[6]", 0.2}, {"_OVR[7]", -0.3}, {"$AA_IW[X]", 0.2}})},
      {"ring, centre not known, with the digit of one direction", ring_aside(),
       "Z-5\nCYCLE976(1002,1,40,,,,5,5)",
       joined(both_axes(), {{"_OVR[6]", 0.2}, {"_OVR[7]", -0.3}, {"$AA_IW[X]", 0.2}})},
      {"ring, centre not known, with the digit of one axis", ring_aside(),
       "Z-5\nCYCLE976(2002,1,40,,1,,5,5)", both_axes()},
      {"ball, with the digit of one direction", ball(), "CYCLE976(1001003,1,25,12.5,,,5,5)",
       joined(both_axes(),
              {{"_OVR[22]", 120.0 - kDelay}, {"$TC_DP3[1,1]", 120.0 - kDelay}, {kMinus3, 0.0}})},
      {"ring, centre known", ring_aside(), "X0.2 Y-0.3 Z-5\nCYCLE976(1,1,40,,,,5,5)", both_axes()},
      {"ring, from an angle",
       part("ring", 100.2, 49.7, -300.0, "bore = 40.0\nrotate_deg = [0.0, 0.0, 30.0]"),
       "X0.2 Y-0.3 Z-5\nCYCLE976(100001,1,40,,,,5,5,,30)",
       joined(both_axes(), {{"_OVR[24]", 30.0}})},
      {"ring, both directions of the first axis", ring_aside(),
       "X0.2 Y-0.3 Z-5\nCYCLE976(2001,1,40,,1,,5,5)", first_axis()},
      {"ring, both directions of the second axis", ring_aside(),
       "X0.2 Y-0.3 Z-5\nCYCLE976(2001,1,40,,2,,5,5)", second_axis()},
      {"ring, one direction",
       ring_aside(),
       "X0.2 Y-0.3 Z-5\nCYCLE976(1001,1,40,,2,1,5,5)",
       {{kMinus2, -kEffective}, {kOff2, kY}, {kPlus2, 0.0}, {kPlus1, 0.0}}},
      {"ball, with the length", ball(), "CYCLE976(1000003,1,25,12.5,,,5,5)",
       joined(both_axes(),
              {{"_OVR[22]", 120.0 - kDelay}, {"$TC_DP3[1,1]", 120.0 - kDelay}, {kMinus3, 0.0}})},
      {"ball, the 3rd axis without the length", ball(), "CYCLE976(2000003,1,25,12.5,,,5,5)",
       joined(both_axes(), {{"$TC_DP3[1,1]", 120.0}, {kMinus3, kDelay}})},
      {"ball, pole not known", ball(), "CYCLE976(3,1,25,,,,10,5)", both_axes()},
      {"ball, along a circle", ball(), "CYCLE976(100003,1,25,,,,10,5)", both_axes()},
      {"ball, the tool's length to the middle of the probe's ball", ball(),
       "$MNS_MEA_FUNCTION_MASK=1\n$TC_DP3[1,1]=117\nD1\nCYCLE976(3,1,25,,,,10,5)", both_axes()},
      {"two edges, first axis", groove(), "Z-5\nCYCLE976(5,1,30,,1,,5,5,,,,-15)",
       joined(first_axis(), {{kDiameter, 2.0 * kEffective}})},
      {"two edges, second axis", groove(90.0), "Z-5\nCYCLE976(5,1,-30,,2,,5,5,,,,15)",
       joined(second_axis(), {{kDiameter, 2.0 * kEffective}})},
      {"edge, plus",
       groove(),
       "X10 Z-5\nCYCLE976(4,1,15,,1,0,3,5)",
       {{kPlus1, kEffective}, {kMinus1, 0.0}, {kOff1, kX}, {kDiameter, 6.0}}},
      {"edge, minus",
       groove(90.0),
       "Y-10 Z-5\nCYCLE976(4,1,-15,,2,1,3,5)",
       {{kMinus2, -kEffective}, {kPlus2, 0.0}, {kOff2, kY}}},
  };
  for (const MeasuringCase& row : kRows) {
    SCOPED_TRACE(row.name);
    expect_measured(row.program, {row.parts, kBentProbe},
                    joined(row.expected, {{"_OVI[2]", 976}, {"_OVI[5]", 1}, {"_OVI[9]", 0}}),
                    kNear);
  }
}

TEST(CalibrationCycle, WithoutThePlaceOfTheBallTheTriggersContainIt) {
  expect_measured("X0.2 Y-0.3 Z-5\nCYCLE976(10001,1,40,,,,5,5)", {ring_aside(), kBentProbe},
                  {{kMinus1, kX - kEffective},
                   {kPlus1, kX + kEffective},
                   {kMinus2, kY - kEffective},
                   {kPlus2, kY + kEffective},
                   {kOff1, 0.0},
                   {kOff2, 0.0}},
                  kNear);
  expect_measured("X10 Z-5\nCYCLE976(10004,1,15,,1,0,3,5)", {groove(), kBentProbe},
                  {{kPlus1, kX + kEffective}, {kOff1, 0.0}}, kNear);
}

TEST(CalibrationCycle, ResultsOfARingAreActualValuesAndWhatChanged) {
  const std::string old_record =
      "[variables]\n\"$SNS_MEA_WP_BALL_DIAM[2]\" = 5.0\n\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[2]\" = "
      "-2.5\n";
  expect_measured("Z-5\nCYCLE976(2,3,40,,,,5,4,300)", {ring_aside() + old_record, kBentProbe},
                  {{"_OVR[4]", 2 * kEffective},
                   {"_OVR[5]", 2 * kEffective - 5.0},
                   {"_OVR[6]", 0.2},
                   {"_OVR[7]", -0.3},
                   {"_OVR[8]", -kEffective},
                   {"_OVR[9]", 2.5 - kEffective},
                   {"_OVR[10]", kEffective},
                   {"_OVR[11]", kEffective},
                   {"_OVR[12]", -kEffective},
                   {"_OVR[13]", -kEffective},
                   {"_OVR[14]", kEffective},
                   {"_OVR[15]", kEffective},
                   {"_OVR[20]", kX},
                   {"_OVR[21]", kY},
                   {"_OVR[24]", 0.0},
                   {"_OVR[27]", 0.0},
                   {"_OVR[28]", 4.0},
                   {"_OVI[2]", 976},
                   {"_OVI[5]", 3},
                   {"_OVI[9]", 0},
                   {"$SNS_MEA_WP_FEED[2]", 300.0},
                   {"$TC_DP6[1,1]", kEffective},
                   {kPlus1, 0.0}},
                  kNear);
}

TEST(CalibrationCycle, OnlyTheChosenAxisHasResults) {
  expect_measured("_OVR[12]=77\n_OVR[13]=77\nX10 Z-5\nCYCLE976(4,1,15,,1,0,3,5)",
                  {groove(), kBentProbe},
                  {{"_OVR[4]", 6.0},
                   {"_OVR[5]", 6.0},
                   {"_OVR[8]", 0.0},
                   {"_OVR[9]", 0.0},
                   {"_OVR[10]", kEffective},
                   {"_OVR[11]", kEffective},
                   {"_OVR[12]", 77.0},
                   {"_OVR[13]", 77.0},
                   {"_OVR[20]", kX},
                   {"_OVR[21]", 0.0},
                   {"_OVR[28]", 5.0}},
                  kNear);
}

TEST(CalibrationCycle, LengthOnAFace) {
  const std::string plate = part("block", 100.0, 50.0, -299.5, "");
  expect_measured("Z3\nCYCLE976(1000,1,0.5,,3,1,3,5)", {plate, kBentProbe},
                  {{kMinus3, kDelay},
                   {"_OVR[4]", 6.0},
                   {"_OVR[5]", 6.0},
                   {"_OVR[16]", kDelay},
                   {"_OVR[17]", kDelay},
                   {"_OVR[18]", 0.0},
                   {"_OVR[19]", 0.0},
                   {"_OVR[22]", 120.0},
                   {"_OVR[27]", 0.0},
                   {"_OVR[28]", 5.0},
                   {"$TC_DP3[1,1]", 120.0},
                   {"$AA_IW[Z]", 3.5}});
  // 0 is downwards, too; the length takes the delay and an error of 0.3 mm.
  expect_measured("$TC_DP3[1,1]=119.7\nD1\nZ3\nCYCLE976(1000000,1,0.5,,,,3,5)", {plate, kBentProbe},
                  {{kMinus3, 0.0},
                   {"_OVR[22]", 120.0 - kDelay},
                   {"$TC_DP3[1,1]", 120.0 - kDelay},
                   {"$P_TOOLL[1]", 120.0 - kDelay}});
  // An additive offset that is in force stays so; length and offset together are the true length.
  expect_measured(
      "$TC_DP3[1,1]=119.7 $TC_SCP13[1,1]=0.1\nD1 DL=1\nZ3\nCYCLE976(1000000,1,0.5,,,,3,5)",
      {plate, kBentProbe},
      {{"$TC_DP3[1,1]", 119.9 - kDelay},
       {"$TC_SCP13[1,1]", 0.1},
       {"$P_TOOLL[1]", 120.0 - kDelay},
       {"$P_DLNO", 1}});
  // Tool length to the ball's centre: the trigger is a radius away.
  expect_measured("$MNS_MEA_FUNCTION_MASK=1\n$TC_DP3[1,1]=117\nD1\nZ6\nCYCLE976(0,1,0.5,,,,3,5)",
                  {plate, kBentProbe}, {{kMinus3, kDelay - 3.0}, {"$AA_IW[Z]", 6.5}});
}

TEST(CalibrationCycle, ACalibratedProbeReadsTrueSizes) {
  struct Measured {
    const char* name;
    std::string shape;
    std::string program;
    std::vector<ExpectedValue> expected;
  };
  const Measured kRows[] = {
      {"hole",
       part("ring", 300.3, 50.1, -300.0, "bore = 30.0"),
       "Z-5\nCYCLE977(1,,,1,30,,,2,5)",
       {{"_OVR[4]", 30.0}, {"_OVR[5]", 0.3}, {"_OVR[6]", 0.1}}},
      {"hole in turned coordinates",
       part("ring", 300.3, 50.1, -300.0, "bore = 30.0\nrotate_deg = [0.0, 0.0, 40.0]"),
       "ROT Z40\nX0 Y0 Z-5\nCYCLE977(1,,,1,30,,,2,5)\nROT\nR1=$AA_IW[X] R2=$AA_IW[Y]",
       {{"_OVR[4]", 30.0}, {"R1", 0.3}, {"R2", 0.1}}},
      {"spigot",
       part("cylinder", 300.3, 50.1, -300.0, "diameter = 30.0"),
       "Z5\nCYCLE977(2,,,1,30,,,2,5,,-15)",
       {{"_OVR[4]", 30.0}, {"_OVR[5]", 0.3}, {"_OVR[6]", 0.1}}},
      {"rib at an angle",
       part("rib", 300.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 20.0]"),
       "Z5\nCYCLE977(4,,,1,20,,,2,5,20,-15,,,1)",
       {{"_OVR[4]", 20.0}, {"_OVR[5]", 0.0}}},
      {"pocket",
       part("pocket", 300.3, 50.1, -300.0, ""),
       "Z-5\nCYCLE977(5,,,1,,60,40,2,5)",
       {{"_OVR[4]", 60.0}, {"_OVR[5]", 40.0}, {"_OVR[6]", 0.3}, {"_OVR[7]", 0.1}}},
      {"edge",
       part("block", 300.3, 50.1, -300.0, ""),
       "X-40\nZ-5\nCYCLE978(0,,,1,-30,5,1,1,1)",
       {{"_OVR[4]", -29.7}}},
      {"height",
       part("block", 300.0, 50.0, -300.3, ""),
       "CYCLE978(0,,,1,0,5,1,3,2)",
       {{"_OVR[4]", -0.3}}},
  };
  const char* const kCalibrations[] = {"CYCLE976(2,1,40,,,,5,5)",
                                       "X0.2 Y-0.3\nCYCLE976(1,1,40,,,,5,5)",
                                       "X0.2 Y-0.3\nCYCLE976(10001,1,40,,,,5,5)"};
  for (const Measured& row : kRows) {
    for (const char* const calibration : kCalibrations) {
      SCOPED_TRACE(std::string(row.name) + " after " + calibration);
      const std::string program = std::string("Z-5\n") + calibration +
                                  "\nZ20\nX30\nZ3\nCYCLE976(0,1,0,,,,3,5)\nZ30\nG55 X0 Y0\nZ20\n" +
                                  row.program;
      const std::string offset = "[work_offsets.G55]\nX = 300.0\nY = 50.0\nZ = -300.0\n";
      expect_measured(program, {ring_aside() + row.shape + offset, kBentProbe}, row.expected,
                      kNear);
    }
  }
}

// A probe on three seats triggers differently all around: what is found in a ring and then used in
// the same directions leaves nothing of it, however the coordinates and the first touch are turned.
TEST(CalibrationCycle, LobesCancelInTheDirectionsThatWereCalibrated) {
  const std::string ring = part("ring", 100.0, 50.0, -300.0, "bore = 40.0");
  const std::string tripod =
      "[probe]\nseats = \"tripod\"\ntrigger_force = 0.5\nstem_stiffness = 10.0\n"
      "weak_direction_deg = 30.0\n";
  const std::string program =
      "Z-5\nROT RPL={0}\nCYCLE976(100002,1,40,,,,5,5,,{1})\nCYCLE977(1,,,1,40,,,5,5,{1})";
  for (const double turned : {0.0, 20.0, 30.0, 60.0, 90.0, 115.0, 330.0}) {
    for (const double start_angle : {0.0, 10.0, -31.0}) {
      SCOPED_TRACE(fmt::format("turned by {}, from {}", turned, start_angle));
      expect_measured(fmt::format(fmt::runtime(program), turned, start_angle), {ring, tripod},
                      {{"_OVR[4]", 40.0}});
    }
  }
}

TEST(CalibrationCycle, AnotherFeedMakesTheOldValuesWorthless) {
  const std::string twice =
      "X0.2 Y-0.3 Z-5\nCYCLE976(2001,1,40,,1,,5,5,300)\nCYCLE976(2001,1,40,,2,,5,5,{})";
  expect_measured(fmt::format(fmt::runtime(twice), 300), {ring_aside(), kBentProbe},
                  {{kPlus1, kEffective}, {kPlus2, kEffective}}, kNear);
  expect_measured(fmt::format(fmt::runtime(twice), 600), {ring_aside(), kBentProbe},
                  {{kPlus1, 0.0}, {kPlus2, kEffective - kDelay}, {"$SNS_MEA_WP_FEED[0]", 600.0}},
                  kNear);
}

TEST(CalibrationCycle, RefusesWithItsOwnAlarmAndKeepsTheOldRecord) {
  struct Refusal {
    const char* name;
    const char* program;
    int alarm;
  };
  const Refusal kRows[] = {
      {"the change is larger than TSA", "Z-5\nCYCLE976(2,1,40,,,,5,1)", 61303},
      {"no such variant", "Z-5\nCYCLE976(7,1,40,,,,5,5)", 61307},
      {"no path", "Z-5\nCYCLE976(2,1,40,,,,0,5)", 61308},
      {"a mill", "T2 M6\nZ-5\nCYCLE976(2,1,40,,,,5,5)", 61309},
      {"no tool", "D0\nCYCLE976(2,1,40,,,,5,5)", 61311},
      {"no such record", "Z-5\nCYCLE976(2,41,40,,,,5,5)", 61313},
      {"a ring that is not there", "Z-5\nCYCLE976(2,1,20,,,,2,5)", 61301},
      {"length in the plane", "Z-5\nCYCLE976(1000,1,0,,1,1,3,5)", 61325},
      {"a spindle that cannot be positioned",
       "$MNS_MEA_FUNCTION_MASK=19\nZ-5\nCYCLE976(2,1,40,,,,5,5)", 61372},
  };
  for (const Refusal& row : kRows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run =
        run_measuring(row.program, {ring_aside()}, {kDiameter, kPlus1, "_OVI[9]"});
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at("_OVI[9]"), row.alarm);
    EXPECT_EQ(run.at(kDiameter), 0.0);
    EXPECT_EQ(run.at(kPlus1), 0.0);
  }
}

TEST(CalibrationCycle, AMonoProbeIsTurnedIntoEachDirection) {
  const std::string mono =
      "[tools.1]\nlength = 120.0\nradius = 3.0\ntype = 712.0\n[probe]\ntype = \"mono\"\n"
      "direction_deg = 30.0\ntrigger_delay_s = 0.001\n[variables]\n\"$TC_DP10[1,1]\" = 330.0\n";
  expect_measured("Z-5\nCYCLE976(2,1,40,,,,5,5)\nCYCLE977(1,,,1,40,,,2,5)", {ring_aside(), mono},
                  {{kPlus1, kEffective},
                   {kMinus2, -kEffective},
                   {"_OVR[4]", 40.0},
                   {"_OVR[5]", 0.2},
                   {"_OVR[6]", -0.3}},
                  kNear);
}

}  // namespace
}  // namespace g31::testing::calibration_cycle_test

// CYCLE977: each variant on a part whose size and place the test chose.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::feature_cycle_test {
namespace {

// Parts stand 0.2 and -0.3 from where the program believes them; G54 is at (100, 50, -300).
constexpr double kDx = 0.2;
constexpr double kDy = -0.3;

const double kSin10 = std::sin(10.0 * std::numbers::pi / 180.0);
const double kCos10 = std::cos(10.0 * std::numbers::pi / 180.0);
/// The offset of the part along and across a direction turned by 10 degrees.
const double kAlong = kDx * kCos10 + kDy * kSin10;

std::vector<MeasuringCase> round_features() {
  return {{"hole",
           part_aside("ring", "bore = 40.0"),
           "Z-5\nCYCLE977(1,,,1,40.01,,,2,5)",
           {{"_OVR[0]", 40.01},
            {"_OVR[1]", 0.0},
            {"_OVR[2]", 0.0},
            {"_OVR[4]", 40.0},
            {"_OVR[5]", kDx},
            {"_OVR[6]", kDy},
            {"_OVR[16]", -0.01},
            {"_OVR[17]", kDx},
            {"_OVR[18]", kDy},
            {"_OVI[2]", 977},
            {"_OVI[3]", 1},
            {"_OVI[5]", 1},
            {"_OVI[9]", 0},
            {"$AA_IW[X]", kDx},
            {"$AA_IW[Y]", kDy},
            {"$AA_IW[Z]", -5.0}}},
          {"hole from a start angle",
           part_aside("ring", "bore = 40.0\nrotate_deg = [0.0, 0.0, 30.0]"),
           "Z-5\nCYCLE977(1,,,1,40,,,2,5,30)",
           {{"_OVR[4]", 40.0}, {"_OVR[5]", kDx}, {"_OVR[6]", kDy}}},
          {"circular spigot",
           part_aside("cylinder", "diameter = 30.0"),
           "Z5\nCYCLE977(2,,,1,30,,,2,5,0,-15)",
           {{"_OVR[0]", 30.0},
            {"_OVR[1]", 0.0},
            {"_OVR[2]", 0.0},
            {"_OVR[4]", 30.0},
            {"_OVR[5]", kDx},
            {"_OVR[6]", kDy},
            {"_OVR[16]", 0.0},
            {"_OVR[17]", kDx},
            {"_OVR[18]", kDy},
            {"_OVI[3]", 2},
            {"$AA_IW[Z]", 5.0}}}};
}

std::vector<MeasuringCase> grooves_and_ribs() {
  return {{"groove across the first axis",
           part_aside("groove", "width = 20.0"),
           "Z-5\nCYCLE977(3,,,1,20.1,,,2,5,,,,,1)",
           {{"_OVR[0]", 20.1},
            {"_OVR[4]", 20.0},
            {"_OVR[5]", kDx},
            {"_OVR[6]", 0.0},
            {"_OVR[16]", -0.1},
            {"_OVR[17]", kDx},
            {"_OVR[18]", 0.0},
            {"_OVI[3]", 3}}},
          {"groove across the second axis",
           part_aside("groove", "width = 20.0\nrotate_deg = [0.0, 0.0, 90.0]"),
           "Z-5\nCYCLE977(3,,,1,20,,,2,5,,,,,2)",
           {{"_OVR[4]", 20.0},
            {"_OVR[5]", 0.0},
            {"_OVR[6]", kDy},
            {"_OVR[17]", 0.0},
            {"_OVR[18]", kDy}}},
          {"groove at an angle",
           part_aside("groove", "width = 20.0\nrotate_deg = [0.0, 0.0, 10.0]"),
           "Z-5\nCYCLE977(3,,,1,20,,,2,5,10,,,,1)",
           {{"_OVR[4]", 20.0}, {"_OVR[5]", kAlong * kCos10}, {"_OVR[6]", kAlong * kSin10}}},
          {"rib",
           part_aside("rib", "width = 20.0"),
           "Z5\nCYCLE977(4,,,1,19.9,,,2,5,,-15,,,1)",
           {{"_OVR[0]", 19.9},
            {"_OVR[4]", 20.0},
            {"_OVR[5]", kDx},
            {"_OVR[6]", 0.0},
            {"_OVR[16]", 0.1},
            {"_OVR[17]", kDx},
            {"_OVR[18]", 0.0},
            {"_OVI[3]", 4},
            {"$AA_IW[X]", kDx},
            {"$AA_IW[Z]", 5.0}}}};
}

std::vector<MeasuringCase> rectangles() {
  return {{"rectangular pocket",
           part_aside("pocket", "length = 60.0\nwidth = 40.0"),
           "Z-5\nCYCLE977(5,,,1,,60.1,39.9,2,5)",
           {{"_OVR[0]", 60.1},
            {"_OVR[1]", 39.9},
            {"_OVR[2]", 0.0},
            {"_OVR[3]", 0.0},
            {"_OVR[4]", 60.0},
            {"_OVR[5]", 40.0},
            {"_OVR[6]", kDx},
            {"_OVR[7]", kDy},
            {"_OVR[16]", -0.1},
            {"_OVR[17]", 0.1},
            {"_OVR[18]", kDx},
            {"_OVR[19]", kDy},
            {"_OVI[3]", 5}}},
          {"rectangular spigot, turned",
           part_aside("block", "rotate_deg = [0.0, 0.0, 10.0]"),
           "Z5\nCYCLE977(6,,,1,,60,40,2,5,10,-15)",
           {{"_OVR[0]", 60.0},
            {"_OVR[1]", 40.0},
            {"_OVR[4]", 60.0},
            {"_OVR[5]", 40.0},
            {"_OVR[6]", kDx},
            {"_OVR[7]", kDy},
            {"_OVR[18]", kDx},
            {"_OVR[19]", kDy},
            {"_OVI[3]", 6},
            {"$AA_IW[Z]", 5.0}}}};
}

std::vector<MeasuringCase> protected_features() {
  return {
      {"hole round a spigot, with its protection zone",
       part_aside("ring", "bore = 60.0") + part("plug", 100.0, 50.0, -295.0, "diameter = 20.0"),
       "Z15\nCYCLE977(1001,,,1,60,,,12,5,,-25,22)",
       {{"_OVR[4]", 60.0}, {"_OVR[5]", kDx}, {"_OVR[6]", kDy}, {"$AA_IW[Z]", 15.0}}},
      {"spigot within a ring, with its protection zone",
       part_aside("cylinder", "diameter = 30.0") + part("ring", 100.0, 50.0, -300.0, "bore = 52.0"),
       "Z15\nCYCLE977(1002,,,1,30,,,9,5,,-25,50)",
       {{"_OVR[4]", 30.0}, {"_OVR[5]", kDx}, {"_OVR[6]", kDy}, {"$AA_IW[Z]", 15.0}}},
      {"groove with a rib in it",
       part_aside("groove", "width = 40.0") +
           part("rib", 100.0, 50.0, -290.0,
                "width = 6.0\nheight = 25.0\nshoulder = 1.0\nbase = 1.0"),
       "Z20\nCYCLE977(1003,,,1,40,,,9,5,,-25,8,,1)",
       {{"_OVR[4]", 40.0}, {"_OVR[5]", kDx}}}};
}

std::vector<MeasuringCase> other_arguments() {
  return {{"set point of the centre given",
           part_aside("ring", "bore = 40.0"),
           "X0.1 Z-5\nCYCLE977(1,,,1,40,,,2,5,,,,,,,,,,,,,,,,,,,0.05,0)",
           {{"_OVR[1]", 0.05},
            {"_OVR[2]", 0.0},
            {"_OVR[5]", kDx},
            {"_OVR[17]", kDx - 0.05},
            {"_OVR[18]", kDy}}},
          {"set point of the centre is where the cycle begins",
           part_aside("ring", "bore = 40.0"),
           "X0.1 Z-5\nCYCLE977(1,,,1,40,,,2,5)",
           {{"_OVR[1]", 0.1}, {"_OVR[5]", kDx}, {"_OVR[17]", kDx - 0.1}}},
          {"three touches each",
           part_aside("ring", "bore = 40.0"),
           "Z-5\nCYCLE977(1,,,1,40,,,2,5,,,,,,3)",
           {{"_OVR[4]", 40.0}, {"_OVR[5]", kDx}, {"_OVR[6]", kDy}}}};
}

TEST(FeatureCycle, HolesAndSpigots) {
  expect_measured(round_features());
}

TEST(FeatureCycle, GroovesAndRibs) {
  expect_measured(grooves_and_ribs());
}

TEST(FeatureCycle, Rectangles) {
  expect_measured(rectangles());
}

TEST(FeatureCycle, ProtectionZones) {
  expect_measured(protected_features());
}

/// The probe stands upright, the part and its coordinates lean by 3 degrees: the ball's middle is
/// not above the tip in them, nor the tip the ball's lowest point; a ball off the axis is higher on
/// one side.
TEST(FeatureCycle, CoordinatesThatLeanAgainstTheProbe) {
  const std::string block = part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 3.0, 0.0]");
  const std::string program =
      "ROT Y3\nX-42 Z20\nZ-8\nCYCLE978({},,,1,-30,5,5,1,1)\nR1=_OVR[4]\nZ20\nX0\nZ5\n"
      "CYCLE978(0,,,1,0,5,5,3,2)\nR2=_OVR[4]\nROT";
  const std::vector<ExpectedValue> expected = {{"R1", -30.0}, {"R2", 0.0}};
  expect_measured(fmt::format(fmt::runtime(program), 0), {block, kCalibrated}, expected, 1e-9);
  const char* const off_axis =
      "[probe]\neccentricity = [0.2, -0.3]\n[variables]\n"
      "\"$SNS_MEA_WP_POS_DEV_AX1[0]\" = 0.2\n\"$SNS_MEA_WP_POS_DEV_AX2[0]\" = -0.3\n";
  for (const int turned_along : {0, 20000}) {
    expect_measured(fmt::format(fmt::runtime(program), turned_along),
                    {block, kCalibrated, off_axis}, expected, 1e-9);
  }
}

TEST(FeatureCycle, SetPointOfTheCentreAndRepetition) {
  expect_measured(other_arguments());
}

}  // namespace
}  // namespace g31::testing::feature_cycle_test

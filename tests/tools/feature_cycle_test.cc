// CYCLE977: each variant on a part whose size and place the test chose.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31 {
namespace {

using testing::expect_measured;
using testing::ExpectedValue;
using testing::kCalibrated;
using testing::part;

// Parts stand 0.2 and -0.3 from where the program believes them; G54 is at (100, 50, -300).
constexpr double kDx = 0.2;
constexpr double kDy = -0.3;

std::string here(const std::string& shape, const std::string& more) {
  return part(shape, 100.0 + kDx, 50.0 + kDy, -300.0, more);
}

struct Variant {
  const char* name;
  std::string parts;  ///< of a set-up sheet
  std::string program;
  std::vector<ExpectedValue> expected;
};

const double kSin10 = std::sin(10.0 * std::numbers::pi / 180.0);
const double kCos10 = std::cos(10.0 * std::numbers::pi / 180.0);
/// The offset of the part along and across a direction turned by 10 degrees.
const double kAlong = kDx * kCos10 + kDy * kSin10;

std::vector<Variant> round_features() {
  return {{"hole",
           here("ring", "bore = 40.0"),
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
           here("ring", "bore = 40.0\nrotate_deg = [0.0, 0.0, 30.0]"),
           "Z-5\nCYCLE977(1,,,1,40,,,2,5,30)",
           {{"_OVR[4]", 40.0}, {"_OVR[5]", kDx}, {"_OVR[6]", kDy}}},
          {"circular spigot",
           here("cylinder", "diameter = 30.0"),
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

std::vector<Variant> grooves_and_ribs() {
  return {{"groove across the first axis",
           here("groove", "width = 20.0"),
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
           here("groove", "width = 20.0\nrotate_deg = [0.0, 0.0, 90.0]"),
           "Z-5\nCYCLE977(3,,,1,20,,,2,5,,,,,2)",
           {{"_OVR[4]", 20.0},
            {"_OVR[5]", 0.0},
            {"_OVR[6]", kDy},
            {"_OVR[17]", 0.0},
            {"_OVR[18]", kDy}}},
          {"groove at an angle",
           here("groove", "width = 20.0\nrotate_deg = [0.0, 0.0, 10.0]"),
           "Z-5\nCYCLE977(3,,,1,20,,,2,5,10,,,,1)",
           {{"_OVR[4]", 20.0}, {"_OVR[5]", kAlong * kCos10}, {"_OVR[6]", kAlong * kSin10}}},
          {"rib",
           here("rib", "width = 20.0"),
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

std::vector<Variant> rectangles() {
  return {{"rectangular pocket",
           here("pocket", "length = 60.0\nwidth = 40.0"),
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
           here("block", "rotate_deg = [0.0, 0.0, 10.0]"),
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

std::vector<Variant> protected_features() {
  return {{"hole round a spigot, with its protection zone",
           here("ring", "bore = 60.0") + part("plug", 100.0, 50.0, -295.0, "diameter = 20.0"),
           "Z15\nCYCLE977(1001,,,1,60,,,12,5,,-25,22)",
           {{"_OVR[4]", 60.0}, {"_OVR[5]", kDx}, {"_OVR[6]", kDy}, {"$AA_IW[Z]", 15.0}}},
          {"spigot within a ring, with its protection zone",
           here("cylinder", "diameter = 30.0") + part("ring", 100.0, 50.0, -300.0, "bore = 52.0"),
           "Z15\nCYCLE977(1002,,,1,30,,,9,5,,-25,50)",
           {{"_OVR[4]", 30.0}, {"_OVR[5]", kDx}, {"_OVR[6]", kDy}, {"$AA_IW[Z]", 15.0}}},
          {"groove with a rib in it",
           here("groove", "width = 40.0") +
               part("rib", 100.0, 50.0, -290.0,
                    "width = 6.0\nheight = 25.0\nshoulder = 1.0\nbase = 1.0"),
           "Z20\nCYCLE977(1003,,,1,40,,,9,5,,-25,8,,1)",
           {{"_OVR[4]", 40.0}, {"_OVR[5]", kDx}}}};
}

std::vector<Variant> other_arguments() {
  return {{"set point of the centre given",
           here("ring", "bore = 40.0"),
           "X0.1 Z-5\nCYCLE977(1,,,1,40,,,2,5,,,,,,,,,,,,,,,,,,,0.05,0)",
           {{"_OVR[1]", 0.05},
            {"_OVR[2]", 0.0},
            {"_OVR[5]", kDx},
            {"_OVR[17]", kDx - 0.05},
            {"_OVR[18]", kDy}}},
          {"set point of the centre is where the cycle begins",
           here("ring", "bore = 40.0"),
           "X0.1 Z-5\nCYCLE977(1,,,1,40,,,2,5)",
           {{"_OVR[1]", 0.1}, {"_OVR[5]", kDx}, {"_OVR[17]", kDx - 0.1}}},
          {"three touches each",
           here("ring", "bore = 40.0"),
           "Z-5\nCYCLE977(1,,,1,40,,,2,5,,,,,,3)",
           {{"_OVR[4]", 40.0}, {"_OVR[5]", kDx}, {"_OVR[6]", kDy}}}};
}

void expect_variants(const std::vector<Variant>& variants) {
  for (const Variant& variant : variants) {
    SCOPED_TRACE(variant.name);
    expect_measured(variant.program, {variant.parts, kCalibrated}, variant.expected);
  }
}

TEST(FeatureCycle, HolesAndSpigots) {
  expect_variants(round_features());
}

TEST(FeatureCycle, GroovesAndRibs) {
  expect_variants(grooves_and_ribs());
}

TEST(FeatureCycle, Rectangles) {
  expect_variants(rectangles());
}

TEST(FeatureCycle, ProtectionZones) {
  expect_variants(protected_features());
}

TEST(FeatureCycle, SetPointOfTheCentreAndRepetition) {
  expect_variants(other_arguments());
}

}  // namespace
}  // namespace g31

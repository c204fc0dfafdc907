// Every result that the manual's tables list, for every variant of the measuring cycles: _OVR and
// _OVI hold something else before the call, so that an entry that is not written shows.

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::measuring_results_test {
namespace {

constexpr double kUnwritten = 99.5;
const std::string kBefore = "_OVR[0]=REP(99.5)\n_OVI[0]=REP(99)\n";

/// Record 3 is that of a perfect probe; empirical value 5 is 0.02 mm.
constexpr const char* kThirdRecord = R"([variables]
"$SNS_MEA_WP_BALL_DIAM[2]" = 6.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[2]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[2]" = -3.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[2]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[2]" = -3.0
"$SCS_MEA_EMPIRIC_VALUE[4]" = 0.02
)";

/// Tool, DL number, TZL, TDIF, TUL, TLL, TMV, weight, memories 2 and 5; tolerances count.
const std::string kLimits =
    "\"MILL\",7,0.01,0.5,0.3,-0.3,0.2,3,20005,,,1)\nR1=(_OVS_TNAME==\"MILL\")";

using Values = std::vector<ExpectedValue>;

Values joined(Values all, const Values& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// What any cycle says of the call.
Values call_of(int cycle, int variant) {
  return {{"_OVI[2]", 1.0 * cycle}, {"_OVI[3]", 1.0 * variant}, {"_OVI[5]", 3.0}, {"_OVI[9]", 0.0}};
}

/// The results of a tool offset by kLimits: the mean value of one deviation, and what is corrected.
Values tool_results(double deviation, double tool_per_deviation) {
  const double mean = (deviation - 0.02) / 3.0;
  return {{"_OVR[8]", 0.3},   {"_OVR[12]", -0.3}, {"_OVR[20]", mean * tool_per_deviation},
          {"_OVR[27]", 0.01}, {"_OVR[28]", 5.0},  {"_OVR[29]", 0.5},
          {"_OVR[30]", 0.02}, {"_OVR[31]", mean}, {"_OVI[0]", 1.0},
          {"_OVI[4]", 3.0},   {"_OVI[6]", 2.0},   {"_OVI[7]", 5.0},
          {"_OVI[8]", 2.0},   {"_OVI[10]", 0.0},  {"_OVI[13]", 7.0},
          {"R1", 1.0}};
}

/// From `_OVR[first]` on the set points, 4 further on the actual values, 16 further the
/// differences.
Values dimensions(int first, const std::vector<double>& wanted, const std::vector<double>& found) {
  Values all;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const int at = first + static_cast<int>(i);
    all.push_back({fmt::format("_OVR[{}]", at), wanted[i]});
    all.push_back({fmt::format("_OVR[{}]", at + 4), found[i]});
    all.push_back({fmt::format("_OVR[{}]", at + 16), found[i] - wanted[i]});
  }
  return all;
}

struct Variant {
  const char* name;
  std::string parts;
  std::string program;
  Values expected;
  double tolerance = 1e-6;
};

void expect_results(const std::vector<Variant>& variants, const std::string& probe) {
  for (const Variant& row : variants) {
    SCOPED_TRACE(row.name);
    expect_measured(kBefore + row.program, {row.parts, probe}, row.expected, row.tolerance);
  }
}

TEST(MeasuringResults, OfHolesSpigotsGroovesAndRibs) {
  const std::string call =
      "X0.05 Y0.02\nZ{}\nCYCLE977({},,4000001,3,{},,,2,5,,{},,,{},1," + kLimits;
  const auto program = [&call](double height, int variant, double size, double down, int axis) {
    return fmt::format(fmt::runtime(call), height, variant, size, down, axis);
  };
  const Values hole = joined(call_of(977, 201), tool_results(0.1, 0.5));
  const Values pin = joined(call_of(977, 202), tool_results(0.1, -0.5));
  const Values groove = joined(call_of(977, 203), tool_results(0.1, 0.5));
  const Values rib = joined(call_of(977, 204), tool_results(0.1, -0.5));
  expect_results(
      {{"hole", part_aside("ring", "bore = 40.1"), program(-5, 201, 40, 0, 1),
        joined(hole, dimensions(0, {40.0, 0.05, 0.02}, {40.1, 0.2, -0.3}))},
       {"spigot", part_aside("cylinder", "diameter = 30.1"), program(5, 202, 30, -15, 1),
        joined(pin, dimensions(0, {30.0, 0.05, 0.02}, {30.1, 0.2, -0.3}))},
       {"groove, first axis", part_aside("groove", "width = 20.1"), program(-5, 203, 20, 0, 1),
        joined(groove, dimensions(0, {20.0, 0.05, 0.02}, {20.1, 0.2, 0.02}))},
       {"groove, second axis", part_aside("groove", "width = 20.1\nrotate_deg = [0.0, 0.0, 90.0]"),
        program(-5, 203, 20, 0, 2),
        joined(groove, dimensions(0, {20.0, 0.05, 0.02}, {20.1, 0.05, -0.3}))},
       {"rib, first axis", part_aside("rib", "width = 20.1"), program(5, 204, 20, -15, 1),
        joined(rib, dimensions(0, {20.0, 0.05, 0.02}, {20.1, 0.2, 0.02}))},
       {"rib, second axis", part_aside("rib", "width = 20.1\nrotate_deg = [0.0, 0.0, 90.0]"),
        program(5, 204, 20, -15, 2),
        joined(rib, dimensions(0, {20.0, 0.05, 0.02}, {20.1, 0.05, -0.3}))}},
      kThirdRecord);
}

TEST(MeasuringResults, OfRectanglesWithToleranceOfEitherSize) {
  const Values second = {{"_OVR[9]", 0.3}, {"_OVR[13]", -0.3}};
  const Values sizes = dimensions(0, {60.0, 40.0, 0.05, 0.02}, {60.1, 40.16, 0.2, -0.3});
  const std::string call = ",,4000001,3,,60,40,2,5,,-15,,,,1," + kLimits;
  expect_results(
      {{"pocket", part_aside("pocket", "length = 60.1\nwidth = 40.16"),
        "X0.05 Y0.02\nZ-5\nCYCLE977(205" + call,
        joined(joined(call_of(977, 205), tool_results(0.13, 0.5)), joined(second, sizes))},
       {"spigot", part_aside("block", "length = 60.1\nwidth = 40.16"),
        "X0.05 Y0.02\nZ5\nCYCLE977(206" + call,
        joined(joined(call_of(977, 206), tool_results(0.13, -0.5)), joined(second, sizes))}},
      kThirdRecord);
}

TEST(MeasuringResults, OfAWorkOffset) {
  const Values corrected = {{"_OVI[0]", 1.0}, {"_OVI[11]", 0.0}};
  expect_results(
      {{"hole", part_aside("ring", "bore = 40.1"), "X0.05 Y0.02\nZ-5\nCYCLE977(101,1,,3,40,,,2,5)",
        joined(joined(call_of(977, 101), corrected),
               dimensions(0, {40.0, 0.05, 0.02}, {40.1, 0.2, -0.3}))},
       {"edge", part_aside("block", ""), "X-40\nZ-5\nCYCLE978(100,1,,3,-30,5,1,1,1)",
        joined(joined(call_of(978, 100), corrected),
               dimensions(0, {-30.0, -30.0}, {-29.8, -29.8}))},
       {"arc", part_aside("ring", "bore = 40.1\nsagitta = 0.0000005"),
        "Z-5\nCYCLE979(101,1,,3,40,2,5,0.05,0.02,0,120)",
        joined(joined(call_of(979, 101), corrected),
               dimensions(0, {40.0, 0.05, 0.02}, {40.1, 0.2, -0.3})),
        2e-6}},
      kThirdRecord);
}

TEST(MeasuringResults, OfOnePoint) {
  const std::string block = part_aside("block", "");
  const auto along = [](int axis, double wanted, double found, double tool_per_deviation) {
    Values all = joined(call_of(978, 200), tool_results(found - wanted, tool_per_deviation));
    all = joined(all, dimensions(0, {wanted}, {found}));
    all = joined(all, dimensions(axis, {wanted}, {found}));
    all.push_back({"_OVR[21]", (found - wanted - 0.02) / 3.0});
    for (int other = 1; other <= 3; ++other) {
      if (other != axis) {
        all.push_back({fmt::format("_OVR[{}]", other), kUnwritten});
        all.push_back({fmt::format("_OVR[{}]", other + 4), kUnwritten});
        all.push_back({fmt::format("_OVR[{}]", other + 16), kUnwritten});
      }
    }
    return all;
  };
  const auto call = [](const char* where, double wanted, int axis, int direction) {
    return fmt::format("{}\nCYCLE978(200,,4000001,3,{},5,5,{},{},1,{}", where, wanted, axis,
                       direction, kLimits);
  };
  expect_results({{"+X", block, call("X-40\nZ-5", -29.9, 1, 1), along(1, -29.9, -29.8, 1.0)},
                  {"-X", block, call("X40\nZ-5", 30.1, 1, 2), along(1, 30.1, 30.2, -1.0)},
                  {"+Y", block, call("Y-30\nZ-5", -20.4, 2, 1), along(2, -20.4, -20.3, 1.0)},
                  {"-Y", block, call("Y30\nZ-5", 19.6, 2, 2), along(2, 19.6, 19.7, -1.0)},
                  {"-Z", block, call("Z10", -0.1, 3, 2), along(3, -0.1, 0.0, -1.0)}},
                 kThirdRecord);
  expect_results(
      {{"reversal", block, "X-40\nZ-5\nCYCLE978(10000,,,3,-30,5,5,1,1)",
        joined(call_of(978, 10000), {{"_OVR[4]", -29.795}, {"_OVR[40]", 0.04}, {"_OVI[0]", 0.0}})}},
      std::string(kBentProbe) + kThirdRecord);
}

TEST(MeasuringResults, OfArcs) {
  const std::string fine = "\nsagitta = 0.0000005";
  const std::string behind = ",,4000001,3,{},2,5,0.05,0.02,0,120,1," + kLimits;
  expect_results({{"inside", part_aside("ring", "bore = 40.1" + fine),
                   "Z-5\nCYCLE979(201" + fmt::format(fmt::runtime(behind), 40.0),
                   joined(joined(call_of(979, 201), tool_results(0.1, 0.5)),
                          dimensions(0, {40.0, 0.05, 0.02}, {40.1, 0.2, -0.3})),
                   2e-6},
                  {"outside", part_aside("cylinder", "diameter = 30.1" + fine),
                   "X30\nZ-5\nCYCLE979(202" + fmt::format(fmt::runtime(behind), 30.0),
                   joined(joined(call_of(979, 202), tool_results(0.1, -0.5)),
                          dimensions(0, {30.0, 0.05, 0.02}, {30.1, 0.2, -0.3})),
                   2e-6}},
                 kThirdRecord);
}

TEST(MeasuringResults, OfAnEdgesAngle) {
  expect_results({{"lower edge",
                   part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 3.0]"),
                   "X-20 Y-27\nZ-5\nCYCLE998(105,1,,3,,2,,5,3,102,1,30,,,,,1,5)",
                   {{"_OVR[0]", 2.0},
                    {"_OVR[4]", 3.0},
                    {"_OVR[16]", 1.0},
                    {"_OVR[20]", 0.98},
                    {"_OVR[28]", 3.0},
                    {"_OVR[30]", 0.02},
                    {"_OVI[0]", 1.0},
                    {"_OVI[2]", 998.0},
                    {"_OVI[5]", 3.0},
                    {"_OVI[7]", 5.0},
                    {"_OVI[9]", 0.0},
                    {"_OVI[11]", 0.0}}}},
                 kThirdRecord);
}

/// A block whose lower left corner is at machine (100.7, 49.6), turned by 12 degrees, in an offset
/// that is turned by 10; start angles are those of the machine.
TEST(MeasuringResults, OfCornersInWorkAndMachineCoordinates) {
  const auto turned = [](double x, double y, double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return std::pair(x * std::cos(angle) - y * std::sin(angle),
                     x * std::sin(angle) + y * std::cos(angle));
  };
  const auto [half_x, half_y] = turned(30.0, 20.0, 12.0);
  const std::string block =
      part("block", 100.7 + half_x, 49.6 + half_y, -300.0, "rotate_deg = [0.0, 0.0, 12.0]");
  const auto [x, y] = turned(0.7, -0.4, -10.0);
  const auto corner = [x = x, y = y](int variant, int offset) {
    return joined(call_of(961, variant), {{"_OVR[4]", 2.0},
                                          {"_OVR[5]", x},
                                          {"_OVR[6]", y},
                                          {"_OVR[20]", 12.0},
                                          {"_OVR[21]", 100.7},
                                          {"_OVR[22]", 49.6},
                                          {"_OVI[11]", offset != 0 ? 0.0 : 99.0}});
  };
  const std::string start = "$P_UIFR[1,Z,RT]=10\nG54\nX-12 Y-12\nZ-5\n";
  expect_results(
      {{"square", block, start + "CYCLE961(6,,3,20,45,15,,,,,,,,10,,,10,5)", corner(6, 0)},
       {"square, offset", block, start + "CYCLE961(106,1,3,20,45,15,,,,,,,,10,,,10,5)",
        joined(corner(106, 1), {{"_OVI[0]", 1.0}})},
       {"any", block, start + "CYCLE961(8,,3,20,45,12,26,,,,,,,10,90,,10,5)",
        joined(corner(8, 0), {{"_OVR[8]", 90.0}})},
       {"any, four points, offset", block,
        start + "CYCLE961(118,1,3,15,-12,40,-12,-12,15,-12,30,,,,,,10,5)",
        joined(corner(118, 1), {{"_OVR[8]", 90.0}, {"_OVI[0]", 1.0}})}},
      kThirdRecord);
}

// Calibration: record 3 holds 5 mm and triggers of 2.5 before, the probe is eccentric and late.

constexpr double kTrigger = 2.995;
constexpr const char* kOldRecord = R"([variables]
"$SNS_MEA_WP_BALL_DIAM[2]" = 5.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[2]" = 2.5
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[2]" = -2.4
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[2]" = 2.3
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[2]" = -2.2
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX3[2]" = 0.1
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[2]" = 0.2
)";

Values calibrated(double diameter) {
  return {{"_OVR[4]", diameter}, {"_OVR[5]", diameter - 5.0}, {"_OVR[27]", 0.0},
          {"_OVR[28]", 4.0},     {"_OVI[2]", 976.0},          {"_OVI[5]", 3.0},
          {"_OVI[9]", 0.0}};
}
const Values kFirst = {{"_OVR[8]", -kTrigger},
                       {"_OVR[9]", 2.4 - kTrigger},
                       {"_OVR[10]", kTrigger},
                       {"_OVR[11]", kTrigger - 2.5}};
const Values kSecond = {{"_OVR[12]", -kTrigger},
                        {"_OVR[13]", 2.2 - kTrigger},
                        {"_OVR[14]", kTrigger},
                        {"_OVR[15]", kTrigger - 2.3}};
const Values kPlace = {{"_OVR[20]", 0.02}, {"_OVR[21]", -0.03}};

/// `_OVR[from]` to `_OVR[to]` are not the chosen axis's.
Values untouched(int from, int to) {
  Values all;
  for (int i = from; i <= to; ++i) {
    all.push_back({fmt::format("_OVR[{}]", i), kUnwritten});
  }
  return all;
}

TEST(MeasuringResults, OfRingBallAndFace) {
  const Values both = joined(joined(calibrated(2 * kTrigger), kFirst), joined(kSecond, kPlace));
  const Values third = {
      {"_OVR[18]", 0.1}, {"_OVR[19]", 0.0}, {"_OVR[16]", 0.005}, {"_OVR[17]", -0.195}};
  const std::string ring = part_aside("ring", "bore = 40.0");
  const std::string ball = part("sphere", 99.8, 50.3, -300.0, "diameter = 25.0");
  const std::string turned_ball =
      part("sphere", 99.8, 50.3, -300.0, "diameter = 25.0\nrotate_deg = [0.0, 0.0, 20.0]");
  const Values centre = {{"_OVR[6]", 0.2}, {"_OVR[7]", -0.3}, {"_OVR[24]", 0.0}};
  expect_results(
      {{"ring, centre unknown", ring, "Z-5\nCYCLE976(2,3,40,,,,5,4)", joined(both, centre), 1e-4},
       {"ring, centre known", ring, "X0.2 Y-0.3 Z-5\nCYCLE976(1,3,40,,,,5,4)", joined(both, centre),
        1e-4},
       {"ball, 3rd axis too", ball, "CYCLE976(2000003,3,25,12.5,,,5,4)",
        joined(joined(both, third), {{"_OVR[22]", 120.0 - 0.005}, {"_OVR[24]", 0.0}}), 1e-4},
       {"ball, round it from 20 degrees", turned_ball, "CYCLE976(2100003,3,25,12.5,,,5,4,,20)",
        joined(joined(joined(calibrated(2 * kTrigger), kPlace), third),
               {{"_OVR[22]", 120.0 - 0.005}, {"_OVR[24]", 20.0}}),
        1e-4},
       {"length", part("block", 100.0, 50.0, -300.0, ""), "Z3\nCYCLE976(1000,3,0,,3,1,3,4)",
        joined(joined(calibrated(5.0), third), {{"_OVR[22]", 120.0}})}},
      std::string(kBentProbe) + kOldRecord);
}

TEST(MeasuringResults, OfEdgesAreThoseOfTheChosenAxis) {
  const std::string groove = part("groove", 100.0, 50.0, -300.0, "width = 30.0");
  const std::string across =
      part("groove", 100.0, 50.0, -300.0, "width = 30.0\nrotate_deg = [0.0, 0.0, 90.0]");
  const Values plus = {
      {"_OVR[8]", -2.4},  {"_OVR[9]", 0.0},  {"_OVR[10]", kTrigger}, {"_OVR[11]", kTrigger - 2.5},
      {"_OVR[20]", 0.02}, {"_OVR[21]", 0.0}, {"_OVR[24]", 0.0}};
  const Values minus = {
      {"_OVR[12]", -kTrigger}, {"_OVR[13]", 2.2 - kTrigger}, {"_OVR[14]", 2.3}, {"_OVR[15]", 0.0},
      {"_OVR[20]", 0.0},       {"_OVR[21]", -0.03},          {"_OVR[24]", 0.0}};
  expect_results({{"one edge, first axis", groove, "X10 Z-5\nCYCLE976(4,3,15,,1,0,3,4)",
                   joined(joined(calibrated(6.0), plus), untouched(12, 19)), 1e-4},
                  {"one edge, second axis", across, "Y-10 Z-5\nCYCLE976(4,3,-15,,2,1,3,4)",
                   joined(joined(calibrated(6.0), minus), untouched(8, 11)), 1e-4},
                  {"two edges, first axis", groove, "Z-5\nCYCLE976(5,3,30,,1,,5,4,,,,-15)",
                   joined(joined(calibrated(2 * kTrigger), kFirst),
                          joined(untouched(12, 19), {{"_OVR[20]", 0.02}, {"_OVR[21]", 0.0}})),
                   1e-4},
                  {"two edges, second axis", across, "Z-5\nCYCLE976(5,3,30,,2,,5,4,,,,-15)",
                   joined(joined(calibrated(2 * kTrigger), kSecond),
                          joined(untouched(8, 11), {{"_OVR[20]", 0.0}, {"_OVR[21]", -0.03}})),
                   1e-4}},
                 std::string(kBentProbe) + kOldRecord);
}

}  // namespace
}  // namespace g31::testing::measuring_results_test

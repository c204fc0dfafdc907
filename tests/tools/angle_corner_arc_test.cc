// CYCLE961, CYCLE979 and CYCLE998 on turned and shifted parts; CYCLE116 and CYCLE119 by themselves.

#include <cmath>
#include <iterator>
#include <numbers>
#include <span>

#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/measuring_run.h"

namespace g31::testing::angle_corner_arc_test {
namespace {

double sine(double degrees) {
  return std::sin(degrees * std::numbers::pi / 180.0);
}
double cosine(double degrees) {
  return std::cos(degrees * std::numbers::pi / 180.0);
}

struct Place {
  double x = 0.0;
  double y = 0.0;
};

/// A block of 60 by 40 whose corner (`sx`, `sy` = -1 or 1: which) is at `corner` of G54, turned.
std::string block_with_corner(Place corner, double sx, double sy, double turned) {
  const double x = corner.x - (30.0 * sx * cosine(turned) - 20.0 * sy * sine(turned));
  const double y = corner.y - (30.0 * sx * sine(turned) + 20.0 * sy * cosine(turned));
  return part("block", 100.0 + x, 50.0 + y, -300.0,
              fmt::format("rotate_deg = [0.0, 0.0, {:.6f}]", turned));
}
/// The same of a pocket.
std::string pocket_with_corner(Place corner, double sx, double sy, double turned) {
  const double x = corner.x - (30.0 * sx * cosine(turned) - 20.0 * sy * sine(turned));
  const double y = corner.y - (30.0 * sx * sine(turned) + 20.0 * sy * cosine(turned));
  return part("pocket", 100.0 + x, 50.0 + y, -300.0,
              fmt::format("rotate_deg = [0.0, 0.0, {:.6f}]", turned));
}

constexpr Place kCorner = {0.7, -0.4};

/// Results of a corner at kCorner whose reference edge lies at `angle`.
std::vector<ExpectedValue> corner_at(double angle, double variant) {
  return {{"_OVR[4]", angle},
          {"_OVR[5]", kCorner.x},
          {"_OVR[6]", kCorner.y},
          {"_OVR[20]", angle},
          {"_OVR[21]", 100.0 + kCorner.x},
          {"_OVR[22]", 50.0 + kCorner.y},
          {"_OVI[2]", 961},
          {"_OVI[3]", variant},
          {"_OVI[5]", 1},
          {"_OVI[9]", 0}};
}

TEST(CornerCycle, SquareAndAnyCornersInsideAndOutside) {
  const MeasuringCase kRows[] = {
      {"outside, position 1", block_with_corner(kCorner, -1, -1, 2.0),
       "X-12 Y-12\nZ-5\nCYCLE961(10006,,1,20,45,15,,,,,,,,0,,,10,5)", corner_at(2.0, 10006)},
      {"outside, position 2", block_with_corner(kCorner, 1, -1, 2.0),
       "X12 Y-12\nZ-5\nCYCLE961(20006,,1,20,45,15,,,,,,,,0,,,10,5)", corner_at(2.0, 20006)},
      {"outside, position 3", block_with_corner(kCorner, 1, 1, -3.0),
       "X12 Y12\nZ-5\nCYCLE961(30006,,1,20,45,15,,,,,,,,0,,,10,5)", corner_at(-3.0, 30006)},
      {"outside, position 4", block_with_corner(kCorner, -1, 1, 2.0),
       "X-12 Y12\nZ-5\nCYCLE961(40006,,1,20,45,15,,,,,,,,0,,,10,5)", corner_at(2.0, 40006)},
      {"outside, the pole given",
       block_with_corner(kCorner, -1, -1, 2.0),
       "X-30 Y-30\nZ-5\nCYCLE961(6,,1,20,45,15,,-12,-12,,,,,0,,,10,5)",
       {{"_OVR[4]", 2.0}, {"_OVR[5]", kCorner.x}, {"$AA_IW[X]", -30.0}, {"$AA_IW[Y]", -30.0}}},
      {"outside, over the part",
       block_with_corner(kCorner, -1, -1, 2.0),
       "X-12 Y-12\nCYCLE961(1006,,1,20,45,15,,,,,,,,0,,25,10,5)",
       {{"_OVR[4]", 2.0}, {"_OVR[6]", kCorner.y}, {"$AA_IW[Z]", 20.0}}},
      {"outside, edges at 30 degrees", block_with_corner(kCorner, -1, -1, 31.0),
       "X-2 Y-16\nZ-5\nCYCLE961(6,,1,20,45,15,,,,,,,,30,,,10,5)", corner_at(31.0, 6)},
      {"L1 is half of L2", block_with_corner(kCorner, -1, -1, 2.0),
       "X-12 Y-12\nZ-5\nCYCLE961(6,,1,,45,15,,,,,,,,0,,,10,5)", corner_at(2.0, 6)},
      {"inside, position 1", pocket_with_corner(kCorner, -1, -1, 2.0),
       "X12 Y12\nZ-5\nCYCLE961(5,,1,10,30,10,,,,,,,,0,,,10,5)", corner_at(2.0, 5)},
      {"inside, position 3", pocket_with_corner(kCorner, 1, 1, 2.0),
       "X-12 Y-12\nZ-5\nCYCLE961(30005,,1,10,30,10,,,,,,,,0,,,10,5)", corner_at(2.0, 30005)},
      {"any corner outside, polar",
       block_with_corner(kCorner, -1, -1, 2.0),
       "X-12 Y-12\nZ-5\nCYCLE961(8,,1,20,45,12,26,,,,,,,0,90,,10,5)",
       {{"_OVR[4]", 2.0},
        {"_OVR[5]", kCorner.x},
        {"_OVR[6]", kCorner.y},
        {"_OVR[8]", 90.0},
        {"_OVR[20]", 2.0},
        {"_OVR[21]", 100.0 + kCorner.x},
        {"_OVR[22]", 50.0 + kCorner.y},
        {"_OVI[3]", 8},
        {"_OVI[9]", 0}}},
      {"any corner inside, four points",
       pocket_with_corner(kCorner, -1, -1, 2.0),
       "X12 Y12\nZ-5\nCYCLE961(17,,1,15,14,40,14,14,15,14,30,,,,,,10,5)",
       {{"_OVR[4]", 2.0}, {"_OVR[5]", kCorner.x}, {"_OVR[6]", kCorner.y}, {"_OVR[8]", 90.0}}},
      {"corner of a hexagon",
       part("prism", 100.0, 50.0, -300.0,
            "sides = 6.0\nacross_flats = 60.0\nrotate_deg = [0.0, 0.0, 30.0]"),
       "X20 Y45\nZ-5\nCYCLE961(18,,1,8,44,-8,44,-28,34,-36,22,,,,,,10,5)",
       {{"_OVR[4]", 180.0},
        {"_OVR[5]", -60.0 * 0.5 / std::sqrt(3.0)},
        {"_OVR[6]", 30.0},
        {"_OVR[8]", 60.0}}},
  };
  expect_measured(kRows);
}

TEST(CornerCycle, BringsTheProgramBackOnThePart) {
  // A ring whose place from the corner is known, on a fixture shifted and turned by 2 degrees.
  const double turned = 2.0;
  const Place from_corner = {150.0, 40.0};
  const std::string parts =
      block_with_corner(kCorner, -1, -1, turned) +
      part("ring",
           100.0 + kCorner.x + from_corner.x * cosine(turned) - from_corner.y * sine(turned),
           50.0 + kCorner.y + from_corner.x * sine(turned) + from_corner.y * cosine(turned), -300.0,
           fmt::format("bore = 40.0\nrotate_deg = [0.0, 0.0, {:.6f}]", turned));
  for (const char* const target : {"1", "10001", "9000"}) {
    SCOPED_TRACE(target);
    expect_measured(
        fmt::format("X-12 Y-12\nZ-5\nCYCLE961(106,{},1,20,45,15,,,,,,5,6,0,,,10,8)\nG54\n"
                    "Z20\nX155 Y46\nZ-5\nCYCLE977(1,,,1,40,,,2,1)",
                    target),
        {parts, kCalibrated},
        {{"_OVR[5]", 155.0},
         {"_OVR[6]", 46.0},
         {"_OVR[17]", 0.0},
         {"_OVR[18]", 0.0},
         {"_OVR[16]", 0.0},
         {"$P_UIFR[1,Z,RT]", turned}});
  }
}

TEST(CornerCycle, Alarms) {
  const std::string parts = block_with_corner(kCorner, -1, -1, 2.0);
  struct Refusal {
    const char* program;
    int alarm;
  };
  const Refusal kRows[] = {{"CYCLE961(104,1,1,20,45,15,,,,,,,,0,,,10,5)", 61307},
                           {"CYCLE961(106,1,1,20,45,15,,,,,,,,0,,,10,0.3)", 61303},
                           {"CYCLE961(106,1,1,20,45,15,,,,,,,,0,,,2,5)", 61301},
                           {"CYCLE961(118,1,1,0,0,0,0,5,5,6,6,,,,,,10,5)", 61367},
                           {"CYCLE961(118,1,1,0,0,10,0,0,5,10,5,,,,,,10,5)", 61368}};
  for (const Refusal& row : kRows) {
    SCOPED_TRACE(row.program);
    const MeasuringRun run =
        run_measuring(std::string("X-12 Y-12\nZ-5\n") + row.program, {parts, kCalibrated},
                      {"$P_UIFR[1,X,FI]", "$P_UIFR[1,Z,RT]"});
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
    EXPECT_EQ(run.at("$P_UIFR[1,Z,RT]"), 0.0);
  }
}

TEST(ArcCycle, InsideAndOutsideByThreeAndFourPoints) {
  // Facets so fine that an arc of 90 degrees, which shows an error three times, stays within 1e-6.
  const std::string ring = part("ring", 100.2, 49.7, -300.0, "bore = 40.0\nsagitta = 0.0000001");
  const std::string pin =
      part("cylinder", 100.2, 49.7, -300.0, "diameter = 30.0\nsagitta = 0.0000001");
  const std::vector<ExpectedValue> hole = {{"_OVR[0]", 40.0}, {"_OVR[1]", 0.0},  {"_OVR[2]", 0.0},
                                           {"_OVR[4]", 40.0}, {"_OVR[5]", 0.2},  {"_OVR[6]", -0.3},
                                           {"_OVR[16]", 0.0}, {"_OVR[17]", 0.2}, {"_OVR[18]", -0.3},
                                           {"_OVI[2]", 979},  {"_OVI[5]", 1},    {"_OVI[9]", 0}};
  const std::vector<ExpectedValue> spigot = {
      {"_OVR[4]", 30.0}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.3}};
  const MeasuringCase kRows[] = {
      {"hole, three points", ring, "Z-5\nCYCLE979(1,,,1,40,2,5,0,0,0,120)", hole},
      {"hole, four points, backwards", ring, "Z-5\nCYCLE979(1001,,,1,40,2,5,0,0,180,-90)", hole},
      {"hole from the middle", ring, "Z-5\nCYCLE979(1,,,1,40,25,5,0,0,10,100)", hole},
      {"spigot, three points", pin, "X30\nZ-5\nCYCLE979(2,,,1,30,3,5,0,0,0,120)", spigot},
      {"spigot, four points, backwards", pin, "Y30\nZ-5\nCYCLE979(1002,,,1,30,3,5,0,0,90,-60)",
       spigot},
      {"centre elsewhere",
       ring,
       "X0.1 Z-5\nCYCLE979(1,,,1,40.2,2,5,0.1,0.05,0,120)",
       {{"_OVR[0]", 40.2},
        {"_OVR[1]", 0.1},
        {"_OVR[2]", 0.05},
        {"_OVR[4]", 40.0},
        {"_OVR[5]", 0.2},
        {"_OVR[16]", -0.2},
        {"_OVR[17]", 0.1},
        {"_OVR[18]", -0.35}}},
      {"set point of the centre given",
       ring,
       "Z-5\nCYCLE979(101,1,,1,40,2,5,0,0,0,120,,,,,,,,,,,,,,0.15,0)",
       {{"_OVR[1]", 0.15},
        {"_OVR[17]", 0.05},
        {"$P_UIFR[1,X,FI]", 0.05},
        {"$P_UIFR[1,Y,FI]", -0.3}}},
      {"tool offset",
       ring,
       "Z-5\nCYCLE979(201,,4000001,1,39.9,2,5,0,0,0,120,,\"MILL\")",
       {{"$TC_DP6[2,1]", 5.05}, {"_OVR[20]", 0.05}, {"_OVI[0]", 1}, {"_OVI[8]", 2}}},
  };
  expect_measured(std::span(kRows).first(testing::of_many(std::size(kRows))));
}

TEST(ArcCycle, WithACalibratedBentProbeAndWithReversal) {
  const std::string ring = part("ring", 100.2, 49.7, -300.0, "bore = 40.0\nsagitta = 0.000005");
  for (const char* const variant : {"1001", "11001"}) {
    SCOPED_TRACE(variant);
    expect_measured(
        fmt::format(
            "X0.2 Y-0.3 Z-5\nCYCLE976(1,1,40,,,,5,5)\nX0 Y0\nCYCLE979({},,,1,40,2,5,0,0,20,80)",
            variant),
        {ring, kBentProbe}, {{"_OVR[4]", 40.0}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.3}}, 1e-4);
  }
}

TEST(ArcCycle, Alarms) {
  const std::string ring = part("ring", 100.2, 49.7, -300.0, "bore = 40.0");
  struct Refusal {
    const char* call;
    int alarm;
  };
  const Refusal kRows[] = {{"CYCLE979(3,,,1,40,2,5,0,0,0,120)", 61307},
                           {"CYCLE979(1,,,1,40,2,5,0,0,0,121)", 61331},
                           {"CYCLE979(1001,,,1,40,2,5,0,0,0,91)", 61331},
                           {"CYCLE979(1,,,1,40,2,5,0,0,0,0)", 61331},
                           {"CYCLE979(1,,,1,-40,2,5,0,0,0,120)", 61316},
                           {"CYCLE979(1,,,1,,2,5,0,0,0,120)", 61316},
                           {"CYCLE979(101,1,,1,40,2,0.1,0,0,0,120)", 61303},
                           {"CYCLE979(1,,,1,30,2,5,0,0,0,120)", 61301}};
  for (const Refusal& row : kRows) {
    SCOPED_TRACE(row.call);
    EXPECT_EQ(run_measuring(std::string("Z-5\n") + row.call, {ring, kCalibrated}, {}).alarm(),
              row.alarm);
  }
}

// A sign slip or a forgotten set point: the touches would be taken for those of the other side.
TEST(SizesOfCycles, AreAboveZeroOrNothingIsTouchedAndNothingStored) {
  const std::string ring = part("ring", 100.2, 49.7, -300.0, "bore = 40.0");
  const char* const kCalls[] = {
      "CYCLE977(1,,,1,-40,,,10,5)",        "CYCLE977(1,,,1,0,,,10,5)",
      "CYCLE977(3,,,1,-40,,,10,5,0,,,,1)", "CYCLE977(5,,,1,,-40,40,10,5)",
      "CYCLE977(5,,,1,,40,0,10,5)",        "CYCLE977(201,,4000001,1,,,,10,,,,,,,1,\"MILL\")",
      "CYCLE976(1,1,-40,,,,5,5)",          "CYCLE976(2,1,,,,,5,5)"};
  for (const char* const call : kCalls) {
    SCOPED_TRACE(call);
    const MeasuringRun run = run_measuring(std::string("Z-5\n") + call, {ring, kCalibrated},
                                           {"_OVR[4]", "$TC_DP6[2,1]", "$SNS_MEA_WP_BALL_DIAM[0]"});
    EXPECT_EQ(run.alarm(), 61316) << run.output.errors;
    EXPECT_TRUE(run.output.document.at("touches").empty());
    EXPECT_EQ(run.at("_OVR[4]"), 0.0);
    EXPECT_EQ(run.at("$TC_DP6[2,1]"), 5.0);
    EXPECT_EQ(run.at("$SNS_MEA_WP_BALL_DIAM[0]"), 6.0);
  }
}

struct Edge {
  const char* name;
  std::string program;
  std::vector<ExpectedValue> expected;
};

/// The block is turned by 3 degrees.
void expect_edges(const std::vector<Edge>& edges, const std::string& turned = "0.0, 0.0, 3.0") {
  const std::string block =
      part("block", 100.0, 50.0, -300.0, fmt::format("rotate_deg = [{}]", turned));
  for (const Edge& row : edges) {
    SCOPED_TRACE(row.name);
    expect_measured(row.program, {block, kCalibrated}, row.expected);
  }
}

TEST(EdgeAngleCycle, AnglesOfEdgesInThePlane) {
  expect_edges(
      {{"lower edge",
        "X-20 Y-27\nZ-5\nCYCLE998(5,,,1,,2,,5,3,102,1,30)",
        {{"_OVR[0]", 2.0},
         {"_OVR[4]", 3.0},
         {"_OVR[16]", 1.0},
         {"_OVR[20]", 0.0},
         {"_OVR[28]", 3.0},
         {"_OVR[30]", 0.0},
         {"_OVI[2]", 998},
         {"_OVI[5]", 1},
         {"_OVI[7]", 0},
         {"_OVI[9]", 0},
         {"$P_UIFR[1,Z,RT]", 0.0}}},
       {"upper edge", "X-20 Y27\nZ-5\nCYCLE998(5,,,1,,,,6,5,102,2,30)", {{"_OVR[4]", 3.0}}},
       {"left edge, parallel to the axis",
        "X-38 Y-10\nZ-5\nCYCLE998(100005,,,1,,,,6,5,201,1,20)",
        {{"_OVR[4]", 3.0}}},
       {"right edge", "X38 Y-10\nZ-5\nCYCLE998(5,,,1,,,,6,5,201,2,20)", {{"_OVR[4]", 3.0}}},
       {"over the protection zone",
        "X-20 Y-50\nZ-5\nCYCLE998(1005,,,1,23,2,,5,3,102,1,30)",
        {{"_OVR[4]", 3.0},
         {"$AA_IW[Y]", -50.0 + 30.0 * std::tan(2.0 * std::numbers::pi / 180.0) -
                           30.0 * (std::tan(5.0 * std::numbers::pi / 180.0) -
                                   std::tan(2.0 * std::numbers::pi / 180.0))}}},
       {"direction from DX",
        "X-20 Y50\nZ-5\nCYCLE998(101005,,,1,-23,2,,6,3,102,0,30)",
        {{"_OVR[4]", 3.0}}}});
}

TEST(EdgeAngleCycle, AngleOfAFace) {
  expect_edges({{"top face against the first axis",
                 "X-15 Z6\nCYCLE998(5,,,1,,,,6,5,103,2,30)",
                 {{"_OVR[4]", 2.0}}}},
               "0.0, 2.0, 0.0");
}

TEST(EdgeAngleCycle, CorrectsTheRotation) {
  expect_edges({{"correction",
                 "X-20 Y-27\nZ-5\nCYCLE998(105,1,,1,,2,,5,3,102,1,30)",
                 {{"_OVR[20]", 1.0},
                  {"$P_UIFR[1,Z,RT]", 1.0},
                  {"$P_UIFR[1,X,TR]", 100.0},
                  {"$P_UIFR[1,X,FI]", 0.0},
                  {"$P_UIFR[1,Y,TR]", 50.0},
                  {"_OVI[0]", 1},
                  {"_OVI[11]", 0}}},
                {"with an empirical value",
                 "$SCS_MEA_EMPIRIC_VALUE[0]=0.25\nX-20 "
                 "Y-27\nZ-5\nCYCLE998(105,1,,1,,2,,5,3,102,1,30,,,,,,1)",
                 {{"_OVR[16]", 1.0},
                  {"_OVR[20]", 0.75},
                  {"_OVR[30]", 0.25},
                  {"_OVI[7]", 1},
                  {"$P_UIFR[1,Z,RT]", 0.75}}},
                {"again, nothing is left",
                 "X-20 Y-27\nZ-5\nCYCLE998(105,1,,1,,,,6,5,102,1,30)\nG54\nY-60\nX-20\nY-27\n"
                 "CYCLE998(5,,,1,,,,6,5,102,1,30)",
                 {{"_OVR[4]", 0.0}, {"$P_UIFR[1,Z,RT]", 3.0}}}});
}

TEST(EdgeAngleCycle, ARotaryTableTakesTheAngleAndTheEdgeIsStraightAgain) {
  const std::string table =
      "[machine]\ntable_side = \"C\"\n[machine.axes.C]\ncentre = [100.0, 50.0, 0.0]\n" +
      part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 3.0]");
  expect_measured(
      "X-20 Y-27\nZ-5\nCYCLE998(105,10001,6,1,,,,6,5,102,1,30)\nY-60\nG54 C0\nX-20\nY-27\n"
      "CYCLE998(5,,,1,,,,6,5,102,1,30)",
      {table, kCalibrated}, {{"_OVR[4]", 0.0}, {"$P_UIFR[1,C,TR]", 3.0}, {"$P_UIFR[1,Z,RT]", 0.0}},
      1e-5);
}

// The rear of the part looks up, and its edge is turned about what is C's axis there.
TEST(EdgeAngleCycle, ASwivelledTableTakesTheAngleWithTheAxisThatTurnsThePlane) {
  const std::string table =
      "[machine]\nfile = \"five_axis_ac.toml\"\n"
      "[work_offsets.G54]\nX = 40.0\nY = -25.0\nZ = -380.0\n" +
      part("block", 40.0, -25.0, -380.0, "height = 60.0\nrotate_deg = [0.0, 0.0, 1.7]");
  const std::string program =
      "CYCLE800(0,\"\",100000,39,0,0,0,0,-90,0,0,0,0,-1)\nG0 X-15 Y20\nZ50\nZ35\n"
      "CYCLE998(100105,9000,{},1,1,0,,10,5,103,2,30)";
  expect_measured(fmt::format(fmt::runtime(program), 6), {table, kCalibrated},
                  {{"$P_UIFR[1,C,TR]", 1.7}, {"$P_UIFR[1,Z,RT]", 0.0}}, 1e-5);
  const MeasuringRun of_other_axis =
      run_measuring(fmt::format(fmt::runtime(program), 4), {table, kCalibrated}, {});
  EXPECT_EQ(of_other_axis.alarm(), 61403);
}

// A block turned by 2 degrees about X, then by -3 about Y: R = Ry Rx, as the angles of a frame
// count.
TEST(PlaneAngleCycle, AnglesByThreePoints) {
  const std::string again = "\nG54\nZ8\nX-15 Y-10 Z4\nCYCLE998(6,,,1,,{},6,5,,,,30,0,0,20)";
  expect_edges(
      {{"measured only",
        "X-15 Y-10 Z4\nCYCLE998(6,,,1,,,,6,5,,,,30,0,0,20)",
        {{"_OVR[0]", 0.0},
         {"_OVR[4]", 2.0},
         {"_OVR[5]", -3.0},
         {"_OVR[16]", 2.0},
         {"_OVR[17]", -3.0},
         {"_OVR[28]", 5.0},
         {"_OVI[2]", 998},
         {"$P_UIFR[1,X,RT]", 0.0}}},
       {"corrected, nothing is left",
        "X-15 Y-10 Z4\nCYCLE998(106,1,,1,,,,6,5,,,,30,0,0,20)" +
            fmt::format(fmt::runtime(again), ","),
        {{"_OVR[4]", 0.0},
         {"_OVR[5]", 0.0},
         {"$P_UIFR[1,X,RT]", 2.0},
         {"$P_UIFR[1,Y,RT]", -3.0},
         {"$P_UIFR[1,Z,RT]", 0.0},
         {"$P_UIFR[1,X,TR]", 100.0}}},
       {"corrected to angles that should be there",
        "X-15 Y-10 Z4\nCYCLE998(106,1,,1,,1,-2,6,5,,,,30,0,0,20)" +
            fmt::format(fmt::runtime(again), "1,-2"),
        {{"_OVR[4]", 1.0}, {"_OVR[5]", -2.0}, {"_OVR[16]", 0.0}, {"_OVR[17]", 0.0}}},
       {"points of any place, an offset that is not in force",
        "X-15 Y-10 Z4\nCYCLE998(100106,2,,1,,,,6,5,,,,30,5,-3,20)",
        {{"_OVR[21]", 2.0}, {"_OVR[22]", -3.0}, {"_OVR[23]", 0.0}, {"$P_UIFR[2,X,RT]", 2.0}}},
       {"over a protection zone",
        "X-15 Y-10 Z14\nCYCLE998(1106,1,,1,-10,,,6,5,,,,30,0,0,20)",
        {{"$P_UIFR[1,X,RT]", 2.0}, {"$P_UIFR[1,Y,RT]", -3.0}}}},
      "2.0, -3.0, 0.0");
}

TEST(PlaneAngleCycle, Alarms) {
  const std::string block = part("block", 100.0, 50.0, -300.0, "rotate_deg = [2.0, -3.0, 0.0]");
  const std::pair<const char*, int> kRows[] = {
      {"CYCLE998(6,,,1,,,,6,2.5,,,,30,0,0,20)", 61303},     // 3 degrees are beyond TSA
      {"CYCLE998(6,,,1,,,,6,5,,,,30,0,60,0)", 61331},       // three points on a line
      {"CYCLE998(10106,1,,1,,,,6,5,,,,30,0,0,20)", 61307},  // no reversal
      {"CYCLE998(106,1,5,1,,,,6,5,,,,30,0,0,20)", 61307}};  // no rotary axis
  for (const auto& [call, alarm] : kRows) {
    SCOPED_TRACE(call);
    const MeasuringRun run = run_measuring(std::string("X-15 Y-10 Z4\n") + call,
                                           {block, kCalibrated}, {"$P_UIFR[1,X,RT]"});
    EXPECT_EQ(run.alarm(), alarm) << run.output.errors;
    EXPECT_EQ(run.at("$P_UIFR[1,X,RT]"), 0.0);
  }
}

TEST(EdgeAngleCycle, Alarms) {
  const std::string block = part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 3.0]");
  struct Refusal {
    const char* call;
    int alarm;
  };
  const Refusal kRows[] = {{"CYCLE998(107,1,,1,,,,5,3,102,1,30)", 61307},
                           {"CYCLE998(105,1,,1,,,,5,3,101,1,30)", 61325},
                           {"CYCLE998(105,1,,1,,,,5,3,102,1,0)", 61331},
                           {"CYCLE998(105,1,,1,,46,,5,3,102,1,30)", 61331},
                           {"CYCLE998(105,1,,1,,,,6,2,102,1,30)", 61303},
                           {"CYCLE998(105,1,5,1,,,,6,5,102,1,30)", 61403},
                           {"CYCLE998(105,1,,1,,,,1,3,102,1,30)", 61301}};
  for (const Refusal& row : kRows) {
    SCOPED_TRACE(row.call);
    const MeasuringRun run = run_measuring(std::string("X-20 Y-27\nZ-5\n") + row.call,
                                           {block, kCalibrated}, {"$P_UIFR[1,Z,RT]"});
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at("$P_UIFR[1,Z,RT]"), 0.0);
  }
}

/// Lines of a program that has to define its variables first.
MeasuringRun run_plain(const std::string& program, const std::vector<std::string>& names) {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("part.mpf", program)};
  options.control = "sinumerik-828d";
  options.prints = names;
  return {testing::run_program(options)};
}

TEST(CircleOfPoints, ThreeAndFourPoints) {
  struct Circle {
    const char* name;
    const char* points;
    double x, y, r;
    int mode;
  };
  const Circle kRows[] = {
      {"three points", "3,0,10,-10,0,0,-10,0,0,0,0,0,0", 0.0, 0.0, 10.0, 0},
      {"four points of one circle", "4,6,2,1,7,-4,2,1,-3,0,0,0,0", 1.0, 2.0, 5.0, 0},
      {"points on a line", "3,0,0,1,1,2,2,0,0,0,0,0,0", 0.0, 0.0, 0.0, 61316},
      {"two points", "2,0,0,1,1,2,2,0,0,0,0,0,0", 0.0, 0.0, 0.0, 61317},
      {"five points", "5,0,0,1,1,2,2,0,0,0,0,0,0", 0.0, 0.0, 0.0, 61317},
  };
  for (const Circle& row : kRows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run =
        run_plain(fmt::format("DEF INT _MODE\nDEF REAL _CAL[13]=({})\nCYCLE116(_CAL,_MODE)\nM30\n",
                              row.points),
                  {"_CAL[9]", "_CAL[10]", "_CAL[11]", "_CAL[12]", "_MODE"});
    ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
    EXPECT_NEAR(run.at("_CAL[9]"), row.x, 1e-9);
    EXPECT_NEAR(run.at("_CAL[10]"), row.y, 1e-9);
    EXPECT_NEAR(run.at("_CAL[11]"), row.r, 1e-9);
    EXPECT_EQ(run.at("_CAL[12]"), row.mode != 0 ? 1.0 : 0.0);
    EXPECT_EQ(run.at("_MODE"), row.mode);
  }
}

TEST(TriangleInSpace, ShiftRotationAndDistortion) {
  const auto program = [](const char* measured, int target, const char* more) {
    return fmt::format(
        "DEF REAL SP[3,3]=(0,0,0,100,0,0,0,100,0), MP[3,3]=({})\nDEF INT ALM\nDEF REAL RES\nDEF "
        "FRAME REF\n"
        "G54\nCYCLE119(SP,MP,ALM,RES,REF,{},0.01)\n"
        "R1=REF[X,TR] R2=REF[Y,TR] R3=REF[Z,TR] R4=REF[X,RT] R5=REF[Y,RT] R6=REF[Z,RT]\n{}M30\n",
        measured, target, more);
  };
  const std::vector<std::string> names = {
      "R1", "R2", "R3", "R4", "R5", "R6", "RES", "ALM", "$P_UIFR[1,X,TR]", "$P_UIFR[1,Z,RT]"};
  const double c = cosine(10.0);
  const double s = sine(10.0);
  const std::string turned = fmt::format("1,2,3,{:.12f},{:.12f},3,{:.12f},{:.12f},3", 1 + 100 * c,
                                         2 + 100 * s, 1 - 100 * s, 2 + 100 * c);
  MeasuringRun run = run_plain(program(turned.c_str(), 1, ""), names);
  ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
  const double kExpected[] = {1.0, 2.0, 3.0, 0.0, 0.0, 10.0};
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(run.at(fmt::format("R{}", i + 1)), kExpected[i], 1e-9);
  }
  EXPECT_NEAR(run.at("RES"), 0.0, 1e-9);
  EXPECT_EQ(run.at("ALM"), 0.0);
  EXPECT_NEAR(run.at("$P_UIFR[1,X,TR]"), 1.0, 1e-9);
  EXPECT_NEAR(run.at("$P_UIFR[1,Z,RT]"), 10.0, 1e-9);
  // A basic frame and that of actual values: in force and stored.
  const std::vector<std::string> outer = {"$P_BFRAME[Y,TR]", "$P_CHBFR[0,Y,TR]",
                                          "$P_SETFRAME[Y,TR]", "$P_SETFR[Y,TR]"};
  for (const int target : {1000, 2000}) {
    run = run_plain(program(turned.c_str(), target, "G54\n"), outer);
    for (std::size_t i = 0; i < outer.size(); ++i) {
      EXPECT_NEAR(run.at(outer[i]), (i < 2) == (target == 1000) ? 2.0 : 0.0, 1e-9) << outer[i];
    }
  }
  // Out of the plane: about X by 90 degrees.
  run = run_plain(program("0,0,0,100,0,0,0,0,100", 0, ""), names);
  EXPECT_NEAR(run.at("R4"), 90.0, 1e-9);
  EXPECT_EQ(run.at("$P_UIFR[1,X,TR]"), 0.0);
  // One side longer by 0.3: the points miss by 0.1 (0.2) each way along it about the middle.
  run = run_plain(program("0,0,0,100,0,0,0,100.3,0", 1, ""), names);
  EXPECT_GT(run.at("RES"), 0.3);
  EXPECT_LT(run.at("RES"), 0.5);
  EXPECT_EQ(run.at("ALM"), 61403.0);
  // No triangle.
  run = run_plain(program("0,0,0,50,0,0,100,0,0", 1, ""), names);
  EXPECT_LT(run.at("RES"), 0.0);
  EXPECT_GT(run.at("ALM"), 0.0);
}

/// Afterwards the set points stand where the measured ones did, whatever lies within the offset.
TEST(TriangleInSpace, IsCorrectedWithinAllFramesInForce) {
  struct Row {
    const char* before;  ///< G54
    const char* behind;
    int target;
  };
  const Row kRows[] = {
      {"", "$P_WPFRAME=CROT(X,30)", 1},
      {"", "$P_TOOLFRAME=CTRANS(X,7):CROT(Y,20)", 1},
      {"", "$P_CYCFRAME=CROT(X,30)", 1},
      {"$P_CHBFR[1]=CROT(Z,90)", "TRANS X5 Z7\nAROT Y15", 1000},
      {"$P_CHBFR[1]=CROT(Z,90)", "", 1011},
      {"$P_CHBFRMASK=2", "$P_WPFRAME=CROT(X,30)", 1000},
      {"$P_CHBFR[0]=CROT(Y,25)\n$P_CHBFRMASK=5", "$P_WPFRAME=CROT(X,30)", 1000},
      {"$P_CHBFR[0]=CROT(Y,25)", "$P_WPFRAME=CROT(X,30)", 1012},
      {"$P_CHBFR[1]=CROT(Z,90)", "$P_WPFRAME=CROT(X,30)", 2000},
      {"$P_CHBFR[1]=CROT(Z,90)\n$P_CHBFRMASK=1", "", 1011},
  };
  for (const Row& row : kRows) {
    SCOPED_TRACE(fmt::format("{} G54 {} {}", row.before, row.behind, row.target));
    const std::string program = fmt::format(
        "DEF REAL SP[3,3]=(0,0,0,100,0,0,0,100,0)\nDEF REAL MP[3,3]=(1,2,3,{0:.12f},{1:.12f},3,"
        "{2:.12f},{3:.12f},3)\nDEF INT ALM\nDEF REAL RES\nDEF FRAME REF, WAS, IS\n{4}\nG54\n{5}\n"
        "WAS=$P_ACTFRAME:CTRANS(X,MP[1,0],Y,MP[1,1],Z,MP[1,2])\n"
        "CYCLE119(SP,MP,ALM,RES,REF,{6},0.01)\nIS=$P_ACTFRAME:CTRANS(X,SP[1,0])\n"
        "R1=WAS[X,TR] R2=WAS[Y,TR] R3=WAS[Z,TR]\nR4=IS[X,TR] R5=IS[Y,TR] R6=IS[Z,TR]\nM30\n",
        1 + 100 * cosine(10.0), 2 + 100 * sine(10.0), 1 - 100 * sine(10.0), 2 + 100 * cosine(10.0),
        row.before, row.behind, row.target);
    const MeasuringRun run = run_plain(program, {"R1", "R2", "R3", "R4", "R5", "R6", "ALM"});
    ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
    EXPECT_EQ(run.at("ALM"), 0.0);
    for (int i = 1; i <= 3; ++i) {
      EXPECT_NEAR(run.at(fmt::format("R{}", i + 3)), run.at(fmt::format("R{}", i)), 1e-9) << i;
    }
  }
}

}  // namespace
}  // namespace g31::testing::angle_corner_arc_test

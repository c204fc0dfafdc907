// CYCLE982 with mills that are wider than the tool probe, with rear edges of side mills, and with
// tools that a swivelled tool carrier holds.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"

namespace g31::testing::turned_mills_test {
namespace {

constexpr double kExactly = 1e-6;  // mm
const double kRad40 = std::numbers::pi / 4.5;

constexpr const char* kLathe = R"([machine]
tool_side = "ZX"
)";

/// B turns the turret about a line along Y through X20 Z30 of the gauge point.
constexpr const char* kSwivelling = R"([machine]
tool_side = "ZXB"
[machine.axes.X]
travel = [-3000.0, 3000.0]
[machine.axes.Z]
travel = [-3000.0, 3000.0]
[machine.axes.B]
centre = [20.0, 0.0, 30.0]
direction = [0.0, 1.0, 0.0]
travel = [-360.0, 360.0]
[machine_data]
"$MNS_MEA_FUNCTION_MASK" = 65547
)";

/// A shell mill of two teeth, whose lower edges rise towards the middle; a side mill on its shank;
/// an insert.
constexpr const char* kTools = R"([tools.5]
length = 50.0
radius = 0.4
type = 500.0
[tools.6]
length = 0.0
radius = 25.0
type = 140.0
[tools.8]
length = 0.0
radius = 30.0
type = 150.0
[[tool]]
number = 5
kind = "turning"
lengths = [50.0, 80.0, 0.0]
tip_radius = 0.4
edge_position = 3
[[tool]]
number = 6
length = 90.0
diameter = 50.0
teeth = [{ angle_deg = 0.0 }, { angle_deg = 180.0 }]
[[tool]]
number = 8
length = 90.0
diameter = 60.0
cutting_length = 6.0
[[tool.body]]
name = "shank"
length = 84.0
diameter = 16.0
)";

std::string with_tool(int tool, double l1, double l2, const std::string& data = "") {
  return fmt::format("$TC_DP3[{0},1]={1:.3f} $TC_DP4[{0},1]={2:.3f} {3}\nT{0} M6\nG18 D1 DIAMOF\n",
                     tool, l1, l2, data);
}

MeasuringRun run_mills(const std::string& body, const char* machine,
                       const std::vector<std::string>& names) {
  return run_on_sheets(body, {kLatheProbe, machine, kTools}, names);
}

void expect_mills(const std::string& body, const char* machine,
                  const std::vector<ExpectedValue>& expected) {
  expect_values(run_mills(body, machine, names_of(expected, {})), expected, kExactly);
}

constexpr const char* kBeside = "G0 SUPA X300 Z-150\n";

TEST(TurnedMills, AWideMillIsTouchedWithItsEdge) {
  const std::string wide = with_tool(6, 0.3, 89.8, "$TC_DP6[6,1]=25.1") + kBeside;
  expect_mills(wide + "CYCLE982(1,0,1,1,2,0,5,2,,,,0.0001,1)", kLathe,
               {{"$TC_DP4[6,1]", 90.0}, {"$TC_DP3[6,1]", 0.3}, {"_OVR[11]", 0.2}});
  expect_mills(wide + "CYCLE982(2002,0,1,0,0,0,5,2,,,,0.0001,1)", kLathe,
               {{"$TC_DP3[6,1]", 0.0}, {"$TC_DP4[6,1]", 90.0}, {"$TC_DP6[6,1]", 25.0}});
  expect_mills(wide + "CYCLE982(2102,0,1,0,0,0,5,2,,0,0,0.0001,1,,,,1000)", kLathe,
               {{"$TC_DP3[6,1]", 0.0}, {"$TC_DP4[6,1]", 90.0}, {"$TC_DP6[6,1]", 25.0}});
}

/// In front of the plate's middle the edges of the shell mill are 15 tan 2 degrees too high; S_ID
/// as large as the radius has it touch there.
TEST(TurnedMills, TheOffsetBringsTheToolNearer) {
  expect_mills(with_tool(6, 0.0, 90.0) + kBeside + "CYCLE982(1,0,1,1,2,25,5,2)", kLathe,
               {{"_OVR[11]", -0.523811542489}});
}

TEST(TurnedMills, ASideMillIsMeasuredByItsRearEdge) {
  const std::string side = with_tool(8, 0.1, 83.8, "$TC_DP6[8,1]=30.2") + kBeside;
  for (const char* const call : {"CYCLE982(3002,0,1,0,0,0,5,2,,,,0.0001,1)",
                                 "CYCLE982(3002,0,1,0,0,0,5,2,,,,0.0001,1,,,,1000)",
                                 "CYCLE982(3102,0,1,0,0,0,5,2,,30,0,0.0001,1)"}) {
    SCOPED_TRACE(call);
    expect_mills(side + call, kLathe,
                 {{"$TC_DP3[8,1]", 0.0},
                  {"$TC_DP4[8,1]", 84.0},
                  {"$TC_DP6[8,1]", 30.0},
                  {"_OVR[9]", -0.1},
                  {"_OVR[11]", 0.2},
                  {"_OVR[13]", -0.2},
                  // The tip is back where the call found it, by its data as they are now.
                  {"$AA_IM[X]", 300.0},
                  {"$AA_IM[Z]", -150.0 + 84.0}});
  }
}

std::string swivelled(double degrees) {
  return fmt::format("G0 SUPA X400 Z100 B{:.0f}\nTCARR=1 TCOABS\n", degrees);
}

TEST(TurnedMills, ATurningToolHeldByACarrierIsMeasuredAtAnyAngle) {
  for (const double degrees : {0.0, 30.0, 45.0, 90.0, -20.0, 180.0}) {
    SCOPED_TRACE(degrees);
    expect_mills(with_tool(5, 50.3, 79.6, "$TC_DP2[5,1]=3") + swivelled(degrees) +
                     "G0 SUPA X200\nG0 SUPA Z-100\nCYCLE982(2,0,1,0,0,0,5,2,,,,0.0001,1)\n"
                     "R1=_OVR[9] R2=_OVR[11]\nCYCLE982(2,0,1,0,0,0,5,2)",
                 kSwivelling,
                 {{"R1", -0.3},
                  {"R2", 0.4},
                  {"$TC_DP3[5,1]", 50.0},
                  {"$TC_DP4[5,1]", 80.0},
                  {"_OVR[9]", 0.0},
                  {"_OVR[11]", 0.0}});
  }
}

TEST(TurnedMills, AMillHeldByACarrierIsMeasuredAlongAnAxis) {
  const std::string mill = with_tool(6, 0.3, 89.8, "$TC_DP6[6,1]=25.1");
  const std::vector<ExpectedValue> found = {
      {"$TC_DP3[6,1]", 0.0}, {"$TC_DP4[6,1]", 90.0}, {"$TC_DP6[6,1]", 25.0}};
  const std::string limits = ",0,0,0,5,2,,,,0.0001,1)";
  expect_mills(mill + swivelled(90) + "G0 SUPA X300\nG0 SUPA Z-150\nCYCLE982(12002,0,1" + limits,
               kSwivelling, found);
  expect_mills(mill + swivelled(0) + kBeside + "CYCLE982(2002,0,1" + limits, kSwivelling, found);
}

/// The tip goes from X100 Z-200 to plus of both; a pin of 2 mm stands there at X130 Z-170.  The
/// ends of the edges, 10 mm and 40 degrees to either side of the way, and the line between them
/// come first.
TEST(TurnedMills, AFixtureMeetsTheBackOfAnInsert) {
  const MeasuringRun run = run_on_sheets(
      "T5 D1 M6\nG18 DIAMOF D0\nG0 X150 Z-120\nG1 X190 Z-80 F1000",
      {"[control]\nprofile = \"sinumerik-828d\"\n", kLathe, kTools,
       "[[tool]]\nnumber = 5\nkind = \"turning\"\nlengths = [50.0, 80.0, 0.0]\n"
       "tip_radius = 0.4\nedge_position = 3\ninsert_angle_deg = 80.0\norientation_deg = 45.0\n"
       "edge_length = 10.0\n",
       part("cylinder", 130.0, -10.0, -170.0,
            "fixture = true\ndiameter = 2.0\nheight = 20.0\nrotate_deg = [90.0, 0.0, 0.0]")},
      {"$AA_IM[X]"});
  EXPECT_EQ(run.output.exit_code, 4) << run.output.errors;
  // From the middle of the tip to its back, along the way: an edge begins where it touches the tip,
  // which is a sine of its radius further off.
  const double back = 10.0 * std::cos(kRad40) - 0.4 * std::sin(kRad40);
  const double way = std::sqrt(2.0) * (30.0 - 0.4) - back - 1.0;
  EXPECT_NEAR(run.at("$AA_IM[X]"), 150.0 + way / std::sqrt(2.0), 0.01);
}

struct AlarmCase {
  const char* name;
  int tool;
  const char* machine;
  const char* before;
  const char* call;
  int alarm;
};

constexpr AlarmCase kAlarms[] = {
    {"a rear edge alone", 8, kLathe, "", "CYCLE982(3001,0,1,1,1,0,5,2)", 61307},
    {"a rear edge without a radius", 8, kLathe, "$TC_DP6[8,1]=0", "CYCLE982(3002,0,1,0,0,0,5,2)",
     61314},
    {"all of a drill", 8, kLathe, "$TC_DP1[8,1]=200", "CYCLE982(2,0,1,0,0,0,5,2)", 61307},
    {"a rear edge on a carrier", 8, kSwivelling, "TCARR=1 TCOABS", "CYCLE982(3002,0,1,0,0,0,5,2)",
     61307},
    {"a mill on the slant", 6, kSwivelling, "G0 B30\nTCARR=1 TCOABS", "CYCLE982(1,0,1,1,2,0,5,2)",
     61330},
    {"a carrier that the cycle shall not know", 5, kSwivelling,
     "$MNS_MEA_FUNCTION_MASK=11\nG0 B30\nTCARR=1 TCOABS", "CYCLE982(1,0,1,1,2,0,5,2)", 61330},
    {"a carrier and a tooth to the side", 6, kSwivelling, "TCARR=1 TCOABS",
     "CYCLE982(1000001,0,1,1,2,0,5,2,,90)", 61330},
};

TEST(TurnedMills, EachAlarmWritesNothing) {
  for (const AlarmCase& row : kAlarms) {
    SCOPED_TRACE(row.name);
    const std::vector<std::string> written = {fmt::format("$TC_DP3[{},1]", row.tool),
                                              fmt::format("$TC_DP4[{},1]", row.tool)};
    const MeasuringRun run =
        run_mills(with_tool(row.tool, 0.3, 84.2) + kBeside + row.before + "\n" + row.call,
                  row.machine, written);
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at(written[0]), 0.3);
    EXPECT_EQ(run.at(written[1]), 84.2);
  }
}

}  // namespace
}  // namespace g31::testing::turned_mills_test

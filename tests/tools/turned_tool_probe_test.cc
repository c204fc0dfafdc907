// CYCLE982 on a lathe with a true tool probe: turning tools, mills and drills whose data are wrong.

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"

namespace g31::testing::turned_tool_probe_test {
namespace {

constexpr double kExactly = 1e-6;  // mm

/// Tools 5 and 9 turn, 6 and 7 mill and drill.
constexpr const char* kLathe = R"([machine]
tool_side = "ZX"
[tools.5]
length = 50.0
radius = 0.4
type = 500.0
[tools.6]
length = 0.0
radius = 5.0
type = 120.0
[tools.7]
length = 0.0
radius = 4.0
type = 200.0
[tools.9]
length = 60.0
radius = 1.0
type = 585.0
[[tool]]
number = 5
kind = "turning"
lengths = [50.0, 80.0, 0.0]
tip_radius = 0.4
edge_position = 3
[[tool]]
number = 6
length = 90.0
diameter = 10.0
[[tool]]
number = 7
kind = "drill"
length = 110.0
diameter = 8.0
[[tool]]
number = 9
kind = "turning"
lengths = [60.0, 70.0, 0.0]
tip_radius = 1.0
edge_position = 3
)";

/// The triggers up to 0.5 mm off.
constexpr const char* kOff = R"([machine_data]
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]" = -199.5
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]" = -220.3
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]" = 110.4
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]" = 89.5
)";

/// The tool with its edge data, away from the probe in X and Z.
std::string with_edge(int tool, double l1, double l2, int position, const char* how = "DIAMOF") {
  return fmt::format(
      "$TC_DP3[{0},1]={1:.3f} $TC_DP4[{0},1]={2:.3f} $TC_DP2[{0},1]={3}\n"
      "T{0} M6\nG18 D1 {4}\nG0 SUPA X300 Z-150\n",
      tool, l1, l2, position, how);
}

void expect_turned(const std::string& body, const std::vector<std::string>& sheets,
                   const std::vector<ExpectedValue>& expected) {
  std::vector<std::string> all = {kLatheProbe, kLathe};
  all.insert(all.end(), sheets.begin(), sheets.end());
  expect_values(run_on_sheets(body, all, names_of(expected, {})), expected, kExactly);
}

TEST(TurnedToolProbe, IsCalibratedFromFourSides) {
  expect_turned(with_edge(9, 60.0, 70.0, 3) +
                    "CYCLE982(0,0,1,1,2,0,5,2)\nR1=_OVR[8] R2=_OVR[9]\n"
                    "CYCLE982(0,0,1,2,2,0,5,2)\nR3=_OVR[12] R4=_OVR[13]\n"
                    "G0 SUPA Z-260\nG0 SUPA X100\nCYCLE982(0,0,1,1,1,0,5,2)\n"
                    "G0 SUPA X60\nCYCLE982(0,0,1,2,1,0,5,2)",
                {kOff},
                {{"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]", -200.0},
                 {"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]", -220.0},
                 {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]", 110.0},
                 {"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]", 90.0},
                 {"R1", -200.0},
                 {"R2", -0.5},
                 {"R3", 110.0},
                 {"R4", -0.4},
                 {"_OVR[14]", 90.0},
                 {"_OVR[15]", 0.5},
                 {"_OVI[2]", 982.0},
                 {"_OVI[9]", 0.0}});
}

TEST(TurnedToolProbe, MeasuresBothLengthsOfATurningToolInRadiusAndInDiameter) {
  for (const char* const how : {"DIAMOF", "DIAMON"}) {
    SCOPED_TRACE(how);
    expect_turned(with_edge(5, 50.3, 79.6, 3, how) +
                      "CYCLE982(2,0,1,0,0,0,5,2,,,,0.0001,1)\n"
                      "R1=_OVR[8] R2=_OVR[9] R3=_OVR[10] R4=_OVR[11]\n"
                      "CYCLE982(2,0,1,0,0,0,5,2)",
                  {},
                  {{"R1", 50.0},
                   {"R2", -0.3},
                   {"R3", 80.0},
                   {"R4", 0.4},
                   {"$TC_DP3[5,1]", 50.0},
                   {"$TC_DP4[5,1]", 80.0},
                   {"_OVR[9]", 0.0},
                   {"_OVR[11]", 0.0}});
  }
}

/// Without [[tool]] the turret holds what the control believes: an insert where its data have it.
TEST(TurnedToolProbe, FindsABelievedTurningToolAsItsDataSay) {
  constexpr const char* kCalibrationToolAlone =
      "[[tool]]\nnumber = 9\nkind = \"turning\"\nlengths = [60.0, 70.0, 0.0]\ntip_radius = 1.0\n";
  expect_turned(with_edge(5, 50.3, 79.6, 3) + "R1=$P_TOOLL[1] R2=$P_TOOLL[2] R3=$P_TOOLL[3]\n" +
                    "CYCLE982(2,0,1,0,0,0,5,2,,,,0.0001,1)",
                {kCalibrationToolAlone},
                {{"R1", 50.3},
                 {"R2", 79.6},
                 {"R3", 0.0},
                 {"_OVR[8]", 50.3},
                 {"_OVR[9]", 0.0},
                 {"_OVR[10]", 79.6},
                 {"_OVR[11]", 0.0}});
}

TEST(TurnedToolProbe, MeasuresTheSameInEachUnit) {
  for (const auto& [code, unit] :
       {std::pair{"G71", 1.0}, std::pair{"G70", 25.4}, std::pair{"G700", 25.4}}) {
    SCOPED_TRACE(code);
    const std::string limits = fmt::format("{:.12f},{:.12f}", 5.0 / unit, 2.0 / unit);
    expect_turned(with_edge(9, 60.0, 70.0, 3) + code + "\nCYCLE982(0,0,1,1,2,0," + limits +
                      ")\nR1=_OVR[8] R2=$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]\nG710",
                  {kOff},
                  {{"R1", -200.0 / unit},
                   {"R2", -200.0 / (std::string(code) == "G700" ? unit : 1.0)},
                   {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]", -200.0}});
    expect_turned(
        with_edge(5, 50.3, 79.6, 3, "DIAMON") + code + "\nCYCLE982(2,0,1,0,0,0," + limits +
            fmt::format(",,,,{:.12f},{:.12f}", 0.0001 / unit, 1.0 / unit) +
            ")\nR1=_OVR[8] R2=_OVR[10]\nG710",
        {},
        {{"R1", 50.0 / unit}, {"R2", 80.0 / unit}, {"$TC_DP3[5,1]", 50.0}, {"$TC_DP4[5,1]", 80.0}});
  }
}

TEST(TurnedToolProbe, MeasuresOneLengthIntoTheWear) {
  expect_turned(with_edge(5, 50.3, 79.6, 3) +
                    "CYCLE982(1,1,1,1,2,0,5,2,,,,0.0001,1)\n"
                    "CYCLE982(1,1,1,2,0,0,5,2,,,,0.0001,1)",
                {},
                {{"$TC_DP3[5,1]", 50.3},
                 {"$TC_DP12[5,1]", -0.3},
                 {"$TC_DP4[5,1]", 79.6},
                 {"$TC_DP13[5,1]", 0.4}});
}

TEST(TurnedToolProbe, MeasuresMillsAndDrills) {
  expect_turned("$TC_DP6[6,1]=5.1\n" + with_edge(6, 0.3, 89.8, 0) +
                    "CYCLE982(2002,0,1,0,0,0,5,2,,,,0.0001,1)",
                {},
                {{"$TC_DP3[6,1]", 0.0},
                 {"$TC_DP4[6,1]", 90.0},
                 {"$TC_DP6[6,1]", 5.0},
                 {"_OVR[9]", -0.3},
                 {"_OVR[11]", 0.2},
                 {"_OVR[12]", 5.0},
                 {"_OVR[13]", -0.1}});
  expect_turned("$TC_DP6[6,1]=4.8\n" + with_edge(6, 0.0, 90.0, 0) +
                    "CYCLE982(1001,0,1,2,2,0,5,2,,,,0.0001,1)",
                {}, {{"$TC_DP6[6,1]", 5.0}, {"$TC_DP3[6,1]", 0.0}});
  expect_turned("$TC_DP6[6,1]=5.2\n" + with_edge(6, 0.3, 90.0, 0) +
                    "CYCLE982(2101,0,1,2,0,0,5,2,,15,0,0.0001,1)",
                {}, {{"$TC_DP6[6,1]", 5.0}, {"$TC_DP3[6,1]", 0.0}});
  expect_turned(with_edge(7, 0.0, 110.4, 0) + "CYCLE982(1,0,1,1,2,0,5,2,,,,0.0001,1)", {},
                {{"$TC_DP4[7,1]", 110.0}, {"_OVR[11]", -0.4}});
}

/// SD42950 = 0: length 1 of a drill in Z with G17 and in X with G19, by the triggers of G18; with
/// the plane of the program or that of _DMODE.  The drill of 110 mm lies along X for G19.
TEST(TurnedToolProbe, DrillsWithLengthsAsOnAMillAreMeasuredAcrossThePlane) {
  const std::string as_mill =
      "[machine_data]\n\"$SC_TOOL_LENGTH_TYPE\" = 0\n[tools.7]\n"
      "type = 200.0\nradius = 4.0\nlength = 110.4\n";
  const std::string along_x =
      "[tools.8]\ntype = 200.0\nradius = 4.0\nlength = 49.7\n[[tool]]\nnumber = 8\nkind = "
      "\"turning\"\nlengths = [50.0, 0.0, 0.0]\ntip_radius = 0.0\nedge_position = 8\n";
  struct Row {
    const char* before;  ///< of the program: its plane
    int axis;            ///< S_MA
    int plane;           ///< _DMODE
  };
  for (const Row& row : {Row{"G17", 1, 0}, Row{"G17", 3, 0}, Row{"G18", 1, 1}, Row{"G19", 1, 1}}) {
    SCOPED_TRACE(row.before + std::to_string(row.plane));
    expect_turned(fmt::format("T7 M6\n{} D1 DIAMOF\nG0 SUPA X300 Z0\nX100\n"
                              "CYCLE982(1,0,1,{},2,0,5,2,,,,0.0001,1,,,,{})",
                              row.before, row.axis, row.plane),
                  {as_mill},
                  {{"$TC_DP3[7,1]", 110.0},
                   {"$TC_DP4[7,1]", 0.0},
                   {"_OVR[8]", 110.0},
                   {"_OVR[9]", -0.4},
                   {"_OVI[9]", 0.0}});
  }
  for (const Row& row : {Row{"G19", 2, 0}, Row{"G19", 3, 0}, Row{"G18", 2, 3}, Row{"G17", 2, 3}}) {
    SCOPED_TRACE(row.before + std::to_string(row.plane));
    expect_turned(fmt::format("T8 M6\n{} D1 DIAMOF\nG0 SUPA X300 Z-100\nZ-210\n"
                              "CYCLE982(10001,1,1,{},2,0,5,2,,,,0.0001,1,,,,{})",
                              row.before, row.axis, row.plane),
                  {as_mill, along_x},
                  {{"$TC_DP3[8,1]", 49.7}, {"$TC_DP12[8,1]", 0.3}, {"_OVR[9]", 0.3}});
  }
}

struct AlarmCase {
  const char* name;
  const char* before;
  const char* call;
  int alarm;
};

constexpr AlarmCase kAlarms[] = {
    {"a kind that is none", "", "CYCLE982(3,0,1,1,2,0,5,2)", 61307},
    {"the rear edge of a side mill", "", "CYCLE982(3002,0,1,1,2,0,5,2)", 61307},
    {"a turning tool in G17", "G17\n", "CYCLE982(1,0,1,1,2,0,5,2)", 61307},
    {"a turning tool in G19", "", "CYCLE982(2,0,1,0,0,0,5,2,,,,,,,,,3)", 61307},
    {"the radius of a turning tool", "", "CYCLE982(1001,0,1,1,2,0,5,2)", 61307},
    {"incremental, all", "", "CYCLE982(100002,0,1,1,2,0,5,2)", 61307},
    {"no path", "", "CYCLE982(1,0,1,1,2,0,0,2)", 61308},
    {"a scale of work coordinates", "", "SCALE X2 Z2\nCYCLE982(11,0,1,1,2,0,5,2)", 61310},
    {"no edge", "", "D0\nCYCLE982(1,0,1,1,2,0,5,2)", 61311},
    {"a data set that is none", "", "CYCLE982(1,0,7,1,2,0,5,2)", 61313},
    {"a 3D probe of lathes", "$TC_DP1[5,1]=580", "CYCLE982(0,0,1,1,2,0,5,2)", 61314},
    {"a turning tool of Y", "$TC_DP1[5,1]=505", "CYCLE982(1,0,1,1,2,0,5,2)", 61314},
    {"a mill with lengths as on a mill", "$TC_DP1[5,1]=120 $SC_TOOL_LENGTH_TYPE=0",
     "CYCLE982(1,0,1,1,2,0,5,2)", 61314},
    {"a drill without a radius by its side", "$TC_DP1[5,1]=200 $TC_DP6[5,1]=0",
     "CYCLE982(1,0,1,2,2,0,5,2)", 61314},
    {"an edge position that is none", "$TC_DP2[5,1]=9", "CYCLE982(1,0,1,1,2,0,5,2)", 61315},
    {"a calibration by an edge that cuts in one axis", "$TC_DP2[5,1]=7",
     "CYCLE982(0,0,1,1,2,0,5,2)", 61315},
    {"no axis", "", "CYCLE982(1,0,1,0,2,0,5,2)", 61325},
    {"an axis that the edge does not cut in", "$TC_DP2[5,1]=7", "CYCLE982(1,0,1,2,2,0,5,2)", 61325},
    {"a direction that is none", "", "CYCLE982(1,0,1,1,3,0,5,2)", 61326},
    {"a data set that is not calibrated", "", "CYCLE982(1,0,2,1,2,0,5,2)", 61341},
    {"a spindle that cannot be positioned", "$TC_DP1[5,1]=120 $MCS_AXIS_USAGE_ATTRIB[6]=512",
     "CYCLE982(1000001,0,1,1,2,0,5,2,,90)", 61372},
    {"outside the safe area", "", "CYCLE982(2,0,1,0,0,0,5,0.2)", 61303},
    {"not reached", "", "CYCLE982(1,0,1,2,2,0,0.2,2)", 61301},
    {"reached on the way", "", "CYCLE982(1,0,1,1,2,0,0.2,2)", 61302},
};

TEST(TurnedToolProbe, EachAlarmWritesNothing) {
  for (const AlarmCase& row : kAlarms) {
    SCOPED_TRACE(row.name);
    const std::vector<std::string> written = {"$TC_DP3[5,1]", "$TC_DP4[5,1]", "$TC_DP12[5,1]",
                                              "$TC_DP13[5,1]", "$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]"};
    const MeasuringRun run = run_on_sheets(
        with_edge(5, 50.3, 79.6, 3) + row.before + "\n" + row.call, {kLatheProbe, kLathe}, written);
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at(written[0]), 50.3);
    EXPECT_EQ(run.at(written[1]), 79.6);
    EXPECT_EQ(run.at(written[2]), 0.0);
    EXPECT_EQ(run.at(written[3]), 0.0);
    EXPECT_EQ(run.at(written[4]), -200.0);
  }
}

TEST(TurnedToolProbe, OneDifferenceBeyondThePermissibleOneCorrectsNothing) {
  const MeasuringRun run =
      run_on_sheets(with_edge(5, 50.3, 79.6, 3) + "CYCLE982(2,0,1,0,0,0,5,2,,,,0.0001,0.35)",
                    {kLatheProbe, kLathe}, {"$TC_DP3[5,1]", "$TC_DP4[5,1]", "_OVI[9]"});
  EXPECT_EQ(run.alarm(), 0) << run.output.errors;
  EXPECT_EQ(run.at("_OVI[9]"), 61306.0);
  EXPECT_EQ(run.at("$TC_DP3[5,1]"), 50.3);
  EXPECT_EQ(run.at("$TC_DP4[5,1]"), 79.6);
}

}  // namespace
}  // namespace g31::testing::turned_tool_probe_test

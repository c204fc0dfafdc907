// What the measuring manual says of tools with numbers or tables, for CYCLE971 and CYCLE982: the
// spacing of teeth, speeds and feeds, edge positions and lengths, the second spindle position.

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"

namespace g31::testing::tool_measuring_examples_test {
namespace {

constexpr double kExactly = 1e-6;

std::vector<const nlohmann::json*> signals_of(const MeasuringRun& run) {
  std::vector<const nlohmann::json*> signals;
  for (const auto& touch : run.output.document.at("touches")) {
    if (touch.at("triggered").get<bool>()) {
      signals.push_back(&touch);
    }
  }
  return signals;
}

/// Three teeth are 120 degrees apart.  Where +X faces the plate they stand at 100, 220 and 340.
TEST(ToolMeasuringExamples, ThreeTeethComeEvery120Degrees) {
  expect_tools("$TC_DPNT[6,1]=3\n" + with_tool(6) + "CYCLE971(102,0,1,1,1,0,5,2,,0.0001,1)",
               {kCube, kKnown,
                "[[tool]]\nnumber = 6\nlength = 100.0\ndiameter = 16.0\nteeth = [{ angle_deg = "
                "20.0 }, { angle_deg = 140.0, radius = 7.98 }, { angle_deg = 260.0, radius = 7.99 "
                "}]\n"},
               {{"_OVR[100]", 7.99}, {"_OVR[101]", 7.98}, {"_OVR[102]", 8.0}}, 1e-4);
}

/// On a disc of radius R a tooth at radius r goes back by r + r r / R times half its angle squared,
/// not by r: whoever took it for a plane would look a degree and more beside these teeth.
TEST(ToolMeasuringExamples, TeethAreFoundOnADisc) {
  for (const double diameter : {25.0, 10.0}) {
    SCOPED_TRACE(diameter);
    const std::string disc = fmt::format(
        "[[tool_probe]]\nshape = \"disc\"\nsize = [{}, 8.0]\nat = [200.0, 0.0, -300.0]\n"
        "[machine_data]\n\"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]\" = {}\n"
        "\"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]\" = {}\n\"$SNS_MEA_TP_EDGE_DISK_SIZE[0]\" = {}\n",
        diameter, 200.0 + diameter / 2.0, 200.0 - diameter / 2.0, diameter);
    expect_tools("$TC_DPNT[6,1]=3\n" + with_tool(6) + "CYCLE971(102,0,1,1,1,0,5,2,,0.0001,1)",
                 {kKnown, disc,
                  "[[tool]]\nnumber = 6\nlength = 100.0\ndiameter = 16.0\nteeth = [{ angle_deg = "
                  "27.0 }, { angle_deg = 147.0, radius = 7.98 }, { angle_deg = 267.0, radius = "
                  "7.99 }]\n"},
                 {{"_OVR[100]", 7.99}, {"_OVR[101]", 7.98}, {"_OVR[102]", 8.0}}, 1e-5);
  }
}

struct SpeedCase {
  double metres;    ///< a minute, SD54670
  double radius;    ///< mm, of the tool
  double accuracy;  ///< mm, SD54677
  double most;      ///< rev/min, SD54671
  double speed;     ///< rev/min: metres / (2 pi r 0.001)
  double feed;      ///< mm/min: speed accuracy
};

constexpr SpeedCase kSpeeds[] = {
    {100.0, 5.0, 0.005, 100000.0, 3183.0989, 15.91549},
    {60.0, 16.0, 0.01, 100000.0, 596.8310, 5.96831},
    {100.0, 0.5, 0.005, 20000.0, 20000.0, 100.0},  // 31830.9886 rev/min are too many
};

TEST(ToolMeasuringExamples, SpeedAndFeedFollowFromRadiusAndAccuracy) {
  for (const SpeedCase& row : kSpeeds) {
    SCOPED_TRACE(row.speed);
    const std::string data = fmt::format(
        "$TC_DP6[5,1]={} $SNS_MEA_CM_MAX_PERI_SPEED[0]={} $SNS_MEA_CM_MAX_REVOLUTIONS[0]={}\n"
        "$SNS_MEA_CM_MEASURING_ACCURACY[0]={} $SNS_MEA_CM_FEEDFACTOR_1[0]=0\n"
        "$SNS_MEA_CM_MAX_FEEDRATE[0]=1000 $SNS_MEA_CM_MIN_FEEDRATE[0]=1\n",
        row.radius, row.metres, row.most, row.accuracy);
    const MeasuringRun run =
        expect_tools(data + with_tool(5) + "CYCLE971(2,0,1,1,1,0,10,10)\nR1=$P_S[1]",
                     {kCube, kKnown}, {{"R1", row.speed}}, 1e-4);
    ASSERT_EQ(signals_of(run).size(), 1U);
    EXPECT_NEAR(signals_of(run).front()->at("feed").get<double>(), row.feed, 1e-5);
  }
}

/// SD54762 bit 5: S2 = 0 is one probing, S3 = 0 two, else three; each at its own feed.
TEST(ToolMeasuringExamples, FeedsAndSpeedsOfTheCallSayHowManyProbings) {
  struct Probings {
    const char* given;  ///< F1, S1, F2, S2, F3, S3
    std::vector<double> feeds;
  };
  for (const Probings& row :
       {Probings{"50,800", {50}}, Probings{"50,800,30,0,3,600", {50}},
        Probings{"50,800,30,700", {50, 30}}, Probings{"50,800,30,700,3,0", {50, 30}},
        Probings{"50,800,30,700,3,600", {50, 30, 3}}}) {
    SCOPED_TRACE(row.given);
    const MeasuringRun run =
        expect_tools("$SNS_MEA_FUNCTION_MASK_TOOL=32\n" + with_tool(5) +
                         fmt::format("CYCLE971(2,0,1,1,1,0,5,2,,,,,{})", row.given),
                     {kCube, kKnown}, {{"_OVI[9]", 0.0}}, 1.0);
    std::vector<double> feeds;
    for (const nlohmann::json* const signal : signals_of(run)) {
      feeds.push_back(signal->at("feed").get<double>());
    }
    EXPECT_EQ(feeds, row.feeds);
  }
}

/// All sides: the third axis first, downwards, then the axes of the plane.
TEST(ToolMeasuringExamples, AutomaticCalibrationBeginsFromAbove) {
  const MeasuringRun run = expect_tools(with_tool(9) + "CYCLE971(100000,0,1,0,0,0,5,2)", {kCube},
                                        {{"_OVR[16]", -300.0}}, kExactly);
  const auto signals = signals_of(run);
  ASSERT_GE(signals.size(), 5U);
  EXPECT_NEAR(signals[0]->at("normal").at(2).get<double>(), 1.0, 1e-9);
  for (std::size_t i = 1; i < signals.size(); ++i) {
    EXPECT_NEAR(signals[i]->at("normal").at(2).get<double>(), 0.0, 1e-9);
  }
}

/// Tools in front of kLatheProbe.
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
[[tool]]
number = 6
length = 90.0
diameter = 10.0
teeth = [{ angle_deg = 170.0, radius = 5.0 }, { angle_deg = 353.0, radius = 4.9 }]
[[tool]]
number = 5
kind = "turning"
lengths = [50.0, 80.0, 0.0]
tip_radius = 0.4
)";

/// The data say 50.3 and 79.6, the tool has 50 and 80.
struct EdgeCase {
  int position;
  double x;  ///< where the tool comes from
  double z;
  double l1;  ///< afterwards
  double l2;
};

constexpr EdgeCase kEdges[] = {
    {1, -100, -270, 50.0, 80.0}, {2, -100, -150, 50.0, 80.0}, {3, 300, -150, 50.0, 80.0},
    {4, 300, -270, 50.0, 80.0},  {5, 300, -270, 50.3, 80.0},  {6, -100, -150, 50.0, 79.6},
    {7, 300, -150, 50.3, 80.0},  {8, 300, -150, 50.0, 79.6},
};

TEST(ToolMeasuringExamples, EdgePositionsSayWhichLengthsAreMeasured) {
  for (const EdgeCase& row : kEdges) {
    SCOPED_TRACE(row.position);
    const std::string tool = fmt::format(
        "[[tool]]\nnumber = 5\nkind = \"turning\"\nlengths = [50.0, 80.0, 0.0]\n"
        "tip_radius = 0.4\nedge_position = {}\n",
        row.position);
    const std::vector<ExpectedValue> expected = {{"$TC_DP3[5,1]", row.l1},
                                                 {"$TC_DP4[5,1]", row.l2}};
    const MeasuringRun run = run_on_sheets(
        fmt::format("$TC_DP3[5,1]=50.3 $TC_DP4[5,1]=79.6 $TC_DP2[5,1]={}\nT5 M6\nG18 D1 DIAMOF\n"
                    "G0 SUPA X{} Z{}\nCYCLE982(2,0,1,0,0,0,5,2,,,,0.0001,1)",
                    row.position, row.x, row.z),
        {kLatheProbe, kLathe, tool}, names_of(expected));
    expect_values(run, expected, kExactly);
    const auto signals = signals_of(run);
    ASSERT_EQ(signals.size(), row.position <= 4 ? 2U : 1U);
    if (row.position <= 4) {  // Z first
      EXPECT_NEAR(std::abs(signals[0]->at("normal").at(2).get<double>()), 1.0, 1e-6);
      EXPECT_NEAR(std::abs(signals[1]->at("normal").at(0).get<double>()), 1.0, 1e-6);
    }
  }
}

/// S_STA1 = 10 and S_CORA = -3 turn the spindle to 10 and 187 degrees: there the teeth at 170 and
/// 353 face -X.  Three degrees beside it 4.9 mm would read 0.007 less.
TEST(ToolMeasuringExamples, TheSecondSpindlePositionTakesTheOffsetAngle) {
  const std::vector<ExpectedValue> expected = {{"$TC_DP6[6,1]", 4.95}};
  const MeasuringRun run = run_on_sheets(
      "$TC_DP3[6,1]=0 $TC_DP4[6,1]=90\nT6 M6\nG18 D1 DIAMOF\nG0 SUPA X300 Z-150\n"
      "CYCLE982(1101,0,1,2,2,0,5,2,,10,-3,0.0001,1)",
      {kLatheProbe, kLathe}, names_of(expected));
  expect_values(run, expected, kExactly);
}

constexpr const char* kMachineAndWork = R"([work_offsets.G54]
X = 20.0
Z = -300.0
[tools.9]
length = 60.0
radius = 1.0
type = 585.0
[machine_data]
"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX1[0]" = 100.4
"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX1[0]" = 79.7
"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX2[0]" = 90.4
"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX2[0]" = 69.5
)";

std::string insert(int number, double l1, double l2, double radius) {
  return fmt::format(
      "[[tool]]\nnumber = {}\nkind = \"turning\"\nlengths = [{}, {}, 0.0]\ntip_radius = {}\n",
      number, l1, l2, radius);
}

void expect_on_lathe(const std::string& program, const std::vector<ExpectedValue>& expected) {
  const MeasuringRun run = run_on_sheets(program,
                                         {kLatheProbe, kLathe, kMachineAndWork,
                                          insert(5, 50.0, 80.0, 0.4) + insert(9, 60.0, 70.0, 1.0)},
                                         names_of(expected));
  expect_values(run, expected, kExactly);
}

constexpr const char* kCalibrator =
    "$TC_DP3[9,1]=60 $TC_DP4[9,1]=70 $TC_DP2[9,1]=3\nT9 M6\nG18 G54 D1 DIAMOF\nG0 SUPA X300 "
    "Z-150\n";
constexpr const char* kTurningTool =
    "$TC_DP3[5,1]=50.3 $TC_DP4[5,1]=79.6 $TC_DP2[5,1]=3\nG0 SUPA X300 Z-100\nT5 M6\n"
    "G18 G54 D1 DIAMON\nG0 SUPA X600 Z-150\n";

/// Tens 1: triggers and tools in the coordinates of G54, which lies at X20 Z-300; X in diameter.
TEST(ToolMeasuringExamples, Cycle982InWorkCoordinates) {
  const std::string calibrate =
      std::string(kCalibrator) +
      "DIAMON\nCYCLE982(10,0,1,1,2,0,5,2)\nCYCLE982(10,0,1,2,2,0,5,2)\nDIAMOF\nG0 SUPA Z-260\n"
      "G0 SUPA X100\nCYCLE982(10,0,1,1,1,0,5,2)\nG0 SUPA X30\nCYCLE982(10,0,1,2,1,0,5,2)\n"
      "G0 SUPA Z-260\nG0 SUPA X300\n";
  expect_on_lathe(calibrate, {{"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX1[0]", 100.0},
                              {"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX1[0]", 80.0},
                              {"$SNS_MEA_TPW_TRIG_MINUS_DIR_AX2[0]", 90.0},
                              {"$SNS_MEA_TPW_TRIG_PLUS_DIR_AX2[0]", 70.0}});
  expect_on_lathe(calibrate + kTurningTool + "CYCLE982(12,0,1,0,0,0,5,2,,,,0.0001,1)",
                  {{"$TC_DP3[5,1]", 50.0}, {"$TC_DP4[5,1]", 80.0}, {"_OVR[9]", -0.3}});
  expect_on_lathe(calibrate + kTurningTool + "CYCLE982(11,1,1,2,0,0,5,2,,,,0.0001,1)",
                  {{"$TC_DP3[5,1]", 50.3}, {"$TC_DP12[5,1]", -0.3}, {"$TC_DP4[5,1]", 79.6}});
}

/// Hundred thousands 1 begins where the tool stands; thousands of _AMODE 1 bring the tip back
/// there, by its data as they are now.
TEST(ToolMeasuringExamples, Cycle982IncrementallyAndBackToTheStart) {
  expect_on_lathe(
      std::string(kTurningTool) +
          "DIAMOF\nG0 SUPA X100\nG0 SUPA Z-196\nCYCLE982(100001,0,1,1,2,0,5,2,,,,0.0001,1)",
      {{"$TC_DP3[5,1]", 50.3}, {"$TC_DP4[5,1]", 80.0}});
  expect_on_lathe(std::string(kCalibrator) +
                      "$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]=-199.5\nG0 SUPA X100\nG0 SUPA Z-195\n"
                      "CYCLE982(100000,0,1,1,2,0,6,2)",
                  {{"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]", -200.0}});
  expect_on_lathe(std::string(kTurningTool) + "CYCLE982(1,0,1,1,2,0,5,2,,,,,,,,,,1000)",
                  {{"$AA_IM[X]", 300.0 + 50.3}, {"$AA_IM[Z]", -150.0 + 80.0}, {"_OVR[11]", 0.4}});
}

/// Milling first, turning second: the outside diameter of what was turned by the spigot of CYCLE977
/// in G17, and the turning tool's length along X, which is L3 with SD42942 = 19.  The part is 0.04
/// too large, so the tool is 0.02 shorter than its data; an inversion says the other sign.
TEST(ToolMeasuringExamples, ATurnedDiameterCorrectsTheLengthOfATurningTool) {
  const std::string sheet =
      "[machine_data]\n\"$MCS_TECHNOLOGY\" = 2\n\"$MCS_TECHNOLOGY_EXTENSION\" = 1\n"
      "\"$SC_TOOL_LENGTH_TYPE\" = 3\n\"$SC_TOOL_LENGTH_CONST\" = 17\n"
      "\"$SC_TOOL_LENGTH_CONST_T\" = 19\n[tools.7]\nname = \"ROUGHER\"\nlength = 100.0\n"
      "radius = 0.8\ntype = 500.0\n";
  const auto correct = [&](const char* edge, double l1, double l3) {
    expect_measured(
        fmt::format("Z5\nCYCLE977(202,,{},1,30,,,3,5,,-15,,,,,\"ROUGHER\",,0,1,1,-1)", edge),
        {kCalibrated, sheet,
         part("cylinder", 100.2, 49.7, -300.0, "diameter = 30.04\nheight = 40.0")},
        {{"_OVR[4]", 30.04}, {"$TC_DP12[7,1]", l1}, {"$TC_DP14[7,1]", l3}, {"$TC_DP15[7,1]", 0.0}});
  };
  correct("300001", 0.0, -0.02);
  correct("10300001", 0.0, 0.02);
  correct("100001", -0.02, 0.0);
}

}  // namespace
}  // namespace g31::testing::tool_measuring_examples_test

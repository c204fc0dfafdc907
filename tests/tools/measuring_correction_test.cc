// What CYCLE977 and CYCLE978 do with a deviation: work offsets, tool data, tolerances, memories,
// and the alarms that leave both alone.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::measuring_correction_test {
namespace {

/// Faces at X -29.8 and 30.2, top at 0.
std::string block() {
  return part("block", 100.2, 50.0, -300.0, "");
}

struct Row {
  const char* name;
  std::string program;
  std::vector<ExpectedValue> expected;
};

void expect_rows(const std::vector<Row>& rows, const std::string& parts) {
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    expect_measured(row.program, {parts, kCalibrated}, row.expected);
  }
}

TEST(OnePointCycle, EachAxisAndDirection) {
  expect_rows({{"+X",
                "X-40\nZ-5\nCYCLE978(0,,,1,-30,5,1,1,1)",
                {{"_OVR[0]", -30.0},
                 {"_OVR[1]", -30.0},
                 {"_OVR[4]", -29.8},
                 {"_OVR[5]", -29.8},
                 {"_OVR[16]", 0.2},
                 {"_OVR[17]", 0.2},
                 {"_OVR[2]", 0.0},
                 {"_OVR[6]", 0.0},
                 {"_OVI[2]", 978},
                 {"_OVI[3]", 0},
                 {"_OVI[5]", 1},
                 {"_OVI[9]", 0},
                 {"$AA_IW[X]", -38.0}}},
               {"-X",
                "X40\nZ-5\nCYCLE978(0,,,1,30,5,1,1,2)",
                {{"_OVR[4]", 30.2}, {"_OVR[16]", 0.2}, {"$AA_IW[X]", 38.0}}},
               {"+Y",
                "Y-30\nZ-5\nCYCLE978(0,,,1,-20.1,5,1,2,1)",
                {{"_OVR[0]", -20.1},
                 {"_OVR[2]", -20.1},
                 {"_OVR[4]", -20.0},
                 {"_OVR[6]", -20.0},
                 {"_OVR[16]", 0.1},
                 {"_OVR[18]", 0.1}}},
               {"-Y", "Y30\nZ-5\nCYCLE978(0,,,1,20,5,1,2,2,4)", {{"_OVR[4]", 20.0}}},
               {"-Z",
                "CYCLE978(0,,,1,0.1,5,1,3,2)",
                {{"_OVR[0]", 0.1},
                 {"_OVR[3]", 0.1},
                 {"_OVR[4]", 0.0},
                 {"_OVR[7]", 0.0},
                 {"_OVR[16]", -0.1},
                 {"_OVR[19]", -0.1},
                 {"$AA_IW[Z]", 5.1}}}},
              block());
}

TEST(OnePointCycle, SpindleReversalNeedsTheDiameterOnly) {
  const std::string diameter = "[variables]\n\"$SNS_MEA_WP_BALL_DIAM[0]\" = 5.99\n";
  expect_measured("X-40\nZ-5\nCYCLE978(10000,,,1,-30,5,1,1,1)",
                  {block(), std::string(kBentProbe) + diameter},
                  {{"_OVR[4]", -29.8}, {"_OVR[40]", 0.04}}, 1e-6);
  expect_measured("Z-5\nCYCLE977(10001,,,1,40,,,2,5)",
                  {ring_aside(), std::string(kBentProbe) + diameter},
                  {{"_OVR[4]", 40.0}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.3}}, 1e-4);
}

TEST(OnePointCycle, AlignmentTouchesWithOneSideOfTheProbe) {
  const std::string one_side =
      "[variables]\n\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]\" = 2.995\n"
      "\"$SNS_MEA_WP_POS_DEV_AX1[0]\" = 0.02\n\"$SNS_MEA_WP_POS_DEV_AX2[0]\" = -0.03\n";
  const std::vector<std::string> sheets = {ring_aside(), std::string(kBentProbe) + one_side};
  expect_measured("Z-5\nCYCLE977(20001,,,1,40,,,2,5)", sheets,
                  {{"_OVR[4]", 40.0}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.3}}, 1e-4);
  EXPECT_EQ(run_measuring("Z-5\nCYCLE977(1,,,1,40,,,2,5)", sheets, {}).alarm(), 61341);
}

const std::vector<ExpectedValue> kFine = {{"$P_UIFR[1,X,TR]", 100.0},  {"$P_UIFR[1,X,FI]", 0.2},
                                          {"$P_UIFR[1,Y,TR]", 50.0},   {"$P_UIFR[1,Y,FI]", -0.3},
                                          {"$P_UIFR[1,Z,TR]", -300.0}, {"$P_UIFR[1,Z,FI]", 0.0}};

TEST(WorkOffsetCorrection, FineCoarseAndBasic) {
  expect_rows({{"fine", "Z-5\nCYCLE977(101,1,,1,40,,,2,5)", kFine},
               {"the offset in force, fine", "Z-5\nCYCLE977(101,9000,,1,40,,,2,5)", kFine},
               {"coarse, the fine part goes into it",
                "$P_UIFR[1,X,FI]=0.05\nG54\nX0 Y0 Z-5\nCYCLE977(101,10001,,1,40,,,2,5)",
                {{"$P_UIFR[1,X,TR]", 100.2},
                 {"$P_UIFR[1,X,FI]", 0.0},
                 {"$P_UIFR[1,Y,TR]", 49.7},
                 {"_OVI[0]", 1},
                 {"_OVI[11]", 0}}},
               {"fine adds to what is there",
                "$P_UIFR[1,X,FI]=0.05\nG54\nX0 Y0 Z-5\nCYCLE977(101,1,,1,40,,,2,5)",
                {{"$P_UIFR[1,X,TR]", 100.0}, {"$P_UIFR[1,X,FI]", 0.2}}},
               {"fine without fine shifts set up is coarse",
                "$MN_MM_FRAME_FINE_TRANS=0\nZ-5\nCYCLE977(101,1,,1,40,,,2,5)",
                {{"$P_UIFR[1,X,TR]", 100.2}, {"$P_UIFR[1,X,FI]", 0.0}}},
               {"another offset gets the measured axes",
                "$P_UIFR[2]=CTRANS(X,7,Y,8,Z,9)\nZ-5\nCYCLE977(101,10002,,1,40,,,2,5)",
                {{"$P_UIFR[2,X,TR]", 100.2},
                 {"$P_UIFR[2,Y,TR]", 49.7},
                 {"$P_UIFR[2,Z,TR]", 9.0},
                 {"$P_UIFR[1,X,TR]", 100.0},
                 {"$P_UIFR[1,X,FI]", 0.0},
                 {"_OVI[0]", 2}}},
               {"basic frame",
                "Z-5\nCYCLE977(101,11001,,1,40,,,2,5)",
                {{"$P_BFRAME[X,TR]", 0.2},
                 {"$P_BFRAME[Y,TR]", -0.3},
                 {"$P_CHBFR[0,X,TR]", 0.2},
                 {"$P_CHBFR[0,Y,TR]", -0.3},
                 {"$P_UIFR[1,X,TR]", 100.0}}},
               {"basic reference",
                "Z-5\nCYCLE977(101,12000,,1,40,,,2,5)",
                {{"$P_SETFRAME[X,TR]", 0.2}, {"$P_SETFR[X,TR]", 0.2}, {"$P_UIFR[1,X,TR]", 100.0}}},
               {"none named", "Z-5\nCYCLE977(101,0,,1,40,,,2,5)", {{"$P_UIFR[1,X,FI]", 0.0}}},
               {"measure only", "Z-5\nCYCLE977(1,1,,1,40,,,2,5)", {{"$P_UIFR[1,X,FI]", 0.0}}},
               {"again, nothing is left",
                "Z-5\nCYCLE977(101,1,,1,40,,,2,5)\nG54 X0 Y0\nCYCLE977(1,,,1,40,,,2,5)",
                {{"_OVR[5]", 0.0}, {"_OVR[6]", 0.0}, {"_OVR[17]", 0.0}, {"_OVR[18]", 0.0}}}},
              ring_aside());
  expect_rows(
      {{"one axis only",
        "X-40\nZ-5\nCYCLE978(100,1,,1,-30,5,1,1,1)",
        {{"$P_UIFR[1,X,FI]", 0.2}, {"$P_UIFR[1,Y,FI]", 0.0}}},
       {"with an empirical value",
        "$SCS_MEA_EMPIRIC_VALUE[2]=0.05\nX-40\nZ-5\nCYCLE978(100,1,,1,-30,5,1,1,1,,,,,,,,,,3)",
        {{"$P_UIFR[1,X,FI]", 0.15}, {"_OVR[16]", 0.2}}}},
      block());
}

TEST(WorkOffsetCorrection, OfFurtherBasicFrames) {
  expect_rows(
      {{"basic frame 2",
        "Z-5\nCYCLE977(101,11002,,1,40,,,2,5)",
        {{"$P_CHBFRAME[1,X,TR]", 0.2},
         {"$P_CHBFR[1,Y,TR]", -0.3},
         {"$P_CHBFR[0,X,TR]", 0.0},
         {"$P_UIFR[1,X,TR]", 100.0}}},
       {"basic frame 2, fine, outside of one that turns",
        "$P_CHBFR[2]=CROT(Z,90)\n$P_UIFR[1]=CTRANS(X,50,Y,-100,Z,-300)\nG54 G0 X0 Y0\n"
        "Z-5\nCYCLE977(101,1002,,1,40,,,2,5)",
        {{"$P_CHBFR[1,X,FI]", 0.2}, {"$P_CHBFR[1,Y,FI]", -0.3}, {"$P_CHBFR[2,Z,RT]", 90.0}}},
       {"global basic frame",
        "Z-5\nCYCLE977(101,13001,,1,40,,,2,5)",
        {{"$P_NCBFRAME[0,X,TR]", 0.2}, {"$P_NCBFR[0,Y,TR]", -0.3}}}},
      ring_aside());
}

TEST(WorkOffsetCorrection, FramesThatTurnWithinAnOffsetCountWhereTheyAreInForce) {
  expect_rows(
      {{"a basic frame that the mask leaves out",
        "$P_CHBFR[1]=CROT(Z,90)\n$P_CHBFRMASK=1\nG54\nX0 Y0 Z-5\nCYCLE977(101,11001,,1,40,,,2,5)",
        {{"$P_CHBFR[0,X,TR]", 0.2}, {"$P_CHBFR[0,Y,TR]", -0.3}}},
       {"a global one that the mask leaves out",
        "$P_NCBFR[1]=CROT(Z,90)\n$P_NCBFRMASK=1\nG54\nX0 Y0 Z-5\nCYCLE977(101,13001,,1,40,,,2,5)",
        {{"$P_NCBFR[0,X,TR]", 0.2}, {"$P_NCBFR[0,Y,TR]", -0.3}}},
       {"a frame of a cycle",
        "$P_CYCFRAME=CROT(Z,90)\nX0 Y0 Z-5\nCYCLE977(101,1,,1,40,,,2,5)",
        {{"_OVR[5]", -0.3},
         {"_OVR[6]", -0.2},
         {"$P_UIFR[1,X,FI]", 0.2},
         {"$P_UIFR[1,Y,FI]", -0.3}}},
       {"the external offset, within the basic reference",
        "$P_UIFR[1]=CTRANS(X,50,Y,-100,Z,-300)\nG54\n$P_EXTFRAME=CROT(Z,90)\nG0 X0 Y0\n"
        "Z-5\nCYCLE977(101,12000,,1,40,,,2,5)",
        {{"$P_SETFR[X,TR]", 0.2}, {"$P_SETFR[Y,TR]", -0.3}}}},
      ring_aside());
}

TEST(WorkOffsetCorrection, WithoutASettableOneTheLastBasicFrameInForceIsCorrected) {
  const std::string measure = "G500 X100 Y50\nZ-305\nCYCLE977(101,19000,,1,40,,,2,5)";
  expect_rows({{"as the mask has it",
                "$P_CHBFRMASK=2\n" + measure,
                {{"$P_CHBFR[1,X,TR]", 0.2}, {"$P_CHBFR[1,Y,TR]", -0.3}, {"$P_CHBFR[0,X,TR]", 0.0}}},
               {"of two of five", "$P_CHBFRMASK=5\n" + measure, {{"$P_CHBFR[2,X,TR]", 0.2}}},
               {"nothing says which", measure, {{"$P_CHBFR[0,X,TR]", 0.2}}}},
              ring_aside());
  const std::string three = "[machine_data]\n\"$MC_MM_NUM_BASE_FRAMES\" = 3\n";
  expect_measured(measure, {ring_aside(), kCalibrated, three},
                  {{"$P_CHBFR[2,X,TR]", 0.2}, {"$P_CHBFR[0,X,TR]", 0.0}});
  const MeasuringRun run =
      run_measuring("$P_CHBFRMASK=0\n" + measure, {ring_aside(), kCalibrated}, {});
  EXPECT_EQ(run.alarm(), 61321);
}

TEST(WorkOffsetCorrection, OfTheBasicFramesThatMachineDataGive) {
  const std::string one =
      "[machine_data]\n\"$MC_MM_NUM_BASE_FRAMES\" = 1\n"
      "\"$MN_MM_NUM_GLOBAL_BASE_FRAMES\" = 1\n";
  const std::vector<std::string> sheets = {ring_aside(), kCalibrated, one};
  expect_measured("Z-5\nCYCLE977(101,11001,,1,40,,,2,5)", sheets,
                  {{"$P_CHBFR[0,X,TR]", 0.2}, {"$P_CHBFR[0,Y,TR]", -0.3}});
  expect_measured("Z-5\nCYCLE977(101,13001,,1,40,,,2,5)", sheets,
                  {{"$P_NCBFR[0,X,TR]", 0.2}, {"$P_NCBFR[0,Y,TR]", -0.3}});
  for (const int knum : {11002, 13002}) {
    const MeasuringRun run = run_measuring(fmt::format("Z-5\nCYCLE977(101,{},,1,40,,,2,5)", knum),
                                           sheets, {"$P_CHBFR[0,X,TR]"});
    EXPECT_NE(run.output.errors.find("[61321]"), std::string::npos) << run.output.errors;
  }
}

TEST(WorkOffsetCorrection, OfAGrooveIsAcrossItOnly) {
  const std::string groove = part("groove", 100.2, 50.0, -300.0, "width = 20.0");
  expect_rows({{"a set point of the centre along the groove does not count",
                "Z-5\nCYCLE977(103,1,,1,20,,,2,1,,,,,1,,,,,,,,,,,,,,0.05,7)",
                {{"_OVR[1]", 0.05},
                 {"_OVR[2]", 0.0},
                 {"_OVR[17]", 0.15},
                 {"_OVR[18]", 0.0},
                 {"$P_UIFR[1,X,FI]", 0.15},
                 {"$P_UIFR[1,Y,FI]", 0.0}}},
               {"an offset that is not in force keeps the other axis",
                "$P_UIFR[2]=CTRANS(X,7,Y,8,Z,9)\nZ-5\nCYCLE977(103,10002,,1,20,,,2,1,,,,,1)",
                {{"$P_UIFR[2,X,TR]", 100.2}, {"$P_UIFR[2,Y,TR]", 8.0}, {"$P_UIFR[2,Z,TR]", 9.0}}}},
              groove);
}

TEST(WorkOffsetCorrection, InTurnedFramesTheShiftIsThatOfTheirParent) {
  const double c = std::cos(30.0 * std::numbers::pi / 180.0);
  const double s = 0.5;
  // Centre in the turned offset: 0.2 along X, 0.1 along Y of it.
  const std::string turned = part("ring", 100.0 + 0.2 * c - 0.1 * s, 50.0 + 0.2 * s + 0.1 * c,
                                  -300.0, "bore = 40.0\nrotate_deg = [0.0, 0.0, 30.0]");
  expect_measured("$P_UIFR[1,Z,RT]=30\nG54\nX0 Y0 Z-5\nCYCLE977(101,1,,1,40,,,2,5)",
                  {turned, kCalibrated},
                  {{"_OVR[5]", 0.2},
                   {"_OVR[6]", 0.1},
                   {"$P_UIFR[1,X,FI]", 0.2 * c - 0.1 * s},
                   {"$P_UIFR[1,Y,FI]", 0.2 * s + 0.1 * c},
                   {"$P_UIFR[1,Z,RT]", 30.0}});
  expect_measured(
      "ROT Z30\nX0 Y0 Z-5\nCYCLE977(101,1,,1,40,,,2,5)", {turned, kCalibrated},
      {{"_OVR[5]", 0.2}, {"$P_UIFR[1,X,FI]", 0.2 * c - 0.1 * s}, {"$P_UIFR[1,Z,RT]", 0.0}});
}

TEST(ToolCorrection, EachComponentAndKind) {
  // The bore is 0.1 too large: the mill of 5 mm is 0.05 larger than it says.
  const auto call = [](const char* code, const char* more = "") {
    return fmt::format("Z-5\nCYCLE977(201,,{},1,40,,,2,5,,,,,,,\"MILL\"{})", code, more);
  };
  expect_rows(
      {{"radius, wear",
        call("1"),
        {{"$TC_DP15[2,1]", 0.05},
         {"$TC_DP6[2,1]", 5.0},
         {"_OVR[20]", 0.05},
         {"_OVI[0]", 1},
         {"_OVI[8]", 2}}},
       {"radius, geometry", call("4000001"), {{"$TC_DP6[2,1]", 5.05}, {"$TC_DP15[2,1]", 0.0}}},
       {"radius named", call("4400001"), {{"$TC_DP6[2,1]", 5.05}}},
       {"inverted", call("14000001"), {{"$TC_DP6[2,1]", 4.95}, {"_OVR[20]", -0.05}}},
       {"length 1, geometry", call("4100001"), {{"$TC_DP3[2,1]", 80.05}}},
       {"length 2, wear", call("200001"), {{"$TC_DP13[2,1]", 0.05}}},
       {"length 3, geometry", call("4300001"), {{"$TC_DP5[2,1]", 0.05}}},
       {"no edge named", call("0"), {{"$TC_DP15[2,1]", 0.0}, {"_OVR[20]", 0.0}}},
       {"no tool named", "Z-5\nCYCLE977(201,,1,1,40,,,2,5)", {{"$TC_DP15[2,1]", 0.0}}},
       {"a replacement tool",
        "$TC_TP1[2]=3\n" + call("100000001", ",,,,,,,,,,,,,,3"),
        {{"$TC_DP15[2,1]", 0.05}, {"_OVI[8]", 2}, {"_OVI[10]", 3}}}},
      ring_aside(40.1));
  expect_measured("Z5\nCYCLE977(202,,4000001,1,30,,,2,5,0,-15,,,,,\"MILL\")",
                  {part("cylinder", 100.0, 50.0, -300.0, "diameter = 30.2"), kCalibrated},
                  {{"$TC_DP6[2,1]", 4.9}});
  expect_rows({{"edge, radius",
                "X-40\nZ-5\nCYCLE978(200,,4000001,1,-30,5,1,1,1,,\"MILL\")",
                {{"$TC_DP6[2,1]", 5.2}}},
               {"height, length",
                "CYCLE978(200,,4000001,1,-0.1,5,1,3,2,,\"MILL\")",
                {{"$TC_DP3[2,1]", 79.9}}}},
              block());
}

TEST(ToolCorrection, RefusesToolsThatAreNotTheOne) {
  struct Refusal {
    const char* name;
    const char* program;
    int alarm;
  };
  const Refusal kRows[] = {
      {"no such name", "CYCLE977(201,,1,1,40,,,2,5,,,,,,,\"NONE\")", 61343},
      {"locked", "$TC_TP8[2]=6\nCYCLE977(201,,1,1,40,,,2,5,,,,,,,\"MILL\")", 61404},
      {"two of the name, none in use", "$TC_TP1[3]=2\nCYCLE977(201,,1,1,40,,,2,5,,,,,,,\"MILL\")",
       61404},
      {"two of the name, both in use",
       "$TC_TP1[3]=2\n$TC_TP8[2]=131\n$TC_TP8[3]=131\nCYCLE977(201,,1,1,40,,,2,5,,,,,,,\"MILL\")",
       61344},
      {"an additive offset without its DL number",
       "CYCLE977(201,,1000001,1,40,,,2,5,,,,,,,\"MILL\")", 61404},
  };
  const std::string twin = "[tools.3]\nradius = 5.0\nname = \"MILL\"\n";
  for (const Refusal& row : kRows) {
    SCOPED_TRACE(row.name);
    const std::string sheet = std::string(row.name).starts_with("two") ? twin : "";
    const MeasuringRun run =
        run_measuring(std::string("Z-5\n") + row.program, {ring_aside(40.1) + sheet, kCalibrated},
                      {"$TC_DP15[2,1]"});
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at("$TC_DP15[2,1]"), 0.0);
  }
  expect_measured("$TC_TP1[3]=2\n$TC_TP8[3]=131\nZ-5\nCYCLE977(201,,1,1,40,,,2,5,,,,,,,\"MILL\")",
                  {ring_aside(40.1) + twin, kCalibrated},
                  {{"$TC_DP15[3,1]", 0.05}, {"$TC_DP15[2,1]", 0.0}, {"_OVI[8]", 3}});
}

/// Tool offset with tolerance: TZL, TDIF, TUL, TLL, TMV, K and memories as given.
std::string judged(const std::string& limits) {
  return "Z-5\nCYCLE977(201,,4000001,1,40,,,2,5,,,,,,,\"MILL\",," + limits + ",,,1)";
}

TEST(Tolerance, LimitsMoveTheSetPointIntoTheirMiddle) {
  expect_measured(
      "Z-5\nCYCLE977(201,,4000001,1,10,,,2,5,,,,,,,\"MILL\",,0,0.05,0,-0.004,0,1,0,,,1)",
      {ring_aside(9.998), kCalibrated},
      {{"_OVR[0]", 9.998},
       {"_OVR[8]", 0.002},
       {"_OVR[12]", -0.002},
       {"_OVR[16]", 0.0},
       {"_OVR[20]", 0.0},
       {"$TC_DP6[2,1]", 5.0}});
  expect_measured(
      "X-40\nZ-5\nCYCLE978(200,,4000001,1,-30,5,1,1,1,,\"MILL\",,0,0.5,0.4,0.2,0,1,0,,,1)",
      {block(), kCalibrated},
      {{"_OVR[0]", -29.7},
       {"_OVR[1]", -29.7},
       {"_OVR[8]", 0.1},
       {"_OVR[12]", -0.1},
       {"_OVR[16]", -0.1},
       {"$TC_DP6[2,1]", 4.9}});
  expect_measured("Z-5\nCYCLE977(205,,1,1,,60,40,2,5,,,,,,,\"MILL\",,0,1,0.2,0,0,1,0,,,1)",
                  {part("pocket", 100.0, 50.0, -300.0, "length = 60.1\nwidth = 40.3"), kCalibrated},
                  {{"_OVR[0]", 60.1},
                   {"_OVR[1]", 40.1},
                   {"_OVR[8]", 0.1},
                   {"_OVR[9]", 0.1},
                   {"_OVR[12]", -0.1},
                   {"_OVR[13]", -0.1},
                   {"_OVR[16]", 0.0},
                   {"_OVR[17]", 0.2},
                   {"_OVI[9]", 61304},
                   {"$TC_DP15[2,1]", 0.05}});
}

TEST(Tolerance, ResultsOfADecision) {
  expect_measured(
      "$SCS_MEA_EMPIRIC_VALUE[4]=0.02\nZ-5\n"
      "CYCLE977(201,,4000001,1,40,,,2,5,,,,,,,\"MILL\",7,0.01,0.5,0.3,-0.3,0.2,3,20005,,,1)",
      {ring_aside(40.1), kCalibrated},
      {{"_OVR[27]", 0.01},
       {"_OVR[28]", 5.0},
       {"_OVR[29]", 0.5},
       {"_OVR[30]", 0.02},
       {"_OVR[31]", 0.08 / 3.0},
       {"_OVR[20]", 0.04 / 3.0},
       {"_OVI[4]", 3},
       {"_OVI[5]", 1},
       {"_OVI[6]", 2},
       {"_OVI[7]", 5},
       {"_OVI[8]", 2},
       {"_OVI[9]", 0},
       {"_OVI[13]", 7},
       {"$TC_DP6[2,1]", 5.0 + 0.04 / 3.0},
       {"$SCS_MEA_AVERAGE_VALUE[1]", 0.0}});
}

TEST(Tolerance, BandsDecideWhatIsCorrected) {
  // The bore is 0.1 too large; TZL, TDIF, TUL, TLL, TMV, K, memories.
  expect_rows(
      {{"within TZL", judged("0.1001,1,0.5,-0.5,0.5,1,0"), {{"$TC_DP6[2,1]", 5.0}, {"_OVI[9]", 0}}},
       {"beyond TZL", judged("0.0999,1,0.5,-0.5,0.5,1,0"), {{"$TC_DP6[2,1]", 5.05}}},
       {"oversize",
        judged("0,1,0.0999,-0.0999,0.5,1,0"),
        {{"_OVI[9]", 61304}, {"$TC_DP6[2,1]", 5.05}}},
       {"undersize",
        judged("0,1,0.3,0.1001,0.5,1,0"),
        {{"_OVI[9]", 61305}, {"_OVR[16]", 0.1 - 0.20005}}},
       {"beyond TDIF",
        judged("0,0.0999,0.5,-0.5,0.5,1,0"),
        {{"_OVI[9]", 61306}, {"$TC_DP6[2,1]", 5.05}}},
       {"a mean value within TZL is kept",
        judged("0.05,1,0.5,-0.5,0.2,4,10000"),
        {{"$TC_DP6[2,1]", 5.0}, {"$SCS_MEA_AVERAGE_VALUE[0]", 0.025}, {"_OVR[31]", 0.025}}},
       {"beyond TMV all of it is corrected, the mean value goes",
        "$SCS_MEA_AVERAGE_VALUE[0]=0.03\n" + judged("0.05,1,0.5,-0.5,0.0999,4,10000"),
        {{"$TC_DP6[2,1]", 5.05}, {"$SCS_MEA_AVERAGE_VALUE[0]", 0.0}}}},
      ring_aside(40.1));
}

TEST(Tolerance, MeanValuesAsTheManualReckonsThem) {
  // Deviations of ten parts in um; TZL 0.04.  Corrections: k = 3 at 7 and 10, k = 2 at 3, 7 and 9.
  const double kDeviations[] = {30, 50, 60, 20, 40, 50, 50, 30, 70, 70};
  for (const int k : {2, 3}) {
    SCOPED_TRACE(k);
    std::string program =
        "DEF REAL LIST[10]=(30,50,60,20,40,50,50,30,70,70)\nDEF INT NN\n"
        "FOR NN=0 TO 9\nX0 Y0 Z-5\n";
    program += fmt::format(
        "CYCLE977(201,,4000001,1,40-LIST[NN]/"
        "1000,,,2,5,,,,,,,\"MILL\",,0.04,1,1,-1,0.5,{},10000,,,1)\n",
        k);
    program += "R[NN]=_OVR[20] R[20+NN]=_OVR[31]\nENDFOR";
    double mean = 0.0;
    std::vector<ExpectedValue> expected;
    for (int i = 0; i < 10; ++i) {
      mean -= (mean - kDeviations[i] / 1000.0) / k;
      const bool corrects = k == 3 ? i == 6 || i == 9 : i == 2 || i == 6 || i == 8;
      expected.push_back({fmt::format("R{}", i), corrects ? mean / 2.0 : 0.0});
      expected.push_back({fmt::format("R{}", 20 + i), mean});
      mean = corrects ? 0.0 : mean;
    }
    const testing::TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write(
        "part.mpf", program.substr(0, program.find("FOR NN")) + "T1 M6\nG54 D1\nG0 X0 Y0 Z20\n" +
                        program.substr(program.find("FOR NN")) + "\nM30\n")};
    options.setups = {folder.write("base.toml", testing::kMeasuringSheet),
                      folder.write("parts.toml", part("ring", 100.0, 50.0, -300.0, "bore = 40.0")),
                      folder.write("data.toml", kCalibrated)};
    for (const ExpectedValue& row : expected) {
      options.prints.push_back(row.name);
    }
    const MeasuringRun run{testing::run_program(options)};
    ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
    for (const ExpectedValue& row : expected) {
      EXPECT_NEAR(run.at(row.name), row.value, 1e-6) << row.name;
    }
  }
}

TEST(Tolerance, RepeatsOnceWhereTheMaskAsksForIt) {
  const std::string once = "$SNS_MEA_FUNCTION_MASK=8\n";
  for (const std::string& asked :
       {once, std::string("$SNS_MEA_FUNCTION_MASK=9\n"), std::string("_CBIT[0]=1\n")}) {
    const MeasuringRun run = run_measuring(asked + "Z-5\nCYCLE977(101,1,,1,40,,,2,0.1)",
                                           {ring_aside(), kCalibrated}, {"$P_UIFR[1,X,FI]"});
    EXPECT_EQ(run.alarm(), 61303);
    EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
    std::size_t touches = 0;
    for (const auto& touch : run.output.document.at("touches")) {
      touches += touch.value("triggered", false) ? 1U : 0U;
    }
    EXPECT_EQ(touches, asked == once ? 4U : 8U) << asked;
  }
}

TEST(MeasuringAlarms, AreTheCyclesOwnAndNothingIsCorrected) {
  struct Refusal {
    const char* name;
    const char* program;
    int alarm;
  };
  const Refusal kRows[] = {
      {"no edge there", "X-40\nZ-5\nCYCLE978(100,1,,1,-36,3,1,1,1)", 61301},
      {"something in the way", "X-40\nZ-5\nCYCLE978(100,1,,1,10,3,1,1,1)", 61302},
      {"already deflected", "X-40\nZ-5\nMEAS=1 G1 X-20 F300\nCYCLE978(100,1,,1,-30,5,1,1,1)",
       61302},
      {"beyond the safe area", "X-40\nZ-5\nCYCLE978(100,1,,1,-30,5,0.1,1,1)", 61303},
      {"no such variant", "CYCLE978(300,1,,1,-30,5,1,1,1)", 61307},
      {"no path", "CYCLE978(100,1,,1,-30,0,1,1,1)", 61308},
      {"a mill", "T2 M6\nCYCLE978(100,1,,1,-30,5,1,1,1)", 61309},
      {"a scaled offset", "$P_UIFR[1,X,SC]=2\nG54\nCYCLE978(100,1,,1,-30,5,1,1,1)", 61310},
      {"a scaled third axis", "SCALE Z2\nCYCLE978(100,1,,1,-30,5,1,1,1)", 61310},
      {"no such record", "CYCLE978(100,1,,99,-30,5,1,1,1)", 61313},
      {"no such work offset", "X-40\nZ-5\nCYCLE978(100,4001,,1,-30,5,1,1,1)", 61321},
      {"no such basic frame", "X-40\nZ-5\nCYCLE978(100,1017,,1,-30,5,1,1,1)", 61321},
      {"no such axis", "CYCLE978(100,1,,1,-30,5,1,4,1)", 61325},
      {"no such direction", "CYCLE978(100,1,,1,-30,5,1,1,3)", 61326},
      {"a record that was never calibrated", "X-40\nZ-5\nCYCLE978(100,1,,2,-30,5,1,1,1)", 61341},
      {"reversal along the tool axis", "CYCLE978(10100,1,,1,-30,5,1,3,2)", 61325},
      {"a spindle that cannot be positioned",
       "$MNS_MEA_FUNCTION_MASK=19\nCYCLE978(10100,1,,1,-30,5,1,1,1)", 61372},
  };
  for (const Refusal& row : kRows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run =
        run_measuring(row.program, {block(), kCalibrated}, {"$P_UIFR[1,X,FI]", "_OVI[9]"});
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at("_OVI[9]"), row.alarm);
    EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
  }
}

TEST(MeasuringAlarms, AZoneThatIsTooSmallCollidesAndSaysWhere) {
  const std::string parts = part("ring", 100.0, 50.0, -300.0, "bore = 60.0") +
                            part("plug", 100.0, 50.0, -295.0, "diameter = 30.0");
  const MeasuringRun run = run_measuring("Z15\nCYCLE977(1101,1,,1,60,,,15,5,,-25,10)",
                                         {parts, kCalibrated}, {"$P_UIFR[1,X,FI]"});
  EXPECT_EQ(run.alarm(), 61302);
  EXPECT_NE(run.output.errors.find("at X 12.000 Y 0.000 Z 4.9"), std::string::npos)
      << run.output.errors;
  EXPECT_EQ(
      run_measuring("Z15\nCYCLE977(1101,1,,1,60,,,15,5,,-25,50)", {parts, kCalibrated}, {}).alarm(),
      61334);
  // Not watched, the ball meets the part: a collision.
  const MeasuringRun crash =
      run_measuring("$SCS_MEA_FUNCTION_MASK=0\nZ15\nCYCLE977(1101,1,,1,60,,,15,5,,-25,10)",
                    {parts, kCalibrated}, {});
  EXPECT_EQ(crash.output.exit_code, 4);
  EXPECT_NE(crash.output.errors.find("plug"), std::string::npos) << crash.output.errors;
}

TEST(MeasuringAlarms, ADryRunMeasuresNothing) {
  expect_measured(
      "Z-5\n_OVR[4]=77\nCYCLE977(101,1,,1,40,,,2,5)",
      {"[control]\nprofile = \"sinumerik-828d\"\ndry_run = 2000.0\n" + ring_aside(), kCalibrated},
      {{"_OVR[4]", 77.0}, {"$P_UIFR[1,X,FI]", 0.0}});
}

}  // namespace
}  // namespace g31::testing::measuring_correction_test

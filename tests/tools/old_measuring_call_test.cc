// The measuring cycles as programs of earlier software call them: parameters in GUD variables, then
// the bare name.

#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"
#include "tests/support/turning_run.h"

namespace g31::testing::old_measuring_call_test {
namespace {

TEST(OldMeasuringCall, EachCycleTakesItsParametersFromVariables) {
  const std::string ring = part("ring", 100.2, 49.7, -300.0, "bore = 40.0");
  const std::string block = part("block", 100.2, 50.0, -300.0, "");
  const std::string turned = part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 3.0]");
  const MeasuringCase kRows[] = {
      {"edge, work offset, direction from the set point",
       block,
       "X-40\nZ-5\n_MVAR=100 _SETVAL=-30 _MA=1 _KNUM=1 _FA=5 _TSA=1\nCYCLE978",
       {{"_OVR[4]", -29.8}, {"$P_UIFR[1,X,FI]", 0.2}, {"_OVI[3]", 100}}},
      {"edge from the other side, tool offset inverted",
       block,
       "X40\nZ-5\n_MVAR=0 _SETVAL=30 _MA=1 _KNUM=10001 _FA=5 _TSA=1 _TUL=1 _TLL=-1 _TDIF=1\n"
       "_TNAME=\"MILL\"\nCYCLE978",
       {{"_OVR[4]", 30.2}, {"$TC_DP15[2,1]", 0.2}, {"_OVI[3]", 200}}},
      {"hole, the offset in force",
       ring,
       "Z-5\n_MVAR=101 _SETVAL=40 _KNUM=9999\nCYCLE977",
       {{"_OVR[4]", 40.0}, {"$P_UIFR[1,X,FI]", 0.2}, {"$P_UIFR[1,Y,FI]", -0.3}}},
      {"hole, tool by its number, radius",
       ring,
       "Z-5\n_MVAR=1 _SETVAL=39.9 _KNUM=2001 _TNUM=2 _TUL=1 _TLL=-1 _TDIF=1 _TSA=1\nCYCLE977",
       {{"$TC_DP15[2,1]", 0.05}, {"_OVR[8]", 1.0}, {"_OVR[29]", 1.0}}},
      {"hole, with a DL number the additive offset",
       ring,
       "Z-5\n_MVAR=1 _SETVAL=39.9 _KNUM=2001 _DLNUM=2 _TNUM=2 _TUL=1 _TLL=-1 _TDIF=1 _TSA=1\n"
       "CYCLE977",
       {{"$TC_SCP26[2,1]", 0.05}, {"$TC_DP15[2,1]", 0.0}, {"_OVI[13]", 2}}},
      {"hole, measured only",
       ring,
       "Z-5\n_MVAR=1 _SETVAL=40 _KNUM=0\nCYCLE977",
       {{"_OVR[5]", 0.2}, {"$P_UIFR[1,X,FI]", 0.0}}},
      {"basic frame",
       ring,
       "Z-5\n_MVAR=101 _SETVAL=40 _KNUM=1011\nCYCLE977",
       {{"$P_BFRAME[X,FI]", 0.2}, {"$P_UIFR[1,X,FI]", 0.0}}},
      {"angle",
       turned,
       "X-20 Y-27\nZ-5\n_MVAR=105 _KNUM=1 _MA=102 _ID=30 _FA=6 _TSA=5 _SETVAL=-20\nCYCLE998",
       {{"_OVR[4]", 3.0}, {"$P_UIFR[1,Z,RT]", 3.0}}},
      {"angle, basic frame",
       turned,
       "X-20 Y-27\nZ-5\n_MVAR=105 _KNUM=1011 _MA=102 _ID=30 _FA=6 _TSA=5 _SETVAL=-20\nCYCLE998",
       {{"_OVR[4]", 3.0}, {"$P_UIFR[1,Z,RT]", 0.0}, {"$P_CHBFR[0,Z,RT]", 3.0}}},
      {"corner",
       turned,
       "X-42 Y-32\nZ-5\n_MVAR=6 _SETV[0]=20 _SETV[1]=45 _SETV[2]=15 _FA=15\nCYCLE961",
       {{"_OVR[4]", 3.0}}},
      {"arc",
       part("ring", 100.2, 49.7, -300.0, "bore = 40.0\nsagitta = 0.0000005"),
       "Z-5\n_MVAR=1 _SETVAL=40 _INCA=120 _FA=2\nCYCLE979",
       {{"_OVR[4]", 40.0}}},
  };
  expect_measured(kRows, 2e-6);
}

std::string edge(const std::string& parameters) {
  return "X40\nZ-5\n_MVAR=0 _SETVAL=30 _MA=1 _FA=5 _TSA=1 _TUL=1 _TLL=-1 _TDIF=1 " + parameters +
         "\nCYCLE978";
}

/// Digits of _KNUM: D number; length or radius; inverted; which length; which offset.  The part is
/// 0.2 too large and its face 0.03 too low.
TEST(OldMeasuringCall, TheOffsetNumberSaysWhatOfTheToolIsCorrected) {
  const std::string block = part("block", 100.2, 50.0, -300.03, "");
  const auto knum = [](int number) {
    return edge("_TNAME=\"MILL\" _KNUM=" + std::to_string(number));
  };
  const MeasuringCase kRows[] = {
      {"no component: the radius", block, knum(1), {{"$TC_DP15[2,1]", -0.2}}},
      {"radius", block, knum(2001), {{"$TC_DP15[2,1]", -0.2}, {"$TC_DP13[2,1]", 0.0}}},
      {"radius, inverted", block, knum(12001), {{"$TC_DP15[2,1]", 0.2}}},
      {"length: of a mill 3 lies along X", block, knum(1001), {{"$TC_DP14[2,1]", -0.2}}},
      {"length 1", block, knum(100001), {{"$TC_DP12[2,1]", -0.2}}},
      {"length 2, geometry", block, knum(4200001), {{"$TC_DP4[2,1]", -0.2}}},
      {"radius, geometry", block, knum(4002001), {{"$TC_DP6[2,1]", 4.8}}},
      {"length of a face",
       block,
       "X0 Y0\nZ5\n_MVAR=0 _SETVAL=0 _MA=3 _FA=5 _TSA=1 _TUL=1 _TLL=-1 _TDIF=1 _TNUM=2 "
       "_KNUM=1001\nCYCLE978",
       {{"$TC_DP12[2,1]", 0.03}}},
  };
  expect_measured(kRows, 2e-6);
  const MeasuringRun none = run_measuring(knum(3001), {block, kCalibrated}, {"$TC_DP14[2,1]"});
  EXPECT_EQ(none.alarm(), 61404) << none.output.errors;
  EXPECT_EQ(none.at("$TC_DP14[2,1]"), 0.0);
}

/// A signal that is 0.001 s late shows the feed: 0.001 mm at 60 mm/min, 0.005 mm at 300.
TEST(OldMeasuringCall, TheVariableFeedIsThatOfTheTouch) {
  constexpr const char* kLate = "[probe]\ntrigger_delay_s = 0.001\n";
  const std::string block = part("block", 100.2, 50.0, -300.0, "");
  const std::string ring = part("ring", 100.0, 50.0, -300.0, "bore = 40.0\nsagitta = 0.0000005");
  const std::string hole = "Z-5\n_MVAR=1 _SETVAL=40 _KNUM=0 _FA=5 _TSA=1 ";
  const std::string arc = "Z-5\n_MVAR=1 _SETVAL=40 _INCA=120 _KNUM=0 _FA=2 _TSA=1 ";
  expect_measured(edge("_VMS=60"), {block, kLate, kCalibrated}, {{"_OVR[4]", 30.199}}, 1e-6);
  expect_measured(edge("_VMS=0"), {block, kLate, kCalibrated}, {{"_OVR[4]", 30.195}}, 1e-6);
  expect_measured(hole + "_VMS=60\nCYCLE977", {ring, kLate, kCalibrated}, {{"_OVR[4]", 40.002}},
                  2e-6);
  expect_measured(arc + "_VMS=60\nCYCLE979", {ring, kLate, kCalibrated}, {{"_OVR[4]", 40.002}},
                  1e-5);
  // A call with brackets has no such feed.
  expect_measured(edge("_VMS=60") + "\nX40\nCYCLE978(0,,,1,30,5,1,1,2,1)",
                  {block, kLate, kCalibrated}, {{"_OVR[4]", 30.195}}, 1e-6);
}

/// The ball is 0.02 and -0.03 off the axis.  A probe that switches in one direction is turned
/// along, here to 180 degrees, and by _CORA beyond.
TEST(OldMeasuringCall, TheProbeNumberTellsAProbeOfOneDirection) {
  constexpr const char* kAside = "[probe]\neccentricity = [0.02, -0.03]\n";
  constexpr const char* kSecond = R"([variables]
"$SNS_MEA_WP_BALL_DIAM[1]" = 6.0
"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[1]" = 3.0
"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[1]" = -3.0
)";
  const std::string block = part("block", 100.2, 50.0, -300.0, "");
  const auto record = [](const std::string& number) { return edge("_PRNUM=" + number); };
  expect_measured(record("2"), {block, kAside, kCalibrated, kSecond},
                  {{"_OVR[4]", 30.18}, {"_OVI[5]", 2}}, 1e-6);
  expect_measured(record("102"), {block, kAside, kCalibrated, kSecond},
                  {{"_OVR[4]", 30.22}, {"_OVI[5]", 2}}, 1e-6);
  expect_measured(record("102 _CORA=90"), {block, kAside, kCalibrated, kSecond},
                  {{"_OVR[4]", 30.23}}, 1e-6);
}

/// A shaft of 50.04 mm, and one that runs out: half a turn apart 49.98 and 50.06.
TEST(OldMeasuringCall, APointOfATurnedPart) {
  const auto shaft = [](const std::string& diameter, double x) {
    return part("shaft", x, 0.0, 200.0, "height = 100.0\ndiameter = " + diameter);
  };
  const auto point = [](const std::string& parameters) {
    return "G54 DIAMON G0 X100\nZ-10\n_SETVAL=50 _MA=2 _FA=3 _TSA=5 _TUL=1 _TLL=-1 _TDIF=1 "
           "_TNAME=\"ROUGHER\" " +
           parameters + "\nCYCLE974";
  };
  const auto expect = [](const std::string& body, const std::string& turned,
                         const std::vector<ExpectedValue>& expected) {
    expect_turned(body, {kProbeToMinusX, kCalibrated, turned}, expected);
  };
  expect(point("_MVAR=0 _KNUM=1"), shaft("50.04", 0.0),
         {{"_OVR[4]", 50.04}, {"$TC_DP12[2,1]", -0.02}, {"$TC_DP13[2,1]", 0.0}, {"_OVI[3]", 202}});
  expect(point("_MVAR=0 _KNUM=2001"), shaft("50.04", 0.0), {{"$TC_DP15[2,1]", -0.02}});
  expect(point("_MVAR=1000 _KNUM=0"), shaft("50.02", -0.02),
         {{"_OVR[4]", 50.02}, {"_OVI[3]", 10002}});
  expect(point("_MVAR=100 _KNUM=1"), shaft("50.04", 0.0), {{"$P_UIFR[1,X,FI]", 0.02}});
}

/// Data of 50.3 and 100.3 mm, true lengths of 50 and 100.
TEST(OldMeasuringCall, ToolsAreMeasured) {
  constexpr const char* kTurret =
      "[machine]\ntool_side = \"ZX\"\n[tools.5]\nlength = 50.3\nradius = 0.4\ntype = 500.0\n"
      "[variables]\n\"$TC_DP2[5,1]\" = 3\n\"$TC_DP4[5,1]\" = 79.6\n[[tool]]\nnumber = 5\n"
      "kind = \"turning\"\nlengths = [50.0, 80.0, 0.0]\ntip_radius = 0.4\nedge_position = 3\n";
  const std::string turned =
      "T5 M6\nG18 D1 DIAMOF\nG0 SUPA X300 Z-150\n_MVAR=2 _MA=0 _MD=1 _FA=5 _TSA=2 _TZL=0.0001 "
      "_TDIF=1 _CHBIT[3]=";
  const auto expect = [](const std::string& body, const std::vector<ExpectedValue>& expected) {
    expect_values(run_on_sheets(body, {kLatheProbe, kTurret}, names_of(expected, {})), expected,
                  1e-6);
  };
  expect(turned + "0\nCYCLE982", {{"$TC_DP3[5,1]", 50.0}, {"$TC_DP4[5,1]", 80.0}, {"_OVI[3]", 2}});
  expect(turned + "1\nCYCLE982",
         {{"$TC_DP3[5,1]", 50.3}, {"$TC_DP12[5,1]", -0.3}, {"$TC_DP13[5,1]", 0.4}});
  expect_tools(
      "$TC_DP3[5,1]=100.3\nT5 M6\nG17 D1\nG0 SUPA X200 Y0 Z-100\n_MVAR=1 _MA=3 _MD=1 "
      "_FA=5 _TSA=2 _TZL=0.0001 _TDIF=1 _CHBIT[3]=1\nCYCLE971",
      {kCube, kKnown}, {{"$TC_DP3[5,1]", 100.3}, {"$TC_DP12[5,1]", -0.3}}, 1e-6);
}

/// Feeds of earlier software are setting data today.
TEST(OldMeasuringCall, FeedsBecomeSettingData) {
  const std::string block = part("block", 100.2, 50.0, -300.0, "");
  const std::string feeds =
      "_SPEED[0]=40 _SPEED[1]=700 _SPEED[2]=600 _SPEED[3]=800 _RF=333 _TENV=\"T\"\n"
      "_TXT[99]=\"A\" _PROTNAME[1]=\"B\" _CALNUM=0 _TPW[2,9]=0\n";
  expect_measured(feeds + edge(""), {block, kCalibrated},
                  {{"_OVR[4]", 30.2},
                   {"$SCS_MEA_FEED_RAPID_IN_PERCENT", 40},
                   {"$SCS_MEA_FEED_PLANE_VALUE", 700},
                   {"$SCS_MEA_FEED_FEEDAX_VALUE", 600},
                   {"$SCS_MEA_FEED_FAST_MEASURE", 800},
                   {"$SCS_MEA_FEED_CIRCLE", 333}},
                  1e-6);
}

/// Data that nothing reads are kept, and told where they are not 0.
TEST(OldMeasuringCall, DataWithoutEffectAreTold) {
  for (const std::string name : {"_CALNUM", "_EVMVNUM[1]", "_PROTFORM[5]", "_TNVL", "_MFS[5]",
                                 "_CM[8]", "_WP[2,10]", "_KB[2,6]", "_TP[2,9]", "_TPW[2,9]"}) {
    SCOPED_TRACE(name);
    const MeasuringRun run = run_measuring(name + "=2", {}, {name});
    EXPECT_EQ(run.output.exit_code, 1);
    EXPECT_EQ(run.at(name), 2.0);
    const std::string told = "a datum has no effect here: " + name.substr(0, name.find('[')) +
                             " = 2: the run goes on as with 0";
    EXPECT_NE(run.output.errors.find(told), std::string::npos) << run.output.errors;
  }
}

TEST(OldMeasuringCall, CalibrationAndMemories) {
  const std::string ring = part("ring", 100.2, 49.7, -300.0, "bore = 40.0");
  expect_measured(
      "Z-5\n_MVAR=8 _SETVAL=40 _FA=5 _TSA=5 _PRNUM=2\nCYCLE976\n_EV[1]=0.125 _MV[0]=0.25",
      {ring, kBentProbe},
      {{"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[1]", 2.995},
       {"$SNS_MEA_WP_POS_DEV_AX1[1]", 0.02},
       {"$SCS_MEA_EMPIRIC_VALUE[1]", 0.125},
       {"$SCS_MEA_AVERAGE_VALUE[0]", 0.25}},
      1e-4);
  expect_measured("X30\nZ3\n_MVAR=10000 _SETVAL=0.5 _FA=3 _TSA=5\nCYCLE976",
                  {part("block", 130.0, 50.0, -299.5, ""), kBentProbe}, {{"$TC_DP3[1,1]", 119.995}},
                  1e-6);
}

}  // namespace
}  // namespace g31::testing::old_measuring_call_test

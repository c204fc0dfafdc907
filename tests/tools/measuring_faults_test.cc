// Each measuring cycle with a work offset as its target, and what goes wrong with probe and part:
// the cycle's own alarm, and the offset stays as it was.  Then what is refused before anything is
// touched.

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::measuring_faults_test {
namespace {

const std::string kRing = part("ring", 100.2, 49.7, -300.0, "bore = 40.0");
const std::string kBlock = part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 1.0]");

const std::string kBall = part("sphere", 100.2, 49.7, -300.0, "diameter = 25.0");

/// A call with places for the calibration record and the safe area.
struct MeasuringCall {
  const char* name;
  const std::string& parts;
  const char* start;  ///< a place in front of the part
  const char* call;
  double safe;   ///< a safe area within which the part lies
  double tight;  ///< one that it leaves
};

const MeasuringCall kCalls[] = {
    {"edge", kBlock, "X-40\nZ-5", "CYCLE978(100,1,,{},-29.5,5,{},1,1)", 2.0, 0.1},
    {"edge's angle", kBlock, "X-20 Y-27\nZ-5", "CYCLE998(105,1,,{},,,,5,{},102,1,30)", 3.0, 0.5},
    {"hole", kRing, "Z-5", "CYCLE977(101,1,,{},40,,,2,{})", 2.0, 0.1},
    {"groove", kRing, "Z-5", "CYCLE977(103,1,,{},40,,,2,{},,,,,1)", 2.0, 0.1},
    {"rectangle", kBlock, "Z5", "CYCLE977(106,1,,{},,60.05,40.05,3,{},1,-15,,,,,,,,,,,,,,,,,0.3)",
     2.0, 0.1},
    {"corner", kBlock, "X-42 Y-32\nZ-5", "CYCLE961(106,1,{},20,45,15,,,,,,-30,-20,0,,,12,{})", 2.0,
     0.1},
    {"ball", kBall, "Z20", "CYCLE997(1101119,1,{},25,2,{},0,90,0,0,0)", 2.0, 0.1},
    {"arc", kRing, "Z-5", "CYCLE979(101,1,,{},40,2,{},0,0,0,100)", 2.0, 0.1},
};

std::string filled(const MeasuringCall& row, int record, double safe) {
  return fmt::format(fmt::runtime(row.call), record, safe);
}

void expect_refused(const std::string& program, const std::string& parts, int alarm) {
  const std::vector<std::string> names = {"_OVI[9]", "$P_UIFR[1,X,TR]", "$P_UIFR[1,X,FI]",
                                          "$P_UIFR[1,Y,FI]", "$P_UIFR[1,Z,RT]"};
  const MeasuringRun run = run_measuring(program, {parts, kCalibrated}, names);
  EXPECT_EQ(run.alarm(), alarm) << run.output.errors;
  EXPECT_EQ(run.at("_OVI[9]"), alarm);
  EXPECT_EQ(run.at("$P_UIFR[1,X,TR]"), 100.0);
  EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
  EXPECT_EQ(run.at("$P_UIFR[1,Y,FI]"), 0.0);
  EXPECT_EQ(run.at("$P_UIFR[1,Z,RT]"), 0.0);
}

TEST(MeasuringFaults, NothingIsWrong) {
  for (const MeasuringCall& row : kCalls) {
    SCOPED_TRACE(row.name);
    expect_measured(std::string(row.start) + "\n" + filled(row, 1, row.safe),
                    {row.parts, kCalibrated}, {{"_OVI[9]", 0.0}, {"_OVI[0]", 1.0}});
  }
}

TEST(MeasuringFaults, ThePartIsNotThere) {
  const std::string elsewhere = part("block", 900.0, 50.0, -300.0, "");
  for (const MeasuringCall& row : kCalls) {
    SCOPED_TRACE(row.name);
    expect_refused(std::string(row.start) + "\n" + filled(row, 1, row.safe), elsewhere, 61301);
  }
}

TEST(MeasuringFaults, TheAlarmShowsTheLineOfTheCall) {
  for (const MeasuringCall& row : kCalls) {
    SCOPED_TRACE(row.name);
    const std::string call = filled(row, 2, row.safe);
    const MeasuringRun run =
        run_measuring(std::string(row.start) + "\n" + call, {row.parts, kCalibrated}, {});
    const auto& alarm = run.output.document.at("alarm");
    const auto lines_before = 3 + std::ranges::count(std::string_view(row.start), '\n') + 1;
    EXPECT_TRUE(alarm.at("file").get<std::string>().ends_with("part.mpf")) << alarm.dump();
    EXPECT_EQ(alarm.at("line"), lines_before + 1);
    EXPECT_TRUE(alarm.at("calls").empty()) << alarm.dump();
    EXPECT_EQ(alarm.at("inside").front().at("program"), "_MC_ALARM");
    EXPECT_EQ(alarm.at("inside").back().at("program"), call.substr(0, 8));
    // The message shows the line itself under its place, and what is inside below it.
    EXPECT_LT(run.output.errors.find(call), run.output.errors.find("in _MC_ALARM"));
    EXPECT_NE(run.output.errors.find("in _MC_ALARM"), std::string::npos);
  }
}

TEST(MeasuringFaults, TheToolIsNoProbe) {
  for (const MeasuringCall& row : kCalls) {
    SCOPED_TRACE(row.name);
    expect_refused("T2 M6\n" + filled(row, 1, row.safe), row.parts, 61309);
  }
}

TEST(MeasuringFaults, TheRecordWasNeverCalibrated) {
  for (const MeasuringCall& row : kCalls) {
    SCOPED_TRACE(row.name);
    expect_refused(std::string(row.start) + "\n" + filled(row, 2, row.safe), row.parts, 61341);
  }
}

TEST(MeasuringFaults, ThePartLiesOutsideTheSafeArea) {
  for (const MeasuringCall& row : kCalls) {
    SCOPED_TRACE(row.name);
    expect_refused(std::string(row.start) + "\n" + filled(row, 1, row.tight), row.parts, 61303);
  }
}

TEST(MeasuringFaults, TheProbeIsDeflectedAtTheCall) {
  // The stop of a measuring block leaves the ball on the surface.
  const std::string block_from_left = "X-40 Y0\nZ-5\nMEAS=1 G1 X-10 F300\n";
  const std::string ring_from_inside = "Z-5\nMEAS=1 G1 X25 F300\n";
  for (const MeasuringCall& row : kCalls) {
    SCOPED_TRACE(row.name);
    const bool is_ring = &row.parts == &kRing;
    expect_refused((is_ring ? ring_from_inside : block_from_left) + filled(row, 1, row.safe),
                   row.parts, 61302);
  }
}

const std::string kSquareBlock = part("block", 100.0, 50.0, -300.0);

/// The alarm is the cycle's own, and the probe has not moved to touch anything.
void expect_untouched(const std::string& call, int alarm) {
  SCOPED_TRACE(call);
  const MeasuringRun run =
      run_measuring(call, {kSquareBlock, kCalibrated}, {"_OVI[9]", "$AA_IM[X]", "$AA_IM[Z]"});
  EXPECT_EQ(run.alarm(), alarm) << run.output.errors;
  EXPECT_EQ(run.at("_OVI[9]"), alarm);
  EXPECT_TRUE(run.output.document.at("touches").empty());
  EXPECT_EQ(run.at("$AA_IM[X]"), 100.0);
  EXPECT_EQ(run.at("$AA_IM[Z]"), -160.0);
}

TEST(MeasuringFaults, OffsetsThatAreNotThere) {
  const std::pair<const char*, int> kNumbers[] = {
      {"-1", 61321},   {"100", 61321},  {"1017", 61321},  {"3017", 61321},  {"1000", 61321},
      {"4000", 61321}, {"5001", 61321}, {"20001", 61307}, {"90001", 61307}, {"100001", 61307}};
  const char* const kTargets[] = {
      "CYCLE978(100,{},,1,0,5,5,3,2)",        "CYCLE977(102,{},,1,40,,,2,5)",
      "CYCLE979(102,{},,1,40,2,5,0,0,0,120)", "CYCLE961(106,{},1,20,45,15,,,,,,,,0,,,10,5)",
      "CYCLE998(105,{},,1,,,,6,5,102,1,30)",  "CYCLE998(106,{},,1,,,,6,5,,,,30,0,0,20)",
      "CYCLE997(109,{},1,25,2,5,,,0,0,0)"};
  for (const char* const call : kTargets) {
    for (const auto& [number, alarm] : kNumbers) {
      expect_untouched(fmt::format(fmt::runtime(call), number), alarm);
    }
  }
}

TEST(MeasuringFaults, GlobalBasicFramesTakeNoRotation) {
  for (const char* const call :
       {"CYCLE961(106,3001,1,20,45,15,,,,,,,,0,,,10,5)", "CYCLE998(105,3001,,1,,,,6,5,102,1,30)",
        "CYCLE998(106,3001,,1,,,,6,5,,,,30,0,0,20)"}) {
    expect_untouched(call, 61321);
  }
}

TEST(MeasuringFaults, MemoriesThatAreNotThere) {
  for (const char* const memory : {"21", "-1", "210001", "30"}) {
    expect_untouched(fmt::format("CYCLE998(105,1,,1,,,,6,5,102,1,30,,,,,1,{})", memory), 61307);
  }
  expect_untouched("$SCS_MEA_EMPIRIC_VALUE_NUM=4\nCYCLE998(105,1,,1,,,,6,5,102,1,30,,,,,1,5)",
                   61307);
  expect_measured("X-20 Y-27\nZ-5\nCYCLE998(105,1,,1,,,,6,5,102,1,30,,,,,1,20)",
                  {kSquareBlock, kCalibrated}, {{"_OVI[7]", 20.0}});
}

// Angles by which all four points lie on one line.
TEST(MeasuringFaults, CornersWithoutAnAngle) {
  for (const char* const angle : {"", "0", "180", "-180", "200"}) {
    expect_untouched(fmt::format("CYCLE961(8,,1,20,45,12,26,,,,,,,0,{},,10,5)", angle), 61331);
  }
}

// The position of the corner is told by the angle, 270 degrees at most, or by S_MVAR.
TEST(MeasuringFaults, CornersAtAnglesBeyondTheirRange) {
  for (const char* const call :
       {"CYCLE961(6,,1,20,45,15,,,,,,,,300,,,10,5)", "CYCLE961(6,,1,20,45,15,,,,,,,,-271,,,10,5)",
        "CYCLE961(10006,,1,20,45,15,,,,,,,,91,,,10,5)",
        "CYCLE961(10008,,1,20,45,12,26,,,,,,,46,90,,10,5)"}) {
    expect_untouched(call, 61331);
  }
  // The reference edge runs upwards; the other one is reached by a negative distance.
  for (const char* const angle : {"90", "-270"}) {
    SCOPED_TRACE(angle);
    expect_measured(fmt::format("X-42 Y-32\nZ-5\nCYCLE961(6,,1,20,35,-15,,,,,,,,{},,,10,5)", angle),
                    {kSquareBlock, kCalibrated}, {{"_OVR[5]", -30.0}, {"_OVR[6]", -20.0}});
  }
}

TEST(MeasuringFaults, PlanesThatAreMirroredOnAMillingMachine) {
  for (const char* const axis : {"X", "Y"}) {
    for (const char* const call :
         {"CYCLE978(0,,,1,0,5,5,3,2)", "CYCLE976(0,1,0,,,,5,5)", "CYCLE977(2,,,1,40,,,2,5)"}) {
      expect_untouched(fmt::format("MIRROR {}0\n{}", axis, call), 61310);
    }
  }
  // Half a turn, and a mirrored tool axis, leave the plane what it is.
  const std::string ring = ring_aside();
  expect_measured("MIRROR X0 Y0\nZ-5\nCYCLE977(1,,,1,40,,,2,5)", {ring, kCalibrated},
                  {{"_OVR[5]", -0.2}, {"_OVR[6]", 0.3}}, 1e-4);
}

// From the middle of the ball the trigger is a radius, and 0 none.
TEST(MeasuringFaults, ATouchAlongTheToolWithoutItsTrigger) {
  const std::string from_middle = "$MNS_MEA_FUNCTION_MASK=9\n$TC_DP3[1,1]=117\nD1\n";
  expect_untouched(from_middle + "CYCLE978(0,,,1,0,5,5,3,2)", 61341);
  expect_untouched(from_middle + "CYCLE998(6,,,1,,,,6,5,,,,30,0,0,20)", 61341);
  expect_measured(from_middle +
                      "$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]=-3\nZ8\n"
                      "CYCLE978(0,,,1,0,5,5,3,2)",
                  {kSquareBlock, kCalibrated}, {{"_OVR[4]", 0.0}});
}

TEST(MeasuringFaults, ANegativeSafeAreaHasNothingInIt) {
  const MeasuringRun run = run_measuring("Z4\nCYCLE978(100,1,,1,0,5,-1,3,2)",
                                         {kSquareBlock, kCalibrated}, {"$P_UIFR[1,Z,FI]"});
  EXPECT_EQ(run.alarm(), 61303);
  EXPECT_EQ(run.at("$P_UIFR[1,Z,FI]"), 0.0);
}

TEST(MeasuringFaults, AnEdgeThatTheToolDoesNotHave) {
  const MeasuringRun run =
      run_measuring("Z4\nCYCLE978(200,,4000003,1,0.1,5,5,3,2,1,\"MILL\")",
                    {kSquareBlock, kCalibrated}, {"_OVR[20]", "_OVI[9]", "$TC_DP3[2,1]"});
  EXPECT_EQ(run.alarm(), 61404) << run.output.errors;
  EXPECT_EQ(run.at("_OVI[9]"), 61404.0);
  EXPECT_EQ(run.at("_OVR[20]"), 0.0);
  EXPECT_EQ(run.at("$TC_DP3[2,1]"), 80.0);
}

// As of every other cycle.
TEST(MeasuringFaults, AnUnknownCalibrationLeavesItsCycleAndARefusedOneItsSafeArea) {
  const MeasuringRun unknown =
      run_measuring("CYCLE976(6,1,39,,,,5,8)", {ring_aside()}, {"_OVI[2]", "_OVI[9]"});
  EXPECT_EQ(unknown.at("_OVI[2]"), 976.0);
  EXPECT_EQ(unknown.at("_OVI[9]"), 61307.0);
  const MeasuringRun far =
      run_measuring("Z-5\nCYCLE976(2,1,40,,,,5,1.5)", {ring_aside()}, {"_OVR[28]", "_OVI[9]"});
  EXPECT_EQ(far.at("_OVI[9]"), 61303.0);
  EXPECT_EQ(far.at("_OVR[28]"), 1.5);
}

}  // namespace
}  // namespace g31::testing::measuring_faults_test

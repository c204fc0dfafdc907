// Each measuring cycle with a work offset as its target, and what goes wrong with probe and part:
// the cycle's own alarm, and the offset stays as it was.

#include <algorithm>
#include <string>
#include <string_view>
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

}  // namespace
}  // namespace g31::testing::measuring_faults_test

// What CYCLE977, CYCLE978 and CYCLE979 do with the offsets of DL: additive ones, $TC_SCP, and
// set-up ones, $TC_ECP.

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::additive_offset_correction_test {
namespace {

/// A hole of 40.1 mm where 40 is asked for: the mill of 5 mm is 0.05 larger than it says.
std::string large_hole() {
  return ring_aside(40.1);
}

/// @param code  S_KNUM1
/// @param more  what follows the name of the tool: S_DLNUM first
std::string hole_call(const char* code, const char* more) {
  return fmt::format("Z-5\nCYCLE977(201,,{},1,40,,,2,5,,,,,,,\"MILL\",{})", code, more);
}

/// Faces at X -29.8 and 30.2, top at 0.
std::string block() {
  return part("block", 100.2, 50.0, -300.0, "");
}

TEST(AdditiveOffset, IsCorrectedInRadiusAndLengths) {
  const MeasuringCase kRows[] = {
      {"radius of DL=1, which nobody wrote before",
       large_hole(),
       hole_call("1000001", "1"),
       {{"$TC_SCP16[2,1]", 0.05},
        {"$TC_ECP16[2,1]", 0.0},
        {"$TC_DP6[2,1]", 5.0},
        {"$TC_DP15[2,1]", 0.0},
        {"_OVR[20]", 0.05}}},
      {"added to what is there, other DL numbers stay",
       large_hole(),
       "$TC_SCP16[2,1]=0.5 $TC_SCP26[2,1]=0.02 $TC_ECP26[2,1]=0.3\n" + hole_call("1000001", "2"),
       {{"$TC_SCP26[2,1]", 0.07}, {"$TC_SCP16[2,1]", 0.5}, {"$TC_ECP26[2,1]", 0.3}}},
      {"radius named, inverted",
       large_hole(),
       hole_call("11400001", "3"),
       {{"$TC_SCP36[2,1]", -0.05}, {"_OVR[20]", -0.05}}},
      {"length 1", large_hole(), hole_call("1100001", "1"), {{"$TC_SCP13[2,1]", 0.05}}},
      {"length 2", large_hole(), hole_call("1200001", "4"), {{"$TC_SCP44[2,1]", 0.05}}},
      {"length 3 of the last DL number",
       large_hole(),
       hole_call("1300001", "6"),
       {{"$TC_SCP65[2,1]", 0.05}}},
      {"the second edge",
       large_hole(),
       "$TC_DP6[2,2]=4\n" + hole_call("1000002", "1"),
       {{"$TC_SCP16[2,2]", 0.05}, {"$TC_SCP16[2,1]", 0.0}, {"_OVI[0]", 2}}},
      {"a replacement tool",
       large_hole(),
       "$TC_TP1[2]=3\n" + hole_call("101000001", "1,,,,,,,,,,,,,3"),
       {{"$TC_SCP16[2,1]", 0.05}, {"_OVI[8]", 2}, {"_OVI[10]", 3}}},
      {"an edge 0.2 behind its place",
       block(),
       "X-40\nZ-5\nCYCLE978(200,,1000001,1,-30,5,1,1,1,,\"MILL\",1)",
       {{"$TC_SCP16[2,1]", 0.2}, {"$TC_SCP13[2,1]", 0.0}}},
      {"a face 0.1 above its height",
       block(),
       "$TC_SCP23[2,1]=0.25\nCYCLE978(200,,1000001,1,-0.1,5,1,3,2,,\"MILL\",2)",
       {{"$TC_SCP23[2,1]", 0.15}, {"$TC_SCP26[2,1]", 0.0}, {"$TC_DP12[2,1]", 0.0}}},
      {"an arc 0.1 too large",
       part("ring", 100.0, 50.0, -300.0, "bore = 40.1\nsagitta = 0.0000005"),
       "Z-5\nCYCLE979(201,,1000001,1,40,2,5,0,0,0,120,,\"MILL\",5)",
       {{"$TC_SCP56[2,1]", 0.05}, {"_OVI[13]", 5}}},
  };
  expect_measured(kRows, 2e-6);
}

TEST(SetupOffset, IsAddedToOrTakesTheAdditiveOne) {
  const std::string before = "$TC_SCP16[2,1]=0.02 $TC_ECP16[2,1]=-0.03 $TC_SCP13[2,1]=0.4\n";
  const MeasuringCase kRows[] = {
      {"added to the set-up offset",
       large_hole(),
       before + hole_call("3000001", "1"),
       {{"$TC_ECP16[2,1]", -0.03 + 0.05}, {"$TC_SCP16[2,1]", 0.02}, {"$TC_DP15[2,1]", 0.0}}},
      {"the additive offset goes into it; only that of the component",
       large_hole(),
       before + hole_call("2000001", "1"),
       {{"$TC_ECP16[2,1]", -0.03 + 0.02 + 0.05},
        {"$TC_SCP16[2,1]", 0.0},
        {"$TC_SCP13[2,1]", 0.4},
        {"$TC_ECP13[2,1]", 0.0},
        {"_OVR[20]", 0.05}}},
      {"inverted, the additive offset keeps its sign",
       large_hole(),
       before + hole_call("12000001", "1"),
       {{"$TC_ECP16[2,1]", -0.03 + 0.02 - 0.05}, {"$TC_SCP16[2,1]", 0.0}}},
      {"a spigot 0.2 too large, by the set-up offset of DL=2",
       part("cylinder", 100.0, 50.0, -300.0, "diameter = 30.2"),
       "Z5\nCYCLE977(202,,3000001,1,30,,,2,5,0,-15,,,,,\"MILL\",2)",
       {{"$TC_ECP26[2,1]", -0.1}, {"$TC_SCP26[2,1]", 0.0}}},
      {"the length by a face",
       block(),
       "CYCLE978(200,,2000001,1,-0.1,5,1,3,2,,\"MILL\",1)",
       {{"$TC_ECP13[2,1]", -0.1}, {"$TC_SCP13[2,1]", 0.0}}},
      {"within S_TZL nothing is corrected: the additive offset stays where it is",
       large_hole(),
       before + hole_call("2000001", "1,0.2,1,0.5,-0.5,0.5,1,0,,,1"),
       {{"$TC_ECP16[2,1]", -0.03}, {"$TC_SCP16[2,1]", 0.02}, {"_OVR[20]", 0.0}}},
  };
  expect_measured(kRows);
}

TEST(AdditiveOffset, CountsWithTheNextDl) {
  expect_measured(hole_call("1000001", "2") +
                      "\nT2 M6\nR1=$P_TOOLR\nDL=2\nR2=$P_TOOLR R3=$P_DLNO\nD1\nR4=$P_TOOLR",
                  {large_hole(), kCalibrated}, {{"R1", 5.0}, {"R2", 5.05}, {"R3", 2}, {"R4", 5.0}});
  expect_measured(
      "$TC_SCP16[1,1]=0.25\nDL=1\nZ-5\n"
      "CYCLE977(201,,3000001,1,40,,,2,5,,,,,,,\"PROBE\",1)\n"
      "R1=$P_TOOLR\nDL=1\nR2=$P_TOOLR",
      {large_hole(), kCalibrated}, {{"R1", 3.25}, {"R2", 3.3}});
}

TEST(AdditiveOffset, ResultsNameToolEdgeAndDlNumber) {
  expect_measured(
      hole_call("1000001", "4"), {large_hole(), kCalibrated},
      {{"_OVI[0]", 1}, {"_OVI[2]", 977}, {"_OVI[8]", 2}, {"_OVI[9]", 0}, {"_OVI[13]", 4}});
  // Wear has no DL number: it is shown only.
  expect_measured(hole_call("1", "4"), {large_hole(), kCalibrated},
                  {{"_OVI[13]", 4}, {"$TC_DP15[2,1]", 0.05}, {"$TC_SCP46[2,1]", 0.0}});
}

TEST(AdditiveOffset, IsInMillimetresForAProgramInInchesToo) {
  expect_measured(
      "Z-5\nG700\n"
      "CYCLE977(201,,1000001,1,40/25.4,,,2/25.4,5/25.4,,,,,,,\"MILL\",1)\nG710",
      {large_hole(), kCalibrated}, {{"$TC_SCP16[2,1]", 0.05}, {"_OVR[20]", 0.05 / 25.4}});
}

TEST(AdditiveOffset, IsNamedInTheLog) {
  struct Target {
    const char* code;
    const char* words;
  };
  const Target kRows[] = {
      {"1000001", "Tool offset, radius, additive DL3\n"},
      {"2000001", "Tool offset, radius, set-up DL3\n"},
      {"3100001", "Tool offset, length L1, set-up DL3\n"},
      {"4000001", "Tool offset, radius, geometry\n"},
  };
  for (const Target& row : kRows) {
    SCOPED_TRACE(row.code);
    const MeasuringRun run =
        expect_measured("CYCLE150(0,1001,\"LOG.TXT\")\n" + hole_call(row.code, "3"),
                        {large_hole(), kCalibrated}, {});
    const std::string log = run.output.document.at("files").value("LOG.TXT", "missing");
    EXPECT_NE(log.find(std::string("Correction into:") + row.words), std::string::npos) << log;
  }
}

TEST(AdditiveOffset, WithoutItsNumberOrOnAMachineWithoutItNothingIsCorrected) {
  struct Refusal {
    const char* name;
    std::string program;
  };
  const Refusal kRows[] = {
      {"no DL number", hole_call("1000001", "")},
      {"DL number 0, set-up", hole_call("3000001", "0")},
      {"below 0", hole_call("1000001", "-1")},
      {"there are six of them", hole_call("2000001", "7")},
      {"no such kind", hole_call("5000001", "1")},
      {"no such component", hole_call("1500001", "1")},
      {"a machine without any", "$MN_MM_NUM_SUMCORR=0\n" + hole_call("1000001", "1")},
      {"no memory for them", "$MN_MM_TOOL_MANAGEMENT_MASK=1\n" + hole_call("3000001", "1")},
  };
  for (const Refusal& row : kRows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run =
        run_measuring("$TC_SCP16[2,1]=0.5\n" + row.program, {large_hole(), kCalibrated},
                      {"$TC_SCP16[2,1]", "$TC_ECP16[2,1]", "$TC_DP15[2,1]", "_OVR[20]"});
    EXPECT_EQ(run.alarm(), 61404) << run.output.errors;
    EXPECT_EQ(run.at("$TC_SCP16[2,1]"), 0.5);
    EXPECT_EQ(run.at("$TC_ECP16[2,1]"), 0.0);
    EXPECT_EQ(run.at("$TC_DP15[2,1]"), 0.0);
    EXPECT_EQ(run.at("_OVR[20]"), 0.0);
  }
  // They need none of that for wear.
  expect_measured("$MN_MM_NUM_SUMCORR=0\n" + hole_call("1", ""), {large_hole(), kCalibrated},
                  {{"$TC_DP15[2,1]", 0.05}});
}

}  // namespace
}  // namespace g31::testing::additive_offset_correction_test

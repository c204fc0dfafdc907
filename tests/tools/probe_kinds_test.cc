// L and star probes, records chosen by the tool, the second measuring input, and what a shop adds
// to the measuring cycles.  Spindle reversal with a ball far off the spindle's axis: both readings
// are of the same spot.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/measuring_run.h"

namespace g31::testing::probe_kinds_test {
namespace {

TEST(ProbeKinds, AStarTouchesWithTheArmThatLeads) {
  const std::string star =
      "[tools.1]\nlength = 117.0\nradius = 20.0\ntype = 714.0\n[probe]\nlength = "
      "117.0\ntrigger_delay_s = 0.001\n"
      "[[probe.ball]]\nat = [17.0, 0.0, 0.0]\n[[probe.ball]]\nat = [-17.0, 0.0, 0.0]\n"
      "[[probe.ball]]\nat = [0.0, 17.0, 0.0]\n[[probe.ball]]\nat = [0.0, -17.0, 0.0]\n";
  expect_measured("Z-8\nCYCLE976(2,1,60,,,,5,25)\nX0 Y0\nCYCLE977(1,,,1,60,,,4,5)",
                  {ring_aside(60.0), star},
                  {{"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]", 19.995},
                   {"_OVR[4]", 60.0},
                   {"_OVR[5]", 0.2},
                   {"_OVR[6]", -0.3}},
                  1e-4);
  EXPECT_EQ(run_measuring("CYCLE978(0,,,1,0,5,1,3,2)", {ring_aside(60.0), star}, {}).alarm(),
            61309);
  EXPECT_EQ(run_measuring("CYCLE977(3,,,1,60,,,4,5,,,,,1)", {ring_aside(60.0), star}, {}).alarm(),
            61309);
}

TEST(ProbeKinds, AnLProbePullsAgainstAFaceFromBelow) {
  const std::string l_probe =
      "[tools.1]\nlength = 114.0\nradius = 3.0\ntype = 713.0\n[probe]\nlength = "
      "117.0\ntrigger_delay_s = 0.001\n"
      "[[probe.ball]]\nat = [30.0, 0.0, 0.0]\n";
  const std::string plate = part("block", 100.0, 50.0, -300.0, "");
  expect_measured("X-80\nZ-26\nX-40\nCYCLE976(1000,1,-20,,3,0,6,5)\nCYCLE978(0,,,1,-20.1,6,1,3,1)",
                  {plate, l_probe},
                  {{"$SNS_MEA_WP_TRIG_PLUS_DIR_AX3[0]", -0.005},
                   {"_OVR[4]", -20.0},
                   {"_OVR[16]", 0.1},
                   {"$AA_IW[Z]", -26.1}});
  EXPECT_EQ(run_measuring("X-50\nCYCLE978(0,,,1,0,5,1,3,2)", {plate, l_probe}, {}).alarm(), 61309);
}

/// The spindle turns along with the work coordinates, so the probe sees their directions: its ball
/// is beside the spindle by what its own triggers say.
TEST(ProbeKinds, AnLProbeInTurnedCoordinatesSeesThem) {
  const std::string l_probe =
      "[tools.1]\nlength = 120.0\nradius = 3.0\ntype = 714.0\n[probe]\nlength = 117.0\n"
      "eccentricity = [0.02, -0.03]\n";
  for (const char* const turn : {"ROT Z30", "ROT Z-100", "ROT Z180"}) {
    SCOPED_TRACE(turn);
    expect_measured(std::string("Z-5\nCYCLE976(10001,1,40,0,1,0,2,5,0,0,1,0,1,0)\n") + turn +
                        "\nG0 X0.5 Y-0.3\nCYCLE977(1,,,1,40,,,2,5)",
                    {part("ring", 100.0, 50.0, -300.0, "bore = 40.0\nsagitta = 0.00001"), l_probe},
                    {{"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]", 3.02},
                     {"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]", -3.03},
                     {"_OVR[4]", 40.0},
                     {"_OVR[5]", 0.0},
                     {"_OVR[6]", 0.0}},
                    5e-5);
  }
}

TEST(ProbeKinds, TheRecordMayBeTheTools) {
  expect_measured(
      "$TC_DPNT[1,1]=3\n$SNS_MEA_FUNCTION_MASK=40\nZ-5\nCYCLE976(2,1,40,,,,5,5)\n"
      "CYCLE977(1,,,1,40,,,2,5)",
      {ring_aside()},
      {{"$SNS_MEA_WP_BALL_DIAM[2]", 6.0},
       {"$SNS_MEA_WP_BALL_DIAM[0]", 0.0},
       {"_OVI[5]", 3.0},
       {"_OVR[4]", 40.0}});
}

TEST(ProbeKinds, TheWorkProbeMayBeOnTheSecondInput) {
  const std::string second = "[probe]\ninput = 2\n";
  expect_measured("$MCS_MEA_FUNCTION_MASK=1\nZ-5\nCYCLE977(1,,,1,40,,,2,5)",
                  {ring_aside() + second, kCalibrated}, {{"_OVR[4]", 40.0}});
  EXPECT_EQ(run_measuring("Z-5\nCYCLE977(1,,,1,40,,,2,5)", {ring_aside() + second, kCalibrated}, {})
                .alarm(),
            61301);
}

TEST(MeasuringInInches, ResultsAreInTheUnitsOfTheProgram) {
  for (const char* const unit : {"G70", "G700"}) {
    SCOPED_TRACE(unit);
    const bool is_all = std::string(unit) == "G700";  // data count in inches, too
    expect_measured(std::string("Z-5\n_OVR[3]=7 _OVR[24]=8\n") + unit +
                        "\nCYCLE977(201,,4000001,1,1.5,,,0.1,0.5,,,,,,,\"MILL\",,0,0.2,0.02,-0.02,"
                        "0.1,1,0,,,1)\n"
                        "R1=$AA_IW[X] R2=$P_GG[13]\nG710",
                    {ring_aside(), kCalibrated},
                    {{"_OVR[0]", 1.5},
                     {"_OVR[4]", 40.0 / 25.4},
                     {"_OVR[5]", 0.2 / 25.4},
                     {"_OVR[6]", -0.3 / 25.4},
                     {"_OVR[8]", 0.02},
                     {"_OVR[16]", 40.0 / 25.4 - 1.5},
                     {"_OVR[28]", 0.5},
                     {"_OVR[29]", 0.2},
                     {"_OVR[3]", 7.0},
                     {"_OVR[24]", 8.0},
                     {"_OVI[9]", 61304.0},
                     {"$TC_DP6[2,1]", 5.0 + (40.0 - 38.1) / 2.0},
                     {"R1", is_all ? 0.2 / 25.4 : 0.2},
                     {"R2", is_all ? 3.0 : 1.0}});
  }
  const std::string block = part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 3.0]");
  expect_measured("X-20 Y-27\nZ-5\nG700\nCYCLE998(105,1,,1,,2,,0.2,3,102,1,1.2)\nG710",
                  {block, kCalibrated}, {{"_OVR[4]", 3.0}, {"$P_UIFR[1,Z,RT]", 1.0}});
  expect_measured(
      "Z-5\nG700\nCYCLE976(2,1,40/25.4,,,,0.2,0.2,10)\nG710", {ring_aside()},
      {{"_OVR[4]", 6.0 / 25.4}, {"$SNS_MEA_WP_BALL_DIAM[0]", 6.0}, {"$SNS_MEA_WP_FEED[0]", 254.0}});
}

TEST(ShopsOwnProgram, RunsBeforeAndAfterMeasuringAndBeforeAnAlarm) {
  const std::string own =
      "\nM30\n%_N_CUST_MEACYC_SPF\nPROC CUST_MEACYC\n"
      "CASE _MV_CUST OF 977 GOTOF _M977 -977 GOTOF _ME977 1 GOTOF _MEACYC_ERROR DEFAULT GOTOF "
      "_MEND\n"
      "_M977:\nR1=R1+1\nGOTOF _AM_WP_MES\n_AM_WP_MES:\nR2=R2+1\nM17\n_ME977:\nR3=_OVR[4]\nM17\n"
      "_MEACYC_ERROR:\nIF _OVI[2]==977\nR4=_OVI[9]\nENDIF\n_MEND:\nM17";
  expect_measured("Z-5\nCYCLE977(1,,,1,40,,,2,5)\nCYCLE977(1,,,1,40,,,2,5)" + own,
                  {ring_aside(), kCalibrated},
                  {{"R1", 2.0}, {"R2", 2.0}, {"R3", 40.0}, {"R4", 0.0}});
  const MeasuringRun run =
      run_measuring("$SNS_MEA_ALARM_MASK=65536\nZ-5\nCYCLE977(1,,,1,40,,,2,0.1)" + own,
                    {ring_aside(), kCalibrated}, {"R3", "R4", "_OVR[17]"});
  EXPECT_EQ(run.alarm(), 61303);
  EXPECT_EQ(run.at("R4"), 61303);
  EXPECT_EQ(run.at("R3"), 0.0);
  // What was measured can be read nevertheless.
  EXPECT_NEAR(run.at("_OVR[17]"), 0.2, 1e-6);
}

constexpr const char* kFarOff = "[probe]\neccentricity = [0.5, -0.3]\n";

/// The record says where the ball is.
constexpr const char* kKnownPlace = R"([variables]
"$SNS_MEA_WP_POS_DEV_AX1[0]" = 0.5
"$SNS_MEA_WP_POS_DEV_AX2[0]" = -0.3
)";

std::string turned_block() {
  return part("block", 100.0, 50.0, -300.0, "rotate_deg = [0.0, 0.0, 3.0]");
}

// The second point was S_ID less twice the deviation from the first: atan(29/30 tan 3 deg)
// = 2.9001.
TEST(Reversal, AnEdgeIsTouchedTheWholeDistanceApart) {
  for (const char* const variant : {"5", "10005", "110005"}) {
    for (const char* const place : {kKnownPlace, ""}) {
      SCOPED_TRACE(fmt::format("{} {}", variant, place));
      expect_measured(fmt::format("X-20 Y-27\nZ-5\nCYCLE998({},,,1,,,,6,5,102,1,30)", variant),
                      {turned_block(), kCalibrated, kFarOff, place}, {{"_OVR[4]", 3.0}});
    }
  }
}

// The mean of two places on a circle lies within it.
TEST(Reversal, AnArcsPointsLieOnItsCircle) {
  const std::string hole = part_aside("ring", "bore = 40.0\nsagitta = 0.0000001");
  const std::string pin = part_aside("cylinder", "diameter = 30.0\nsagitta = 0.0000001");
  const MeasuringCase kRows[] = {
      {"hole, three points",
       hole,
       "Z-5\nCYCLE979(10001,,,1,40,2,5,0,0,0,120)",
       {{"_OVR[4]", 40.0}}},
      {"hole, four points", hole, "Z-5\nCYCLE979(11001,,,1,40,2,5,0,0,20,80)", {{"_OVR[4]", 40.0}}},
      {"spigot", pin, "X30\nZ-5\nCYCLE979(10002,,,1,30,3,5,0,0,0,120)", {{"_OVR[4]", 30.0}}},
  };
  for (const MeasuringCase& row : some_of(kRows)) {
    SCOPED_TRACE(row.name);
    std::vector<ExpectedValue> expected = row.expected;
    expected.insert(expected.end(), {{"_OVR[5]", 0.2}, {"_OVR[6]", -0.3}});
    expect_measured(row.program, {row.parts, kCalibrated, kFarOff, kKnownPlace}, expected, 1e-6);
  }
}

TEST(Reversal, APointIsTheOneThatIsTouchedWithoutIt) {
  const auto measured = [](const char* variant) {
    return run_measuring(fmt::format("X-40\nZ-5\nCYCLE978({},,,1,-30,5,5,1,1)", variant),
                         {turned_block(), kCalibrated, kFarOff, kKnownPlace}, {"_OVR[4]"})
        .at("_OVR[4]");
  };
  EXPECT_NEAR(measured("10000"), measured("0"), 1e-6);
}

}  // namespace
}  // namespace g31::testing::probe_kinds_test

// What machine and setting data change in the measuring cycles: feeds, spindles that cannot be
// positioned, alarms that are not shown, frames that come back behind a cycle.

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::measuring_switches_test {
namespace {

std::size_t signals_of(const MeasuringRun& run) {
  std::size_t count = 0;
  for (const auto& touch : run.output.document.at("touches")) {
    count += touch.value("triggered", false) ? 1U : 0U;
  }
  return count;
}

double seconds_of(const MeasuringRun& run) {
  return run.output.document.at("machine_time_s").get<double>();
}

TEST(MeasuringFeeds, AFastApproachFindsTheSurfaceAndTheTouchThatCountsIsAsBefore) {
  const std::string hole = "Z-5\nCYCLE977(101,1,,1,40,,,10,5)";
  const std::vector<ExpectedValue> sizes = {
      {"_OVR[4]", 40.0}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.3}, {"$P_UIFR[1,X,FI]", 0.2}};
  const std::string calibrated =
      "X0.2 Y-0.3 Z-5\n$SCS_MEA_FUNCTION_MASK={}\nCYCLE976(1,1,40,,,,5,5)\nX0 Y0\n";
  for (const int mask : {81921, 81937, 81953, 81969}) {
    SCOPED_TRACE(mask);
    const MeasuringRun run = expect_measured(fmt::format(fmt::runtime(calibrated), mask) + hole,
                                             {ring_aside(), kBentProbe}, sizes, 1e-4);
    // Eight touches of the calibration and four of the hole, each twice with bit 4.
    EXPECT_EQ(signals_of(run), (mask & 16) != 0 ? 24U : 12U);
  }
}

TEST(MeasuringFeeds, FastApproachAndRetractionAtRapidSaveTime) {
  const auto lasts = [](int mask) {
    const MeasuringRun run = run_measuring(
        fmt::format("$SCS_MEA_FUNCTION_MASK={}\nZ-5\nCYCLE977(1,,,1,40,,,12,5)", mask),
        {ring_aside(), kCalibrated}, {});
    EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
    return seconds_of(run);
  };
  const double usual = lasts(81921);
  EXPECT_LT(lasts(81921 + 16), usual - 3.0);
  EXPECT_LT(lasts(81921 + 32), usual - 0.5);
}

TEST(MeasuringFeeds, AFastApproachThatFindsNothingIsAMissedTouch) {
  EXPECT_EQ(run_measuring("$SCS_MEA_FUNCTION_MASK=81945\nZ-5\nCYCLE977(1,,,1,30,,,2,5)",
                          {ring_aside(), kCalibrated}, {})
                .alarm(),
            61301);
}

TEST(SpindleThatCannotBePositioned, IsMarkedAtItsChannelAxis) {
  const std::string marked = "$MCS_AXIS_USAGE_ATTRIB[6]=512\nSPOS=25\nZ-5\n";
  expect_measured(marked + "CYCLE977(1,,,1,40,,,2,5)", {ring_aside(), kCalibrated},
                  {{"_OVR[4]", 40.0}, {"_OVR[5]", 0.2}});
  const char* const kReversed[] = {"CYCLE977(10101,1,,1,40,,,2,5)", "CYCLE976(2,1,40,,,,5,5)"};
  for (const char* const call : kReversed) {
    SCOPED_TRACE(call);
    const MeasuringRun run =
        run_measuring(marked + call, {ring_aside(), kCalibrated}, {"$P_UIFR[1,X,FI]"});
    EXPECT_EQ(run.alarm(), 61372) << run.output.errors;
    EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
  }
  const std::string star = "[tools.1]\nlength = 117.0\nradius = 20.0\ntype = 714.0\n";
  EXPECT_EQ(
      run_measuring(marked + "CYCLE977(1,,,1,40,,,2,5)", {ring_aside(), star, kCalibrated}, {})
          .alarm(),
      61373);
}

TEST(AlarmsThatAreNotShown, EndTheCycleWithoutCorrectingAndTheProgramGoesOn) {
  struct Row {
    const char* name;
    int mask;
    const char* call;
    int alarm;
    bool shown;
  };
  constexpr int kJump = 65536;
  constexpr int kMasked = 131072;
  const Row kRows[] = {
      {"safe area", kJump + kMasked, "CYCLE977(101,1,,1,40,,,2,0.1)", 61303, false},
      {"no signal", kJump + kMasked, "CYCLE977(101,1,,1,30,,,2,5)", 61301, false},
      {"without bit 16 it is shown", kMasked, "CYCLE977(101,1,,1,40,,,2,0.1)", 61303, true},
      {"bit 16 alone shows it", kJump, "CYCLE977(101,1,,1,40,,,2,0.1)", 61303, true},
      {"another alarm is shown", kJump + kMasked, "CYCLE977(107,1,,1,40,,,2,5)", 61307, true},
  };
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run = run_measuring(
        fmt::format("$SNS_MEA_ALARM_MASK={}\nF777\nZ-5\n{}\nR1=1 R2=$P_F", row.mask, row.call),
        {ring_aside(), kCalibrated}, {"R1", "R2", "_OVI[9]", "$P_UIFR[1,X,FI]"});
    EXPECT_EQ(run.alarm(), row.shown ? row.alarm : 0) << run.output.errors;
    EXPECT_EQ(run.at("R1"), row.shown ? 0.0 : 1.0);
    EXPECT_EQ(run.at("R2"), row.shown ? 0.0 : 777.0);
    EXPECT_EQ(run.at("_OVI[9]"), row.alarm);
    EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
  }
}

TEST(AlarmsThatAreNotShown, ADimensionDifferenceIsCorrectedEitherWay) {
  const std::string call =
      "\nZ-5\nCYCLE977(201,,4000001,1,39.9,,,2,5,,,,,,,\"MILL\",,0,0.05,0.5,-0.5,0.5,1,0,,,1)";
  expect_measured("$SNS_MEA_ALARM_MASK=0" + call, {ring_aside(), kCalibrated},
                  {{"_OVI[9]", 61306.0}, {"$TC_DP6[2,1]", 5.05}});
  const MeasuringRun silent =
      expect_measured("$SNS_MEA_ALARM_MASK=196608" + call, {ring_aside(), kCalibrated},
                      {{"$TC_DP6[2,1]", 5.05}}, 1e-6, {"_OVI[9]"});
  EXPECT_EQ(silent.at("_OVI[9]"), 61306.0);
}

TEST(FramesBehindACycle, TheSettableFrameOfTheCallCountsUntilItIsProgrammed) {
  const std::string measured =
      "Z-5\nCYCLE977(101,1,,1,40,,,2,5)\nX0 Y0\nR1=$AA_IM[X] R2=$P_IFRAME[X,FI]\n"
      "R3=$P_UIFR[1,X,FI]\nG54\nX0 Y0\nR4=$AA_IM[X] R5=$P_IFRAME[X,FI]";
  expect_measured(measured, {ring_aside(), kCalibrated},
                  {{"R1", 100.2}, {"R2", 0.2}, {"R3", 0.2}, {"R4", 100.2}, {"R5", 0.2}});
  expect_measured("$MN_FRAME_SAVE_MASK=1\n" + measured, {ring_aside(), kCalibrated},
                  {{"R1", 100.0}, {"R2", 0.0}, {"R3", 0.2}, {"R4", 100.2}, {"R5", 0.2}});
  // The second call measures from the frame in force and finds the same correction.
  expect_measured(
      "$MN_FRAME_SAVE_MASK=1\nZ-5\nCYCLE977(101,1,,1,40,,,2,5)\nX0 Y0\n"
      "CYCLE977(101,1,,1,40,,,2,5)\nR1=$AA_IW[X]\nG54",
      {ring_aside(), kCalibrated},
      {{"_OVR[17]", 0.2}, {"$P_UIFR[1,X,FI]", 0.2}, {"$P_UIFR[1,Y,FI]", -0.3}, {"R1", 0.2}});
}

}  // namespace
}  // namespace g31::testing::measuring_switches_test

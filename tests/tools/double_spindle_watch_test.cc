// Two probes that measure at once: what they are watched for, MEASA with two triggers, and sheets
// that are refused.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/double_spindle.h"
#include "tests/support/effort.h"

namespace g31::testing::double_spindle_watch_test {
namespace {

struct AlarmCase {
  const char* name;
  std::string parts;
  const char* program;
  int alarm;
};

TEST(DoubleSpindleWatch, EachAlarmWritesNothing) {
  const std::string rings =
      first_part("ring", 0.0, 0.0, bore(40.0)) + second_part("ring", 0.0, 0.0, bore(40.0));
  const std::string near = first_part("groove", 0.2, 0.0, "width = 50.0");
  const AlarmCase kRows[] = {
      {"only one part is there", near, "Z-5\nCYCLE977(103,1,,1,50,,,5,5,,,,,1)", 61302},
      {"the parts differ by more than SD55700",
       near + second_part("groove", 0.2, 0.0, "width = 54.0"),
       "Z-5\nCYCLE977(103,1,,1,50,,,5,5,,,,,1)", 61302},
      {"neither is there", "", "Z-5\nCYCLE977(103,1,,1,50,,,5,5,,,,,1)", 61301},
      {"the second part is outside the safe area",
       near + second_part("groove", 0.9, 0.0, "width = 50.0"),
       "Z-5\nCYCLE977(103,1,,1,50,,,5,0.5,,,,,1)", 61303},
      {"the record of the second probe", rings, "Z-5\nCYCLE977(101,1,,2,40,,,2,5)", 61313},
      {"the edge of the second probe", rings, "D2 Z-5\nCYCLE977(101,1,,1,40,,,2,5)", 61313},
      {"calibrating the first by the second record", rings, "Z-5\nCYCLE976(1,2,40,,,,2,5)", 61313},
      {"calibrating the second by the first record", rings, "D2 Z-5\nCYCLE976(1,1,40,,,,2,5)",
       61313},
      {"calibrating into the length of the tool", rings, "Z-5\nCYCLE976(1000000,1,0,,3,1,2,5)",
       61307},
      {"balls off their axes by different ways", rings,
       "$SCS_MEA_SIMULTAN_POS_DEV_MAX=0.1\n$SNS_MEA_WP_POS_DEV_AX1[1]=0.11\nZ-5\n"
       "CYCLE977(101,1,,1,40,,,2,5)",
       61967},
      {"a ball", rings, "Z-5\nCYCLE997(109,1,1,20,5,5,0,90)", 61307},
      {"a tool", rings, "Z-5\nCYCLE971(1,,1,103,2,,2,5)", 61307},
      {"tilted work coordinates", rings,
       "$P_UIFR[1]=$P_UIFR[1]:CROT(X,5)\nG54 Z-5\nCYCLE977(101,1,,1,40,,,2,5)", 61330},
  };
  const std::vector<std::string> written = {"$P_UIFR[1,X,FI]", "$SNS_MEA_WP_BALL_DIAM[0]",
                                            "$TC_DP3[1,1]", "_OVI[9]", "_OVR[17]"};
  for (const AlarmCase& row : some_of(kRows)) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run = run_measuring(row.program, on_both(row.parts), written);
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_EQ(run.at("_OVI[9]"), row.alarm);
    EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
    EXPECT_EQ(run.at("$SNS_MEA_WP_BALL_DIAM[0]"), 6.0);
    EXPECT_EQ(run.at("$TC_DP3[1,1]"), 120.0);
    EXPECT_LT(std::abs(run.at("_OVR[17]")), 1.0) << "no mark is left behind";
  }
}

/// Where the other part is missing a probe goes on by SD55700 alone.
TEST(DoubleSpindleWatch, AProbeGoesOnNoFurtherThanTheLimit) {
  for (const double limit : {1.0, 0.5}) {
    const MeasuringRun run = run_measuring(
        fmt::format("$SCS_MEA_SIMULTAN_LIMIT={}\nX-45 Z-5\nCYCLE978(0,,,1,-30,5,5,1,1,1)", limit),
        on_both(first_part("block", 0.0, 0.0, "")), {});
    EXPECT_EQ(run.alarm(), 61302);
    double furthest = -1e9;
    for (const auto& touch : run.output.document.at("touches")) {
      furthest = std::max(furthest, touch.at("stopped").at(0).get<double>());
    }
    EXPECT_NEAR(furthest, 100.0 - 33.0 + limit, 1e-9);
  }
}

TEST(DoubleSpindleWatch, MeasaWaitsForBothTriggers) {
  const std::string walls = first_part("block", 0.0, 0.0, "") + second_part("block", 0.07, 0.0, "");
  const std::vector<ExpectedValue> expected = {{"R1", 67.0},   {"R2", 67.07}, {"R3", -33.0},
                                               {"R4", -32.93}, {"R5", 1.0},   {"R6", 1.0},
                                               {"R7", 67.07}};
  const char* const read =
      "STOPRE\nR1=$AA_MM1[X] R2=$AA_MM2[X] R3=$AA_MW1[X] R4=$AA_MW2[X] R5=$AC_MEA[1] "
      "R6=$AC_MEA[2] R7=$AA_IM[X]";
  const std::string program = fmt::format("X-45\nZ-5\nMEASA[X]=(1,1,2) G1 X-20 F100\n{}", read);
  expect_measured(program, on_both(walls, "[machine]\nstopping = \"ideal\"\n"), expected, 1e-9);
  // Axes that lag latch the same.
  const MeasuringRun lags = run_measuring(
      program, on_both(walls, "[machine.axes.X]\nservo_gain = 1.8\n"), names_of(expected));
  EXPECT_NEAR(lags.at("R1"), 67.0, 1e-6);
  EXPECT_NEAR(lags.at("R2"), 67.07, 1e-6);
  // The other way round: the second trigger comes first.
  expect_measured("X45 Z-5\nMEASA[X]=(1,1,2) G1 X20 F100\nSTOPRE\nR1=$AA_MM1[X] R2=$AA_MM2[X]",
                  on_both(walls), {{"R1", 133.0}, {"R2", 133.07}}, 1e-9);
}

/// The probe that switches has its place, and the program goes on where the axes are: SD55700
/// behind the signal.
TEST(DoubleSpindleWatch, OneOfTwoTriggersLatches) {
  const std::string program =
      "X-45 Z-5\nMEASA[X]=(1,1,2) G1 X-20 F100\nSTOPRE\nR1=$AA_MM1[X] R2=$AA_MM2[X] "
      "R3=$AC_MEA[1] R4=$AC_MEA[2] R5=$AA_IM[X]\nG91 X-0.5\nR6=$AA_IM[X]";
  expect_measured(program, on_both(first_part("block", 0.0, 0.0, "")),
                  {{"R1", 67.0}, {"R2", 0.0}, {"R3", 1.0}, {"R4", 0.0}, {"R5", 68.0}, {"R6", 67.5}},
                  1e-9);
  expect_measured(
      program, on_both(second_part("block", 0.07, 0.0, "")),
      {{"R1", 0.0}, {"R2", 67.07}, {"R3", 0.0}, {"R4", 1.0}, {"R5", 68.07}, {"R6", 67.57}}, 1e-9);
}

/// Mode 2: the edge of the second trigger counts behind that of the first one.
TEST(DoubleSpindleWatch, TriggersInOrder) {
  const std::string walls = first_part("block", 0.0, 0.0, "") + second_part("block", 0.07, 0.0, "");
  const auto in_mode_2 = [](const char* triggers) {
    return fmt::format(
        "X-45 Z-5\nMEASA[X]=(2,{}) G1 X-20 F100\nSTOPRE\nR1=$AA_MM1[X] R2=$AA_MM2[X] R3=$AC_MEA[1] "
        "R4=$AC_MEA[2] R5=$AA_IM[X]",
        triggers);
  };
  const std::string ideal = "[machine]\nstopping = \"ideal\"\n";
  expect_measured(in_mode_2("1,2"), on_both(walls, ideal),
                  {{"R1", 67.0}, {"R2", 67.07}, {"R3", 1.0}, {"R4", 1.0}, {"R5", 67.07}}, 1e-9);
  expect_measured(in_mode_2("2,1"), on_both(walls, ideal),
                  {{"R1", 67.07}, {"R2", 0.0}, {"R3", 0.0}, {"R4", 1.0}, {"R5", 68.07}}, 1e-9);
}

TEST(DoubleSpindleWatch, SheetsThatFitNotAreRefused) {
  struct Row {
    const char* sheet;
    const char* code;
  };
  const Row kRows[] = {
      {"[probe.second]\ninput = 2\n", "SET152"},
      {"[probe.second]\nat = [200.0, 0.0, 0.0]\ninput = 1\n", "SET152"},
      {"[probe]\nat = [-100.0, 0.0, 0.0]\n[probe.second]\nat = [200.0, 0.0, 0.0]\n", "SET152"},
      {"[probe.second]\nat = [200.0, 0.0]\n", "SET104"},
  };
  for (const Row& row : kRows) {
    SCOPED_TRACE(row.sheet);
    const MeasuringRun run = run_measuring("", {row.sheet}, {});
    EXPECT_NE(run.output.errors.find(row.code), std::string::npos) << run.output.errors;
    EXPECT_EQ(run.output.exit_code, 2) << run.output.errors;
  }
}

}  // namespace
}  // namespace g31::testing::double_spindle_watch_test

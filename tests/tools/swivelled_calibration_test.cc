// CYCLE976 where the work coordinates are turned: in planes that CYCLE800 swivels, on the six
// machines, with a probe whose ball is beside the spindle and whose signal is late.

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/kinematics/plane_rotation.h"
#include "tests/support/effort.h"
#include "tests/support/five_axis_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::swivelled_calibration_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

constexpr double kOffA = 0.02;
constexpr double kOffB = -0.03;
/// 0.001 s at 300 mm/min.
constexpr double kLate = 0.005;

const char* const kProbe =
    "[probe]\neccentricity = [0.02, -0.03]\ntrigger_delay_s = 0.001\n[variables]\n"
    "\"$SNS_MEA_WP_BALL_DIAM[0]\" = 0.0\n\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]\" = 0.0\n"
    "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]\" = 0.0\n\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]\" = 0.0\n"
    "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]\" = 0.0\n";

/// A part in the plane 20, -15, 10 degrees about the turned X, Y, Z, at its origin.
std::string placed(const std::string& part) {
  return "[[part]]\non = \"G54\"\nat = [30.0, -20.0, 5.0]\nrotate_deg = [15.0, -20.0, 25.0]\n" +
         part;
}

/// The plane of that part, as frames turn: about Z, the new Y, the new X.
std::string in_the_plane(std::size_t set_up) {
  return fmt::format(
      "T1 M6\nG54 D1\n{}CYCLE800(0,\"\",0,27,30,-20,5,25,-20,15,0,0,0,{})\nG0 X0 Y0 Z50\n",
      set_up % 2 == 1 ? "TRAORI\n" : "", set_up % 3 == 0 ? 1 : -1);
}

const std::size_t kSetUps = of_many(6U);

std::vector<machine::AxisChainSetup> machines() {
  return {k1(), k2(), k3(), k4(), k5(), k6()};
}

/// Calibrates in the ring, then finds its middle from another place.
MeasuringRun ring_on(std::size_t set_up, int variant, const std::vector<std::string>& names) {
  const std::string program =
      in_the_plane(set_up) + fmt::format(
                                 "Z-5\nCYCLE976({},1,40,0,1,0,2,5,0,0,1,0,1,0)\nX0.5 Y-0.3\n"
                                 "CYCLE977(1,,,1,40,,,2,5)\n",
                                 variant);
  return run_on_sheets(program,
                       {five_axis_sheet(machines().at(set_up), Point(200, -100, -400)), kProbe,
                        placed("name = \"ring\"\nshape = \"ring\"\nbore = 40.0\n"
                               "sagitta = 0.000001\n")},
                       names);
}

/// Whether the ball's place is kept apart or not, the triggers are those of the probe, not of the
/// plane.
TEST(SwivelledCalibration, ARingSaysWhatTheProbesOwnDirectionsDo) {
  for (std::size_t i = 0; i < kSetUps; ++i) {
    SCOPED_TRACE(i);
    const double radius = 3.0 - kLate;
    expect_values(
        ring_on(i, 10001,
                {"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]", "$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]",
                 "$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]", "$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]"}),
        {{"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]", kOffA - radius},
         {"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]", kOffA + radius},
         {"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]", kOffB - radius},
         {"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]", kOffB + radius}},
        5e-6);
    expect_values(ring_on(i, 1, {"$SNS_MEA_WP_POS_DEV_AX1[0]", "$SNS_MEA_WP_POS_DEV_AX2[0]"}),
                  {{"$SNS_MEA_WP_POS_DEV_AX1[0]", kOffA}, {"$SNS_MEA_WP_POS_DEV_AX2[0]", kOffB}},
                  5e-6);
  }
}

TEST(SwivelledCalibration, WhatIsMeasuredThereAfterwardsIsRight) {
  for (std::size_t i = 0; i < kSetUps; ++i) {
    for (const int variant : {1, 10001}) {
      SCOPED_TRACE(fmt::format("{} {}", i, variant));
      // Without the ball's place the chords lie up to 0.036 beside the middle: 0.00007 of 40.
      const MeasuringRun run = ring_on(i, variant, {"_OVR[4]", "_OVR[5]", "_OVR[6]"});
      expect_values(run, {{"_OVR[5]", 0.0}, {"_OVR[6]", 0.0}}, 5e-6);
      EXPECT_NEAR(run.at("_OVR[4]"), 40.0, variant == 1 ? 5e-6 : 1e-4);
    }
  }
}

TEST(SwivelledCalibration, ABallToo) {
  for (std::size_t i = 0; i < kSetUps; ++i) {
    SCOPED_TRACE(i);
    const std::string program = in_the_plane(i) +
                                "Z15\nCYCLE976(3,1,25,0,1,0,3,5,0,0,1,0,1,0)\nG0 X0 Y0 Z20\n"
                                "CYCLE997(1102019,,1,25,2,5,0,90,0,0,0)\n";
    const MeasuringRun run =
        run_on_sheets(program,
                      {five_axis_sheet(machines().at(i), Point(200, -100, -400)), kProbe,
                       placed("name = \"ball\"\nshape = \"sphere\"\ndiameter = 25.0\n")},
                      {"_OVR[4]", "_OVR[5]", "_OVR[6]"});
    expect_values(run, {{"_OVR[4]", 25.0}, {"_OVR[5]", 0.0}, {"_OVR[6]", 0.0}}, 1e-5);
  }
}

/// Nothing is touched, nothing written.
void expect_refused(const std::string& turn, const std::string& call) {
  SCOPED_TRACE(turn + " " + call);
  const MeasuringRun run =
      run_measuring(turn + "\n" + call,
                    {kCalibrated,
                     "[[part]]\nname = \"ring\"\nshape = \"ring\"\non = \"G54\"\n"
                     "at = [0.0, 0.0, 0.0]\nbore = 40.0\n"},
                    {"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]", "_OVI[9]"});
  EXPECT_EQ(run.alarm(), 61330) << run.output.errors;
  EXPECT_EQ(run.at("$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]"), 3.0);
  EXPECT_EQ(run.output.document.at("touches").size(), 0U);
}

TEST(SwivelledCalibration, CoordinatesTiltedAgainstTheProbeShowNoneOfItsDirections) {
  for (const char* const call : {"CYCLE976(0,1,0,0,3,1,2,5)", "CYCLE976(1,1,40,0,1,0,2,5)",
                                 "CYCLE976(3,1,25,0,1,0,2,5)", "CYCLE976(4,1,-20,0,1,1,2,5)"}) {
    expect_refused("ROT X20", call);
  }
}

TEST(SwivelledCalibration, OneDirectionIsOneOfTheProbe) {
  expect_refused("ROT Z30", "CYCLE976(4,1,-20,0,1,1,2,5)");
  expect_refused("ROT Z30", "CYCLE976(5,1,-20,0,1,1,2,5,,,1,40)");
  expect_refused("ROT Z30", "CYCLE976(1001,1,40,0,1,0,2,5)");
}

}  // namespace
}  // namespace g31::testing::swivelled_calibration_test

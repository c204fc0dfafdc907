// The SINUMERIK example of parts/library does what it says.

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::testing::library_programs_test {
namespace {

TEST(RingGaugeProgram, CalibratesALateProbeAndMeasuresTheBore) {
  cli::RunOptions options;
  options.programs = {"parts/library/ring_gauge/measure_ring.mpf"};
  options.setups = {"parts/library/ring_gauge/sinumerik.toml"};
  options.prints = {"$SNS_MEA_WP_BALL_DIAM[0],_OVR[4],_OVR[16]"};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  // 300 mm/min for 4 ms, on both sides.
  const auto value = [&](const char* name) {
    return output.document["variables"][name].get<double>();
  };
  EXPECT_NEAR(value("$SNS_MEA_WP_BALL_DIAM[0]"), 6.0 - 2.0 * 300.0 / 60.0 * 0.004, 1e-6);
  EXPECT_NEAR(value("_OVR[4]"), 39.996, 1e-6);
  EXPECT_NEAR(value("_OVR[16]"), 0.0, 1e-6);
}

TEST(TurnedShaftProgram, CalibratesAndCorrectsTheWearOfTheTool) {
  cli::RunOptions options;
  options.programs = {"parts/library/turned_shaft/measure_shaft.mpf"};
  options.setups = {"parts/library/turned_shaft/lathe.toml"};
  options.prints = {"R1,_OVR[4],$TC_DP12[2,1]"};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  const auto value = [&](const char* name) {
    return output.document["variables"][name].get<double>();
  };
  EXPECT_NEAR(value("R1"), 40.02, 1e-6);
  EXPECT_NEAR(value("_OVR[4]"), 50.02, 1e-6);
  EXPECT_NEAR(value("$TC_DP12[2,1]"), -0.01, 1e-6);
}

TEST(KinematicsBallProgram, FindsTheTableWhereItIs) {
  cli::RunOptions options;
  options.programs = {"parts/library/kinematics_ball/measure_kinematics.mpf"};
  options.setups = {"parts/library/kinematics_ball/kinematics_ball.toml"};
  options.prints = {"$TC_CARR6[1],$TC_CARR15[1],_OVR[155]"};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  const auto value = [&](const char* name) {
    return output.document["variables"][name].get<double>();
  };
  EXPECT_NEAR(value("$TC_CARR6[1]"), -450.0, 1e-6);
  EXPECT_NEAR(value("$TC_CARR15[1]"), -0.03, 1e-6);
  EXPECT_NEAR(value("_OVR[155]"), 0.0, 1e-6);
}

}  // namespace
}  // namespace g31::testing::library_programs_test

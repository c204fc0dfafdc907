// Examples of parts/library do what they say.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::testing::library_programs_test {
namespace {

struct Reading {
  const char* name;
  double value;
};

/// Runs an example to its end and reads what it leaves.
void expect_readings(const std::string& program, const std::vector<std::string>& sheets,
                     const std::vector<Reading>& readings) {
  cli::RunOptions options;
  options.programs = {"parts/library/" + program};
  for (const std::string& sheet : sheets) {
    options.setups.push_back("parts/library/" + sheet);
  }
  for (const Reading& reading : readings) {
    options.prints.emplace_back(reading.name);
  }
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  for (const Reading& reading : readings) {
    EXPECT_NEAR(output.document["variables"][reading.name].get<double>(), reading.value, 1e-6)
        << reading.name;
  }
}

TEST(RingGaugeProgram, CalibratesALateProbeAndMeasuresTheBore) {
  // 300 mm/min for 4 ms, on both sides.
  expect_readings("ring_gauge/measure_ring.mpf", {"ring_gauge/sinumerik.toml"},
                  {{"$SNS_MEA_WP_BALL_DIAM[0]", 6.0 - 2.0 * 300.0 / 60.0 * 0.004},
                   {"_OVR[4]", 39.996},
                   {"_OVR[16]", 0.0}});
}

TEST(TurnedShaftProgram, CalibratesAndCorrectsTheWearOfTheTool) {
  expect_readings("turned_shaft/measure_shaft.mpf", {"turned_shaft/lathe.toml"},
                  {{"R1", 40.02}, {"_OVR[4]", 50.02}, {"$TC_DP12[2,1]", -0.01}});
}

TEST(TurnedShaftProgram, MeasuresADiameterByTwoPoints) {
  expect_readings("turned_shaft/two_points.mpf",
                  {"turned_shaft/lathe.toml", "turned_shaft/axial_probe.toml"},
                  {{"_OVR[4]", 40.02}});
}

TEST(TurnedToolsProgram, FindsBothLengthsOfTheTool) {
  expect_readings("turned_tools/measure_turning_tool.mpf", {"turned_tools/lathe.toml"},
                  {{"$TC_DP3[5,1]", 50.0}, {"$TC_DP4[5,1]", 80.0}});
}

TEST(ToolSetterProgram, FindsLengthAndRadiusOnAFanuc) {
  expect_readings("tool_setter/measure_tools.nc", {"tool_setter/setter_fanuc.toml"},
                  {{"#11005", 100.0}, {"#13005", 8.0}});
}

TEST(KinematicsBallProgram, FindsTheTableWhereItIs) {
  expect_readings("kinematics_ball/measure_kinematics.mpf",
                  {"kinematics_ball/kinematics_ball.toml"},
                  {{"$TC_CARR6[1]", -450.0}, {"$TC_CARR15[1]", -0.03}, {"_OVR[155]", 0.0}});
}

TEST(KinematicsBallProgram, FindsTheTableInSingleSteps) {
  expect_readings("kinematics_ball/by_steps.mpf", {"kinematics_ball/kinematics_ball.toml"},
                  {{"$TC_CARR6[1]", -450.0}, {"$TC_CARR15[1]", -0.03}, {"_OVR[155]", 0.0}});
}

TEST(CyclesPrograms, FindByHowMuchTheSpindleLeans) {
  expect_readings("cycles/spindle.mpf", {"cycles/machine.toml", "cycles/spindle.toml"},
                  {{"_OVR[2]", 0.05}, {"_OVR[3]", 0.02}});
}

TEST(ToolSetterProgram, FindsLengthAndRadiusOfATurningCutter) {
  expect_readings("tool_setter/turning_cutter.nc", {"tool_setter/setter_fanuc.toml"},
                  {{"#11005", 100.0}, {"#13005", 8.0}, {"#550", 0.0}});
}

TEST(ToolSetterProgram, FindsLengthAndRadiusInALaser) {
  // The beam of 0.5 mm lies at Y50.3 Z-399.6: tools break it from 0.25 above.
  expect_readings("tool_setter/laser.nc",
                  {"tool_setter/setter_fanuc.toml", "tool_setter/laser.toml"},
                  {{"#11005", 100.0}, {"#13005", 8.0}, {"#552", 50.3}, {"#553", -399.35}});
}

}  // namespace
}  // namespace g31::testing::library_programs_test

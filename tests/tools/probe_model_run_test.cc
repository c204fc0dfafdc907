// Whole programs with a probe that has errors of its own, and one that is not well.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/control_run.h"
#include "tests/support/run_program.h"

namespace g31::probe_model_run_test {
namespace {

using testing::ControlRun;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

const char* const kRing = "parts/library/ring_gauge/ring.toml";

/// Touches the ring gauge from its axis in +X and -X at each spindle angle; #101.. are the
/// readings.
std::string touches_along_x(const std::vector<std::string>& spindle) {
  std::string program = "O1\nG59 G90 G00 X0 Y0\nG43 Z-7.5 H99\n";
  int variable = 101;
  for (const std::string& m19 : spindle) {
    program += m19 + "\n";
    for (const char* end : {"20.", "-20."}) {
      program +=
          std::string("G31 X") + end + " F50.\n#" + std::to_string(variable++) + "=#5061\nG00 X0\n";
    }
  }
  return program + "M30\n";
}

RunOutput run_with(const std::string& probe_keys, const std::string& program) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("touch.nc", program)};
  options.setups = {kRing, folder.write("probe.toml", "[machine]\nstopping = \"ideal\"\n[probe]\n" +
                                                          probe_keys + "\n")};
  options.prints = {"#101-#104,#1005"};
  options.touches = true;
  return run_program(options);
}

double variable(const RunOutput& output, const char* name) {
  return output.document.at("variables").at(name).get<double>();
}

constexpr double kWay = 19.998 - 3.0;

TEST(ProbeModelRun, M19TurnsAnEccentricBall) {
  const RunOutput output =
      run_with("eccentricity = [0.02, 0.0]", touches_along_x({"M19", "M19 R180."}));
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(variable(output, "#101"), kWay - 0.02, 1e-9);
  EXPECT_NEAR(variable(output, "#102"), -(kWay + 0.02), 1e-9);
  EXPECT_NEAR(variable(output, "#103"), kWay + 0.02, 1e-9);
  EXPECT_NEAR(variable(output, "#104"), -(kWay - 0.02), 1e-9);
}

TEST(ProbeModelRun, M19StandsAtItsAngle) {
  const ControlRun run("fanuc-16i", "M19\nM19 R90.5\nM19 P180\nG00 X1. M19 R-30.");
  EXPECT_EQ(run.machine().log(),
            (std::vector<std::string>{"orient 0", "orient 90.5", "orient 180", "orient -30",
                                      "move 1.000 0.000 0.000 rapid"}));
}

TEST(ProbeModelRun, CalibrationTakesAConstantPreTravelOutInAllDirections) {
  TemporaryFolder folder;
  const auto sheet = folder.write("pre.toml", "[probe]\npre_travel_mm = 0.0125\n");
  cli::RunOptions calibrate;
  calibrate.programs = {"macros/fanuc/O6001.nc"};
  calibrate.setups = {kRing, sheet};
  calibrate.prints = {"#517,#518"};
  const RunOutput calibrated = run_program(calibrate);
  ASSERT_EQ(calibrated.exit_code, 0) << calibrated.errors;
  // The macro's corrections are negative where the signal comes late.
  EXPECT_NEAR(variable(calibrated, "#517"), -0.0125, 1e-9);
  EXPECT_NEAR(variable(calibrated, "#518"), -0.0125, 1e-9);

  cli::RunOptions measure;
  measure.programs = {"parts/library/ring_gauge/measure_ring.nc"};
  measure.setups = {kRing, sheet};
  measure.libraries = {"macros/fanuc"};
  measure.assignments = {"#517=-0.0125", "#518=-0.0125"};
  measure.prints = {"#164,#179"};
  const RunOutput measured = run_program(measure);
  ASSERT_EQ(measured.exit_code, 0) << measured.errors;
  EXPECT_NEAR(variable(measured, "#164"), 39.996, 1e-9);
  EXPECT_NEAR(variable(measured, "#179"), 39.996, 1e-9);
}

TEST(ProbeModelRun, ADoubleTriggerLatchesTheFirstSignal) {
  const std::string program = touches_along_x({"M19"});
  const RunOutput healthy = run_with("", program);
  const RunOutput twice = run_with("state = \"double_trigger\"", program);
  ASSERT_EQ(twice.exit_code, 0) << twice.errors;
  EXPECT_EQ(variable(twice, "#101"), variable(healthy, "#101"));
  EXPECT_EQ(twice.document.at("touches").at(0).at("signals"), 2);
  EXPECT_FALSE(healthy.document.at("touches").at(0).contains("signals"));
  EXPECT_EQ(twice.document.at("probe").at("state"), "double_trigger");
  EXPECT_FALSE(healthy.document.contains("probe"));
}

TEST(ProbeModelRun, ALowBatteryIsToldToTheProgramAndTheDocument) {
  const std::string program = touches_along_x({"M19"});
  const RunOutput low = run_with("state = \"low_battery\"\nlow_battery_input = 1005", program);
  ASSERT_EQ(low.exit_code, 0) << low.errors;
  EXPECT_EQ(variable(low, "#1005"), 1.0);
  EXPECT_EQ(low.document.at("probe").at("state"), "low_battery");
  EXPECT_NEAR(variable(low, "#101"), kWay, 1e-9) << "it still measures";
  EXPECT_EQ(variable(run_with("low_battery_input = 1005", program), "#1005"), 0.0);
}

TEST(ProbeModelRun, ADeadProbeNeverStopsASkipMove) {
  const RunOutput dead = run_with("state = \"dead\"",
                                  "O1\nG59 G90 G00 X0 Y0\nG43 Z-7.5 H99\n"
                                  "G31 X19. F50.\n#101=#5061\nM30\n");
  EXPECT_EQ(dead.exit_code, 1) << dead.errors;
  EXPECT_NEAR(variable(dead, "#101"), 19.0, 1e-9);
  EXPECT_EQ(dead.document.at("touches").at(0).at("triggered"), false);
}

}  // namespace
}  // namespace g31::probe_model_run_test

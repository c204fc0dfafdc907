// `g31 evaluate circle`: a program runs on the simulated machine, whose errors come back.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "tests/support/run_evaluate.h"

namespace g31::circle_command_test {
namespace {

using evaluate::OptionId;
using testing::EvaluateOutput;
using testing::run_evaluate;
using testing::TemporaryFolder;

const char* const kBothWays =
    "%\nO1\nG90 G17 G21 G94\nG54 G0 X0. Y0. Z0.\nG0 X20. Y0.\nG4 P100\n"
    "G3 X20. Y0. I-20. J0. F4000.\nG4 P100\nG2 X20. Y0. I-20. J0. F4000.\nG4 P100\n"
    "G0 X0. Y0.\nM30\n%\n";

EvaluateOutput evaluated_run(const std::string& program, const std::string& sheet) {
  TemporaryFolder folder;
  cli::RunOptions run;
  run.programs = {folder.write("circle.nc", program)};
  run.setups = {folder.write("machine.toml", sheet)};
  run.trace = folder.path("trace.csv");
  EXPECT_EQ(testing::run_program(run).exit_code, 0);
  cli::EvaluateOptions options;
  options.kind = "circle";
  options.file = run.trace;
  options.given[OptionId::Radius] = "20";
  return run_evaluate(options);
}

TEST(EvaluateCircle, FindsTheErrorsOfTheSheet) {
  int inside = 0;
  int all = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const auto between = [&](double low, double high, std::uint64_t which) {
      return low + (high - low) * uniform(Stream{seed, 1}, which);
    };
    const double backlash_x = between(0.0, 0.02, 0);
    const double backlash_y = between(0.0, 0.02, 1);
    const double scale_x = between(-100.0, 100.0, 2);  // um/m, over the 40 mm from -20 to 20
    const double scale_y = between(-100.0, 100.0, 3);
    const double turned = between(-100.0, 100.0, 4);
    const std::string sheet = fmt::format(
        "[machine.axes.X]\nbacklash = {}\n[machine.axes.Y]\nbacklash = {}\n[machine.errors]\n"
        "EXX = [[-20.0, {}], [20.0, {}]]\nEYY = [[-20.0, {}], [20.0, {}]]\nC0Y = {}\n",
        backlash_x, backlash_y, -2e-5 * scale_x, 2e-5 * scale_x, -2e-5 * scale_y, 2e-5 * scale_y,
        turned);
    const EvaluateOutput output = evaluated_run(kBothWays, sheet);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const std::pair<const char*, double> kTruth[] = {{"backlash_X", 1e3 * backlash_x},
                                                     {"backlash_Y", 1e3 * backlash_y},
                                                     {"scale_X", scale_x},
                                                     {"scale_Y", scale_y},
                                                     {"squareness", -turned},
                                                     {"servo_mismatch", 0.0}};
    for (const auto& [name, truth] : kTruth) {
      EXPECT_NEAR(output.value(name), truth, 3e-3) << name << " of machine " << seed;
      inside += std::abs(output.value(name) - truth) <= 3.0 * output.u(name) ? 1 : 0;
      ++all;
    }
  }
  EXPECT_EQ(inside, all);
}

TEST(EvaluateCircle, FindsTheMismatchOfTheServoGains) {
  // Lags of 60 / 1800 and 60 / 1750 s; 4 m/min on 20 mm is 3.333 rad/s.  A lagging axis turns by
  // atan(omega T) / omega.
  const EvaluateOutput output = evaluated_run(
      kBothWays, "[machine.axes.X]\nservo_gain = 1.8\n[machine.axes.Y]\nservo_gain = 1.75\n");
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const double omega = 4000.0 / 60.0 / 20.0;
  const double lag_x = std::atan(omega * 0.06 / 1.8) / omega;
  const double lag_y = std::atan(omega * 0.06 / 1.75) / omega;
  EXPECT_NEAR(output.value("servo_mismatch"), 1e3 * (lag_x - lag_y), 1e-3);
  EXPECT_NEAR(output.value("squareness"), 0.0, 0.1);
  // The gain that the feed takes from the radius, 1 / sqrt(1 + (omega T)^2), counts as scale.
  const double gain_x = 1.0 / std::hypot(1.0, omega * 0.06 / 1.8);
  EXPECT_NEAR(output.value("scale_X"), 1e6 * (gain_x - 1.0), 1.0);
}

TEST(EvaluateCircle, OfTheIdealMachineIsZero) {
  const EvaluateOutput output = evaluated_run(kBothWays, "");
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  // The trace has steps of 1e-7 mm.
  for (const char* const name : {"backlash_X", "backlash_Y", "radial_error_max", "spike_X"}) {
    EXPECT_NEAR(output.value(name), 0.0, 2e-4) << name;
  }
  EXPECT_EQ(output.document.at("schema"), "g31.evaluation/1");
  EXPECT_EQ(output.document.at("kind"), "circle");
  EXPECT_EQ(output.document.at("results").at("radius").at("unit"), "mm");
  EXPECT_FALSE(output.document.contains("curves"));
}

}  // namespace
}  // namespace g31::circle_command_test

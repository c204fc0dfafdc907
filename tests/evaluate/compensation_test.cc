// The loop of the paper: a bent slide is measured, what was found is compensated, and the machine
// goes straighter by as much.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/evaluate/bent_slide.h"
#include "tests/support/run_evaluate.h"

namespace g31::compensation_test {
namespace {

using namespace evaluate::bent_slide;  // NOLINT(google-build-using-namespace)
using evaluate::OptionId;
using testing::TemporaryFolder;

/// Sensors that ride with the machine along a work with a shape of its own; readings rise as the
/// work comes nearer, and Y is positive towards the sensors.
std::string bench_file() {
  const auto work = [](double x) { return 0.01 * std::cos(x / 170.0); };
  std::string text = "K,A,B\n";
  for (int k = 0; k * kStep <= kLength; ++k) {
    const double x = k * kStep;
    text += fmt::format("{},{:.12f},{:.12f}\n", k, work(x) - error_at(x),
                        work(x + kStep) - error_at(x));
  }
  return text;
}

TEST(Compensation, LeavesWhatInterpolationBetweenThePointsLeaves) {
  TemporaryFolder folder;
  const std::string bent = folder.write("bent.toml", sheet("EYX"));
  cli::EvaluateOptions options;
  options.kind = "straightness";
  options.given[OptionId::Step] = std::to_string(kStep);
  options.given[OptionId::Compensation] = folder.path("compensation.toml");
  const auto output = testing::evaluate_text(bench_file(), options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const std::vector<std::string> program = {
      folder.write("way.nc", "%\nO1\nG90 G21 G94\nG1 X1000. F60000.\nM30\n%\n")};
  for (const Beside& at : driven(folder, program, {bent})) {
    EXPECT_NEAR(at.dy, error_at(at.x), kTable) << at.x;
  }
  double most = 0.0;
  for (const Beside& at : driven(folder, program, {bent, folder.path("compensation.toml")})) {
    EXPECT_NEAR(at.dy, left_at(at.x), kTable) << at.x;
    most = std::max(most, std::abs(at.dy));
  }
  EXPECT_LT(most, 0.0022);  // of 0.0204 before
  EXPECT_GT(most, 0.0010);
}

TEST(Compensation, KnowsLinearAxesOnly) {
  TemporaryFolder folder;
  cli::RunOptions run;
  run.programs = {folder.write("way.nc", "%\nO1\nM30\n%\n")};
  run.setups = {folder.write("wrong.toml", "[machine.compensation]\nEAX = 1.0\n")};
  const auto output = testing::run_program(run);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("unknown key EAX in [machine.compensation]"), std::string::npos)
      << output.errors;
}

}  // namespace
}  // namespace g31::compensation_test

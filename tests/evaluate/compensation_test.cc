// The loop of the paper: a bent slide is measured, what was found is compensated, and the machine
// goes straighter by as much.

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"

namespace g31::compensation_test {
namespace {

using evaluate::OptionId;
using testing::TemporaryFolder;

constexpr int kStep = 100;
constexpr int kLength = 1000;

/// mm along Y when X stands at x; both ends 0.
double bend(double x) {
  return 0.02 * std::sin(std::numbers::pi * x / kLength) +
         0.003 * std::sin(7.0 * std::numbers::pi * x / kLength);
}

/// The sheet's table is straight over 10 mm: an eighth of 10^2 times the largest curvature, 1.65e-6
/// per mm.
constexpr double kTable = 2.1e-5;

std::string bent_sheet() {
  std::string text = "[machine.errors]\nEYX = [";
  for (int x = 0; x <= kLength; x += 10) {
    text += fmt::format("[{}.0, {:.12f}], ", x, bend(x));
  }
  return text + "]\n";
}

/// Sensors that ride with the machine along a work with a shape of its own; readings rise as the
/// work comes nearer, and Y is positive towards the sensors.
std::string bench_file() {
  const auto work = [](double x) { return 0.01 * std::cos(x / 170.0); };
  std::string text = "K,A,B\n";
  for (int k = 0; k * kStep <= kLength; ++k) {
    const double x = k * kStep;
    text += fmt::format("{},{:.12f},{:.12f}\n", k, work(x) - bend(x), work(x + kStep) - bend(x));
  }
  return text;
}

/// X and true Y of each sample of a run along X.
std::vector<std::array<double, 2>> driven(const TemporaryFolder& folder,
                                          const std::vector<std::string>& sheets) {
  cli::RunOptions run;
  run.programs = {folder.write("way.nc", "%\nO1\nG90 G21 G94\nG1 X1000. F60000.\nM30\n%\n")};
  run.setups = sheets;
  run.trace = folder.path("trace.csv");
  EXPECT_EQ(testing::run_program(run).exit_code, 0);
  std::ifstream in(run.trace);
  std::string line;
  std::getline(in, line);
  EXPECT_TRUE(
      line.starts_with("time_s,X_commanded,Y_commanded,Z_commanded,X_encoder,Y_encoder,"
                       "Z_encoder,X_true,Y_true"));
  std::vector<std::array<double, 2>> way;
  while (std::getline(in, line)) {
    std::vector<double> values;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) {
      values.push_back(std::stod(field));
    }
    EXPECT_EQ(values.at(5), 0.0);  // the encoder of Y knows of nothing
    way.push_back({values.at(4), values.at(8)});
  }
  return way;
}

TEST(Compensation, LeavesWhatInterpolationBetweenThePointsLeaves) {
  TemporaryFolder folder;
  const std::string bent = folder.write("bent.toml", bent_sheet());
  cli::EvaluateOptions options;
  options.kind = "straightness";
  options.given[OptionId::Step] = std::to_string(kStep);
  options.given[OptionId::Compensation] = folder.path("compensation.toml");
  const auto output = testing::evaluate_text(bench_file(), options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  for (const auto& [x, y] : driven(folder, {bent})) {
    EXPECT_NEAR(y, bend(x), kTable) << x;
  }
  double most = 0.0;
  for (const auto& [x, y] : driven(folder, {bent, folder.path("compensation.toml")})) {
    const double low = std::floor(x / kStep) * kStep;
    const double share = (x - low) / kStep;
    const double left = bend(x) - (1.0 - share) * bend(low) - share * bend(low + kStep);
    EXPECT_NEAR(y, left, kTable) << x;
    most = std::max(most, std::abs(y));
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

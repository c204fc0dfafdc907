// A study of CYCLE9960 with a probe that scatters: the vectors scatter as the propagation of errors
// has it.

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/effort.h"
#include "tests/support/kinematics_run.h"
#include "tests/support/run_study.h"

namespace g31::testing::kinematics_scatter_test {
namespace {

constexpr double kSigma = 0.0005;  ///< mm, of a touch

/// What a study of `runs` runs finds: standard deviations of two results.
std::vector<double> scatter(const MisbelievedMachine& machine, const std::string& call,
                            const std::vector<std::string>& results, int runs) {
  const TemporaryFolder folder;
  std::string sheet;
  for (const std::string& part : kinematics_sheets(machine)) {
    sheet += part;
  }
  const std::string probe = "[probe]\n";
  sheet.insert(sheet.find(probe) + probe.size(), "repeatability_mm = 0.0005\n");
  folder.write("sheet.toml", sheet);
  folder.write("part.mpf", over_the_ball(call) + "\nM30\n");
  std::string text =
      fmt::format("[study]\nprogram = \"part.mpf\"\nsetup = \"sheet.toml\"\nrepeats = {}\n", runs);
  for (std::size_t i = 0; i < results.size(); ++i) {
    text += fmt::format("[results.r{}]\nvalue = \"{}\"\n", i, results[i]);
  }
  cli::StudyOptions options;
  options.study = folder.write("study.toml", text);
  const StudyOutput output = study_document(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  const nlohmann::json document = nlohmann::json::parse(output.out);
  std::vector<double> deviations;
  for (std::size_t i = 0; i < results.size(); ++i) {
    double mean = 0.0;
    double squares = 0.0;
    for (const auto& row : document.at("rows")) {
      mean += row.at("results").at(i).get<double>() / runs;
    }
    for (const auto& row : document.at("rows")) {
      const double off = row.at("results").at(i).get<double>() - mean;
      squares += off * off / (runs - 1);
    }
    deviations.push_back(std::sqrt(squares));
  }
  return deviations;
}

/// Four standard deviations of an estimated standard deviation.
double margin(int runs) {
  return 4.0 / std::sqrt(2.0 * runs);
}

const int kRuns = of_many(160);

TEST(KinematicsScatter, OfATableIsHalfThatOfATouch) {
  // A place of the ball across has the variance sigma^2 / 2: half the difference of two touches.
  // The middle of four places round a circle has 2 / 4 of that, sigma^2 / 4.
  MisbelievedMachine machine = misbelieved_machines().front();
  machine.truth = machine.believed;
  const std::vector<double> found =
      scatter(machine, "CYCLE9960(50400,\"\",1,25,0,0,0,0,0,0,0,270,4,0,1,3,5,1,1,0,0)",
              {"_OVR[15]", "_OVR[16]"}, kRuns);
  std::printf("table %.4g %.4g um\n", 1000.0 * found[0], 1000.0 * found[1]);
  EXPECT_NEAR(found[0] / (0.5 * kSigma), 1.0, margin(kRuns));
  EXPECT_NEAR(found[1] / (0.5 * kSigma), 1.0, margin(kRuns));
}

TEST(KinematicsScatter, OfAHeadGrowsByTheTouchOfThePole) {
  // Axis C of a fork head with A at 30: the vector is the mean of four places that are turned back.
  // Along X it is that of the equator, sigma^2 / 2; along Y the pole, one touch, has its part:
  // (cos^2 30) sigma^2 / 2 + (sin^2 30) sigma^2.
  MisbelievedMachine machine = misbelieved_machines().at(4);
  machine.truth = machine.believed;
  const std::vector<double> found =
      scatter(machine, "CYCLE9960(40400,\"\",1,25,0,0,270,4,30,0,0,0,0,0,1,3,5,1,1,0,0)",
              {"_OVR[4]", "_OVR[5]"}, kRuns);
  std::printf("head %.4g %.4g um\n", 1000.0 * found[0], 1000.0 * found[1]);
  EXPECT_NEAR(found[0] / (std::sqrt(0.5 / 4.0) * kSigma), 1.0, margin(kRuns));
  EXPECT_NEAR(found[1] / (std::sqrt((0.75 * 0.5 + 0.25) / 4.0) * kSigma), 1.0, margin(kRuns));
}

}  // namespace
}  // namespace g31::testing::kinematics_scatter_test

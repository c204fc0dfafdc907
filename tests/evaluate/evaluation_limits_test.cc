// What an evaluation may take: time and output are limited, and nothing is half-written.

#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"

namespace g31::evaluation_limits_test {
namespace {

using testing::CommandOutput;
using testing::TemporaryFolder;

std::string circle_file(int rows) {
  std::string text = "t,X,Y\n";
  for (int i = 0; i < rows; ++i) {
    const double angle = 6.4 * i / rows;
    text += fmt::format("{:.4f},{:.7f},{:.7f}\n", 0.001 * i, 10.0 * std::cos(angle),
                        10.0 * std::sin(angle));
  }
  return text;
}

class EvaluationLimits : public ::testing::Test {
 protected:
  CommandOutput evaluate(std::vector<std::string> more) {
    std::vector<std::string> words = {"evaluate",
                                      "circle",
                                      file_,
                                      "--json",
                                      folder_.path("c.json"),
                                      "--svg",
                                      folder_.path("c.svg"),
                                      "--curves"};
    words.insert(words.end(), more.begin(), more.end());
    return testing::g31(words);
  }
  [[nodiscard]] bool is_there(const std::string& name) const {
    return std::filesystem::exists(folder_.path(name));
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.write("circle.csv", circle_file(50'000));
};

TEST_F(EvaluationLimits, EndAnEvaluationWhoseTimeIsUp) {
  const CommandOutput output = evaluate({"--max-time", "0.0001"});
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_NE(output.errors.find("the limit of computing time is reached"), std::string::npos)
      << output.errors;
  EXPECT_EQ(output.out, "");
  EXPECT_FALSE(is_there("c.svg"));
}

TEST_F(EvaluationLimits, EndAnEvaluationThatWouldWriteTooMuch) {
  const CommandOutput output = evaluate({"--max-output", "100K"});
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_NE(output.errors.find("the limit of output is reached"), std::string::npos)
      << output.errors;
  EXPECT_EQ(output.out, "");
  EXPECT_FALSE(is_there("c.svg"));
}

TEST_F(EvaluationLimits, LetPassWhatKeepsThem) {
  const CommandOutput output = evaluate({"--max-time", "60", "--max-output", "64M", "--quiet"});
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_TRUE(is_there("c.svg"));
  EXPECT_TRUE(is_there("c.json"));
  EXPECT_EQ(output.errors, "") << "no progress where there is no terminal";
}

TEST_F(EvaluationLimits, AreNumbers) {
  for (const char* const bad : {"0", "-1", "nan", "inf", "soon"}) {
    EXPECT_EQ(evaluate({"--max-time", bad}).exit_code, 2) << bad;
  }
  EXPECT_EQ(evaluate({"--max-output", "much"}).exit_code, 2);
}

}  // namespace
}  // namespace g31::evaluation_limits_test

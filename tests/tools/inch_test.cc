// The result document counts millimetres, whatever unit the program is in.

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::inch_test {
namespace {

testing::RunOutput run_text(const std::string& text) {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("inch.nc", text)};
  options.moves = true;
  options.touches = true;
  return testing::run_program(options);
}

TEST(Inches, MovesAndTouchesAreReportedInMillimetres) {
  const auto run = run_text("G21 G1 X25.4 F254.\nG20 G1 X2. F10.\nG31 Z-1. F5.\nM30\n");
  const auto& moves = run.document["moves"];
  ASSERT_EQ(moves.size(), 3U) << run.errors;
  EXPECT_EQ(moves[0]["to"], (nlohmann::json{25.4, 0.0, 0.0}));
  EXPECT_EQ(moves[0]["feed"], 254.0);
  EXPECT_EQ(moves[1]["to"], (nlohmann::json{50.8, 0.0, 0.0}));
  EXPECT_EQ(moves[1]["feed"], 254.0);
  EXPECT_EQ(run.document["touches"][0]["commanded"], (nlohmann::json{50.8, 0.0, -25.4}));
  EXPECT_EQ(run.document["touches"][0]["feed"], 127.0);
}

TEST(Inches, RoundInAWordRoundsToTheLeastIncrementInInches) {
  // 27/32 = 0.84375 in, at 0.0001 in 0.8438, which is 21.43252 mm
  const auto run = run_text("#101=27/32\nG20\nG0 X[ROUND[#101]]\nM30\n");
  EXPECT_DOUBLE_EQ(run.document["moves"][0]["to"][0], 21.43252) << run.errors;
}

}  // namespace
}  // namespace g31::inch_test

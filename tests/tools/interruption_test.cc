// A command that is interrupted ends soon, with what it did so far told and nothing half-written.

#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"
#include "tests/support/run_program.h"
#include "tests/support/run_study.h"

namespace g31::interruption_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

const runtime::Interruption kAsked = true;
constexpr int kInterrupted = 130;

RunOutput run_interrupted(const TemporaryFolder& folder, const std::string& file,
                          const std::string& program) {
  cli::RunOptions options;
  options.programs = {folder.write(file, program)};
  options.setups = {folder.write(
      "sheet.toml", fmt::format("[machine]\nfile = \"{}\"\n",
                                std::filesystem::absolute("machine/library/v55.toml").string()))};
  if (file.ends_with(".mpf")) {
    options.control = "sinumerik-828d";
  }
  options.trace = folder.path("trace.csv");
  options.budget.interruption = &kAsked;
  return run_program(options);
}

TEST(Interruption, EndsALoopALongBlockAndManyMoves) {
  const struct {
    const char* file;
    const char* program;
  } kRows[] = {{"loop.nc", "O1\nN1 #1=#1+1\nGOTO1\nM30\n"},
               {"loop.mpf", "A: R1=R1+1\nGOTOB A\nM30\n"},
               {"dwell.nc", "O1\nG4 X9999999.\nM30\n"},
               {"dwell.mpf", "G4 F999999\nM30\n"},
               {"moves.nc", "O1\nN1 G0 X1.\nX0.\nGOTO1\nM30\n"},
               {"moves.mpf", "A: G0 X1\nX0\nGOTOB A\nM30\n"}};
  for (const auto& row : kRows) {
    const TemporaryFolder folder;
    const RunOutput run = run_interrupted(folder, row.file, row.program);
    EXPECT_EQ(run.exit_code, kInterrupted) << row.file << "\n" << run.errors;
    EXPECT_NE(run.errors.find("[PRB603]"), std::string::npos) << run.errors;
    ASSERT_TRUE(run.document.is_object()) << row.file;
    EXPECT_EQ(run.document.value("status", ""), "interrupted");
    EXPECT_FALSE(std::filesystem::exists(folder.path("trace.csv"))) << "half of one is none";
  }
}

TEST(Interruption, EndsARunBeforeItBegins) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("short.nc", "O1\nM30\n")};
  options.setups = {"parts/library/ring_gauge/ring.toml"};
  options.budget.interruption = &kAsked;
  const RunOutput run = run_program(options);
  EXPECT_EQ(run.exit_code, kInterrupted) << run.errors;
  ASSERT_TRUE(run.document.is_object());
  EXPECT_EQ(run.document.value("status", ""), "interrupted");
  EXPECT_EQ(run.document["diagnostics"][0].value("code", ""), "PRB603");
}

TEST(Interruption, EndsAStudyWithoutItsFiles) {
  const TemporaryFolder folder;
  cli::StudyOptions options;
  options.study = "parts/library/acceptance/location.toml";
  options.json = folder.path("study.json");
  options.csv = folder.path("study.csv");
  options.interruption = &kAsked;
  const testing::StudyOutput output = testing::run_study(options);
  EXPECT_EQ(output.exit_code, kInterrupted) << output.errors;
  EXPECT_EQ(output.out, "");
  EXPECT_TRUE(folder.names().empty());
}

TEST(Interruption, EndsAnEvaluationWithoutItsFiles) {
  const TemporaryFolder folder;
  cli::EvaluateOptions options;
  options.kind = "positioning";
  options.file = folder.write("rows.csv",
                              "axis,target,direction,cycle,position\nX,0,1,1,0.001\nX,0,1,2,0."
                              "002\nX,9,1,1,9\nX,9,1,2,9.001\n");
  options.svg = folder.path("plot.svg");
  const testing::EvaluateOutput whole = testing::run_evaluate(options);
  EXPECT_EQ(whole.exit_code, 0) << whole.errors;
  options.svg = folder.path("other.svg");
  options.interruption = &kAsked;
  const testing::EvaluateOutput output = testing::run_evaluate(options);
  EXPECT_EQ(output.exit_code, kInterrupted) << output.errors;
  EXPECT_EQ(folder.names().size(), 2U);
}

}  // namespace
}  // namespace g31::interruption_test

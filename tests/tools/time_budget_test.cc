// --max-time within one block that lasts for ever: exit code 6, and what was written is whole.

#include "interpreter/runtime/time_budget.h"

#include <chrono>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/probe/test_meshes.h"
#include "tests/support/run_program.h"
#include "tests/support/run_study.h"
#include "tools/session/world.h"
#include "tools/setup/toml_reader.h"

namespace g31::time_budget_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr double kLimitS = 0.3;

constexpr const char* kFriction =
    "[machine.axes.X]\nservo_gain = 3.0\nvelocity_gain = 200.0\nfriction = 100.0\n";
constexpr const char* kRing =
    "[probe]\nball_diameter = 6.0\nlength = 100.0\n[[part]]\nname = \"ring\"\nshape = \"ring\"\n"
    "bore = 40.0\nouter_diameter = 60.0\nheight = 20.0\n";

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(TimeBudget, EndsABlockThatLastsForEver) {
  const struct {
    const char* name;
    const char* program;
    const char* sheet;
    bool traces;
  } kCases[] = {
      {"a dwell of years with a trace", "O1\nG4X99999999.\nM30\n", "", true},
      {"a move of days with a trace", "O1\nG9G1X999.F0.001\nM30\n", "", true},
      {"a move of days against friction", "O1\nG1X999.F0.001\nM30\n", kFriction, false},
      {"a circle of days against friction", "O1\nG2I500.F0.001\nM30\n", kFriction, false},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.name);
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write("long.nc", c.program)};
    options.setups = {folder.write("sheet.toml", c.sheet)};
    options.budget.wall_seconds = kLimitS;
    options.max_output = 100'000'000'000;
    options.trace = c.traces ? folder.path("t.csv") : "";
    const auto start = std::chrono::steady_clock::now();
    const RunOutput output = run_program(options);
    EXPECT_LT(seconds_since(start), kLimitS + 5.0);
    EXPECT_EQ(output.exit_code, 6);
    EXPECT_EQ(output.document.at("status"), "budget");
    EXPECT_EQ(output.document.at("diagnostics").back().at("code"), "PRB602");
    EXPECT_EQ(output.document.at("diagnostics").back().at("line"), 2);
    if (c.traces) {
      EXPECT_EQ(testing::text_of(options.trace).back(), '\n');
    }
  }
}

TEST(TimeBudget, HoldsWhereEachPassOfALoopReadsALargeFile) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(
      "read.mpf", "DEF INT E,I\nDEF STRING[200] T\nFOR I=1 TO 40000\nWRITE(E,\"F\",\"" +
                      std::string(190, 'X') +
                      "\")\nENDFOR\nLOOP\nREAD(E,\"F\",40000,1,T)\nENDLOOP\nM30\n")};
  options.budget.wall_seconds = 1.0;
  const auto start = std::chrono::steady_clock::now();
  const RunOutput output = run_program(options);
  EXPECT_LT(seconds_since(start), 1.0 + 5.0);
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_EQ(output.document.at("diagnostics").back().at("code"), "PRB602");
  EXPECT_EQ(output.document.at("diagnostics").back().at("line"), 7) << "READ";
}

TEST(TimeBudget, CountsTheReadingOfParts) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("short.nc", "O1\nM30\n")};
  options.setups = {folder.write("sheet.toml", kRing)};
  options.budget.wall_seconds = 1e-9;
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_NE(output.errors.find("the limit of computing time is reached with the reading of part "
                               "ring: --max-time raises it"),
            std::string::npos)
      << output.errors;
  EXPECT_EQ(output.document["status"], "budget");
}

/// What comes behind the reading: a mesh of 14,000 facets, more than are worked on unasked.
TEST(TimeBudget, HoldsForTheTreesOverParts) {
  TemporaryFolder folder;
  const std::vector<std::string> sheets = {folder.write("sheet.toml", kRing)};
  const auto job = setup::read_job(sheets);
  ASSERT_TRUE(job.ok());
  const std::vector<probe::ProbedPart> parts = {{"ball", testing::sphere_mesh(10.0, 60)}};
  EXPECT_TRUE(session::sensed_parts(job.value(), parts).ok());
  const runtime::TimeBudget spent(-1.0);
  const auto late = session::sensed_parts(job.value(), parts, &spent);
  ASSERT_FALSE(late.ok());
  EXPECT_EQ(late.error().ending, session::Ending::Budget);
  EXPECT_EQ(late.error().message,
            "the limit of computing time is reached with the trees over the parts: --max-time "
            "raises it");
  const runtime::Interruption is_asked_for = true;
  const runtime::TimeBudget interrupted(600.0, &is_asked_for);
  const auto broken_off = session::sensed_parts(job.value(), parts, &interrupted);
  ASSERT_FALSE(broken_off.ok());
  EXPECT_EQ(broken_off.error().ending, session::interrupted().ending);
}

TEST(TimeBudget, HoldsForEachRunOfAStudy) {
  TemporaryFolder folder;
  folder.write("long.nc", "O1\nG1X999.F0.001\nM30\n");
  folder.write("sheet.toml", kFriction);
  cli::StudyOptions options;
  options.study = folder.write("study.toml",
                               "[study]\nprogram = \"long.nc\"\nsetup = \"sheet.toml\"\n"
                               "max_time = 0.2\n[results.r]\nvalue = \"#100\"\n");
  const auto ended = testing::study_document(options);
  EXPECT_EQ(nlohmann::json::parse(ended.out).at("rows").at(0).at("status"), "budget");
}

}  // namespace
}  // namespace g31::time_budget_test

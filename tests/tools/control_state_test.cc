// What a control keeps from run to run, and its clocks: on the whole machine, where time passes.

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::control_state_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;
using testing::text_of;

RunOutput run(const TemporaryFolder& folder, const std::string& program, const std::string& sheet,
              const std::string& print = "#100") {
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\n" + program + "\nM30\n")};
  options.setups = {folder.write("sheet.toml", sheet)};
  options.prints = {print};
  return run_program(options);
}

constexpr const char* kKeeping = "[control]\nvariables_file = \"machine.vars\"\n";

TEST(PermanentVariables, OutliveTheRunAndVolatileOnesDoNot) {
  const TemporaryFolder folder;
  EXPECT_EQ(run(folder, "#500=1.5\n#999=-0.1\n#100=7\n#1=8", kKeeping).exit_code, 0);
  EXPECT_EQ(text_of(folder.path("machine.vars")), "#500=1.5\n#999=-0.1\n");
  const RunOutput next = run(folder, "#101=#500\n#102=#999\n#103=#1", kKeeping, "#100-#103");
  EXPECT_EQ(next.document["variables"]["#100"], nullptr);
  EXPECT_EQ(next.document["variables"]["#101"], 1.5);
  EXPECT_EQ(next.document["variables"]["#102"], -0.1);
  EXPECT_EQ(next.document["variables"]["#103"], nullptr);
}

TEST(PermanentVariables, LeaveTheFileWhenTheyBecomeNull) {
  const TemporaryFolder folder;
  run(folder, "#500=1\n#501=2", kKeeping);
  run(folder, "#500=#0", kKeeping);
  EXPECT_EQ(text_of(folder.path("machine.vars")), "#501=2\n");
}

TEST(PermanentVariables, AreSavedAfterAnAlarm) {
  const TemporaryFolder folder;
  EXPECT_EQ(run(folder, "#500=3\n#3000=1(STOP)", kKeeping).exit_code, 3);
  EXPECT_EQ(text_of(folder.path("machine.vars")), "#500=3\n");
}

TEST(PermanentVariables, AreNotTouchedByARefusedProgram) {
  const TemporaryFolder folder;
  const std::string before = "; by hand\n#500=3\n";
  folder.write("machine.vars", before);
  EXPECT_EQ(run(folder, "#500=[1+", kKeeping).exit_code, 2);
  EXPECT_EQ(text_of(folder.path("machine.vars")), before);
}

TEST(PermanentVariables, StandBehindTheSheetAndTheCommandLine) {
  const TemporaryFolder folder;
  folder.write("machine.vars", "#500=1\n#501=1\n#502=1\n");
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\nM30\n")};
  options.setups = {folder.write(
      "sheet.toml", std::string(kKeeping) + "[variables]\n\"#501\" = 2\n\"#502\" = 2\n")};
  options.assignments = {"#502=3"};
  options.prints = {"#500-#502"};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.document["variables"]["#500"], 1);
  EXPECT_EQ(output.document["variables"]["#501"], 2);
  EXPECT_EQ(output.document["variables"]["#502"], 3);
}

TEST(PermanentVariables, LeaveNoPartOfAFileBehind) {
  const TemporaryFolder folder;
  run(folder, "#500=1", kKeeping);
  EXPECT_EQ(folder.names().size(), 3U) << "program, sheet and variables";
}

TEST(Clocks, RunWithSimulatedTime) {
  struct Case {
    const char* name;
    const char* program;
    double value;
  };
  const Case kCases[] = {
      {"the timer counts milliseconds", "G4P2500\n#100=#3001", 2500},
      {"from what it was set to", "#3001=100\nG4X1.\n#100=#3001", 1100},
      {"and starts again at 2^31", "#3001=2147483.*1000\nG4X1.\n#100=#3001", 352},
      {"hours", "G4X1800.\n#100=#3002", 0.5},
      {"from what they were set to", "#3002=10\nG4X1800.\n#100=#3002", 10.5},
      {"the day begins at midnight", "#100=#3012", 0},
      {"time of day has no leading zero", "G4X33010.\n#100=#3012", 91010},
      {"the date without a sheet", "#100=#3011", 20000101},
      {"midnight passes", "G4X86400.\n#100=#3011", 20000102},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const TemporaryFolder folder;
    EXPECT_NEAR(run(folder, c.program, "").document["variables"]["#100"].get<double>(), c.value,
                1e-9);
  }
}

TEST(Clocks, GoOnFromTheSheetsDate) {
  const TemporaryFolder folder;
  const RunOutput output =
      run(folder, "G4X2.\n#100=#3011\n#101=#3012",
          "[variables]\n\"#3011\" = 20240228\n\"#3012\" = 235959\n", "#100,#101");
  EXPECT_EQ(output.document["variables"]["#100"], 20240229) << "2024 is a leap year";
  EXPECT_EQ(output.document["variables"]["#101"], 1);
}

}  // namespace
}  // namespace g31::control_state_test

// One meaning of an exit code in both dialects, what --fail-on and comments of programs make of it,
// and names of --print, which are looked at before the run.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_arguments.h"
#include "tests/support/run_program.h"
#include "tests/support/run_study.h"

namespace g31::exit_codes_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

RunOutput run_of(const std::string& file, const std::string& program, const std::string& sheet = {},
                 const std::vector<std::string>& prints = {}) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(file, program)};
  if (!sheet.empty()) {
    options.setups = {folder.write("sheet.toml", sheet)};
  }
  options.prints = prints;
  return run_program(options);
}

std::vector<std::string> codes_of(const RunOutput& output) {
  std::vector<std::string> codes;
  for (const auto& message : output.document.at("diagnostics")) {
    codes.push_back(message.at("code"));
  }
  return codes;
}

using Codes = std::vector<std::string>;

TEST(ExitCodes, MeanTheSameInBothDialects) {
  const std::string tool = "[tools.1]\nlength = 1.0\nname = \"PROBE\"\n";
  const struct {
    const char* name;
    const char* file;
    const char* program;
    std::string sheet;
    int exit_code;
    const char* status;
    int alarm;  ///< 0: none
  } kCases[] = {
      {"Fanuc, syntax", "a.nc", "O1\n#1=[2+\nM30\n", "", 2, "alarm", 114},
      {"SINUMERIK, syntax", "a.mpf", "R1=(2+\nM30\n", "", 2, "alarm", 12080},
      {"SINUMERIK, an end is missing", "a.mpf", "IF R1==0\nM30\n", "", 2, "alarm", 12640},
      {"Fanuc, no program", "a.nc", "", "", 2, "usage", 0},
      {"SINUMERIK, wrong block that nobody reaches", "a.mpf", "M30\nR1=(2+\n", "", 0, "completed",
       0},
      {"Fanuc, wrong block that nobody reaches", "a.nc", "O1\nM30\n#1=[2+\n", "", 0, "completed",
       0},
      {"Fanuc, missing subprogram", "a.nc", "O1\nM98 P77\nM30\n", "", 3, "alarm", 78},
      {"SINUMERIK, missing subprogram", "a.mpf", "CALL \"L77\"\nM30\n", "", 3, "alarm", 14011},
      {"Fanuc, missing jump", "a.nc", "O1\nGOTO7\nM30\n", "", 3, "alarm", 128},
      {"SINUMERIK, missing jump", "a.mpf", "GOTOF N7\nM30\n", "", 3, "alarm", 14080},
      {"Fanuc, missing tool", "a.nc", "O1\nG43 H2 Z1.\nM30\n", tool, 5, "setup", 0},
      {"SINUMERIK, missing tool", "a.mpf", "T2 M6\nM30\n", tool, 5, "setup", 0},
      {"SINUMERIK, missing tool by name", "a.mpf", "T=\"MILL\" M6\nM30\n", tool, 5, "setup", 17191},
      {"Fanuc, no touch", "a.nc", "O1\nG31 X9. F100.\n#100=#5061\nM30\n", "", 1, "completed", 0},
      {"SINUMERIK, no touch", "a.mpf", "MEAS=1 G1 X9 F100\nR1=$AA_MW[X]\nM30\n", "", 1, "completed",
       0},
      {"Fanuc, no touch, nobody reads it", "a.nc", "O1\nG31 X9. F100.\nM30\n", "", 1, "completed",
       0},
      {"SINUMERIK, no touch, nobody reads it", "a.mpf", "MEAS=1 G1 X9 F100\nM30\n", "", 1,
       "completed", 0},
      {"Fanuc, no touch, compared", "a.nc", "O1\nG31 X9. F100.\nIF[#5061GT8.]GOTO1\nN1M30\n", "", 0,
       "completed", 0},
      {"SINUMERIK, no touch, compared", "a.mpf",
       "MEAS=1 G1 X9 F100\nIF $AA_MW[X]>8 GOTOF E1\nE1: M30\n", "", 0, "completed", 0},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.name);
    const RunOutput output = run_of(c.file, c.program, c.sheet);
    EXPECT_EQ(output.exit_code, c.exit_code) << output.errors;
    ASSERT_TRUE(output.document.is_object());
    EXPECT_EQ(output.document.at("status"), c.status);
    EXPECT_EQ(output.document.value("/alarm/number"_json_pointer, 0), c.alarm) << output.errors;
  }
}

TEST(Prints, AreNamesBeforeTheRun) {
  for (const auto& [file, program, name] :
       {std::tuple("a.nc", "O1\nG0X5.\n#3000=1(STOP)\nM30\n", "#99999999"),
        std::tuple("a.mpf", "G0 X5\nSETAL(65001)\nM30\n", "NO_SUCH_NAME")}) {
    const RunOutput output = run_of(file, program, "", {name});
    EXPECT_EQ(output.exit_code, 2) << output.errors;
    EXPECT_NE(output.errors.find("--print: "), std::string::npos) << output.errors;
    EXPECT_NE(output.errors.find(name), std::string::npos) << output.errors;
    EXPECT_EQ(output.errors.find("STOP"), std::string::npos) << "nothing has run";
  }
}

TEST(Prints, ThatCannotBeReadAtTheEndHideNoAlarm) {
  // The expression is one; its index is wrong only once R1 is.
  const std::string head = "DEF REAL A[3]\nR1=7\n";
  const RunOutput alarm = run_of("a.mpf", head + "SETAL(65001)\nM30\n", "", {"A[R1]"});
  EXPECT_EQ(alarm.exit_code, 3) << alarm.errors;
  EXPECT_EQ(alarm.document.at("alarm").at("number"), 65001);
  EXPECT_TRUE(alarm.document.at("variables").at("A[R1]").is_null());
  EXPECT_NE(alarm.errors.find("--print: A[R1]: "), std::string::npos) << alarm.errors;
  const RunOutput completed = run_of("a.mpf", head + "M30\n", "", {"A[R1]"});
  EXPECT_EQ(completed.exit_code, 2) << completed.errors;
  EXPECT_EQ(completed.document.at("status"), "completed");
}

TEST(FailOn, SaysWhichMessagesAreFindings) {
  // PRB301 is a warning, PRB324 a note.
  const struct {
    const char* program;
    const char* fail_on;
    int exit_code;
  } kCases[] = {
      {"O1\nG31 X9. F100.\nM30\n", "error", 0}, {"O1\nG31 X9. F100.\nM30\n", "warning", 1},
      {"O1\nG31 X9. F100.\nM30\n", "note", 1},  {"O1\nM06\nM30\n", "error", 0},
      {"O1\nM06\nM30\n", "warning", 0},         {"O1\nM06\nM30\n", "note", 1},
      {"O1\n#3000=1(NO)\nM30\n", "error", 3}};
  for (const auto& c : kCases) {
    SCOPED_TRACE(std::string(c.program) + c.fail_on);
    const TemporaryFolder folder;
    const auto options =
        testing::parsed_run_options({folder.write("a.nc", c.program), "--fail-on", c.fail_on});
    ASSERT_TRUE(options.ok());
    const RunOutput output = run_program(options.value());
    EXPECT_EQ(output.exit_code, c.exit_code) << output.errors;
  }
  EXPECT_FALSE(testing::parsed_run_options({"a.nc", "--fail-on", "hint"}).ok());
}

TEST(Allow, CommentsOfProgramsSilenceTheirLines) {
  const struct {
    const char* name;
    const char* file;
    const char* program;
    Codes codes;
  } kCases[] = {
      {"its own line",
       "a.nc",
       "O1\nG31 X9. F100. (g31: allow PRB301 nothing may be there)\nM30\n",
       {}},
      {"the next line", "a.nc", "O1\nG0X0\n(G31: ALLOW PRB301)\n\nG31 X9. F100.\nM30\n", {}},
      {"the next line only",
       "a.nc",
       "O1\nG0X0\n(G31: ALLOW PRB301)\nG31 X9. F100.\n#1=#5061\nG31 X19. F100.\n#2=#5061\nM30\n",
       {"PRB301"}},
      {"the file",
       "a.nc",
       "%\nO1 (HEAD)\n(g31: allow PRB301, PRB324 both)\nM6\nG31 X9. F100.\nM30\n",
       {}},
      {"beside the number of the program",
       "a.nc",
       "O1(g31: allow PRB301)\nG0X0\nG31X9.F100.\nM30\n",
       {}},
      {"another code",
       "a.nc",
       "O1\nG31 X9. F100. (g31: allow PRB316)\nM30\n",
       {"PRB301", "PRB326"}},
      {"no code", "a.nc", "O1\nG0X0 (g31: allow)\nM30\n", {"PRB326"}},
      {"behind its line",
       "a.nc",
       "O1\nG31 X9. F100.\n(g31: allow PRB301)\nM30\n",
       {"PRB301", "PRB326"}},
      {"of a check", "a.nc", "O1\nM30 (g31: disable=NC012)\n", {}},
      {"an alarm stays", "a.nc", "O1\n(g31: allow PRB401)\nG99.9\nM30\n", {"10"}},
      {"its own line", "a.mpf", "MEAS=1 G1 X9 F100 ; g31: allow PRB301 reason\nM30\n", {}},
      {"the next line", "a.mpf", "G0 X0\n; G31: ALLOW PRB301\nMEAS=1 G1 X9 F100\nM30\n", {}},
      {"the file", "a.mpf", "%_N_A_MPF\n; g31: allow PRB301\nG0 X0\nMEAS=1 G1 X9 F100\nM30\n", {}},
      {"a text is no comment",
       "a.mpf",
       "MEAS=1 G1 X9 F100\nMSG(\"; g31: allow PRB301\")\nM30\n",
       {"PRB301"}},
      {"brackets are none",
       "a.mpf",
       "G0 X0\nMEAS=1 G1 X9 F100 ; (g31: allow PRB301)\nM30\n",
       {"PRB301"}},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(std::string(c.file) + ", " + c.name);
    const RunOutput output = run_of(c.file, c.program);
    EXPECT_EQ(codes_of(output), c.codes) << output.errors;
  }
}

TEST(Allow, TakesCodesInSmallLetters) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nG31 X9. F100.\nM30\n");
  for (const char* const code : {"PRB301", "prb301", "Prb301"}) {
    const auto options = testing::parsed_run_options({program, "--allow", code});
    ASSERT_TRUE(options.ok()) << options.error();
    EXPECT_EQ(run_program(options.value()).exit_code, 0) << code;
  }
  EXPECT_FALSE(testing::parsed_run_options({program, "--allow", "prb999"}).ok());
}

TEST(Allow, ACommentWithoutUseHasItsPlace) {
  const RunOutput output = run_of("a.nc", "O1\nG0X0 (g31: allow PRB301 old)\nM30\n");
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_NE(output.errors.find(
                "a.nc:2:6: note: the comment g31: allow has no use: no PRB301 comes here [PRB326]\n"
                "    2 | G0X0 (g31: allow PRB301 old)\n"
                "      |      ^\n"),
            std::string::npos)
      << output.errors;
}

TEST(Study, SaysWhyItDoesNotExitWithZero) {
  const TemporaryFolder folder;
  folder.write("p.nc", "O1\nG31 X9. F100.\n#101=#5061\nM30\n");
  cli::StudyOptions options;
  options.study = folder.write(
      "study.toml", "[study]\nprogram = \"p.nc\"\nrepeats = 2\n[results.a]\nvalue = \"#101\"\n");
  const auto output = testing::run_study(options);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.errors.find("g31: warning: 2 of 2 runs completed with findings; run 1: "),
            std::string::npos)
      << output.errors;
  EXPECT_NE(output.errors.find("p.nc:2:1: warning: "), std::string::npos) << output.errors;
  folder.write("p.nc", "O1\nG31 X9. F100. (g31: allow PRB301)\n#101=#5061\nM30\n");
  EXPECT_EQ(testing::run_study(options).exit_code, 0);
}

}  // namespace
}  // namespace g31::exit_codes_test

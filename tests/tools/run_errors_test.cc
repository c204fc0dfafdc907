// What a user can do wrong with `g31 run`: each gets its place, its words, its exit code, and
// nothing is written.

#include <filesystem>
#include <functional>

#include <gtest/gtest.h>

#include "machine/base/contract.h"
#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/run_command.h"
#include "tools/cli/run_refusal.h"

namespace g31::run_errors_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

struct Case {
  const char* name;
  const char* program;
  int exit_code;
  const char* says;  ///< part of standard error, behind the folder
};

TEST(RunErrors, OfTheProgramHaveAPlaceAndTheirCode) {
  const Case kCases[] = {
      {"a missing operand", "O1\n#1=[2+\nM30\n", 2,
       "case.nc:2:7: error: FORMAT ERROR IN MACRO: the block ends where a value is expected [114]\n"
       "    2 | #1=[2+\n"
       "      |       ^\n"},
      {"an unclosed bracket", "O1\n#1=[2\nM30\n", 2, "case.nc:2:4: error:"},
      {"a statement and words", "O1\nG01X1.#1=2\nM30\n", 2, "[127]"},
      {"END without DO", "O1\nEND1\nM30\n", 2, "case.nc:2:1: error:"},
      {"a missing subprogram", "O1\nG65 P1234\nM30\n", 3, "case.nc:2:5: error: NUMBER NOT FOUND"},
      {"division by zero", "O1\n#2=1/#1\nM30\n", 3,
       "case.nc:2:4: error: DIVIDED BY ZERO: the divisor is vacant [112]"},
      {"an unknown G code", "O1\nG99.9 X1.\nM30\n", 3, "case.nc:2:1: error: IMPROPER G-CODE"},
      {"no such block", "O1\nGOTO 7\nM30\n", 3, "[128]"},
      {"no end", "O1\nG00 X1.\n", 3, "[5010]"},
      {"an endless loop", "O1\nN1 GOTO 1\nM30\n", 6,
       "case.nc:2:1: error: the limit of executed blocks"},
      {"endless recursion", "O1\nG65 P1\nM30\n", 3, "called from O0001"},
      {"no feed", "O1\nG01 X1.\nM30\n", 3, "[11]"},
      {"nothing in the file", "", 2, "no program in this file"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write("case.nc", c.program)};
    options.budget.blocks = 1000;
    const RunOutput output = run_program(options);
    EXPECT_EQ(output.exit_code, c.exit_code);
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
    EXPECT_TRUE(output.document.is_object());
    EXPECT_EQ(folder.names().size(), 1U);
  }
}

TEST(RunErrors, OfTheSetupHaveAPlaceAndTheirCode) {
  const Case kCases[] = {
      {"an unknown key", "[probe]\nball_diamter = 6\n", 2,
       "sheet.toml:2:1: error: unknown key ball_diamter in [probe], did you mean ball_diameter? "
       "[SET103]"},
      {"a mesh that is not there", "[[part]]\nfile = \"no.stl\"\n", 5,
       "sheet.toml:2:8: error: there is no file"},
      {"a mesh that is none", "[[part]]\nfile = \"sheet.toml\"\n", 5,
       "sheet.toml:2:8: error: mesh file"},
      {"a ring without wall", "[[part]]\nshape = \"ring\"\nbore = 40.0\nouter_diameter = 30.0\n", 5,
       "sheet.toml:2:9: error:"},
      {"an unknown control", "[control]\nprofile = \"fanuk-16i\"\n", 5,
       "did you mean 'fanuc-16i'?"},
      {"a tool that the sheet has not", "[tools.1]\nlength = 1.0\n", 5,
       "H2 is not in the tool table"},
      {"an offset that the sheet has not", "[work_offsets.G59]\nX = 1.0\n", 5,
       "G54 is not among the work offsets"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write("case.nc", "O1\nG54\nG43 H2 Z1.\nM30\n")};
    options.setups = {folder.write("sheet.toml", c.program)};
    const RunOutput output = run_program(options);
    EXPECT_EQ(output.exit_code, c.exit_code);
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
    EXPECT_EQ(folder.names().size(), 2U);
  }
}

TEST(RunErrors, OfSettableFramesThatTheSheetLeavesOut) {
  for (const auto& [program, says] :
       {std::pair("G54 G0 X0\nG55 X0\nM30\n",
                  "case.mpf:2:1: error: G55 is not among the work offsets of the set-up sheet"),
        std::pair("G512 X0\nM30\n", "case.mpf:1:1: error: G512 is not among")}) {
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write("case.mpf", program)};
    options.setups = {folder.write("sheet.toml", "[work_offsets.G54]\nX = 1.0\n")};
    const RunOutput output = run_program(options);
    EXPECT_EQ(output.exit_code, 5);
    EXPECT_NE(output.errors.find(says), std::string::npos) << output.errors;
  }
}

TEST(RunErrors, OfAWorkOffsetThatIsMissingHaveTheNameOfTheProgram) {
  for (const auto& [control, code, says] :
       {std::tuple("haas", "G154 P2", "error: G154 P2 is not"),
        std::tuple("haas", "G111", "error: G154 P2 is not"),
        std::tuple("haas", "G55", "error: G55 is not"),
        std::tuple("fanuc-30i", "G54.1 P2", "error: G54.1 P2 is not"),
        std::tuple("fanuc-30i", "G54 P2", "error: G54.1 P2 is not")}) {
    TemporaryFolder folder;
    cli::RunOptions options;
    options.control = control;
    options.programs = {folder.write("case.nc", std::string("O1\n") + code + "\nM30\n")};
    options.setups = {folder.write("sheet.toml", "[work_offsets.G54]\nX = 1.0\n")};
    const RunOutput output = run_program(options);
    EXPECT_EQ(output.exit_code, 5);
    EXPECT_NE(output.errors.find(says), std::string::npos) << output.errors;
  }
}

TEST(RunErrors, OfSettingsThatTheControlRefusesHaveTheirPlaceInTheSheet) {
  const std::string sheet =
      "[variables]\n\"#500\" = 1.0\n\"#5001\" = 3.0\n[tools.99999]\nlength = 2.0\n"
      "[gud]\n\"_A\" = 3\n";
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\nM30\n")};
  options.setups = {folder.write("sheet.toml", sheet)};
  options.assignments = {"#5002=1"};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 5);
  for (const char* says :
       {"sheet.toml:3:11: error: variable #5001: cannot be set on this control [SET126]\n"
        "    3 | \"#5001\" = 3.0\n",
        "sheet.toml:4:8: error: tool 99999: offset numbers are 1 to 999 [SET126]",
        "sheet.toml:7:8: error: machine data and user data are of SINUMERIK [SET126]",
        "--set #5002=1: error: variable #5002: cannot be set on this control [SET126]"}) {
    EXPECT_NE(output.errors.find(says), std::string::npos) << output.errors;
  }
}

TEST(RunErrors, OfAVariablesFileHaveTheirLine) {
  const Case kCases[] = {
      {"no assignment", "#500=1\nnonsense\n", 2, "kept.vars:2:1: error: "},
      {"a system variable", "; of the machine\n#500=1\n\n#5001=2\n", 5,
       "kept.vars:4:1: error: variable #5001: cannot be set on this control [SET126]"},
      {"a local variable", "#500=1\n#26=2\n", 5,
       "kept.vars:2:1: error: variable #26: a local variable, which no control keeps [SET126]"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write("case.nc", "O1\nM30\n")};
    options.setups = {folder.write("sheet.toml", "[control]\nvariables_file = \"kept.vars\"\n")};
    const std::string path = folder.write("kept.vars", c.program);
    const RunOutput output = run_program(options);
    EXPECT_EQ(output.exit_code, c.exit_code);
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
    EXPECT_EQ(folder.names().size(), 3U);
  }
}

TEST(RunErrors, OfTheCommandLineAreWrongUsage) {
  TemporaryFolder folder;
  cli::RunOptions plain;
  plain.programs = {folder.write("case.nc", "O1\nM30\n")};
  cli::RunOptions no_program = plain;
  no_program.programs = {folder.path("none.nc")};
  cli::RunOptions no_folder = plain;
  no_folder.libraries = {folder.path("none")};
  cli::RunOptions bad_value = plain;
  bad_value.assignments = {"#1=x"};
  cli::RunOptions bad_name = plain;
  bad_name.prints = {"nonsense"};
  for (const auto& [options, says] :
       {std::pair{no_program, "cannot read the program"}, std::pair{no_folder, "no such folder"},
        std::pair{bad_value, "--set #1=x"}, std::pair{bad_name, "nonsense is not a variable"}}) {
    const RunOutput output = run_program(options);
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_NE(output.errors.find(says), std::string::npos) << output.errors;
    EXPECT_EQ(output.document.at("status"), "usage");
    EXPECT_EQ(output.document.at("exit_code"), 2);
  }
}

TEST(RunErrors, AnOutputThatHasNoPlaceIsToldBeforeTheRun) {
  TemporaryFolder folder;
  const std::string json = folder.path("none/result.json");
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\n#500=1\nM30\n")};
  options.setups = {folder.write("sheet.toml", "[control]\nvariables_file = \"kept.vars\"\n")};
  options.json = json;
  const auto said = testing::captured([&] { return cli::run_command(options); });
  EXPECT_EQ(said.errors,
            "g31: error: --json " + json + ": cannot write: No such file or directory\n");
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(folder.names().size(), 2U) << "no variables were kept";
}

TEST(RunErrors, AVariablesFileThatCannotBeReadIsNotReplaced) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("kept.vars"));
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\nM30\n")};
  options.setups = {folder.write("sheet.toml", "[control]\nvariables_file = \"kept.vars\"\n")};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("cannot read the variables file " + folder.path("kept.vars") +
                               ": it is a folder\n"),
            std::string::npos)
      << output.errors;
}

TEST(RunErrors, ADefectBeforeARunBeginsHasItsDocument) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.path("case.nc")};
  options.json = folder.path("result.json");
  ::testing::internal::CaptureStderr();
  const auto code = cli::run_or_tell(options, []() -> Result<cli::ExitCode, session::Refusal> {
    contract_violated("a machine has axes", "world.cc", 1);
  });
  EXPECT_EQ(static_cast<int>(code), 70);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "g31: defect: world.cc:1: contract violated: a machine has axes\n"
            "g31: defect: nothing has run\n");
  const auto document = nlohmann::json::parse(testing::text_of(options.json));
  EXPECT_EQ(document["status"], "defect");
  EXPECT_EQ(document["program"], "case.nc");
  EXPECT_TRUE(document["alarm"].is_null());
  EXPECT_EQ(document["diagnostics"][0]["code"], "PRB606");
  EXPECT_EQ(document["diagnostics"][0]["message"],
            "world.cc:1: contract violated: a machine has axes");
}

TEST(RunDocument, HasTheShapeOfTheContract) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("case.nc",
                                   "O1\n#100=1.5\nG00 X10.\nG04 P250\nG31 X20. F100\n"
                                   "#101=#5061\n#3006=1(LOOK)\nM30\n")};
  options.setups = {folder.write("sheet.toml", "[[skip_signal]]\naxis = \"X\"\nat = 15.0\n")};
  options.prints = {"#100-#102"};
  options.moves = true;
  options.touches = true;
  const RunOutput output = run_program(options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const auto& d = output.document;
  EXPECT_EQ(d.at("schema"), "g31.run/1");
  EXPECT_EQ(d.at("program"), "case.nc");
  EXPECT_EQ(d.at("control"), "fanuc-16i");
  EXPECT_EQ(d.at("status"), "completed");
  EXPECT_TRUE(d.at("alarm").is_null());
  EXPECT_EQ(d.at("variables").dump(), R"({"#100":1.5,"#101":15.0,"#102":null})");
  EXPECT_EQ(d.at("stops").at(0).at("text"), "LOOK");
  EXPECT_EQ(d.at("moves").at(0).at("g"), 0);
  EXPECT_EQ(d.at("moves").at(1).dump(), R"({"g":4,"t":0.25,"to":[10.0,0.0,0.0]})");
  EXPECT_EQ(d.at("moves").at(2).at("to").dump(), "[15.0,0.0,0.0]");
  const auto& touch = d.at("touches").at(0);
  EXPECT_EQ(touch.at("block"), "G31");
  EXPECT_EQ(touch.at("line"), 5);
  EXPECT_TRUE(touch.at("triggered").get<bool>());
  EXPECT_EQ(touch.at("commanded").dump(), "[20.0,0.0,0.0]");
  EXPECT_TRUE(touch.at("contact").is_null());
  EXPECT_EQ(d.at("blocks"), 8);
  // Of 3.142 s without the dwell: 5 mm at 100 mm/min are 3 s, sqrt(4 x 10 mm / 2 m/s^2) the rapid,
  // and speeding up to the feed takes 100/60/2000 s / 2 more.
  EXPECT_NEAR(d.at("machine_time_s").get<double>(), 3.392, 0.001);
}

TEST(VariablesFile, KeepsThePermanentVariables) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\n#500=#500+1.25\n#100=7\nM30\n")};
  options.setups = {folder.write("sheet.toml", "[control]\nvariables_file = \"kept.vars\"\n")};
  options.prints = {"#500,#100"};
  EXPECT_EQ(run_program(options).document.at("variables").at("#500"), 1.25);
  const RunOutput second = run_program(options);
  EXPECT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_EQ(second.document.at("variables").at("#500"), 2.5);
}

}  // namespace
}  // namespace g31::run_errors_test

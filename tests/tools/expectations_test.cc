// What a run is expected to come to: [expect] of a sheet and --expect.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"
#include "tools/expect/expectation.h"

namespace g31::expectations_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr const char* kProgram =
    "O1\n#100=20.0004\nPOPEN\nDPRNT[X#100[33]]\nPCLOS\nG31 X20. F600.\n#101=#5061\nM30\n";
constexpr const char* kSignal =
    "[work_offsets.G54]\nX = 1.5\n[[skip_signal]]\naxis = \"X\"\nat = 15.0\n";

RunOutput run_with(const std::string& program, const std::string& sheet,
                   const std::vector<std::string>& expects = {}, const char* file = "a.nc") {
  const TemporaryFolder folder;
  folder.write("out.txt", "X  20.000\n");
  folder.write("other.txt", "X  20.001\n");
  cli::RunOptions options;
  options.programs = {folder.write(file, program)};
  options.setups = {folder.write("sheet.toml", sheet)};
  options.expects = expects;
  return run_program(options);
}

TEST(Expectations, OfASheetHoldOrFailEachWithItsPlace) {
  const struct {
    const char* expect;
    const char* fails;  ///< "": it holds
  } kCases[] = {
      {"status = \"completed\"", ""},
      {"status = \"alarm\"", "status: expected alarm, got completed"},
      {"alarm = 3001", "alarm: expected 3001, got completed"},
      {"variables = { \"#100\" = [20.0, 1e-3] }", ""},
      {"variables = { \"#100\" = [20.0, 4e-4] }", ""},
      {"variables = { \"#100\" = [20.0, 3.9e-4] }", "#100: expected 20 +- 0.00039, got 20.0004"},
      {"variables = { \"#100\" = 20.0004 }", ""},
      {"variables = { \"#7\" = \"vacant\", \"#100\" = [20, 1] }", ""},
      {"variables = { \"#100\" = \"vacant\" }", "#100: expected vacant, got 20.0004"},
      {"variables = { \"#7\" = [0.0, 1.0] }", "#7: expected 0 +- 1, got vacant"},
      {"work_offsets.G54 = { X = [1.5, 1e-6], Y = 0 }", ""},
      {"work_offsets.G54 = { X = [1.4, 0.05] }",
       "work_offsets.G54.X: expected 1.4 +- 0.05, got 1.5"},
      {"output = \"X  20.000\\n\"", ""},
      {"output = \"X  20.000\"", "output: expected \"X  20.000\", got \"X  20.000\\n\""},
      {"output_contains = \"20.0\"", ""},
      {"output_contains = \"30.0\"", "output_contains: expected \"30.0\", got \"X  20.000\\n\""},
      {"output_file = \"out.txt\"", ""},
      {"output_file = \"other.txt\"",
       "output_file: expected \"X  20.001\\n\", got \"X  20.000\\n\""},
      {"output_file = \"none.txt\"", "none.txt, which cannot be read, got \"X  20.000\\n\""},
      {"touches = 1", ""},
      {"touches = 4", "touches: expected 4, got 1"},
      {"findings = 0", ""},
      {"findings = 2", "findings: expected 2, got 0"},
      {"machine_time_s = [1.5, 2.0]", ""},
      {"machine_time_s = [2.0, 3.0]", "machine_time_s: expected 2 to 3 s, got 1.5025 s"},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.expect);
    const std::string sheet = fmt::format("{}[expect]\n{}\n", kSignal, c.expect);
    const RunOutput output = run_with(kProgram, sheet);
    const std::string fails = c.fails;
    EXPECT_EQ(output.exit_code, fails.empty() ? 0 : 1) << output.errors;
    EXPECT_EQ(output.errors.find("PRB701") == std::string::npos, fails.empty()) << output.errors;
    EXPECT_NE(output.errors.find(fails), std::string::npos) << output.errors;
    if (!fails.empty()) {
      EXPECT_NE(output.errors.find("sheet.toml:7:"), std::string::npos) << output.errors;
      EXPECT_EQ(output.document.at("diagnostics").back().at("code"), "PRB701");
    }
    EXPECT_FALSE(output.document.at("expectations").empty());
  }
}

/// 1.5 inches are 38.1 mm, and 38.099999999999994 as a product of doubles.
TEST(Expectations, OfOneNumberAreMetByItsLastDigits) {
  const std::string program = "O1\nG20\nG10 L2 P2 X1.5\nM30\n";
  EXPECT_EQ(run_with(program, "[expect.work_offsets.G55]\nX = 38.1\n").exit_code, 0);
  EXPECT_EQ(run_with(program, "[expect.work_offsets.G55]\nX = 38.1000000001\n").exit_code, 1);
}

TEST(Expectations, OfAnEndMakeItsExitCode) {
  const char* const kAlarm = "O1\n#3000=160(DATA EMPTY)\nM30\n";
  const struct {
    const char* name;
    const char* program;
    const char* expect;
    int exit_code;
  } kCases[] = {
      {"the alarm", kAlarm, "alarm = 3160", 0},
      {"the status", kAlarm, "status = \"alarm\"", 0},
      {"another alarm", kAlarm, "alarm = 3161", 1},
      {"an alarm that nobody names", kAlarm, "touches = 0", 3},
      {"no alarm comes", "O1\nM30\n", "alarm = 3160", 1},
      {"a syntax error", "O1\n#1=[2+\nM30\n", "alarm = 114", 0},
      {"a finding", "O1\nG31 X9. F100.\nM30\n", "touches = 0", 1},
      {"a finding that is expected", "O1\nG31 X9. F100.\nM30\n", "findings = 1", 0},
      {"fewer findings", "O1\nG31 X9. F100.\nM30\n", "findings = 2", 1},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.name);
    const RunOutput output = run_with(c.program, fmt::format("[expect]\n{}\n", c.expect));
    EXPECT_EQ(output.exit_code, c.exit_code) << output.errors;
    EXPECT_EQ(output.document.at("exit_code"), c.exit_code);
  }
}

TEST(Expectations, OfTheCommandLineComeBehindThoseOfSheets) {
  const RunOutput good = run_with(kProgram, kSignal, {"#100=20+-0.001", "#7=vacant"});
  EXPECT_EQ(good.exit_code, 0) << good.errors;
  const RunOutput bad = run_with(kProgram, kSignal, {"#100=20+-0.001", "#101 = 16 +- 0.5"});
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_NE(bad.errors.find(
                "--expect #101 = 16 +- 0.5: error: not as expected: #101: expected 16 +- 0.5, got"),
            std::string::npos)
      << bad.errors;
}

// As a later sheet does, key by key.
TEST(Expectations, OfTheCommandLineTakeThePlaceOfTheSheets) {
  const std::string sheet =
      std::string(kSignal) +
      "[expect.variables]\n\"#100\" = 1.0\n\"#101\" = [13.5, 0.1]\n\"#7\" = \"vacant\"\n";
  const RunOutput good = run_with(kProgram, sheet, {"#0100=20+-0.001"});
  EXPECT_EQ(good.exit_code, 0) << good.errors;
  EXPECT_EQ(good.document.at("expectations").size(), 4U) << "three, and the status";
}

// None of them may do away with another; a sheet refuses the pair, too (SET108).
TEST(Expectations, OfTheCommandLineSayOneThingOfAVariable) {
  for (const auto& [first, second] :
       {std::pair("#100=3", "#100=20+-0.001"), std::pair("#100=3", "#0100=20+-0.001"),
        std::pair("#101=3", "#100-#102=1"), std::pair("#100-#102=3", "#102-#103=1")}) {
    const RunOutput output = run_with(kProgram, kSignal, {first, second});
    EXPECT_EQ(output.exit_code, 2) << first << " " << second;
    EXPECT_NE(output.errors.find(std::string("by --expect ") + first + ", too: keep one of them"),
              std::string::npos)
        << output.errors;
  }
}

TEST(Expectations, OfSinumerik) {
  const char* const kMain =
      "DEF STRING[9] TT=\"OK\"\nR1=5\n$P_UIFR[1]=CTRANS(X,10,Y,2):CFINE(X,0.5)\nM30\n";
  const char* const kSheet =
      "[expect.variables]\nR1 = [5.0, 0.1]\nTT = \"OK\"\n[expect.work_offsets.G54]\n"
      "X = [10.5, 1e-9]\nY = 2.0\n";
  const RunOutput good = run_with(kMain, kSheet, {}, "a.mpf");
  EXPECT_EQ(good.exit_code, 0) << good.errors;
  EXPECT_EQ(good.document.at("expectations").size(), 5U) << "the status, too";
}

TEST(Expectations, OfTheCommandLineMayBeTexts) {
  const char* const kMain = "DEF STRING[40] TT=\"a+-b = c\"\nDEF STRING[9] NN=\"\"\nR1=5\nM30\n";
  const RunOutput good = run_with(kMain, "", {R"(NN="")", R"(TT = "a+-b = c" )"}, "a.mpf");
  EXPECT_EQ(good.exit_code, 0) << good.errors;
  const RunOutput bad = run_with(kMain, "", {R"(NN="x")", R"(R1="5")"}, "a.mpf");
  EXPECT_EQ(bad.exit_code, 1);
  EXPECT_NE(bad.errors.find(R"(NN: expected "x", got "")"), std::string::npos) << bad.errors;
  EXPECT_NE(bad.errors.find(R"(R1: expected "5", got 5)"), std::string::npos) << bad.errors;
  const RunOutput bare = run_with(kMain, "", {"TT=x"}, "a.mpf");
  EXPECT_NE(bare.errors.find("nor a text in quotes, such as \"OK\""), std::string::npos);
}

// As --print takes names: a range is each of its variables, never a difference.
TEST(Expectations, OfTheCommandLineMayBeOfRanges) {
  const char* const kMain = "R1=5\nR2=5\nR3=5\nM30\n";
  EXPECT_EQ(run_with(kMain, "", {"R1-R3=5"}, "a.mpf").exit_code, 0);
  const RunOutput bad = run_with(kMain, "", {"R1-R3=0"}, "a.mpf");
  EXPECT_EQ(bad.exit_code, 1) << "R1 less R3 is 0";
  EXPECT_EQ(bad.document.at("expectations").size(), 4U) << "three, and the status";
  EXPECT_NE(bad.errors.find("R2: expected 0, got 5"), std::string::npos) << bad.errors;
  EXPECT_EQ(run_with("O1\n#101=1\nM30\n", "", {"#100-#103,#7=vacant", "#101=1"}).exit_code, 0);
  for (const char* const none : {"R1+1=6", "R1*2=10", "(R1)=5", "R3-R1=0"}) {
    const RunOutput output = run_with(kMain, "", {none}, "a.mpf");
    EXPECT_EQ(output.exit_code, 2) << none;
    EXPECT_NE(output.errors.find("--expect"), std::string::npos) << output.errors;
  }
}

TEST(Expectations, ThatCannotBeAreRefusedBeforeTheRun) {
  const struct {
    const char* expect;
    const char* says;
    int exit_code;
  } kCases[] = {
      {"[expect]\nstatus = \"good\"\n", "sheet.toml:2:10: error: ", 2},
      {"[expect]\ntouchs = 4\n", "did you mean touches?", 2},
      {"[expect]\nvariables = { \"#1\" = [1.0, -1.0] }\n", "a tolerance of 0 or more", 2},
      {"[expect]\nvariables = { \"#1\" = [1.0] }\n", "[value, tolerance]", 2},
      {"[expect]\nvariables = { \"#99999999\" = 1.0 }\n", "sheet.toml:2:", 2},
      {"[expect]\nwork_offsets.G505 = { X = 1.0 }\n", "work offset G505: this control has none", 2},
      {"[expect]\nmachine_time_s = [9.0, 1.0]\n", "the first below the second", 2},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.expect);
    const RunOutput output = run_with("O1\n#3000=1(RAN)\nM30\n", c.expect);
    EXPECT_EQ(output.exit_code, c.exit_code) << output.errors;
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
    EXPECT_EQ(output.errors.find("RAN"), std::string::npos) << output.errors;
  }
  for (const char* text : {"#100", "=5", "#100=", "#100=5+-", "#100=5+--1", "#100=x", "#100=5+-x",
                           "#100=\"", "TT=OK", "TT='OK'"}) {
    EXPECT_FALSE(expect::parse_expectation(text).ok()) << text;
    EXPECT_EQ(run_with("O1\nM30\n", "", {text}).exit_code, 2) << text;
  }
}

}  // namespace
}  // namespace g31::expectations_test

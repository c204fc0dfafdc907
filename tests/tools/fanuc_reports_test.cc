// What a run of a Fanuc program says about the set-up and the files around it.

#include <algorithm>
#include <string>
#include <tuple>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::fanuc_reports_test {
namespace {

using testing::RunOutput;
using testing::TemporaryFolder;

RunOutput run_with(const std::string& program, const std::string& sheet) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("o1.nc", program)};
  options.setups = {folder.write("sheet.toml", sheet)};
  return testing::run_program(options);
}

/// @param library  a folder of subprograms
RunOutput run_beside(const std::string& program, const TemporaryFolder& library) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("main.nc", program)};
  options.libraries = {library.path("")};
  options.prints = {"#100,#101,#102"};
  return testing::run_program(options);
}

bool mentions(const RunOutput& run, const std::string& code) {
  for (const auto& row : run.document["diagnostics"]) {
    if (row["code"] == code) {
      return true;
    }
  }
  return false;
}

TEST(KeyPrompt, WithoutAKeyEndsTheRun) {
  const auto run = run_with("%\nO1\nN5 M109 P501 (GO ON?)\nIF [#501 EQ 0] GOTO5\nM30\n%\n",
                            "[control]\nprofile = \"haas\"\n");
  EXPECT_EQ(run.exit_code, static_cast<int>(cli::ExitCode::Budget));
  EXPECT_NE(run.errors.find("o1.nc:3:1: error: the program asks the operator for a key, and "
                            "control.keys has none left: GO ON? [PRB607]"),
            std::string::npos)
      << run.errors;
  ASSERT_EQ(run.document["stops"].size(), 1U);
  EXPECT_EQ(run.document["stops"][0]["kind"], "M109");
}

TEST(LatheProgram, IsRefusedWithOneLine) {
  const auto run = run_with(
      "%\nO1\nT0101\nG50 S2000\nG96 S200 M3\nG0 X50. Z2.\nG71 U2. R1.\nG71 P10 Q20 U0.5 W0.1 F0.2\n"
      "N10 G0 X20.\nN20 G1 Z-30.\nM30\n%\n",
      "[control]\nprofile = \"fanuc-0i\"\n");
  EXPECT_EQ(run.exit_code, static_cast<int>(cli::ExitCode::BadUsage));
  EXPECT_NE(run.errors.find("o1.nc:3:1: error: a program for a lathe (G50 S, T of four digits, G96 "
                            "S, U or W, G70 to G73 P Q): g31 runs programs for machining centres "
                            "[PRB003]"),
            std::string::npos)
      << run.errors;
  EXPECT_EQ(run.errors.find("error:", run.errors.find("error:") + 1), std::string::npos)
      << run.errors;
}

TEST(LatheProgram, IsNotWhatAMillMayWrite) {
  for (const char* const program :
       {"O1\nT0101 M6\nG0 X1.\nM30\n", "O1\nG96 S100 M3\nG0 X1.\nM30\n", "O1\nG50\nS500 M3\nM30\n",
        "O1\nG65 P2 U1. W2.\nG04 U0.1\nT0102\nM30\nO2\nM99\n",
        // A tool change by T and M6 clears of U and G96, any M6 of the T word.
        "O1\nT1001 M6\nG96 S200 M3\nU5.\nM30\n", "O1\nT1001\nM6\nG96 S200 M3\nM30\n",
        // Words of calls: a code set up so, a modal one, a tool number handed on.
        "O1\nG96 S200 M3\nG100 U10. V0 W0\nM30\n",
        "O1\nG96 S200 M3\nG66.1 P2\nU1. W2.\nG67\nM30\nO2\nM99\n",
        "O1\nG96 S200 M3\nG65 P2 T1001\nM30\nO2\nM99\n",
        // One weak sign beside what mills have: a safety line, a preset, an arc in ZX.
        "O1\nT1001\nG17 G40 G49 G80 G98\nM30\n", "O1\nT1001\nG98 G81 X1. Y2. Z-1. R1. F100\nM30\n",
        "O1\nT1001\nG18 G2 X2. Z0 I1. K0 F100\nM30\n", "O1\nT1001\nG92 X0 Y0 Z0\nM30\n",
        "O1\nT1001\nG10 L2 P1 X1. Z1.\nM30\n", "O1\nT1001\nG73 X1. Z-1. R1. P100 Q1. F100\nM30\n",
        // The line that makes all functions safe, with the speed.
        "O1\nT1 M06\nG00 G40 G50 G69 G80 G90 X10. S3000 M03\nM30\n",
        "O1\nG00 G17 G40 G49 G50 G80 G90 S3000 M03\nM30\n",
        "O1\nG90 G50 S3000 M03\nG43 H1 Z50.\nM30\n",
        // G97 behind G96 is no second sign.
        "O1\nG0 X50.\nG96 S100\nG97 S200\nG95 G1 X10. F.2\nM30\n",
        // A mill whose tools have four digits, points in increments no more, the end of scaling.
        "O1\nT0101 M6\nG97 S900 M3\nG90 G54 G00 X1. Y2.\nG43 H1 Z5.\nG90 X2. Z1. F100.\nM30\n",
        "O1\nG98\nT0101 M6\nG90 X25. Z-20. Y1. F40.\nM30\n",
        "O1\nT0101\nG90 G01 X50. Z-20. F200.\nM30\n", "O1\nT0101\nG50\nX200. Z100.\nM30\n",
        "O1\nG90 X50. Z-20. F200.\nM30\n"}) {
    EXPECT_FALSE(mentions(run_with(program, ""), "PRB003")) << program;
  }
}

TEST(LatheProgram, ShowsTwoSignsOfItsSeries) {
  for (const char* const program :
       {"O1\nT0505\nG98 G40\nG0 X100. Z20.\nM30\n", "O1\nT0101\nG99\nG0 X1.\nM30\n",
        "O1\nT01\nG99\nG0 X22. Z5.\nG92 X19. Z-20. F1.5\nM30\n",
        "O1\nT0101\nG2 X24. Z-12. I2. K0 F0.2\nM30\n", "O1\nT0101\nG71 P10 Q20 F0.2\nM30\n",
        "O1\nT0101\nG10 P1 X1. Z2. R0.4 Q3\nM30\n",
        "O1\nG66.1 P2\nU1.\nG67\nT0101\nU1.\nM30\nO2\nM99\n",
        "O1\nT0101\nG97 S500 M03\nG00 X60. Z2.\nG90 X50. Z-20. F0.2\nX45.\nM30\n",
        "O1\nT0101\nG94 X50. Z-20. F0.2\nM30\n", "O1\nT0101\nG50 X200. Z100.\nM30\n",
        // A training lathe changes by M06.
        "O1\nG21 G98\nM06 T0101\nG97 S900 M03\nG00 X32. Z5.\nG90 X25. Z-20. F40.\nM30\n",
        // A lathe with Y has its other signs.
        "O1\nT0101\nG50 S2000\nG0 X50. Y2.\nM30\n"}) {
    EXPECT_TRUE(mentions(run_with(program, ""), "PRB003")) << program;
  }
}

TEST(LatheProgram, ShowsItselfByOneSignWhereThereIsNoY) {
  const std::string without_y = "[machine]\nfile = \"lathe.toml\"\n";
  const char* const turret = "O1\nT0101\nG54 G00 X60. Z-20.\nG31 X40. F100\nM30\n";
  EXPECT_FALSE(mentions(run_with(turret, ""), "PRB003"));
  EXPECT_TRUE(mentions(run_with(turret, without_y), "PRB003"));
  EXPECT_TRUE(mentions(run_with("O1\nG96 S200 M03\nG01 X5. F0.2\nM30\n", without_y), "PRB003"));
  // Two axes alone are no lathe.
  EXPECT_FALSE(mentions(run_with("O1\nG98\nG0 X60. Z20.\nM30\n", without_y), "PRB003"));
}

TEST(LatheProgram, IsAnyWhereParametersSayThatXIsADiameter) {
  const char* const program = "O1\nG0 X1.\nM30\n";
  for (const char* const entry : {"\"1006.3\" = 1", "\"1006.X\" = 1000"}) {
    const RunOutput run = run_with(program, fmt::format("[parameters]\n{}\n", entry));
    EXPECT_TRUE(mentions(run, "PRB003")) << entry;
    EXPECT_NE(run.errors.find("parameter 1006.3, DIA, of X"), std::string::npos) << run.errors;
  }
  EXPECT_FALSE(mentions(run_with(program, "[parameters]\n\"1006.Z\" = 1000\n"), "PRB003"));
}

TEST(SamePrograms, InOneFileAreTold) {
  const auto run = run_with("O1\nG65 P9010\nM30\nO9010\n#100=1\nM99\nO9010\n#100=2\nM99\n", "");
  EXPECT_NE(run.errors.find("O9010 appears twice: this one is used, not that of line 7"),
            std::string::npos)
      << run.errors;
  EXPECT_TRUE(mentions(run, "PRB504"));
  EXPECT_EQ(run.exit_code, static_cast<int>(cli::ExitCode::Findings));
}

TEST(SamePrograms, OfALongMainProgramAreToldWhereverTheRunEnds) {
  std::string blocks;
  while (blocks.size() < (std::size_t{5} << 20)) {
    blocks += "G0 X0\nG1 X0 F100.\n";
  }
  const std::string second = "O 0001\n#100=1\nM30\n";
  const auto early = run_with("O1\nM30\n" + blocks + second, "");
  const auto lines = 3 + std::ranges::count(blocks, '\n');
  EXPECT_NE(early.errors.find(
                fmt::format("O0001 appears twice: this one is used, not that of line {}", lines)),
            std::string::npos)
      << early.errors;
  const auto jumps = run_with("O1\nGOTO10\n" + blocks + "N10 M30\n" + second, "");
  EXPECT_TRUE(mentions(jumps, "PRB504")) << jumps.errors;
  EXPECT_FALSE(mentions(run_with("O1\nM30\n" + blocks + "O10\nM99\nO2\nM99\n", ""), "PRB504"));
}

TEST(SamePrograms, InOneFolderAreTold) {
  const TemporaryFolder library;
  library.write("9010.nc", "O9010\n#100=1\nM99\n");
  library.write("O9010.txt", "O9010\n#100=2\nM99\n");
  const auto run = run_beside("O1\nG65 P9010\nM30\n", library);
  EXPECT_TRUE(mentions(run, "PRB504")) << run.errors;
}

TEST(SamePrograms, InFilesWhoseNamesSayNoNumberAreTold) {
  const TemporaryFolder library;
  library.write("measure.nc", "O9010\n#100=1\nM99\n");
  library.write("measure_old.nc", "O9011\nM99\nO9010\n#100=2\nM99\n");
  library.write("other.nc", "O9012\nM99\n");
  const auto run = run_beside("O1\nG65 P9010\nM30\n", library);
  EXPECT_NE(run.errors.find("O9010 appears twice: this one is used, not measure_old.nc"),
            std::string::npos)
      << run.errors;
  EXPECT_FALSE(mentions(run_beside("O1\nG65 P9012\nM30\n", library), "PRB504"));
}

TEST(SamePrograms, OneOverAnotherIsHowLibrariesWork) {
  const TemporaryFolder library;
  library.write("O9010.nc", "O9010\n#100=2\nM99\n");
  const auto run = run_beside("O1\nG65 P9010\nM30\nO9010\n#100=1\nM99\n", library);
  EXPECT_FALSE(mentions(run, "PRB504"));
}

/// The leg in front of a corner waits for the one behind it.
TEST(OverTravel, InFrontOfACornerIsToldWhereTheLegStands) {
  const auto run = run_with("%\nO1\nG17 G90 G94 F100\nG01 X30. ,C1.\nY10.\nM30\n%\n",
                            "[machine.axes.X]\ntravel = [-5.0, 15.0]\n");
  EXPECT_EQ(run.exit_code, 4) << run.errors;
  EXPECT_EQ(run.document.at("alarm").at("line"), 4);
  EXPECT_EQ(run.document.at("collision").at("line"), 4);
}

/// A way back to a block that the caller lacks is a fault of the program that wants to go there
/// (MB-219), with its levels: the caller is shorter than the place, or longer.
TEST(ReturnToABlock, ThatTheCallerLacksIsAnAlarmOfTheSubprogram) {
  for (const auto& [block, number, column] :
       {std::tuple("M99P77", 78, 4), std::tuple("M99P1.5", 7, 4), std::tuple("M99P-1", 78, 4),
        std::tuple("M99P0", 78, 4), std::tuple("/M99P77", 78, 5), std::tuple("N5M99P5", 78, 6)}) {
    const TemporaryFolder library;
    library.write("O0002.nc", "%\nO0002(PROBE)\n" + std::string(block) + "\n%\n");
    for (const std::string caller :
         {"O1\nM98P2\nM30\n", "O1\nG65P2\nM30\n",
          "O1\nG0X7.\nM98P2\nM30\n(A CALLER THAT IS LONGER THAN WHAT IT CALLS)\n"}) {
      const auto run = run_beside(caller, library);
      ASSERT_EQ(run.exit_code, 3) << block << run.errors;
      const auto& alarm = run.document.at("alarm");
      EXPECT_EQ(alarm.at("number"), number) << block;
      EXPECT_EQ(alarm.at("file"), "O0002.nc");
      EXPECT_EQ(alarm.at("line"), 3) << block;
      EXPECT_EQ(alarm.at("column"), column) << block;
      ASSERT_EQ(alarm.at("calls").size(), 1U) << block;
      EXPECT_EQ(alarm.at("calls")[0].at("program"), "O0001");
    }
  }
}

TEST(ReturnToABlock, OfTheCallerGoesOnThere) {
  const TemporaryFolder library;
  library.write("O0002.nc", "O2\n#100=#100+1\nM99P#100\n");
  const auto run =
      run_beside("O1\nM98P2L3\n#102=9\nM30\nN1#101=7\nM98P2\nM30\nN2#101=#101+1\nM30\n", library);
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.document.at("variables").at("#100"), 2);
  EXPECT_EQ(run.document.at("variables").at("#101"), 8);
  EXPECT_TRUE(run.document.at("variables").at("#102").is_null());
}

/// Known by the tables, and nothing here follows them.
TEST(UnknownParameter, SoIsOneThatIsKnownWithoutEffect) {
  for (const char* const name : {"1620", "1621", "12400", "12401", "19665"}) {
    const auto run =
        run_with("O1\nM30\n", "[parameters]\n\"" + std::string(name) + "\" = 1\n\"12321\" = 3\n");
    EXPECT_NE(run.errors.find("parameter " + std::string(name) + " has no effect here"),
              std::string::npos)
        << run.errors;
    EXPECT_EQ(run.errors.find("12321"), std::string::npos) << run.errors;
  }
}

TEST(UnknownParameter, IsTold) {
  const auto run =
      run_with("O1\nM30\n", "[parameters]\n\"6099.1\" = 1\n\"6001.1\" = 1\n  \"6098\" = 2\n");
  EXPECT_TRUE(mentions(run, "PRB505"));
  EXPECT_NE(run.errors.find("sheet.toml:2:12: note: parameter 6099.1 has no "
                            "effect here [PRB505]\n    2 | \"6099.1\" = 1\n      |            ^\n"),
            std::string::npos)
      << run.errors;
  EXPECT_NE(run.errors.find("sheet.toml:4:12: note: parameter 6098 "), std::string::npos)
      << run.errors;
  EXPECT_EQ(run.document["diagnostics"][1]["file"], "sheet.toml");
  EXPECT_EQ(run.document["diagnostics"][1]["line"], 2);
  EXPECT_EQ(run.errors.find("6001"), std::string::npos) << run.errors;
  EXPECT_EQ(run.exit_code, static_cast<int>(cli::ExitCode::Completed));
}

TEST(OffsetWithoutLength, IsTold) {
  const auto bare = run_with("O1\nG43 H99 G0 Z10.\nM30\n", "");
  EXPECT_TRUE(mentions(bare, "PRB503")) << bare.errors;
  EXPECT_EQ(bare.exit_code, static_cast<int>(cli::ExitCode::Completed));
  EXPECT_FALSE(mentions(run_with("O1\nG10 L10 P99 R5.\nG43 H99 G0 Z10.\nM30\n", ""), "PRB503"));
}

TEST(MacroAlarm, OfMeldasHasTheShopsNumberAsANumber) {
  const auto run =
      run_with("O1\n#3000=121(NO ARGUMENT)\nM30\n", "[control]\nprofile = \"meldas\"\n");
  EXPECT_EQ(run.document["alarm"]["number"], 277);
  EXPECT_EQ(run.document["alarm"]["detail"], 121);
  EXPECT_EQ(run.document["alarm"]["text"], "NO ARGUMENT");
}

}  // namespace
}  // namespace g31::fanuc_reports_test

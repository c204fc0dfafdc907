// Programs beyond kWholeFileBytes run window by window; they must do what they would do whole.

#include "interpreter/dialects/fanuc/code/program_windows.h"

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::program_windows_test {
namespace {

constexpr int kLineBytes = 30;  // about what straight_line writes

/// A straight block that leaves its number in the position: X = n / 1000.
std::string straight_line(int n) {
  return fmt::format("N{} G1 X{}.{:03} Y0.5 F1000.\n", n % 9000 + 10, n / 1000, n % 1000);
}

std::string many_lines(int count) {
  std::string text;
  text.reserve(static_cast<std::size_t>(count) * kLineBytes);
  for (int n = 0; n < count; ++n) {
    text += straight_line(n);
  }
  return text;
}

/// Enough lines for several windows.
constexpr int kLines = 250'000;

testing::RunOutput run_text(const std::string& text) {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("long.nc", text)};
  options.prints = {"#100,#101,#5001,#4114"};
  return testing::run_program(options);
}

TEST(ProgramWindows, ALongProgramEndsWhereItsLastBlockSays) {
  const std::string text = "%\nO7001\nG90 G21\n" + many_lines(kLines) + "M30\n%\nX garbage\n";
  ASSERT_GT(text.size(), fanuc::kWholeFileBytes + 4 * fanuc::kWindowBytes);
  const auto run = run_text(text);
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.document["blocks"], kLines + 3);  // O7001, G90 G21, the lines, M30
  EXPECT_EQ(run.document["variables"]["#5001"], 249.999);
  EXPECT_EQ(run.document["variables"]["#4114"], (kLines - 1) % 9000 + 10);
}

TEST(ProgramWindows, AMessageNamesTheLineOfTheFile) {
  const auto run = run_text("O7001\n" + many_lines(kLines) + "G1 X[1/0]\nM30\n");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.document["alarm"]["number"], 112);
  EXPECT_EQ(run.document["alarm"]["line"], kLines + 2);
  EXPECT_EQ(run.document["alarm"]["column"], 5);
}

TEST(ProgramWindows, ABlockThatNoJumpReachesRefusesNothing) {
  // The jump leaves its window, or goes on behind the block.
  for (const std::string passed : {"N77 X1..2\n", "N77 X1..2\nN99 #100=2\n"}) {
    const auto run =
        run_text("O7001\n#100=1\nGOTO99\n" + passed + many_lines(kLines) + "N99 M30\n");
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    EXPECT_EQ(run.document["variables"]["#100"], passed.size() > 10 ? 2 : 1);
  }
  const auto reached = run_text("O7001\nGOTO77\nN77 X1..2\n" + many_lines(kLines) + "M30\n");
  EXPECT_EQ(reached.exit_code, 2);
  EXPECT_EQ(reached.document["blocks"], 0);
}

TEST(ProgramWindows, WhatIsMissingAtTheEndOfTheTextHasItsColumn) {
  for (const std::string end : {"", "\n", "\r\n"}) {
    const auto run = run_text("O7001\n" + many_lines(kLines) + "G1X5.Y" + end);
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_EQ(run.document["alarm"]["line"], kLines + 2);
    EXPECT_EQ(run.document["alarm"]["column"], 7) << end.size();
  }
}

TEST(ProgramWindows, AWarningOfAnEarlierWindowKeepsItsPlace) {
  const auto run = run_text("O7001\nG31 X1. F100.\n#100=#5061\n" + many_lines(kLines) + "M30\n");
  EXPECT_EQ(run.exit_code, 1) << run.errors;
  ASSERT_EQ(run.document["diagnostics"].size(), 1U);
  EXPECT_EQ(run.document["diagnostics"][0]["line"], 2);
}

TEST(ProgramWindows, JumpsGoWhereTheyWouldInAWholeProgram) {
  // N5 stands once before the jump and once far behind it: the one behind comes first (MB-171).
  const std::string lines = many_lines(kLines);
  const auto forward = run_text("O7001\nN5 #100=1\n" + lines + "IF[#101EQ1]GOTO6\nGOTO5\n#100=9\n" +
                                lines + "N5 #101=#101+1\nN6 M30\n");
  EXPECT_EQ(forward.exit_code, 0) << forward.errors;
  EXPECT_EQ(forward.document["variables"]["#100"], 1);
  EXPECT_EQ(forward.document["variables"]["#101"], 1);

  const auto backward = run_text("O7001\nN5 #100=#100+1\n" + lines + "IF[#100LT2]GOTO5\nM30\n");
  EXPECT_EQ(backward.exit_code, 0) << backward.errors;
  EXPECT_EQ(backward.document["variables"]["#100"], 2);
  EXPECT_EQ(backward.document["blocks"], 2 * (kLines + 2) + 2);
}

TEST(ProgramWindows, ALoopOverManyWindowsRuns) {
  const auto run = run_text("O7001\n#100=0\n" + many_lines(kLines) + "WHILE[#100LT2]DO1\n" +
                            many_lines(kLines) + "#100=#100+1\nEND1\nM30\n");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.document["variables"]["#100"], 2);
  // O, #100=0, lines; head, body and end twice, the head once more; M30
  EXPECT_EQ(run.document["blocks"], 2 + kLines + 2 * (kLines + 3) + 1 + 1);
}

TEST(ProgramWindows, SubprogramsBehindTheLongProgramAreFound) {
  const auto run =
      run_text("O7001\n" + many_lines(kLines) + "M98 P7002\nM98 P7001 Q99999\nM30\nN99999 M99\n" +
               "O7002\n#100=42\nM99\n");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.document["variables"]["#100"], 42);
}

TEST(ProgramWindows, AlarmsOfSubprogramsBehindTheLongProgramKeepTheirPlace) {
  const auto run =
      run_text("O7001\n" + many_lines(kLines) + "M98 P7003\nM30\nO7002\n#100=42\nM99\n" +
               "O7003\nM98 P7002\nG1 X[#100/0]\nM99\n");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_EQ(run.document["alarm"]["number"], 112);
  EXPECT_EQ(run.document["alarm"]["line"], kLines + 9);
  EXPECT_EQ(run.document["alarm"]["column"], 5);
  EXPECT_EQ(run.document["variables"]["#100"], 42);
  EXPECT_NE(run.errors.find("X[#100/0]"), std::string::npos) << run.errors;
}

int number_of_alarm(const testing::RunOutput& run) {
  const auto& alarm = run.document["alarm"];
  return alarm.is_null() ? 0 : alarm["number"].get<int>();
}

TEST(ProgramWindows, AlarmsOfJumpsToNowhereAreWhereTheJumpStands) {
  struct Case {
    const char* block;
    int alarm;
    int column;
    int lines_behind;  ///< from the first one behind the long part
  };
  constexpr int kComments = 200'000;
  std::string comments;
  for (int i = 0; i < kComments; ++i) {
    comments += "(PAD)\n";
  }
  for (const auto& [block, alarm, column, lines_behind] :
       {Case{"GOTO22", 128, 5, 0}, Case{"GOTO[20+2]", 128, 5, 0},
        Case{"IF[1EQ1]GOTO22", 128, 13, 0}, Case{"M99 P5", 78, 5, 0}, Case{"M98 Q7", 78, 5, 0},
        Case{"M98 P7002", 78, 4, 3}}) {
    const auto run = run_text("O7001\n" + comments + block + "\nM30\nO7002\nM99P9\n");
    EXPECT_EQ(number_of_alarm(run), alarm) << block << run.errors;
    EXPECT_EQ(run.document["alarm"]["line"], 2 + kComments + lines_behind) << block;
    EXPECT_EQ(run.document["alarm"]["column"], column) << block;
  }
}

/// What must be the same of a long program and of one whose lines are few.
void expect_as_whole(const std::string& head, const std::string& tail) {
  const auto whole = run_text(head + many_lines(10) + tail);
  const auto long_one = run_text(head + many_lines(kLines) + tail);
  EXPECT_EQ(long_one.exit_code, whole.exit_code) << long_one.errors;
  EXPECT_EQ(long_one.document["variables"]["#100"], whole.document["variables"]["#100"]);
  EXPECT_EQ(number_of_alarm(long_one), number_of_alarm(whole));
  EXPECT_EQ(long_one.document["diagnostics"].size(), whole.document["diagnostics"].size());
}

TEST(ProgramWindows, AProgramEndsWhereTheNextOneBegins) {
  expect_as_whole("O7001\n", "#100=1\nO7002\n#100=2\nM30\n");
  expect_as_whole("O7001\n#100=0\n", "#100=1\nGOTO 7\n O7002\n#100=2\nN7 M30\n");
}

TEST(ProgramWindows, SubprogramsAreThoseOfTheWholeFile) {
  const std::string calls = "M98 P7002\nM30\n";
  expect_as_whole("O7001\n", calls + "O7002\n#100=1\nM99\nO7002\n#100=2\nM99\n");
  expect_as_whole("O7001\n", calls + "%\nO7002\n#100=1\nM99\n");
  expect_as_whole("%\nO7001\n", calls + "O7002(100%)\n#100=1\nM99\nO7003\n#100=3\n%\n");
  expect_as_whole("O7001\n", "M98 P7003\nM30\nO7002(100%)\n#100=1\nM99\nO7003\n#100=3\nM99\n");
  expect_as_whole("O7001\n", calls + "O7003; O7002\n#100=1\nM99\n");
  expect_as_whole("O7001\n", calls + ":7002\n#100=1\nM98 P7003\nM99\nO7003\n#100=#100+3\n");
}

TEST(ProgramWindows, ALineLongerThanAWindowIsOneBlock) {
  const std::string blanks(3 * fanuc::kWindowBytes, ' ');
  const auto run = run_text("O7001\n" + many_lines(kLines) + "#100=1" + blanks + "+2\nM30\n");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.document["variables"]["#100"], 3);
}

}  // namespace
}  // namespace g31::program_windows_test

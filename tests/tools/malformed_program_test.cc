// What a broken or hostile program file does to `g31 run`: an exit code of the contract, the place
// in the text and the reason, a marker under it, nothing written, and never long.

#include <chrono>
#include <ostream>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::malformed_program_test {
namespace {

using namespace std::string_literals;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

/// Far more than any case needs on a busy computer, far less than one without limits takes.
constexpr double kPatienceSeconds = 30.0;

/// A program of which one piece may stand there many times: the cases are made before any test is
/// chosen, and texts of 10 MB in them would slow down the start of every test.
class Program {
 public:
  Program(const char* text) : before_(text) {}             // NOLINT: rows are texts
  Program(std::string text) : before_(std::move(text)) {}  // NOLINT
  Program(std::string piece, std::size_t times) : piece_(std::move(piece)), times_(times) {}

  std::string text() const {
    std::string text = before_;
    text.reserve(before_.size() + piece_.size() * times_ + behind_.size());
    for (std::size_t i = 0; i < times_; ++i) {
      text += piece_;
    }
    return text + behind_;
  }

  friend Program operator+(const char* before, Program program) {
    program.before_.insert(0, before);
    return program;
  }
  friend Program operator+(Program program, const char* behind) {
    (program.times_ == 0 ? program.before_ : program.behind_) += behind;
    return program;
  }

 private:
  std::string before_;
  std::string piece_;
  std::size_t times_ = 0;
  std::string behind_;
};

struct Case {
  const char* name;
  Program program;
  int exit_code;
  std::string place;  ///< line and column, "2:4"; empty: not checked
  std::string says;   ///< part of the message
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

Program repeated(const char* piece, std::size_t times) {
  return {piece, times};
}

/// Blocks between O1 and M30; the first of them is line 2.
Program framed(const Program& blocks) {
  return "O1\n" + blocks + "\nM30\n";
}

class Malformed : public ::testing::TestWithParam<Case> {};

TEST_P(Malformed, IsRefusedWithItsPlace) {
  const Case& c = GetParam();
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", c.program.text())};
  options.budget = {1000, kPatienceSeconds / 2};
  const auto start = std::chrono::steady_clock::now();
  const RunOutput output = run_program(options);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(output.exit_code, c.exit_code) << output.errors;
  EXPECT_LT(passed.count(), kPatienceSeconds);
  EXPECT_EQ(folder.names().size(), 1U) << "nothing is written beside the program";
  ASSERT_TRUE(output.document.is_object());
  EXPECT_EQ(output.document.at("exit_code"), c.exit_code);
  EXPECT_LT(output.errors.size(), 20000U);
  if (c.exit_code != 0) {
    const std::string head = fmt::format("case.nc:{}: error: ", c.place);
    EXPECT_NE(output.errors.find(c.place.empty() ? "case.nc:" : head), std::string::npos)
        << output.errors;
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
    EXPECT_NE(output.errors.find("^"), std::string::npos) << output.errors;
    EXPECT_EQ(output.errors.find_first_of("\x1B\x07\r"s + '\0'), std::string::npos);
  } else {
    EXPECT_EQ(output.errors, "");
  }
}

const Case kSyntax[] = {
    {"unclosed bracket", framed("#1=[1+2"), 2, "2:4", "this [ has no ]"},
    {"missing operand", framed("#1=1+"), 2, "2:6", "the block ends where a value is expected"},
    {"number sign without a number", framed("#"), 2, "2:2", "a variable is # and its number"},
    {"number sign as a value", framed("G#"), 2, "2:3", "a variable is # and its number"},
    {"overlapping loops", framed("DO1\nDO2\nEND1\nEND2"), 2, "", "[124]"},
    {"WHILE without END", framed("WHILE[1EQ1]DO1"), 2, "2:1", "this DO has no END"},
    {"WHILE without a comparison", framed("WHILE[1]DO1"), 2, "2:6", "a condition compares"},
    {"END without DO", framed("END1"), 2, "2:1", "this END has no DO"},
    {"DO4", framed("DO4\nEND4"), 2, "2:1", "a loop number is 1 to 3"},
    {"DO0", framed("DO0\nEND0"), 2, "2:3", "a loop number is an integer from 1"},
    {"DO128", framed("DO128\nEND128"), 2, "2:3", "a loop number is an integer from 1 to 127"},
    {"ENDIF", framed("N5\nENDIF"), 2, "3:1", "there is no ENDIF"},
    {"the letter O in a jump", framed("GOTO1O"), 2, "2:6", "the letter O instead of 0?"},
    {"the letter O in a variable", framed("#1O0=5"), 2, "2:3", "the letter O instead of 0?"},
    {"a decimal comma", framed("X10,5"), 2, "2:4", "the decimal sign is a point"},
    {"format without places", framed("DPRNT[X#100]"), 2, "2:6", "#100 needs its places"},
    {"format without end", framed("DPRNT[X#100[53]"), 2, "2:6", "this [ has no ]"},
    {"no such statement", framed("FOO[1]"), 2, "2:1", "FOO is neither a statement"},
    {"exponent", framed("#1=1e400"), 2, "2:5", "[127]"},
    {"O number of 12 digits", "O123456789012\nM30\n", 2, "1:14", "[3]"},
    {"N number of 12 digits", framed("N123456789012G0"), 2, "2:14", "[3]"},
    {"100,000 brackets", framed("#1=" + repeated("[", 100000)), 2, "2:9", "nests 6 deep"},
    {"100,000 functions", framed("#1=" + repeated("SIN[", 100000)), 2, "2:27", "nests 6 deep"},
    {"100,000 indirections", framed("#1=" + repeated("#[", 100000)), 2, "2:15", "nests 6 deep"},
    {"100,000 signs", framed("#1=" + repeated("-", 100000)), 2, "2:5", "not '-'"},
    {"100,000 THEN", framed(repeated("IF[1EQ1]THEN", 100000)), 2, "2:133", "too many THEN"},
    {"10 MB of one letter", repeated("A", 10'000'000), 2, "1:1", "AAAAAAAA is neither"},
    {"binary", "\xFB\xC4\x01\x02\x1B[31m\n\xA0\n"s, 2, "1:1", "the byte 0xFB cannot begin a word"},
    {"a bracket without its partner", framed("X5.)"), 2, "2:4", "')' is not an address letter"},
    {"nothing behind a letter, CR LF", framed("G1X5.Y\r"), 2, "2:7", "Y needs a number"},
    {"an escape sequence", framed("\x1B[31mG0"), 2, "2:1", "the byte 0x1B cannot begin a word"},
    {"UTF-16, low byte first", "\xFF\xFEO\0\x31\0\n\0"s, 2, "1:1", "this file is UTF-16"},
    {"UTF-16, high byte first", "\xFE\xFF\0O\0\x31\0\n"s, 2, "1:1", "this file is UTF-16"},
    {"empty file", "", 2, "1:1", "no program in this file"},
    {"only NUL", std::string(1000, '\0'), 2, "1:1", "no program in this file"},
    {"only %", "%", 2, "1:1", "no program in this file"},
};

const Case kAlarms[] = {
    {"no such N", framed("GOTO77"), 3, "2:5", "O0001 has no N77"},
    {"no such program", framed("M98P77"), 3, "2:4", "O0077 is in none of the files"},
    {"subprogram in itself", "O1\nM98P1\nM30\n", 3, "2:1", "called from O0001"},
    {"macro in itself", "O1\nG65P1\nM30\n", 3, "2:1", "called from O0001"},
    {"macro call behind a subprogram call", framed("M98P1G65P1"), 3, "2:6",
     "G65 together with another"},
    {"modal call behind a subprogram call", framed("M98P1G66P1"), 3, "2:6",
     "G66 together with another"},
    {"overflow", framed("#1=99999999.\n#2=#1*#1*#1*#1*#1*#1*#1"), 3, "3:4", "[111]"},
    {"root of -1", framed("#1=SQRT[-1]"), 3, "2:4", "SQRT of -1"},
    {"logarithm of 0", framed("#1=LN[0]"), 3, "2:4", "LN of 0"},
    {"arcus sine of 2", framed("#1=ASIN[2]"), 3, "2:4", "the argument is 2"},
    {"division by zero", framed("#1=1/0"), 3, "2:4", "[112]"},
    {"500 digits", framed("#1=" + repeated("9", 500)), 3, "2:4", "255 digits or more"},
    {"500 digits of a word", framed("X" + repeated("9", 500)), 3, "2:1", "255 digits or more"},
    {"500 decimals", framed("#1=." + repeated("0", 500) + "1"), 3, "2:4", "255 digits or more"},
    {"10 MB of digits", framed("#1=" + repeated("1", 10'000'000)), 3, "2:4", "255 digits or more"},
    {"alarm number below 0", framed("#3000=-1(T)"), 3, "2:1", "#3000 takes 0 to 200"},
    {"alarm number of 8 digits", framed("#3000=99999999(T)"), 3, "2:1", "#3000 takes 0 to 200"},
    {"too many places", framed("DPRNT[#100[99]]"), 3, "2:7", "the places together are 0 to 8"},
    {"% and a number", "%\nO1\n", 3, "2:1", "O0001 ends without M30"},
    {"comment to the end", "O1\n(ABC", 3, "", "ends without M30"},
    {"CR LF", "%\r\nO1\r\nG0X1.\r\n#1=1/0\r\nM30\r\n", 3, "4:4", "    4 | #1=1/0\n"},
    {"CR alone", "%\rO1\rG0X1.\r#1=1/0\rM30\r", 3, "4:4", "    4 | #1=1/0\n"},
    {"marker behind UTF-8", framed("(gr\u00F6\u00DFe)#1=1/0"), 3, "2:11",
     "    2 | (gr\u00F6\u00DFe)#1=1/0\n      |           ^~~"},
    {"marker behind Shift-JIS", framed("(\x83\x5C\x91\xAA)#1=1/0"), 3, "2:8",
     "    2 | (ソ測)#1=1/0\n      |          ^~~"},
    {"alarm text in Shift-JIS", framed("#3000=1(\x83\x5C\x91\xAA)"), 3, "2:1",
     "error: ソ測 [3001]"},
    {"endless loop", framed("WHILE[1EQ1]DO1\nEND1"), 6, "", "the limit of executed blocks"},
    {"endless repeats of the program", "O1\nM99\n", 6, "", "the limit of executed blocks"},
};

const Case kHarmless[] = {
    {"UTF-8 with a mark", "\xEF\xBB\xBFO1\nM30\n", 0, "", ""},
    {"NUL between all", "O\0001\n\0G0\0X1.\0\nM30\n\0\0"s, 0, "", ""},
    {"comments in UTF-8 and Shift-JIS", framed("(gr\u00F6\u00DFe)\n(\x83\x5C\x91\xAA)"), 0, "", ""},
    {"comment without end", framed("(ABC"), 0, "", ""},
    {"POPEN twice", framed("POPEN\nPOPEN\nPCLOS\nPCLOS"), 0, "", ""},
    {"10 MB of comment", framed("(" + repeated("A", 10'000'000) + ")"), 0, "", ""},
    {"2 MB of terms", framed("#1=1" + repeated("+1", 1'000'000)), 0, "", ""},
    {"a million N", "O1\nGOTO7\n" + repeated("N5\n", 1'000'000) + "N7M30\n", 0, "", ""},
};

INSTANTIATE_TEST_SUITE_P(Syntax, Malformed, ::testing::ValuesIn(kSyntax));
INSTANTIATE_TEST_SUITE_P(Alarms, Malformed, ::testing::ValuesIn(kAlarms));
INSTANTIATE_TEST_SUITE_P(Harmless, Malformed, ::testing::ValuesIn(kHarmless));

RunOutput run_sinumerik(const std::string& text) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("CASE.MPF", text)};
  options.prints = {"R1"};
  return run_program(options);
}

TEST(LineEnds, AreThoseOfAFileWithCrAloneOnASinumerik) {
  const RunOutput run = run_sinumerik(
      "; g31: allow PRB319 nothing is measured here\r; part 1\rR1=5\rR2=$AA_MW[X]\rM30\r");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(run.document.at("blocks"), 3);
  EXPECT_EQ(run.document.at("variables").at("R1"), 5.0);
  for (const std::string end : {"\r", "\r\n", "\n"}) {
    std::string text = "; part 1" + end;
    constexpr int kLines = 60'000;  // several windows
    for (int line = 2; line < kLines; ++line) {
      text += "G1 X" + std::to_string(line % 100) + " Y0.5 F1000 ; a line" + end;
    }
    const RunOutput alarm = run_sinumerik(text + "R1=7" + end + "R1=1/0" + end + "M30" + end);
    EXPECT_EQ(alarm.exit_code, 3);
    EXPECT_NE(alarm.errors.find("CASE.MPF:60001:4: error: "), std::string::npos) << alarm.errors;
    EXPECT_NE(alarm.errors.find(" | R1=1/0\n"), std::string::npos) << alarm.errors;
    EXPECT_EQ(alarm.document.at("variables").at("R1"), 7.0);
  }
}

// 9999 holes of 1e5 pecks are 3e9 moves in one block.
TEST(Budget, EndsACannedCycleInTime) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", framed("F100\nG83X1.Z-99.R1.Q.001K9999").text())};
  options.budget.wall_seconds = 0.05;
  const auto start = std::chrono::steady_clock::now();
  const RunOutput output = run_program(options);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_EQ(output.document.at("status"), "budget");
  EXPECT_EQ(output.document.at("blocks"), 3);
  EXPECT_NE(output.errors.find("case.nc:3:1: error: the limit of computing time is reached"),
            std::string::npos)
      << output.errors;
  EXPECT_LT(passed.count(), kPatienceSeconds);
}

// M99 ends the main program of many a robot's cell.
TEST(Budget, TellsHowOftenM99HasBegunTheMainProgramAgain) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\n#1=1\nM99\n")};
  options.budget.blocks = 30;
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_NE(output.errors.find("the limit of executed blocks is reached: M99 has begun the main "
                               "program again 10 times"),
            std::string::npos)
      << output.errors;
}

TEST(Warnings, OfOneBlockAreCounted) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", framed("WHILE[#1LT50]DO1\nG91G31X1.F100\n"
                                                     "#2001=#5061\n#1=#1+1\nEND1")
                                                  .text())};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 1);
  ASSERT_EQ(output.document.at("diagnostics").size(), 1U);
  EXPECT_NE(output.errors.find("case.nc:3:1: note: 50 times in all"), std::string::npos)
      << output.errors;
}

}  // namespace
}  // namespace g31::malformed_program_test

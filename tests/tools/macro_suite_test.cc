// A suite of several hundred programs in one folder, as probe makers deliver them: nested macros,
// every way to write and name a file.  What each program adds to #500 is known in closed form.

#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::macro_suite_test {
namespace {

using testing::RunOutput;
using testing::TemporaryFolder;

constexpr int kFirst = 7000;
constexpr int kPrograms = 300;

/// How a program of the suite is written; program k has style k modulo their number.
enum Style {
  kPlain,
  kLowerCase,
  kCarriageReturns,
  kTabs,
  kTwoInOneFile,
  kNested,
  kJumpTable,
  kLoop,
  kOptionBits,
  kNamedByText,
  kStyles
};

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += with.size()) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string lower(std::string text) {
  for (char& c : text) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

/// The text of program k, which adds value(k) to #500; argument A is 2, @ stands for k.
std::string body(int k) {
  switch (k % kStyles) {
    case kNested:
      return "#9=9701\nG65P#9A#1I@.J1.K2.I3.J4.K5.\nM99\n";
    case kJumpTable:
      return "#5=[@MOD3]+1\n#6=#5*10\n#[#5+100]=#5\nGOTO#6\n"
             "N10#500=#500+1\nGOTO99\nN20#500=#500+2\nGO99\nN30#500=#500+3\nN99M99\n";
    case kLoop:
      return "#2=0\n#3=#0\nWHILE[#2LT@]DO2\n#2=#2+1\n#3=#3+#2\nEND2\n#500=#500+#3\nM99\n";
    case kOptionBits:
      return "#120=@\nIF[#120AND3EQ3]GOTO5\n#500=#500+10\nM99\nN5IF[[#120AND4]EQ4]THEN#500=#500+20"
             "\n#500=#500+30\nM99\n";
    default:
      return "#500=#500+#1*@\n/2#500=#500+1000\nM99(END)\n";
  }
}

double value(int k) {
  switch (k % kStyles) {
    case kNested:
      return 2.0 * k + 15.0;
    case kJumpTable:
      return k % 3 + 1;
    case kLoop:
      return k * (k + 1) / 2.0;
    case kOptionBits:
      return (k & 3) != 3 ? 10.0 : (k & 4) != 0 ? 50.0 : 30.0;
    default:
      return 2.0 * k;
  }
}

std::string program(int k) {
  return "O" + std::to_string(kFirst + k) + "\n" + replaced(body(k), "@", std::to_string(k));
}

void write_program(const TemporaryFolder& folder, int k) {
  const std::string number = std::to_string(kFirst + k);
  const std::string text = program(k);
  switch (k % kStyles) {
    case kLowerCase:
      folder.write("o" + number + ".txt", lower(text));
      return;
    case kCarriageReturns:
      folder.write(number, replaced("%\n" + text + "%\n", "\n", "\r"));
      return;
    case kTabs:
      folder.write("O" + number + ".NC",
                   replaced(replaced("%\n" + text + "%\n", "=", "\t=\t "), "\n", " \r\n"));
      return;
    case kTwoInOneFile:
      folder.write("O" + number + ".tap", "%\nO1234\nM99\n" + text + "O1235\nM99\n%\n");
      return;
    case kNamedByText:
      folder.write("PROBE" + number + "B.MPG", "%\n(CYCLE)\n" + text + "%\n");
      return;
    default:
      folder.write("O" + number, text);
  }
}

/// O9701 to O9703: the second to the fourth level.
void write_levels(const TemporaryFolder& folder) {
  folder.write("levels.nc",
               "%\n"
               "O9701(ADDS I AND ITS TRIPLES)\n"
               "G65P9702A#1B#4I#5J#6K#7I#8J#9\n"
               "M99\n"
               "O9702\n"
               "#30=#4+#5+#6+#7+#8\n"
               "#29=9703\n"
               "M98P[#29]\n"
               "M99\n"
               "O9703(SHARES THE LOCALS)\n"
               "G65P9704A[#1*#2]B#30\n"
               "M99\n"
               "O9704\n"
               "#500=#500+#1+#2\n"
               "M99\n"
               "%\n");
}

RunOutput run_suite(const TemporaryFolder& library, const std::string& main,
                    const std::string& control) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("main.nc", main)};
  options.setups = {folder.write("sheet.toml", "[control]\nblock_skip = [2]\n")};
  options.libraries = {library.path("")};
  options.control = control;
  options.prints = {"#500"};
  return testing::run_program(options);
}

TEST(MacroSuite, EachProgramOfTheFolderDoesItsPart) {
  const TemporaryFolder library;
  write_levels(library);
  double total = 0.0;
  for (int k = 0; k < kPrograms; ++k) {
    write_program(library, k);
    total += value(k);
  }
  const std::string main =
      "O1\n#500=0\n#10=0\nWHILE[#10LT300]DO1\nG65P[7000+#10]A2.\n#10=#10+1\nEND1\nM30\n";
  for (const char* const control : {"fanuc-16i", "fanuc-30i", "meldas", "haas"}) {
    const RunOutput output = run_suite(library, main, control);
    EXPECT_EQ(output.exit_code, 0) << control << ": " << output.errors;
    EXPECT_EQ(output.document["variables"]["#500"], total) << control;
  }
}

TEST(MacroSuite, EveryStyleAddsItsValue) {
  const TemporaryFolder library;
  write_levels(library);
  for (int k = 20; k < 20 + kStyles; ++k) {
    write_program(library, k);
  }
  for (int k = 20; k < 20 + kStyles; ++k) {
    const RunOutput output = run_suite(
        library, "O1\n#500=0\nG65P" + std::to_string(kFirst + k) + "A2.\nM30\n", "fanuc-16i");
    EXPECT_EQ(output.document["variables"]["#500"], value(k)) << k << ": " << output.errors;
  }
}

TEST(MacroSuite, AnAlarmInsideNamesTheFileAndTheCallers) {
  const TemporaryFolder library;
  library.write("O9810.nc", "%\nO9810\n#1=1\n#3000=#1+90(PATH OBSTRUCTED)\nM99\n%\n");
  library.write("O9812.nc", "%\nO9812\nG65P9810\nM99\n%\n");
  const RunOutput output = run_suite(library, "O1\nG65P9812A1.\nM30\n", "fanuc-16i");
  EXPECT_EQ(output.exit_code, 3);
  const auto& alarm = output.document["alarm"];
  EXPECT_EQ(alarm["number"], 3091);
  EXPECT_EQ(alarm["text"], "PATH OBSTRUCTED");
  EXPECT_EQ(alarm["line"], 4);
  EXPECT_NE(alarm["file"].get<std::string>().find("O9810.nc"), std::string::npos);
  ASSERT_EQ(alarm["calls"].size(), 2U);
  EXPECT_EQ(alarm["calls"][0]["program"], "O9812");
  EXPECT_EQ(alarm["calls"][1]["program"], "O0001");
}

}  // namespace
}  // namespace g31::macro_suite_test

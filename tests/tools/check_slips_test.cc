// `g31 check`: slips of the keyboard that a control takes as they stand.

#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"

namespace g31::check_slips_test {
namespace {

using testing::TemporaryFolder;
using Places = std::vector<std::string>;

Places found(const std::string& text, const std::vector<std::string>& options = {}) {
  const TemporaryFolder folder;
  std::vector<std::string> words = {"check", folder.write("p.nc", text)};
  words.insert(words.end(), options.begin(), options.end());
  return testing::places(testing::g31(words).out, folder);
}

TEST(CheckSlips, AnAddressTwiceInABlockIsTold) {
  EXPECT_EQ(found("O1\nG0 X0 X5.\nG1 X1. Y2. F100. (ONE) Z3. Y4.\nT1 T2 M6\nM30\n"),
            (Places{"p.nc:2:7: warning: X5. counts, and not X0 before it in the block [NC018]",
                    "p.nc:3:28: warning: Y4. counts, and not Y2. before it in the block [NC018]"}));
}

TEST(CheckSlips, TwoGCodesOfOneGroupAreTold) {
  EXPECT_EQ(found("O1\nG91 G28 Z0 G90\nG0 G90 G80 G40 G49 G17 G21 G94 X1.\nG90 G90 X2.\nM30\n"),
            (Places{"p.nc:2:12: warning: G90 counts, and not G91 before it in the block [NC018]"}));
}

// I J K of G65 may stand again, and the others may be arguments of what a sheet makes a call.
TEST(CheckSlips, WordsOfCallsMayStandTwice) {
  EXPECT_EQ(
      found("O1\nG65 P9001 I1. J2. K3. I4. J5. K6.\nG66 P9001 X1.\nG67\nG0 X0 /X1.\nM98 P9001\n"
            "M200 A1. A2.\nG200 A1. A2.\nM30\nO9001\nM99\n"),
      Places());
}

TEST(CheckSlips, AComparisonOfTwoConstantsIsTold) {
  EXPECT_EQ(found("O1\nIF [11 NE #0] GOTO 1\nN1 IF [[2 EQ 3] OR [#1 EQ 2]] GOTO 2\n"
                  "N2 WHILE [1 EQ 1] DO 1\nGOTO 3\nEND 1\nN3 IF [#1 EQ #0] GOTO 4\nN4 M30\n"),
            (Places{"p.nc:2:4: warning: two constants are compared: it always comes out the same "
                    "[NC017]",
                    "p.nc:3:8: warning: two constants are compared: it always comes out the same "
                    "[NC017]"}));
}

TEST(CheckSlips, AJumpThatNeverGoesNeedsItsBlock) {
  EXPECT_EQ(
      found("O1\nIF [1 EQ 2] GOTO 5\nM30\n"),
      (Places{
          "p.nc:2:4: warning: two constants are compared: it always comes out the same "
          "[NC017]",
          "p.nc:2:18: error: alarm 128, ILLEGAL MACRO SEQUENCE NUMBER: O0001 has no N5 [NC004]"}));
}

TEST(CheckSlips, AnArgumentKWithoutItsPointIsTold) {
  EXPECT_EQ(found("O1\nG65 P9140 H5. K100\nM30\nO9140\nM99\n"),
            (Places{"p.nc:2:15: warning: K100 without a decimal point is 0.1 (under G20 0.01) "
                    "[NC012]"}));
}

// What the last block calls goes back behind it, where nothing stands.
TEST(CheckSlips, ACallIsNoEndOfAProgram) {
  EXPECT_EQ(
      found("O1\nG65 P9002\n%\n"),
      (Places{"p.nc:2:5: error: alarm 78, NUMBER NOT FOUND: O9002 is in none of the files and "
              "folders [NC005]"}));
  const std::string end =
      "p.nc:2:1: error: alarm 5010, END OF RECORD: O0001 ends without M30, M02 or M99 [NC006]";
  struct Case {
    const char* what;
    std::string call;
    std::string called;
    bool is_told;
  };
  const Case kCases[] = {
      {"a macro", "G65 P9002", "O9002\n#1=1\nM99\n", true},
      {"a subprogram", "M98 P9002", "O9002\nIF [#1 EQ 1] GOTO 1\nX1.\nN1 M99\n", true},
      {"it may end the run", "M98 P9002", "O9002\nIF [#1 EQ 1] GOTO 1\nM30\nN1 M99\n", false},
      {"it calls another one", "M98 P9002", "O9002\nM98 P9003\nM99\nO9003\nM30\n", false},
      {"it goes elsewhere", "M98 P9002", "O9002\nM99 P5\n", false},
  };
  for (const Case& c : kCases) {
    const TemporaryFolder folder;
    folder.write("O9002.nc", c.called);
    const std::string main = folder.write("p.nc", "O1\n" + c.call + "\n%\n");
    EXPECT_EQ(testing::places(testing::g31({"check", main}).out, folder),
              c.is_told ? Places{end} : Places())
        << c.what;
  }
}

}  // namespace
}  // namespace g31::check_slips_test

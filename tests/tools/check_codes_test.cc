// What `g31 check` says of G codes that a run ends at or passes over.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"
#include "tools/cli/check_command.h"

namespace g31::check_codes_test {
namespace {

using testing::places;
using testing::TemporaryFolder;

testing::CommandOutput checked(const cli::CheckOptions& options) {
  return testing::captured([&] { return cli::check_command(options); });
}

TEST(Check, CodesOfAFanucThatAreNotSimulatedAreWarnings) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("case.nc", "O1\nG39 X1.\nG7.1 C50.\nG12 X1.\nG96 S100\nM30\n")};
  options.control = "fanuc-16i";
  EXPECT_EQ(places(checked(options).out, folder),
            (std::vector<std::string>{
                "case.nc:2:1: warning: alarm 10, G39, cutter compensation, arc around a corner: "
                "not simulated: a run ends here [NC007]",
                "case.nc:3:1: warning: alarm 10, G7.1, cylindrical interpolation: not simulated: "
                "a run ends here [NC007]",
                "case.nc:4:1: warning: alarm 10, G12, which this control has not: a run ends here "
                "[NC007]"}));
  options.control = "haas";
  EXPECT_EQ(
      places(checked(options).out, folder).at(2),
      "case.nc:4:1: warning: G12, circular pocket clockwise: not simulated: a run passes over "
      "it [NC007]");
}

TEST(Check, AGCodeThatTheControlHasNotIsAWarningWhereNothingIsCalledByIt) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {
      folder.write("case.nc",
                   "O1\nG77 X5. Z-5.\nG37.5\nG#1\nG66 P2\nG67\nG84.3 X1. R1. Z-1. F1.\nG80\n"
                   "G113\nG999\nG100 U1.\nG659810 X1.\nM30\nO2\nM99\n")};
  options.control = "fanuc-30i";
  const std::string g37 =
      "case.nc:3:1: warning: alarm 10, G37.5, which this control has not: a run ends here [NC007]";
  const std::string lost_p =
      "case.nc:12:1: warning: alarm 10, G659810, which this control has not: "
      "a run ends here [NC007]";
  EXPECT_EQ(places(checked(options).out, folder),
            (std::vector<std::string>{"case.nc:2:1: warning: alarm 10, G77, which this control has "
                                      "not: a run ends here [NC007]",
                                      g37, lost_p}))
      << "G100 and above are called by sheets and parameters, which are not there";
  for (const char* const sheet : {"[macro_calls]\nG77 = 2\n", "[parameters]\n6050 = 77\n"}) {
    options.setups = {folder.write("sheet.toml", sheet)};
    EXPECT_EQ(
        places(checked(options).out, folder),
        (std::vector<std::string>{g37,
                                  "case.nc:10:1: warning: alarm 10, G999, which this control has "
                                  "not: a run ends here [NC007]",
                                  "case.nc:11:1: warning: alarm 10, G100, which this control has "
                                  "not: a run ends here [NC007]",
                                  lost_p}))
        << sheet << " says which codes are calls";
  }
}

TEST(Check, WordsOfACallByEveryBlockAreNoGCodes) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("case.nc", "O1\nG66.1 P2\nG77 X1.\nG67\nM30\nO2\nM99\n")};
  options.control = "fanuc-30i";
  EXPECT_EQ(checked(options).exit_code, 0);
}

// A control refuses to load the second one, and every call finds the first.
TEST(CheckCodes, AProgramThatIsThereTwiceIsTold) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("twice.nc", "O1\nM98 P100\nM30\nO100\n#500=1\nM99\nO100\n#500=2\nM99\n");
  const auto output = testing::g31({"check", file});
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.out.find("twice.nc:7:1: warning: O0100 appears twice: calls find that of line 4 "
                            "[NC013]"),
            std::string::npos)
      << output.out;
  EXPECT_EQ(testing::g31({"check", folder.write("left.nc", "O1\nO1\nM30\n")}).out, "");
  const std::string archive = folder.write(
      "twice.arc",
      "%_N_A_MPF\n;$PATH=/_N_MPF_DIR\nSUBX\nM30\n%_N_SUBX_SPF\n;$PATH=/_N_SPF_DIR\nR9=1\nM17\n"
      "%_N_SUBX_SPF\n;$PATH=/_N_CUS_DIR\nR9=3\nM17\n%_N_SUBX_SPF\n;$PATH=/_N_SPF_DIR\nR9=2\nM17\n");
  EXPECT_EQ(places(testing::g31({"check", archive}).out, folder),
            (std::vector<std::string>{
                "twice.arc:13:1: warning: SUBX appears twice: calls find that of line 5 [NC013]"}));
}

// What stands behind it does not run, and nothing else would say so.
TEST(CheckCodes, ACommentWithoutItsEndIsTold) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "open.nc", "(LEADER\n%\nO1 (WHOLE) (A (B)\nG0 X1. (UP Y2.\n#1=1 (A) (B\nM30\n%\n(BEHIND\n");
  const auto output = testing::g31({"check", file});
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(places(output.out, folder),
            (std::vector<std::string>{"open.nc:4:8: warning: this comment has no ) [NC014]",
                                      "open.nc:5:10: warning: this comment has no ) [NC014]"}));
}

// No call finds it, and it runs as part of the one before.
TEST(CheckCodes, AProgramNumberBehindOtherWordsIsTold) {
  const TemporaryFolder folder;
  const std::string file = folder.write(
      "heads.nc", "O1\nM98 P2\nG0 X1. O0002\nM30\nO2 (SECOND)\nM99O0003(THIRD)\nM99\n");
  EXPECT_EQ(places(testing::g31({"check", file}).out, folder),
            (std::vector<std::string>{
                "heads.nc:3:8: warning: O0002 stands within a block, where no program begins "
                "[NC016]",
                "heads.nc:6:4: warning: O0003 stands within a block, where no program begins "
                "[NC016]"}));
}

// Blocks that calls and jumps of their own codes begin at: a run ends there.
TEST(CheckCodes, ABlockThatIsNotThereIsToldWhateverNamesIt) {
  const TemporaryFolder folder;
  const std::string local = folder.write(
      "local.nc", "O1\nM97 P10\nM97 P999\nM96 P10 Q1\nM96 P998 Q1\nM97\nM30\nN10 M99\n");
  EXPECT_EQ(places(testing::g31({"check", local, "--control", "haas"}).out, folder),
            (std::vector<std::string>{
                "local.nc:3:5: error: alarm 78, SEQUENCE NUMBER NOT FOUND: no N999 [NC004]",
                "local.nc:5:5: error: alarm 78, SEQUENCE NUMBER NOT FOUND: no N998 [NC004]",
                "local.nc:6:1: error: alarm 76, PROGRAM NOT SPECIFIED: M97 without P [NC002]"}));
  EXPECT_EQ(testing::g31({"check", local, "--control", "fanuc-16i"}).exit_code, 0)
      << "M96 and M97 are not of this control";
  const std::string called = folder.write(
      "called.nc", "O1\nM98 P2 Q20\nM98 P2 Q50\nM98 Q1\nM98 Q7\nN1 M30\nO2\nN20 G0 X1.\nM99\n");
  EXPECT_EQ(
      places(testing::g31({"check", called, "--control", "fanuc-30i"}).out, folder),
      (std::vector<std::string>{
          "called.nc:3:8: error: alarm 78, SEQUENCE NUMBER NOT FOUND: O0002 has no N50 [NC004]",
          "called.nc:5:5: error: alarm 78, SEQUENCE NUMBER NOT FOUND: no N7 [NC004]"}));
}

}  // namespace
}  // namespace g31::check_codes_test

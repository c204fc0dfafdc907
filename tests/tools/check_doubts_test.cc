// What `g31 check` says of blocks that a SINUMERIK takes, but that do otherwise than they look.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"

namespace g31::check_doubts_test {
namespace {

using testing::places;
using testing::TemporaryFolder;

TEST(CheckDoubts, ComparisonsJoinedWithoutBracketsAreTold) {
  TemporaryFolder folder;
  const auto output = testing::g31({"check", folder.write("CASE.MPF",
                                                          "DEF BOOL A,B,C\n"
                                                          "IF R1==0 AND R2==0 GOTOF DONE\n"
                                                          "WHILE R1>1 OR R2<5 OR R3<>2\n"
                                                          "R1=1\n"
                                                          "ENDWHILE\n"
                                                          "IF (R1==0) AND (R2==0) GOTOF DONE\n"
                                                          "IF A AND B==C GOTOF DONE\n"
                                                          "IF (R1<2)==(A OR B) GOTOF DONE\n"
                                                          "IF NOT A AND (R1<R2) GOTOF DONE\n"
                                                          "R5=(R1==0 XOR R2==0)\n"
                                                          "GOTOF DONE\n"
                                                          "R6=(R1==0 AND R2==0)\n"
                                                          "DONE:\n"
                                                          "IF R1==2 AND A GOTOF LAST\n"
                                                          "IF NOT R1==3 GOTOF LAST\n"
                                                          "IF A AND R1==7 GOTOF LAST\n"
                                                          "IF NOT A==B GOTOF LAST\n"
                                                          "IF (R1==3)==(NOT A AND B) GOTOF LAST\n"
                                                          "IF NOT (R1==3) AND A GOTOF LAST\n"
                                                          "IF R1 B_AND 4==4 GOTOF LAST\n"
                                                          "LAST: M30\n")});
  EXPECT_EQ(places(output.out, folder),
            (std::vector<std::string>{
                "CASE.MPF:2:4: warning: AND, OR, XOR and NOT bind closer than comparisons [NC011]",
                "CASE.MPF:3:7: warning: AND, OR, XOR and NOT bind closer than comparisons [NC011]",
                "CASE.MPF:10:5: warning: AND, OR, XOR and NOT bind closer than comparisons [NC011]",
                "CASE.MPF:12:5: warning: AND, OR, XOR and NOT bind closer than comparisons [NC011]",
                "CASE.MPF:14:4: warning: AND, OR, XOR and NOT bind closer than comparisons [NC011]",
                "CASE.MPF:15:4: warning: AND, OR, XOR and NOT bind closer than comparisons [NC011]",
                "CASE.MPF:16:4: warning: AND, OR, XOR and NOT bind closer than comparisons [NC011]",
            }));
}

TEST(CheckDoubts, AnEndThatEndsNothingIsTold) {
  TemporaryFolder folder;
  const auto output = testing::g31({"check", folder.write("CASE.MPF",
                                                          "IF R1==0\n"
                                                          "R2=1\n"
                                                          "ENDIF\n"
                                                          "ENDIF\n"
                                                          "M30\n"
                                                          "  ENDIF\n")});
  EXPECT_EQ(places(output.out, folder),
            (std::vector<std::string>{"CASE.MPF:4:1: warning: ENDIF without IF [NC015]",
                                      "CASE.MPF:6:3: warning: ENDIF without IF [NC015]"}));
}

/// Each of them has room by itself; a run would write all of them into its document.
TEST(CheckMemory, VariablesOfAProgramAreTakenTogether) {
  TemporaryFolder folder;
  const auto output = testing::g31({"check", folder.write("CASE.MPF",
                                                          "DEF STRING[10] FIRST[70000]\n"
                                                          "DEF REAL NUMBERS[100000]\n"
                                                          "DEF STRING[10] LAST[70000]\n"
                                                          "M30\n")});
  EXPECT_EQ(
      places(output.out, folder),
      (std::vector<std::string>{
          "CASE.MPF:3:1: error: alarm 12560, programmed value exceeds allowed limits: size of "
          "all variables together: 32 MB at most [NC002]"}));
}

}  // namespace
}  // namespace g31::check_doubts_test

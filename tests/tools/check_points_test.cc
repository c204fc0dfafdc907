// Numbers that have lost their decimal point: what `g31 check` says of them, and what a run reads.

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"

namespace g31::check_points_test {
namespace {

using testing::TemporaryFolder;

const char* const kProgram =
    "O1\n"
    "G90 G54 G0 X10 Y-5.\n"
    "G31 Z-999 F100\n"
    "G65 P2 Z10 M1 A3 F300\n"
    "G4 P500 (ms)\n"
    "G68 X0 Y0 R45\n"
    "G10 L2 P1 X5\n"
    "G51 X0 Y0 I500 J500\n"
    "G83 Z-5. R1. Q500 K2 F100.\n"
    "G80 A90 X1000 Y#1\n"
    "G2 X10. I5 K#2\n"
    "M30\n"
    "O2\nM99\n";

/// "line:column: message" of each finding of NC012.
std::vector<std::string> told_in(const std::string& program, const std::string& sheet,
                                 const std::string& control) {
  const TemporaryFolder folder;
  const auto output = testing::g31({"check", folder.write("case.nc", program), "--setup",
                                    folder.write("sheet.toml", sheet), "--control", control});
  static const std::regex kForm(R"(case\.nc:(.*): warning: (.*) \[NC012\])");
  std::vector<std::string> found;
  for (std::sregex_iterator at(output.out.begin(), output.out.end(), kForm), end; at != end; ++at) {
    found.push_back(at->format("$1: $2"));
  }
  return found;
}

std::vector<std::string> told(const std::string& sheet, const std::string& control) {
  return told_in(kProgram, sheet, control);
}

/// The same of blocks from the second line on.
std::vector<std::string> told_of(const std::string& blocks, const std::string& sheet) {
  return told_in("O1\n" + blocks + "\nM30\n", sheet, "fanuc-16i");
}

const std::vector<std::string> kExpected = {
    "2:12: X10 without a decimal point is 0.01 (under G20 0.001)",
    "3:5: Z-999 without a decimal point is -0.999 (under G20 -0.0999)",
    "4:8: Z10 without a decimal point is 0.01 (under G20 0.001)",
    "4:15: A3 without a decimal point is 0.003 (under G20 0.0003)",
    "6:11: R45 without a decimal point is 0.045",
    "7:11: X5 without a decimal point is 0.005 (under G20 0.0005)",
    "10:5: A90 without a decimal point is 0.09",
    "11:9: I5 without a decimal point is 0.005 (under G20 0.0005)",
};

TEST(CheckPoints, ThatAreLostAreToldWhereTheyMakeALengthOfNothing) {
  EXPECT_EQ(told("", "fanuc-16i"), kExpected);
}

TEST(CheckPoints, OfACallThatTheSheetNamesAreThoseOfItsArguments) {
  const std::string block = "G100 U50 R5. Z-7. A1.";
  EXPECT_EQ(
      told_of(block, "[macro_calls]\nG100 = 9010\n"),
      (std::vector<std::string>{"2:6: U50 without a decimal point is 0.05 (under G20 0.005)"}));
  EXPECT_TRUE(told_of(block, "").empty()) << "nobody knows what it calls";
}

TEST(CheckPoints, OfATiltedPlaneAreLost) {
  EXPECT_EQ(told_in("O1\nG68.2 X10 Y0 Z5. I0 J30 K0\nG69\nM30\n", "", "fanuc-30i"),
            (std::vector<std::string>{"2:7: X10 without a decimal point is 0.01 (under G20 0.001)",
                                      "2:21: J30 without a decimal point is 0.03"}));
  EXPECT_EQ(told_in("O1\nG68.2 P3 Q1 X0 Y0 Z0 I1 J0 K0\nG68.2 P3 Q2 I0 J.5 K1\nG69\nM30\n", "",
                    "fanuc-30i"),
            (std::vector<std::string>{"3:20: K1 without a decimal point is 0.001"}))
      << "a direction alone has no unit";
  EXPECT_TRUE(told_in("O1\nG68 X0. Y0. Z0. I0 J0 K1 R30.\nG69\nM30\n", "", "fanuc-30i").empty());
}

TEST(CheckPoints, OfAFeedAreLostOnAHaas) {
  std::vector<std::string> found = told("", "haas");
  EXPECT_EQ(std::erase(found, "3:11: F100 without a decimal point is 0.1 (under G20 0.01)"), 1U);
  EXPECT_EQ(found, kExpected);
}

TEST(CheckPoints, AreNotMissedWhereTheSheetReadsWholeMillimetres) {
  EXPECT_EQ(told("[parameters]\n\"3401.0\" = 1\n", "haas"), std::vector<std::string>());
}

TEST(CheckPoints, CountTheIncrementsOfTheSheet) {
  const auto finer = told("[control]\nincrement = \"IS-C\"\n", "fanuc-16i");
  ASSERT_EQ(finer.size(), kExpected.size() + 2);
  EXPECT_EQ(finer[0], "2:12: X10 without a decimal point is 0.001 (under G20 0.0001)");
  EXPECT_EQ(finer[6], "9:14: Q500 without a decimal point is 0.05 (under G20 0.005)");
  EXPECT_EQ(finer[8], "10:9: X1000 without a decimal point is 0.1 (under G20 0.01)");
  EXPECT_EQ(told_of("G1 X9 Y10.", "[control]\nincrement = \"IS-A\"\n"),
            std::vector<std::string>{"2:4: X9 without a decimal point is 0.09 (under G20 0.009)"});
  EXPECT_TRUE(told_of("G1 X100 A500 Y10.", "[control]\nincrement = \"IS-A\"\n").empty());
}

TEST(CheckPoints, ROfASkipMoveIsNoLengthWhereItSaysHowItAccelerates) {
  const std::string program = "O1\nG31 R1 Z-10. F100.\nM30\n";
  EXPECT_TRUE(told_in(program, "", "meldas").empty());
  EXPECT_EQ(told_in(program, "", "fanuc-16i").size(), 1U);
}

TEST(CheckPoints, AreOfLengthsAnglesTimesAndFeedsAlone) {
  struct Row {
    const char* block;
    std::vector<std::string> said;
  };
  const std::string without = " without a decimal point is ";
  for (const Row& row : std::vector<Row>{
           {"G10 L12 P1 R5", {"2:12: R5" + without + "0.005 (under G20 0.0005)"}},
           {"G83 Z-5. R1. Q2 K2 F100.", {"2:14: Q2" + without + "0.002 (under G20 0.0002)"}},
           {"G1 X10. ,R5", {"2:9: ,R5" + without + "0.005 (under G20 0.0005)"}},
           {"G4 X5", {"2:4: X5" + without + "0.005"}},
           {"G4 X500", {}},
           {"G5.1 Q1 R5", {}},
           {"G10 L99 P1 R5", {}},
           {"G84 X1. Z-2. R1. F100. J2", {}},
           {"G31 R5 Z-10. F100.", {"2:5: R5" + without + "0.005 (under G20 0.0005)"}},
           {"G81 Z-2. R1. F100. K3", {}},
           {"G81 Z-2. R1. F100.\nG91 X5. K3", {}},  // repeats of the cycle in force
           {"G18 G3 X5. K3", {"2:12: K3" + without + "0.003 (under G20 0.0003)"}},
           {"G54.1 P5 H3 D2 S500 T4 M6", {}},
           {"G31 P1 X5. L2", {}}}) {
    EXPECT_EQ(told_of(row.block + std::string("\nY10."), ""), row.said) << row.block;
  }
  EXPECT_EQ(told_of("G1 (mm)X5(ten)Y10.", ""),
            std::vector<std::string>{"2:8: X5" + without + "0.005 (under G20 0.0005)"});
  EXPECT_EQ(told_of("G1 F100 Y10.", "[parameters]\n\"1403.0\" = 1\n"),
            std::vector<std::string>{"2:4: F100" + without + "0.1 (under G20 0.001)"});
}

TEST(CheckPoints, AreNotMissedInAProgramOfIncrements) {
  EXPECT_TRUE(told_of("G0 X10000 Y20000\nG1 Z-2500 F100\nX10500 Y500\nY-250", "").empty());
  EXPECT_EQ(told_of("G0 X10000 Y20000\nG1 Z-2500 F100\nX10500 Y500\nY-2.50", "").size(), 1U);
}

TEST(CheckPoints, AreReadByARunAsTheyAreTold) {
  const TemporaryFolder folder;
  const std::string program =
      "O1\nG90 G0 X10\n#500=#5001\nG65 P2 Z10 A3 F300\nG20\nX10\n#504=#5001\nM30\n"
      "O2\n#501=#26\n#502=#1\n#503=#9\nM99\n";
  const auto output = testing::g31(
      {"run", folder.write("case.nc", program), "--control", "haas", "--print", "#500-#504"});
  EXPECT_EQ(output.out, "#500 = 0.01\n#501 = 0.01\n#502 = 0.003\n#503 = 300\n#504 = 0.001\n");
}

}  // namespace
}  // namespace g31::check_points_test

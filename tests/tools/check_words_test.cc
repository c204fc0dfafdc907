// Numbers of plain words that end every run: `g31 check` says of them what the run says.

#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"

namespace g31::check_words_test {
namespace {

using testing::TemporaryFolder;

/// A block, and what is said of it: "column number TEXT: what exactly".
struct Row {
  const char* block;
  const char* said;
};

/// The first error of the second line as a row says it; empty: there is none.
std::string first_error(const std::string& text, const std::regex& form, const char* order) {
  std::smatch match;
  return std::regex_search(text, match, form) ? match.format(order) : std::string();
}

std::string said_by_run(const std::string& file, const std::string& control) {
  static const std::regex form(R"(:2:(\d+): error: (.*) \[(\d+)\])");
  const auto output = testing::g31({"run", file, "--control", control});
  return first_error(output.errors, form, "$1 $3 $2");
}

std::string said_by_check(const std::string& file, const std::string& control) {
  static const std::regex form(R"(:2:(\d+): \w+: alarm (\d+), (.*) \[NC\d+\])");
  const auto output = testing::g31({"check", file, "--control", control});
  return first_error(output.out, form, "$1 $2 $3");
}

std::string fanuc_program(const std::string& block) {
  return fmt::format("O1\n{}\nM30\nO2\nM99\n", block);
}

std::string sinumerik_program(const std::string& block) {
  return fmt::format("; PART\n{}\nM30\n", block);
}

constexpr const char* kSinumerik = "sinumerik-828d";

void expect_both_say(const std::string& control, const std::vector<Row>& rows) {
  const TemporaryFolder folder;
  for (const Row& row : rows) {
    SCOPED_TRACE(control + ": " + row.block);
    const std::string file = control == kSinumerik
                                 ? folder.write("CASE.MPF", sinumerik_program(row.block))
                                 : folder.write("case.nc", fanuc_program(row.block));
    EXPECT_EQ(said_by_check(file, control), row.said);
    EXPECT_EQ(said_by_run(file, control), row.said);
  }
}

TEST(CheckWords, NumbersOfFanucWordsAreToldAsARunTellsThem) {
  expect_both_say(
      "fanuc-16i",
      {
          {"M12.5", "1 7 ILLEGAL USE OF DECIMAL POINT: M takes an integer"},
          {"G0 T-5 M99", "4 6 ILLEGAL USE OF MINUS SIGN: T counts from 0"},
          {"M99 T-5", "5 6 ILLEGAL USE OF MINUS SIGN: T counts from 0"},
          {"G67 F-9.", "5 6 ILLEGAL USE OF MINUS SIGN: a feed cannot be negative"},
          {"X1. M-5", "5 6 ILLEGAL USE OF MINUS SIGN: M counts from 0"},
          {"T-5", "1 6 ILLEGAL USE OF MINUS SIGN: T counts from 0"},
          {"T1.5 M6", "1 7 ILLEGAL USE OF DECIMAL POINT: T takes an integer"},
          {"S-1 M3", "1 6 ILLEGAL USE OF MINUS SIGN: S counts from 0"},
          {"G1 X1. F-9", "8 6 ILLEGAL USE OF MINUS SIGN: a feed cannot be negative"},
          {"D1.5", "1 7 ILLEGAL USE OF DECIMAL POINT: D takes an integer"},
          {"H1000", "1 30 ILLEGAL OFFSET NUMBER: H is 0 to 999"},
          {"G43 H-1", "5 30 ILLEGAL OFFSET NUMBER: H is 0 to 999"},
          {"G41 D1000 X10. F100", "1 30 ILLEGAL OFFSET NUMBER: D1000: D is 0 to 999"},
          {"G1 X1. ,C-1. F100",
           "8 6 ILLEGAL USE OF MINUS SIGN: the size of a corner cannot be "
           "negative"},
          {"G1 X1. ,C1. ,R1. F100", "13 53 TOO MANY ADDRESS COMMANDS: one of ,C and ,R in a block"},
      });
}

TEST(CheckWords, NumbersOfFanucCodesAreToldAsARunTellsThem) {
  expect_both_say(
      "fanuc-16i",
      {
          {"G10 L1.5 P1 R1", "5 7 ILLEGAL USE OF DECIMAL POINT: L takes an integer"},
          {"G10 L2 P7 X0", "8 31 ILLEGAL P COMMAND IN G10: P is 0 to 6"},
          {"G10 L20 P0 X0", "9 31 ILLEGAL P COMMAND IN G10: P is 1 to 300"},
          {"G10 L10 P1000 R1", "9 31 ILLEGAL P COMMAND IN G10: P is 1 to 999"},
          {"G10 P1.5 R1", "5 7 ILLEGAL USE OF DECIMAL POINT: P takes an integer"},
          {"G10 L11 R1", "1 31 G10 FORMAT ERROR: P is missing"},
          {"G10 L11 P1", "1 32 G10 FORMAT ERROR: R is missing"},
          {"G04 X-1.", "1 6 ILLEGAL USE OF MINUS SIGN: a dwell cannot be negative"},
          {"G04 P-1", "1 6 ILLEGAL USE OF MINUS SIGN: a dwell cannot be negative"},
          {"G04 P1.5", "5 7 ILLEGAL USE OF DECIMAL POINT: P takes an integer"},
          {"G54.1 P999", "7 30 ILLEGAL OFFSET NUMBER: G54.1 has P1 to P300"},
          {"G54 P301", "5 30 ILLEGAL OFFSET NUMBER: G54 has P1 to P300"},
          {"G54.4 P8", "7 30 ILLEGAL OFFSET NUMBER: G54.4 has P0 to P7"},
          {"G30 P5 Z0", "5 46 ILLEGAL REFERENCE RETURN COMMAND: P5"},
          {"G31 Z-9. F100 P5", "15 370 G31P FORMAT ERROR: P5"},
          {"G31 X1. Z-9. F100 P99", "19 369 G31 FORMAT ERROR: one axis is needed"},
          {"G51 P0", "1 142 ILLEGAL SCALE RATE: the factor is 0"},
          {"G51 P1.5", "5 7 ILLEGAL USE OF DECIMAL POINT: P takes an integer"},
          {"G68.2 P9", "7 5457 G68.2/G68.3 FORMAT ERROR: P is 0 to 4"},
          {"G82 Z-5. R2. P-1 F100", "14 6 ILLEGAL USE OF MINUS SIGN: a dwell cannot be negative"},
      });
}

TEST(CheckWords, NumbersOfCallsAreToldAsARunTellsThem) {
  expect_both_say("fanuc-16i",
                  {
                      {"G65 P1.5", "5 7 ILLEGAL USE OF DECIMAL POINT: P takes an integer"},
                      {"G65 P2 L1.5", "8 7 ILLEGAL USE OF DECIMAL POINT: L takes an integer"},
                      {"G65 P2 G1 X1.", "8 129 ILLEGAL ARGUMENT ADDRESS: G as argument"},
                      {"G90 G65 P2", "1 129 ILLEGAL ARGUMENT ADDRESS: G as argument"},
                      {"G66 P2 O5", "8 129 ILLEGAL ARGUMENT ADDRESS: O as argument"},
                      {"M98 P1.5", "5 7 ILLEGAL USE OF DECIMAL POINT: P takes an integer"},
                      {"M98 P2 L1.5", "8 7 ILLEGAL USE OF DECIMAL POINT: L takes an integer"},
                      {"M98 P2 F-9", "8 6 ILLEGAL USE OF MINUS SIGN: a feed cannot be negative"},
                      {"M99 P1.5", "5 7 ILLEGAL USE OF DECIMAL POINT: P takes an integer"},
                      {"DPRNT[#1[99]]",
                       "7 114 FORMAT ERROR IN DPRNT/BPRNT: #1[99]: the places together are 0 to 8"},
                      {"M99 L-1", "5 9 ILLEGAL ADDRESS INPUT: L repeats 0 to 9999 times"},
                  });
}

TEST(CheckWords, EachControlHasItsOwnLimits) {
  expect_both_say("meldas", {{"G31 Z-9. F100 P256",
                              "15 35 SETTING VALUE RANGE OVER: P is 1 to 255, one bit "
                              "for each signal"},
                             {"M98 P2 S-1", "8 35 ILLEGAL USE OF MINUS SIGN: S counts from 0"}});
  expect_both_say("haas", {{"G04 P-1.5",
                            "1 6 ILLEGAL USE OF MINUS SIGN: a dwell cannot be "
                            "negative"}});
  expect_both_say("fanuc-30i", {{"G51 P-1.5", "1 142 ILLEGAL SCALE RATE: the factor is -1.5"}});
}

TEST(CheckWords, ConstantsOfSinumerikExpressionsAreToldAsARunTellsThem) {
  expect_both_say(
      kSinumerik,
      {
          {"R1=5/(3-3)", "4 14051 arithmetic error in part program: division by zero"},
          {"R1=(R2-1) MOD (2-2)", "4 14051 arithmetic error in part program: division by zero"},
          {"R1=SQRT(3-4)", "4 14051 arithmetic error in part program: SQRT of -1"},
          {"R1=LN(0)", "4 14051 arithmetic error in part program: LN of 0"},
          {"R1=ASIN(2)", "4 14051 arithmetic error in part program: ASIN of 2"},
          {"R1=TAN(90)", "4 14051 arithmetic error in part program: TAN of 90"},
          {"R1=EXP(9999)", "4 14051 arithmetic error in part program: EXP of 9999"},
          {"R1=2147483647+1", "4 14051 arithmetic error in part program: 2147483648 is not INT"},
          {"R1=BOUND(5,1,3)",
           "4 12030 invalid arguments or data types: BOUND: the lower limit is "
           "above the upper one"},
          {"R1=R[1000+1]", "6 17020 illegal array index 1: R[1001] of 1000"},
          {"DEF REAL LL[3]=SET(1,2,3,4)", "1 12260 too many initialization values"},
          {"DEF REAL LL[3]=REP(1,4)", "1 12260 too many initialization values"},
          {"SETAL(1)", "1 12560 programmed value exceeds allowed limits: SETAL(1)"},
          {"SETMS(-1)", "1 12560 programmed value exceeds allowed limits: SETMS(-1)"},
          {"ID=256 DO M1", "1 12560 programmed value exceeds allowed limits: ID=256: 1 to 255"},
          {"A1: REPEATB A1 P=-1", "1 14013 number of subroutine passes invalid: P-1"},
      });
}

TEST(CheckWords, WordsOfSinumerikBlocksAreToldAsARunTellsThem) {
  expect_both_say(
      kSinumerik,
      {
          {"T-5", "1 17190 illegal T number: T-5"},
          {"T=1-2", "1 17190 illegal T number: T-1"},
          {"T1.5", "1 17190 illegal T number: T1.5"},
          {"D32001", "1 14090 invalid D number: D32001"},
          {"DL=7", "1 17182 illegal sum correction number: DL=7"},
          {"G1 X1 F-9", "1 10860 feedrate not programmed"},
          {"G1 X1 F0", "1 10860 feedrate not programmed"},
          {"G1 X1 FB=0 F100", "1 10860 feedrate not programmed"},
          {"G4 F-1", "1 12560 programmed value exceeds allowed limits: G4, -1 s"},
          {"G75 FP=9 X0", "1 12560 programmed value exceeds allowed limits: FP=9"},
          {"SF=400", "1 12560 programmed value exceeds allowed limits: SF=400: 0 to 359.999"},
          {"OVR=201", "1 12560 programmed value exceeds allowed limits: OVR=201: 1 to 200"},
          {"FA[X]=-1", "1 14810 negative axis velocity programmed for positioning axis: FA[X]=-1"},
          {"ACC[X]=300", "1 12560 programmed value exceeds allowed limits: ACC[X]=300: 1 to 200"},
          {"G1 X1 RND=-1 F100", "1 12560 programmed value exceeds allowed limits: -1"},
          {"G1 X1 RND=1 CHF=1 F100",
           "1 12090 parameter not expected: only one of RND, CHF and CHR "
           "in a block"},
          {"G1 AP=400 RP=5 F100", "1 14210 polar angle too large: AP=400"},
          {"G1 AP=10 RP=-5 F100", "1 14200 negative polar radius: RP=-5"},
          {"G110 AP=400 RP=5", "1 14210 polar angle too large: AP=400"},
          {"OFFN=1", "1 12140 functionality not implemented: OFFN=1"},
      });
}

TEST(CheckWords, WordsOfMeasuringAndOfCirclesAreToldAsARunTellsThem) {
  expect_both_say(
      kSinumerik,
      {
          {"G1 X1 MEAS=9 F100", "1 12560 programmed value exceeds allowed limits: MEAS: 9"},
          {"G1 X1 MEAW=0 F100", "1 12560 programmed value exceeds allowed limits: MEAS: 0"},
          {"G1 MEASA[X]=(1,9) X1 F100",
           "1 12560 programmed value exceeds allowed limits: MEASA: 9"},
          {"G1 MEASA[X]=(4,1) X1 F100", "1 12140 functionality not implemented: MEASA, mode 4"},
          {"G1 MEASA[X]=(1,1,-1) X1 F100",
           "1 12140 functionality not implemented: MEASA: two edges of one probe, or different "
           "edges"},
          {"G1 MEASA[X]=(1,1,-2) X1 F100",
           "1 12140 functionality not implemented: MEASA: two edges of one probe, or different "
           "edges"},
          {"G1 MEASA[X]=(1,1,9) X1 F100",
           "1 12560 programmed value exceeds allowed limits: MEASA: 9"},
          {"G1 MEAS=1 MEAW=1 X1 F100", "1 21701 measurement not possible"},
          {"G1 MEAS=1 MEASA[X]=(1,1) X1 F100", "1 21701 measurement not possible"},
          {"G2 X1 CR=1 MEAS=1 F100", "1 12140 functionality not implemented: MEAS on a circle"},
          {"G2 X0 Y0 I5 TURN=-1 F100", "1 12560 programmed value exceeds allowed limits: TURN=-1"},
          {"G2 X0 Y0 I5 TURN=1.5 F100",
           "1 12560 programmed value exceeds allowed limits: TURN=1.5"},
          {"G3 X10 AR=360 F100",
           "1 14910 invalid angle of aperture for programmed circle: AR=360.0000"},
      });
}

TEST(CheckWords, WhatMayBeRightOnASinumerikPassesWithoutAWord) {
  const TemporaryFolder folder;
  for (const char* const block : {
           "T=R1 D=R2 DL=R3",
           "T=\"MILL\"",
           "F-9",
           "G1 X1 FB=5 F0",
           "X1 F0",
           "G4 S-1",
           "G4 F1 MEAS=9",
           "TRANS X1 AP=400",
           "FP=9",
           "TURN=-1",
           "G2 X10 AR=360 CR=5 F100",
           "G1 RP=IC(-5) AP=10 F100",
           "G1 MEASA[X]=(0,9) X1 F100",
           "G2 MEASA[X]=(0) X1 CR=1 F100",
           "G2 MEASA[X]=(1,1) POS[X]=1 F100",
           "G1 MEASA[X]=(1,1,2) X1 F100",
           "G1 MEASA[X]=(1,1,R1) X1 F100",
           "G1 MEASA[X]=(R1,R2) X1 F100",
           "R1=5/(R2-R2)",
           "R1=SQRT(R2) R3=ASIN(R4)",
           "R1=2147483647.0+1",
           "R1=BOUND(1,1,3)",
           "SETAL(65000)",
           "SETAL(R1)",
           "WHEN R1>0 DO M1",
           "FA[X]=R1 OVR=R2",
           "DEF REAL LL[3]=SET(1,2,3,)\nLL[1]=SET(1,2)\nLL[0]=REP(1,3)\nLL[R1]=SET(1,2,3)",
           "DISC=0 OFFN=0",
       }) {
    SCOPED_TRACE(block);
    EXPECT_EQ(testing::g31({"check", folder.write("CASE.MPF", sinumerik_program(block))}).out, "");
  }
}

TEST(CheckWords, WhatMayBeRightPassesWithoutAWord) {
  const TemporaryFolder folder;
  for (const char* const block : {
           "G100 M12.5 T1.5 F-9.",  // arguments, where the sheet says so
           "G360",
           "G10 L75 P1\nG11",
           "G10 L99 P1 R1",
           "M6 T1 D25.5",
           "M12 S-1",
           "G65 P2 M1.5 T-1. S1.5 F-9. D1.5 H-1.",
           "G66.1 P2\nM12.5 F-9.\nG67",
           "G10 L3\nP1 L10\nT1.5 H1 D1\nG11",
           "G10 L50\nN3410 R-1\nG11",
           "G10 L10 P#1 R#2",
           "G10 L21 P0 X1.",
           "G04 X-1. U1.",
           "G04 P-1 X#1",
           "G54",
           "G54.1",
           "G31 Z-9. F100 P1",
           "G31 X#1 Z#2 F100 P99",
           "G51 P0 I1000 J1000 K1000",
           "G81 P-1",
           "BPRNT[#1[9]]",
           "DPRNT[#1[44]]",
           "D1000",
           "T#149 S[1.5] M#1",
           "/ T1 H999 D999",
           "G1 / M12.5",
       }) {
    SCOPED_TRACE(block);
    EXPECT_EQ(testing::g31({"check", folder.write("case.nc", fanuc_program(block))}).out, "");
  }
}

// The sheet says which of the usual codes are macro calls, and G66.1 lasts in what it calls.
TEST(CheckWords, WordsOfACodeThatCallsAMacroAreArguments) {
  const TemporaryFolder folder;
  const std::string file = folder.write("case.nc", "O1\nG81 T-5 F-9\nG82 T1.5\nM30\nO9010\nM99\n");
  const auto said = [&](const std::string& sheet) {
    return testing::g31({"check", file, "-s", folder.write("sheet.toml", sheet)}).out;
  };
  const std::string profile = "[control]\nprofile = \"fanuc-16i\"\n";
  EXPECT_NE(said(profile).find(":2:5: error: alarm 6"), std::string::npos);
  for (const std::string call : {"[macro_calls]\nG81 = 9010\n", "[parameters]\n\"6050\" = 81\n"}) {
    const std::string out = said(profile + call);
    EXPECT_EQ(out.find(":2:"), std::string::npos) << out;
    EXPECT_NE(out.find(":3:5: error: alarm 7"), std::string::npos) << out;
  }
  const std::string called = folder.write(
      "called.nc", "G66.1 P9000\nM98 P9001\nG67\nM30\nO9000\nM99\nO9001\nT-5 M1.5\nM99\n");
  EXPECT_EQ(testing::g31({"check", called}).out, "");
}

// P of a hole cycle with a point is in seconds there, as that of G04 (real programs have
// G82 ... P0.25).
TEST(CheckWords, ADwellOfAHoleWithAPointIsInSecondsOnAHaas) {
  const TemporaryFolder folder;
  const std::string file = folder.write("case.nc", fanuc_program("G82 Z-5. R2. P0.25 F100."));
  EXPECT_EQ(said_by_check(file, "haas"), "");
  EXPECT_EQ(said_by_run(file, "haas"), "");
  EXPECT_EQ(said_by_check(file, "fanuc-16i"), said_by_run(file, "fanuc-16i"));
  EXPECT_NE(said_by_run(file, "fanuc-16i"), "");
}

TEST(CheckWords, AWholeNumberWithAPointIsOneWhereTheControlTakesIt) {
  const TemporaryFolder folder;
  const auto said = [&folder](const char* block, const std::string& control) {
    const std::string file = folder.write("case.nc", fanuc_program(block));
    EXPECT_EQ(said_by_check(file, control), said_by_run(file, control)) << block;
    return said_by_run(file, control);
  };
  EXPECT_EQ(said("S2200. M3", "haas"), "");
  EXPECT_EQ(said("S2200. T1. M6", "meldas"), "");
  EXPECT_EQ(said("S2200.5", "haas"), "1 7 ILLEGAL USE OF DECIMAL POINT: S takes an integer");
  EXPECT_EQ(said("S-5.", "haas"), "1 6 ILLEGAL USE OF MINUS SIGN: S counts from 0");
  EXPECT_EQ(said("T1.", "haas"), "1 7 ILLEGAL USE OF DECIMAL POINT: T takes an integer");
  EXPECT_EQ(said("S2200.", "fanuc-16i"), "1 7 ILLEGAL USE OF DECIMAL POINT: S takes an integer");
}

TEST(CheckWords, ACodeOfTheMakerMayBeAMacroCall) {
  const TemporaryFolder folder;
  const std::string file = folder.write("case.nc", fanuc_program("G111 H1.5 B1."));
  EXPECT_EQ(said_by_check(file, "haas"), "");
}

TEST(CheckWords, ABlockThatMayBeSkippedOrIsNeverReachedIsToldAsOthersAre) {
  const TemporaryFolder folder;
  const std::string file = folder.write("case.nc", "O1\n/ M12.5\nM30\nT-5\n");
  EXPECT_EQ(said_by_check(file, "fanuc-16i"),
            "3 7 ILLEGAL USE OF DECIMAL POINT: M takes an integer");
  const std::string out = testing::g31({"check", file}).out;
  EXPECT_NE(out.find(":4:1: warning: alarm 6, ILLEGAL USE OF MINUS SIGN: T counts from 0 [NC003]"),
            out.npos)
      << out;
}

}  // namespace
}  // namespace g31::check_words_test

// `g31 check` as a user meets it: what it prints, its document, its exit code.

#include "tools/cli/check_command.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/disk/shipped.h"

namespace g31::check_command_test {
namespace {

using nlohmann::json;
using testing::places;
using testing::TemporaryFolder;

struct CheckOutput {
  int exit_code = -1;
  std::string text;
  std::string errors;
};

CheckOutput checked(const cli::CheckOptions& options) {
  const auto said = testing::captured([&] { return cli::check_command(options); });
  return {said.exit_code, said.out, said.errors};
}

CheckOutput checked_files(const std::vector<std::string>& files) {
  cli::CheckOptions options;
  options.files = files;
  return checked(options);
}

TEST(Check, SaysAllThatIsWrongInAllProgramsAtOnce) {
  TemporaryFolder folder;
  const std::string fanuc =
      folder.write("part.nc", "O1\n#1=[2+\nGOTO 7\nN8 G65 P1234\nM30\nO2\nG00 X1.\n");
  const std::string sinumerik =
      folder.write("PART.MPF", "GOTOF NOWHERE\nSUBX(1)\nR1=\nREPEAT LAB\nM30\n");
  const CheckOutput output = checked_files({fanuc, sinumerik});
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(output.errors, "");
  EXPECT_EQ(
      places(output.text, folder),
      (std::vector<std::string>{
          "part.nc:2:7: error: alarm 114, FORMAT ERROR IN MACRO: the block ends where a value is "
          "expected [NC002]",
          "part.nc:3:6: error: alarm 128, ILLEGAL MACRO SEQUENCE NUMBER: O0001 has no N7 [NC004]",
          "part.nc:4:8: error: alarm 78, NUMBER NOT FOUND: O1234 is in none of the files and "
          "folders [NC005]",
          "part.nc:7:1: error: alarm 5010, END OF RECORD: O0002 ends without M30, M02 or M99 "
          "[NC006]",
          "PART.MPF:1:7: error: alarm 14080, jump destination not found: NOWHERE [NC004]",
          "PART.MPF:2:1: error: alarm 12550, name not defined or option/function not available: "
          "SUBX [NC005]",
          "PART.MPF:3:1: error: alarm 12080, syntax error in text: the end of the block [NC002]",
          "PART.MPF:4:1: error: alarm 14082, label, program section not found: LAB [NC004]",
      }));
}

TEST(Check, ShowsTheLineAndWhatWouldBeRight) {
  TemporaryFolder folder;
  const CheckOutput output = checked_files({folder.write("case.nc", "O1\nG65 P1234\nM30\n")});
  EXPECT_NE(output.text.find("[NC005]\n"
                             "    2 | G65 P1234\n"
                             "      |     ^~~~~\n"
                             "      = give the file, or its folder with --lib\n"),
            std::string::npos)
      << output.text;
  EXPECT_EQ(output.text.find('\033'), std::string::npos);
}

TEST(Check, CarefulProgramsPassWithoutAWord) {
  TemporaryFolder folder;
  const CheckOutput output = checked_files(
      {folder.write("O0001.nc", "O1\nG65 P9 A1.\nIF[#100EQ#0]GOTO9\nM30\nN9#3000=1(NO)\n"),
       folder.write("O0009.nc", "O9\n#100=#1\nM99\n"),
       folder.write("PART.MPF", "SUB1(2)\nIF R1>1\n MSG(\"A\")\nENDIF\nM30\n"),
       folder.write("SUB1.SPF", "PROC SUB1(REAL A)\nR1=A\nM17\n")});
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_EQ(output.text, "");
  EXPECT_EQ(output.errors, "");
}

// What is wrong with the beginning of a loop is not said of its end once more.
TEST(Check, ABadBeginningOfALoopIsToldOnce) {
  TemporaryFolder folder;
  const CheckOutput output = checked_files({folder.write(
      "case.mpf", "DEF INT I\nFOR I=1 TO NOBODY\nR1=NOTHING\nENDFOR\nR2=NOWHERE\nM30\n")});
  const auto found = places(output.text, folder);
  ASSERT_EQ(found.size(), 3U) << output.text;
  EXPECT_TRUE(found[0].starts_with("case.mpf:2:12:"));
  EXPECT_TRUE(found[1].starts_with("case.mpf:3:4:"));
  EXPECT_TRUE(found[2].starts_with("case.mpf:5:4:"));
  const CheckOutput of_fanuc = checked_files({folder.write(
      "case.nc",
      "O1\nWHILE[#1LT3]DO1 #1=#1+1\nWHILE[#1 LT]DO2\nDO3 X1\nEND3\nEND2\nEND1\nEND1\nM30\n")});
  const auto others = places(of_fanuc.text, folder);
  ASSERT_EQ(others.size(), 4U) << of_fanuc.text;
  EXPECT_TRUE(others[0].starts_with("case.nc:2:17: error: alarm 127,"));
  EXPECT_TRUE(others[1].starts_with("case.nc:3:12: error: alarm 114,"));
  EXPECT_TRUE(others[2].starts_with("case.nc:4:5: error: alarm 127,"));
  EXPECT_TRUE(others[3].starts_with("case.nc:8:1: warning: alarm 124,"));
}

TEST(Check, ArgumentsAreHeldAgainstTheProcOfTheProgramCalled) {
  TemporaryFolder folder;
  const std::string main = folder.write("PART.MPF",
                                        "DEF INT COUNT\n"
                                        "SUBX(1,2,3)\n"
                                        "SUBX(1,5)\n"
                                        "SUBX(1)\n"
                                        "SUBX(\"A\",COUNT)\n"
                                        "CALL \"PLAIN\" (1)\n"
                                        "MCALL SUBX(,COUNT,7)\n"
                                        "SUBX(,COUNT)\n"
                                        "ELSEWHERE(1)\n"
                                        "SUBX(1,2,3) P0\n"
                                        "M30\n");
  const std::string sub = folder.write("SUBX.SPF", "PROC SUBX(REAL A, VAR INT B)\nB=A\nM17\n");
  const std::string plain = folder.write("PLAIN.SPF", "R1=1\nM17\n");
  const CheckOutput output = checked_files({main, sub, plain});
  EXPECT_EQ(places(output.text, folder),
            (std::vector<std::string>{
                "PART.MPF:2:1: error: alarm 12340, number of arguments exceeded: SUBX takes 2 "
                "arguments, 3 are given [NC009]",
                "PART.MPF:3:8: error: alarm 12320, argument must be call-by-reference: SUBX, B "
                "[NC009]",
                "PART.MPF:4:1: error: alarm 12300, call-by-reference argument missing on "
                "subroutine call: SUBX, B [NC009]",
                "PART.MPF:5:6: error: alarm 12330, type of argument incorrect: SUBX, A: STRING "
                "is not REAL [NC009]",
                "PART.MPF:6:6: error: alarm 14510, PROC instruction missing on subroutine call: "
                "PLAIN [NC009]",
                "PART.MPF:7:7: error: alarm 12340, number of arguments exceeded: SUBX takes 2 "
                "arguments, 3 are given [NC009]",
                "PART.MPF:9:1: error: alarm 12550, name not defined or option/function not "
                "available: ELSEWHERE [NC005]",
            }));
}

TEST(Check, OfProgramsThatAreMissingOnlyOneThatIsWrittenMayBe) {
  TemporaryFolder folder;
  const std::string file = folder.write("PART.MPF",
                                        "DEF INT FAULT\n"
                                        "WRITE(FAULT,\"/_N_MPF_DIR/_N_LOG_MPF\",\"R1=2\")\n"
                                        "CALL \"LOG\"\n"
                                        "MEASUREALL\n"
                                        "M30\n");
  EXPECT_EQ(places(checked_files({file}).text, folder),
            (std::vector<std::string>{
                "PART.MPF:4:1: error: alarm 12550, name not defined or option/function not "
                "available: MEASUREALL [NC005]",
            }));
  const std::string any = folder.write("ANY.MPF",
                                       "DEF INT FAULT\n"
                                       "WRITE(FAULT,\"LOG\"<<R1,\"R1=2\")\n"
                                       "MEASUREALL\n"
                                       "M30\n");
  EXPECT_EQ(places(checked_files({any}).text, folder), std::vector<std::string>());
}

TEST(Check, ACallIsRightWhereOneOfTheProgramsOfItsNameTakesIt) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("old"));
  const std::string old = folder.write("old/SUBX.SPF", "PROC SUBX(INT A)\nM17\n");
  const std::string now = folder.write("SUBX.SPF", "PROC SUBX(INT A, INT B)\nM17\n");
  const std::string main = folder.write("PART.MPF", "SUBX(1)\nSUBX(1,2)\nSUBX(1,2,3)\nM30\n");
  const CheckOutput output = checked_files({main, old, now});
  const auto found = places(output.text, folder);
  ASSERT_EQ(found.size(), 1U) << output.text;
  EXPECT_TRUE(found[0].starts_with("PART.MPF:3:1: error: alarm 12340")) << found[0];
}

TEST(Check, ConstantsThatDoNotFitAreTold) {
  TemporaryFolder folder;
  const std::string main = folder.write("PART.MPF",
                                        "DEF STRING[5] NAME\n"
                                        "DEF INT COUNT=2147483648\n"
                                        "DEF REAL LLI 0 ULI 10 DEPTH=3\n"
                                        "DEF CHAR LETTER\n"
                                        "DEF REAL LIST[2,3]\n"
                                        "NAME=\"TOO LONG\"\n"
                                        "LETTER=256\n"
                                        "DEPTH=11\n"
                                        "R1=LIST[1,3]\n"
                                        "R2=R1/0\n"
                                        "SUBX(\"ABCDE\")\n"
                                        "IF FALSE\nNAME=\"TOO LONG\"\nENDIF\n"
                                        "NAME=\"FITTS\" COUNT=2147483647 LETTER=255\n"
                                        "DEPTH=10 LIST[1,2]=R1/2 LIST[COUNT,0]=1\n"
                                        "M30\n");
  const std::string sub = folder.write("SUBX.SPF", "PROC SUBX(STRING[4] A)\nM17\n");
  const CheckOutput output = checked_files({main, sub});
  EXPECT_EQ(
      places(output.text, folder),
      (std::vector<std::string>{
          "PART.MPF:2:15: error: alarm 14096, illegal type conversion: 2147483648 is not INT "
          "[NC002]",
          "PART.MPF:6:1: error: alarm 12210, string too long: \"TOO LONG\" in STRING[5] [NC002]",
          "PART.MPF:7:8: error: alarm 14096, illegal type conversion: 256 is not CHAR [NC002]",
          "PART.MPF:8:1: error: alarm 17090, value above upper limit: DEPTH = 11 [NC002]",
          "PART.MPF:9:11: error: alarm 17030, illegal array index 2: LIST[3] of 3 [NC002]",
          "PART.MPF:10:4: error: alarm 14051, arithmetic error in part program: division by zero "
          "[NC002]",
          "PART.MPF:11:6: error: alarm 12210, string too long: SUBX, A: \"ABCDE\" in STRING[4] "
          "[NC009]",
          "PART.MPF:13:1: warning: alarm 12210, string too long: \"TOO LONG\" in STRING[5] [NC003]",
      }));
}

TEST(Check, ConstantsThatDoNotFitOnAFanucAreTold) {
  TemporaryFolder folder;
  const std::string main = folder.write("part.nc",
                                        "O1\n"
                                        "#1=#2/0\n"
                                        "#1=SQRT[-4]+1\n"
                                        "#1=ASIN[1.5]\n"
                                        "#1=#2 MOD [1-1]\n"
                                        "#1=30000000*200 AND #2\n"
                                        "#1=#34\n"
                                        "#[30+4]=1\n"
                                        "#5041=1\n"
                                        "IF[LN[0] GT 1]GOTO 9\n"
                                        "G1 X[#1/0] F100\n"
                                        "G1 X1234567890 F100\n"
                                        "G65 P2 L10000\n"
                                        "/ #1=1/0\n"
                                        "#1=123456789\n"
                                        "G1 / X[1/0] F100\n"
                                        "IF[1 EQ 2]THEN #1=1/0\n"
                                        "N9 #1=SQRT[4]/2 MOD 3\n"
                                        "#[#1]=#[#2]/#3\n"
                                        "#500=#5041+#4001\n"
                                        "G65 P2 L9999\n"
                                        "#1=TAN[450]\n"
                                        "#1=BIN[10]+BIN[16]\n"
                                        "#1=BCD[-1]\n"
                                        "M30\n"
                                        "O2\n"
                                        "M99\n");
  const CheckOutput output = checked_files({main});
  EXPECT_EQ(
      places(output.text, folder),
      (std::vector<std::string>{
          "part.nc:2:4: error: alarm 112, DIVIDED BY ZERO: the divisor is 0 [NC002]",
          "part.nc:3:4: error: alarm 119, ILLEGAL ARGUMENT: SQRT of -4 [NC002]",
          "part.nc:4:4: error: alarm 111, ILLEGAL ARGUMENT: the argument is 1.5 [NC002]",
          "part.nc:5:4: error: alarm 112, DIVIDED BY ZERO: the divisor of MOD is 0 [NC002]",
          "part.nc:6:4: error: alarm 110, DATA OVERFLOW: an operand does not fit 32 bits [NC002]",
          "part.nc:7:4: error: alarm 115, ILLEGAL VARIABLE NUMBER: #34 cannot be read [NC002]",
          "part.nc:8:1: error: alarm 115, ILLEGAL VARIABLE NUMBER: #34 cannot be written [NC002]",
          "part.nc:9:1: error: alarm 116, WRITE PROTECTED VARIABLE: #5041 cannot be written "
          "[NC002]",
          "part.nc:10:4: error: alarm 119, ILLEGAL ARGUMENT: LN of 0 [NC002]",
          "part.nc:11:5: error: alarm 112, DIVIDED BY ZERO: the divisor is 0 [NC002]",
          "part.nc:12:4: error: alarm 3, TOO MANY DIGITS: 10 digits, the control takes 8 here "
          "[NC002]",
          "part.nc:13:8: error: alarm 9, ILLEGAL ADDRESS INPUT: L repeats 0 to 9999 times [NC002]",
          "part.nc:14:6: error: alarm 112, DIVIDED BY ZERO: the divisor is 0 [NC002]",
          "part.nc:15:4: error: alarm 3, TOO MANY DIGITS: 9 digits, the control takes 8 here "
          "[NC002]",
          "part.nc:17:3: warning: two constants are compared: it always comes out the same [NC017]",
          "part.nc:17:19: warning: alarm 112, DIVIDED BY ZERO: the divisor is 0 [NC003]",
          "part.nc:22:4: error: alarm 112, DIVIDED BY ZERO: TAN of 450 [NC002]",
          "part.nc:23:4: error: alarm 119, ILLEGAL ARGUMENT: BIN of 10 [NC002]",
          "part.nc:24:4: error: alarm 119, ILLEGAL ARGUMENT: BCD of -1 [NC002]",
      }));
}

TEST(Check, ACallOfProgram0IsTold) {
  TemporaryFolder folder;
  const std::string main =
      folder.write("part.nc", "O1\nM98 P110000\nM98 P0\nG65 P0\nM30\nO0000\nM99\n");
  const CheckOutput output = checked_files({main});
  const std::string what = "error: alarm 78, NUMBER NOT FOUND: 0 is no number of a program [NC005]";
  EXPECT_EQ(places(output.text, folder),
            (std::vector<std::string>{"part.nc:2:5: " + what, "part.nc:3:5: " + what,
                                      "part.nc:4:5: " + what}));
}

TEST(Check, ShippedProgramsPassWithoutAWord) {
  const auto macros = disk::shipped_folder("macros");
  ASSERT_TRUE(macros);
  const CheckOutput output = checked_files({*macros});
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_EQ(output.text, "");
}

TEST(Check, SubprogramsMayLieInAnotherFolderOrFile) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("lib"));
  std::filesystem::create_directory(folder.path("main"));
  const std::string sub = folder.write("lib/O0009.nc", "O9\nM99\n");
  const std::string main = folder.write("main/O0001.nc", "O1\nM98 P9\nM30\n");
  EXPECT_EQ(checked_files({main}).exit_code, 1);
  EXPECT_EQ(checked_files({main, sub}).exit_code, 0);
  cli::CheckOptions options;
  options.files = {main};
  options.libraries = {folder.path("lib")};
  EXPECT_EQ(checked(options).exit_code, 0);
}

TEST(Check, AFolderIsAllProgramsBelowIt) {
  TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("a/b"));
  folder.write("z.nc", "O1\nGOTO 1\n");
  folder.write("a/b/O1234", "O1234\nGOTO 2\n");
  folder.write("a/P.MPF", "GOTO GONE\n");
  folder.write("a/G.DEF", "DEF NCK REAL\n");
  folder.write("a/notes.txt", "GOTO 3\n");
  folder.write("table.def", "ROW(1)\n");
  folder.write("m.txt", "%\nO5(M)\nGOTO 4\n%\n");
  folder.write("a/n.prg", "%_N_N_MPF\nGOTO GONE\n");
  folder.write("page.ps", "%!PS\nGOTO 5\n");
  folder.write("result.prn", "%\nX10.000\nGOTO 6\n%\n");
  folder.write("thesis.tex", "% O1\nGOTO 7\n");
  const CheckOutput output = checked_files({folder.path("")});
  const auto found = places(output.text, folder);
  ASSERT_EQ(found.size(), 6U) << output.text;
  EXPECT_TRUE(found[0].starts_with("m.txt:3:6:")) << found[0];
  EXPECT_TRUE(found[1].starts_with("z.nc:2:6:"));
  EXPECT_TRUE(found[2].starts_with("a/G.DEF:1:"));
  EXPECT_TRUE(found[3].starts_with("a/P.MPF:1:6:"));
  EXPECT_TRUE(found[4].starts_with("a/n.prg:2:6:")) << found[4];
  EXPECT_TRUE(found[5].starts_with("a/b/O1234:2:6:"));
}

TEST(Check, AFolderWithoutAProgramIsNoCheckedOne) {
  TemporaryFolder folder;
  folder.write("part.dat", "GOTO 1\n");
  const CheckOutput output = checked_files({folder.path("")});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("no program is in this folder"), std::string::npos) << output.errors;
}

TEST(Check, DefinitionFilesOfASisterFolderHoldForTheProgramsOfAFolder) {
  TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("a/DEF.DIR"));
  std::filesystem::create_directories(folder.path("a/MPF.DIR"));
  std::filesystem::create_directories(folder.path("b/DEF.DIR"));
  std::filesystem::create_directories(folder.path("b/MPF.DIR"));
  folder.write("a/DEF.DIR/MGUD.DEF", "DEF NCK REAL OF_A=1\n");
  folder.write("a/MPF.DIR/TT.MPF", "R1=OF_A\nM30\n");
  folder.write("b/DEF.DIR/MGUD.DEF", "DEF NCK STRING[9] OF_B=\"X\"\n");
  folder.write("b/MPF.DIR/TT.MPF", "OF_B=\"Y\"\nM30\n");
  folder.write("b/table.def", "ROW(1)\n");  // of other software
  const CheckOutput output = checked_files({folder.path("")});
  EXPECT_EQ(output.exit_code, 0) << output.text;  // each has the MGUD that lies nearest
}

TEST(Check, AnErrorInADefinitionFileOfALibraryEndsEveryRun) {
  TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("lib"));
  folder.write("lib/MGUD.DEF", "DEF NCK REAL KK=QQ\n");
  cli::CheckOptions options;
  options.files = {folder.write("TT.MPF", "R1=1\nM30\n")};
  options.libraries = {folder.path("lib")};
  const CheckOutput output = checked(options);
  EXPECT_EQ(output.exit_code, 1);
  const auto found = places(output.text, folder);
  ASSERT_EQ(found.size(), 1U) << output.text;
  EXPECT_TRUE(found[0].starts_with("lib/MGUD.DEF:1:17:")) << found[0];
}

TEST(Check, AWrongBlockMayBeTheEndThatIsMissing) {
  TemporaryFolder folder;
  const CheckOutput wrong_end = checked_files({folder.write("case.nc", "O1\nG00 X1.\nM30 ]\n")});
  EXPECT_EQ(places(wrong_end.text, folder).size(), 1U) << wrong_end.text;
  EXPECT_EQ(wrong_end.text.find("NC006"), std::string::npos);
  const CheckOutput no_end = checked_files({folder.write("case.nc", "O1\nG00 X1.\n")});
  EXPECT_NE(no_end.text.find("[NC006]"), std::string::npos);
}

TEST(Check, WhatNoWayLeadsToIsAWarning) {
  TemporaryFolder folder;
  const CheckOutput output =
      checked_files({folder.write("case.nc", "O1\nM30\n#1=[2+\nG65 P1234\n")});
  EXPECT_EQ(output.exit_code, 1);
  const auto found = places(output.text, folder);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_TRUE(found[0].starts_with("case.nc:3:7: warning:"));
  EXPECT_TRUE(found[1].ends_with("[NC003]"));
}

TEST(Check, TheDocumentHasTheShapeOfTheContract) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  // Columns count characters: the text before the number has one of two bytes and one of Latin-1.
  options.files = {folder.write("case.nc", "O1\n(\xC3\xA4\xE4)G65 P1234\nM30\n")};
  options.json = folder.path("findings.json");
  EXPECT_EQ(checked(options).exit_code, 1);
  const json document = json::parse(testing::text_of(options.json));
  EXPECT_EQ(document, json::parse(R"({"schema": "g31.check/1", "findings": [{
    "rule": "NC005", "level": "error",
    "message": "alarm 78, NUMBER NOT FOUND: O1234 is in none of the files and folders",
    "file": ")" + options.files[0] +
                                  R"(", "line": 2, "column": 9, "end_line": 2, "end_column": 14,
    "fix": null, "line_text": "(\u00e4?)G65 P1234", "remedy": "give the file, or its folder with --lib",
    "alarm": 78}]})"));
  options.json = "-";
  EXPECT_EQ(json::parse(checked(options).text), document);
  options.json = "";
  options.format = cli::CheckOptions::Format::Json;
  EXPECT_EQ(json::parse(checked(options).text), document);
  options.format = cli::CheckOptions::Format::Github;
  EXPECT_EQ(checked(options).text,
            "::error file=" + options.files[0] +
                ",line=2,col=9,endLine=2,endColumn=14,title=NC005::alarm 78, NUMBER NOT FOUND: "
                "O1234 is in none of the files and folders\n");
}

TEST(Check, APlaceAtTheEndOfALineStaysOnIt) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("case.nc", "O1\n#1=[2+\nM30\n")};
  options.format = cli::CheckOptions::Format::Json;
  const json finding = json::parse(checked(options).text)["findings"][0];
  EXPECT_EQ(finding["line"], 2);
  EXPECT_EQ(finding["column"], 7);
  EXPECT_EQ(finding["end_line"], 2);
  EXPECT_EQ(finding["end_column"], 8);
}

TEST(Check, AProgramForALatheIsRefusedWithOneLine) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("o1.nc",
                                "O1\nG50 S2000\nT0101\nG96 S200 M03\nG1 U2. W-5. F.2\n"
                                "G65 P4711\nM30\n")};
  options.control = "fanuc-0i";
  const CheckOutput output = checked(options);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.text.find("o1.nc:2:1: error: a program for a lathe (G50 S, T of four digits, "
                             "G96 S, U or W): g31 runs programs for machining centres [NC008]"),
            output.text.npos)
      << output.text;
  EXPECT_EQ(output.text.find("error:", output.text.find("error:") + 1), output.text.npos)
      << output.text;
}

TEST(Check, FilesThatAreNoProgramsHaveTheirOwnMessage) {
  TemporaryFolder folder;
  const CheckOutput output =
      checked_files({folder.write("empty.nc", ""), folder.write("EMPTY.MPF", "\n\n"),
                     folder.write("picture.nc", std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16))});
  EXPECT_EQ(output.exit_code, 1);
  const auto found = places(output.text, folder);
  ASSERT_EQ(found.size(), 3U) << output.text;
  EXPECT_EQ(found[0], "empty.nc:1:1: error: no program in this file [NC001]");
  EXPECT_EQ(found[1], "EMPTY.MPF:1:1: error: no program in this file [NC001]");
  EXPECT_EQ(found[2], "picture.nc:1:1: error: this file is not text [NC001]");
}

TEST(Check, AMissingFileIsExitCodeTwoAndTheOthersAreCheckedAllTheSame) {
  TemporaryFolder folder;
  const CheckOutput output =
      checked_files({folder.path("gone.nc"), folder.write("case.nc", "O1\nGOTO 1\nM30\n")});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_EQ(places(output.text, folder).size(), 1U);
  EXPECT_EQ(output.errors, "g31: error: " + folder.path("gone.nc") + ": no such file or folder\n");
}

TEST(Check, OptionsDecideWhatCounts) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("case.nc", "O1\nM30\n#1=[2+\n")};
  options.fail_on = source::Severity::Error;
  EXPECT_EQ(checked(options).exit_code, 0);
  EXPECT_NE(checked(options).text, "");
  options.fail_on = source::Severity::Warning;
  options.disabled = {"NC003"};
  EXPECT_EQ(checked(options).exit_code, 0);
  EXPECT_EQ(checked(options).text, "");
  options.disabled = {"NC03"};
  EXPECT_EQ(checked(options).exit_code, 2);
  EXPECT_NE(checked(options).errors.find("did you mean NC003?"), std::string::npos);
  options.disabled = {};
  options.libraries = {folder.path("gone")};
  EXPECT_EQ(checked(options).exit_code, 2);
  options.libraries = {};
  options.control = "fanuk-16i";
  EXPECT_EQ(checked(options).exit_code, 5);
}

TEST(Check, TheControlDecidesWhatIsWrong) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("case.nc", "O1\nIF[#1EQ1]THEN#2=1\nM30\n")};
  EXPECT_EQ(checked(options).exit_code, 0);
  options.control = "brother";
  EXPECT_EQ(checked(options).exit_code, 1);
}

TEST(Check, WhatOnlySeries30iHasIsWrongOnSeries16i) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write(
      "case.nc", "O1\n[#X]=1\n#1=[#Y]+1\n#2=POW[2,3]\n#3=PRM[1]\n#4=PRM[1]/[2]\nM30\n")};
  options.control = "fanuc-16i";
  const CheckOutput output = checked(options);
  EXPECT_EQ(
      places(output.text, folder),
      (std::vector<std::string>{
          "case.nc:2:3: error: alarm 114, FORMAT ERROR IN MACRO: this control has no names of "
          "variables [NC002]",
          "case.nc:3:6: error: alarm 114, FORMAT ERROR IN MACRO: this control has no names of "
          "variables [NC002]",
          "case.nc:4:4: error: alarm 113, IMPROPER COMMAND: this control has no POW [NC002]",
          "case.nc:5:4: error: alarm 113, IMPROPER COMMAND: this control has no PRM [NC002]",
          "case.nc:6:4: error: alarm 113, IMPROPER COMMAND: this control has no PRM [NC002]"}))
      << output.text;
  options.control = "fanuc-30i";
  EXPECT_EQ(checked(options).exit_code, 0) << "a run knows the names";
}

/// SINUMERIK passes over control characters, and a tape or a line leaves some.
TEST(Check, AFewControlCharactersMakeNoPictureOfAText) {
  TemporaryFolder folder;
  EXPECT_EQ(checked_files({folder.write("CASE.MPF", "R1=1\n\x01R2=2\nM30\n")}).exit_code, 0);
}

TEST(Check, ASheetSaysWhatTheControlKnows) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("part.nc", "R1=$MN_OEM_LIMIT+PALLET[1]\nM30\n")};
  const std::string sheet = folder.write("machine.toml",
                                         "[control]\nprofile = \"sinumerik-828d\"\n"
                                         "[machine_data]\n\"$MN_OEM_LIMIT\" = 2.0\n"
                                         "[gud]\nPALLET = [1.0, 2.0]\n");
  options.control = "sinumerik-828d";
  const CheckOutput without = checked(options);
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_NE(without.text.find("$MN_OEM_LIMIT"), without.text.npos) << without.text;
  options.control = "";
  options.setups = {sheet};
  const CheckOutput with = checked(options);
  EXPECT_EQ(with.exit_code, 0);
  EXPECT_EQ(with.text, "");
}

TEST(Check, NamesOfAxesComeFromTheSheet) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("part.mpf", "G0 SP1=90 W10\nPOS[SP1]=IC(5)\nM30\n")};
  const CheckOutput without = checked(options);
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_NE(without.text.find("names in [machine.axes]"), without.text.npos) << without.text;
  options.setups = {folder.write("machine.toml", "[machine.axes.C]\nnames = \"SP1\"\n")};
  const CheckOutput with = checked(options);
  EXPECT_EQ(with.exit_code, 0);
  EXPECT_EQ(with.text, "");
}

TEST(Check, ACycleThatIsNotSimulatedIsAWarningUnlessThereIsAProgramOfItsName) {
  TemporaryFolder folder;
  const CheckOutput without =
      checked_files({folder.write("part.mpf", "G0 X1\nCYCLE96(\"CONTOUR\",2)\nM30\n")});
  EXPECT_EQ(without.exit_code, 1);
  EXPECT_NE(without.text.find("part.mpf:2:1: warning: CYCLE96, thread undercut"), without.text.npos)
      << without.text;
  EXPECT_NE(without.text.find("[NC007]"), without.text.npos) << without.text;
  folder.write("CYCLE96.SPF", "PROC CYCLE96(STRING[20] NAME,REAL MID)\nM17\n");
  EXPECT_EQ(checked_files({folder.path("part.mpf")}).exit_code, 0);
}

TEST(Check, ASheetWithAMistakeIsRefusedAtItsPlace) {
  TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("part.mpf", "M30\n")};
  options.setups = {folder.write("machine.toml", "[machne_data]\n")};
  const CheckOutput output = checked(options);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("machine.toml:1"), output.errors.npos) << output.errors;
}

TEST(Check, ListsItsRules) {
  cli::CheckOptions options;
  options.lists_rules = true;
  const CheckOutput output = checked(options);
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_TRUE(output.text.starts_with("NC001  error    no program: ")) << output.text;
}

}  // namespace
}  // namespace g31::check_command_test

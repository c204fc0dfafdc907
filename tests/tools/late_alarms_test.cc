// Alarms of blocks that have waited for others: their place, who called their program, its locals.

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace g31::late_alarms_test {
namespace {

constexpr const char* kFanuc = "[control]\nprofile = \"fanuc-16i\"\n[tools.1]\nradius = 3.0\n";
constexpr const char* kSinumerik =
    "[control]\nprofile = \"sinumerik-828d\"\n[tools.1]\nlength = 0.0\nradius = 3.0\ntype = 120\n";

/// "number line called from line, line {locals}"
std::string alarm_of(const testing::RunOutput& output) {
  const auto& alarm = output.document.at("alarm");
  if (alarm.is_null()) {
    return "none: " + output.errors;
  }
  std::string text = alarm["number"].dump() + " " + alarm["line"].dump() + " from";
  for (const auto& call : alarm["calls"]) {
    text += " " + call["program"].get<std::string>() + ":" + call["line"].dump();
  }
  return text + " " + alarm["locals"].dump();
}

std::string alarm_of(const std::string& name, const std::string& sheet, const std::string& text) {
  testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(name, text)};
  options.setups = {folder.write("sheet.toml", sheet)};
  return alarm_of(testing::run_program(options));
}

TEST(LateAlarms, OfACompensationHaveTheCallsOfTheirBlock) {
  EXPECT_EQ(alarm_of("a.nc", kFanuc,
                     "O1\nG17 G90 G94 F100\n#1=11\nG65 P2\nG65 P3\nM30\n"
                     "O2\n#1=5\nG41 D1 G01 X5. Y10.\nX10.\nX11.\nM99\n"
                     "O3\n#1=7\nX10. Y10.1\nX9.\nM99\n"),
            "41 11 from O0001:4 {}")
      << "O2 has ended: its locals are gone, those of O3 are not its own";
}

TEST(LateAlarms, HaveTheLocalsOfTheirLevelWhereItStillRuns) {
  EXPECT_EQ(alarm_of("a.nc", kFanuc,
                     "O1\nG17 G90 G94 F100\n#1=11\nG41 D1 G01 X5. Y10.\nX10.\nX11.\nG65 P3\nM30\n"
                     "O3\n#1=7\nX10. Y10.1\nX9.\nM99\n"),
            "41 6 from {\"#1\":11.0}");
}

TEST(LateAlarms, OfACornerHaveTheCallsOfTheirBlock) {
  EXPECT_EQ(alarm_of("a.nc", kFanuc,
                     "O1\nG17 G90 G94 F100\n#1=11\nG65 P2\nG65 P3\nM30\n"
                     "O2\n#1=5\nG01 X5.,R20.\nM99\n"
                     "O3\n#1=7\nY10.\nM99\n"),
            "55 9 from O0001:4 {}");
}

TEST(LateAlarms, OnASinumerikToo) {
  EXPECT_EQ(alarm_of("A.MPF", kSinumerik,
                     "T1 D1 M6\nG17 G90 G94 F100\nGO\nBACK\nM30\n"
                     "%_N_GO_SPF\nPROC GO\nDEF INT DEEP=5\nG41 G1 X5 Y0\nX20\nX21\nRET\n"
                     "%_N_BACK_SPF\nPROC BACK\nDEF INT DEEP=7\nX20 Y0.1\nX19\nRET\n"),
            "10751 11 from A:3 {}");
}

TEST(LateAlarms, ALineByAngleThatHasNoEndIsToldAtItsOwnCall) {
  EXPECT_EQ(alarm_of("A.MPF", kSinumerik,
                     "T1 D1\nG17 G90 G94 F100 G1\nGO\nBACK\nM30\n"
                     "%_N_GO_SPF\nPROC GO\nANG=30\nRET\n"
                     "%_N_BACK_SPF\nPROC BACK\nM30\nRET\n")
                .substr(0, 17),
            "12110 8 from A:3 ");
}

// The axes lag: with a gain of 1/s the ball of X53 meets the block long after the move has ended.
TEST(LateAlarms, ACollisionOfAxesThatStillFollowIsThatOfTheirMove) {
  constexpr const char* kLagging =
      "[control]\nprofile = \"fanuc-30i\"\n"
      "[machine.axes.X]\ntravel = [-100.0, 100.0]\nacceleration = 500.0\nservo_gain = 1.0\n"
      "[probe]\nball_diameter = 6.0\nlength = 50.0\n"
      "[[part]]\nname = \"block\"\nshape = \"block\"\nlength = 10.0\nwidth = 40.0\nheight = 20.0\n"
      "at = [60.0, 0.0, -100.0]\n";
  for (const std::string behind :
       {"#1=1\nM30\n", "G4 X9.\nM30\n", "#3000=5\n", "#500=1/0\n", "GOTO1\nN1 M30\n"}) {
    testing::TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write(
        "a.nc", "O1\nG90 G54 G0 Z-60.\nG1 X40. F3000.\nM98 P2\n" + behind + "O2\nX53.\nM99\n")};
    options.setups = {folder.write("sheet.toml", kLagging)};
    options.moves = true;
    const testing::RunOutput run = testing::run_program(options);
    EXPECT_EQ(run.document.at("status"), "collision") << run.errors;
    const auto& message = run.document.at("diagnostics").back();
    const auto line = 6 + std::count(behind.begin(), behind.end(), '\n');
    EXPECT_EQ(message.at("line"), line) << behind << run.errors;
    ASSERT_EQ(message.at("notes").size(), 1U) << behind;
    EXPECT_EQ(message.at("notes")[0].at("line"), 4);
    EXPECT_EQ(run.document.at("moves").size(), 2U) << "the one that met the block is none of them";
  }
}

TEST(ExecutedTexts, AreAmongTheCalls) {
  EXPECT_EQ(alarm_of("A.MPF", kSinumerik,
                     "R1=1\nEXECSTRING(\"SUB8(3)\")\nM30\n"
                     "%_N_SUB8_SPF\nPROC SUB8(INT A)\nR3=1/R99\nRET\n"),
            "14051 6 from A:1 A:2 {\"A\":3.0}");
  EXPECT_EQ(alarm_of("A.MPF", kSinumerik, "R1=1\nEXECSTRING(\"R3=1/R99\")\nM30\n").substr(0, 14),
            "14051 1 from A")
      << "in the text itself";
}

}  // namespace
}  // namespace g31::late_alarms_test

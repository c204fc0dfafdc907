// What touches that count are wrong by, as notes with a number.

#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::touch_notes_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

RunOutput run_on(const std::string& sheet, const std::string& name, const std::string& program) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(name, program)};
  options.setups = {folder.write("sheet.toml", sheet)};
  return run_program(options);
}

/// The messages by their code.
std::multimap<std::string, std::string> notes_of(const RunOutput& output) {
  std::multimap<std::string, std::string> notes;
  for (const auto& diagnostic : output.document["diagnostics"]) {
    EXPECT_EQ(diagnostic["severity"], "note") << diagnostic["message"];
    notes.emplace(diagnostic["code"], diagnostic["message"]);
  }
  return notes;
}

/// The number before " mm" at the end of a message.
double last_mm(const std::string& message) {
  const std::size_t end = message.rfind(" mm");
  return std::stod(message.substr(message.rfind(' ', end - 1) + 1));
}

/// A wall turned by 25 degrees about Z, met along X.
constexpr const char* kTurnedWall =
    "[probe]\nball_diameter = 6.0\nlength = 100.0\n"
    "[[part]]\nname = \"box\"\nshape = \"block\"\nheight = 40.0\nat = [80.0, 0.0, 0.0]\n"
    "rotate_deg = [0.0, 0.0, 25.0]\n"
    "[start]\nX = 0.0\nZ = 80.0\n";

TEST(TouchNotes, ObliqueByTheAngleAndTheBall) {
  const double errs = 3.0 * (1.0 / std::cos(25.0 * std::numbers::pi / 180.0) - 1.0);
  for (const auto& [name, program] :
       {std::pair("oblique.nc", "O1\nG31 X100. F100.\n#1=#5061\nIF[#1EQ0]GOTO1\nN1 M30\n"),
        std::pair("oblique.mpf", "MEAS=1 G1 X100 F100\nR1=$AA_MM[X] R2=$AC_MEA[1]\nM30\n")}) {
    const RunOutput output = run_on(kTurnedWall, name, program);
    EXPECT_EQ(output.exit_code, 0) << output.errors;
    const auto notes = notes_of(output);
    ASSERT_EQ(notes.count("PRB316"), 1U) << output.errors;
    const std::string& text = notes.find("PRB316")->second;
    EXPECT_NE(text.find("25.0 degrees off"), std::string::npos) << text;
    // Printed with three places: 3 mm (1 / cos 25 - 1) = 0.310 mm.
    EXPECT_NEAR(last_mm(text), errs, 0.0005) << text;
  }
}

TEST(TouchNotes, NothingOfATouchThatNobodyReadsNorAlongTheNormal) {
  EXPECT_TRUE(notes_of(run_on(kTurnedWall, "fast.nc", "O1\nG31 X100. F100.\nM30\n")).empty());
  std::string straight = kTurnedWall;
  straight.replace(straight.find("25.0"), 4, "0.0");
  EXPECT_TRUE(
      notes_of(run_on(straight, "head_on.nc", "O1\nG31 X100. F100.\n#1=#5061\nM30\n")).empty());
}

TEST(TouchNotes, WhatIsAllowedIsNeitherToldNorCounted) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {
      folder.write("case.nc", "O1\nG31 X100. F100.\n#1=#5061\nG00 X0\nG31 X-9.\nM30\n")};
  options.setups = {folder.write("sheet.toml", kTurnedWall)};
  const RunOutput all = run_program(options);
  EXPECT_EQ(all.exit_code, 1) << all.errors;
  EXPECT_EQ(all.document["diagnostics"].size(), 2U);
  options.allowed = {"PRB316"};
  EXPECT_EQ(run_program(options).document["diagnostics"].size(), 1U);
  options.allowed = {"PRB301", "PRB316"};
  const RunOutput none = run_program(options);
  EXPECT_EQ(none.exit_code, 0) << none.errors;
  EXPECT_EQ(none.errors, "");
}

TEST(TouchNotes, EachBlockOnce) {
  const RunOutput output = run_on(kTurnedWall, "loop.nc",
                                  "O1\nWHILE[#1LT3]DO1\nG31 X100. F100.\n#100=#5061\nG00 X0\n"
                                  "#1=#1+1\nEND1\nM30\n");
  EXPECT_EQ(notes_of(output).count("PRB316"), 1U) << output.errors;
}

TEST(TouchNotes, AnotherFeedThanThatOfTheCalibration) {
  const std::string sheet =
      "[probe]\nlength = 100.0\ntrigger_delay_s = 0.004\ncalibrated_feed = 50.0\n"
      "[[part]]\nshape = \"block\"\nheight = 40.0\nat = [80.0, 0.0, 0.0]\n[start]\nZ = 80.0\n";
  const std::string program =
      "O1\nG31 X100. F300.\n#1=#5061\nG00 X0\nG31 X100. F50.\n#2=#5061\nM30\n";
  const auto notes = notes_of(run_on(sheet, "feeds.nc", program));
  ASSERT_EQ(notes.size(), 1U);
  // 4 ms at 250 mm/min more: 0.0167 mm.
  EXPECT_NEAR(last_mm(notes.find("PRB317")->second), 0.004 * 250.0 / 60.0, 0.00005);
}

TEST(TouchNotes, ABallThatLeavesAFaceGrazesNothing) {
  const std::string sheet =
      "[control]\nprofile = \"sinumerik-828d\"\n[probe]\nball_diameter = 6.0\nlength = 100.0\n"
      "[[part]]\nshape = \"block\"\n[start]\nZ = 120.0\n";
  const RunOutput run = run_on(sheet, "falling.mpf",
                               "MEAS=1 G1 F300 Z90\nMEAS=-1 G1 F100 Z120\nR1=$AA_MW[Z]\nIF "
                               "$AC_MEA[1]==0\nSETAL(65001)\nENDIF\nM30\n");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_EQ(notes_of(run).count("PRB320"), 0U) << run.errors;
}

TEST(TouchNotes, GrazingIsAWarning) {
  // The ball's centre passes the upper edge 0.2 um lower than its radius; at 2 um the angle between
  // normal and move is acos(sqrt(2 r e) / r) = 87.9 degrees, which is oblique.
  const std::string sheet =
      "[probe]\nball_diameter = 6.0\nlength = 100.0\n"
      "[[part]]\nshape = \"block\"\nheight = 40.0\nat = [80.0, 0.0, 0.0]\n[start]\nZ = ";
  const std::string program = "O1\nG31 X100. F100.\n#1=#5061\nIF[#1EQ0]GOTO1\nN1 M30\n";
  const RunOutput grazing = run_on(sheet + "102.9998\n", "grazing.nc", program);
  EXPECT_EQ(grazing.exit_code, 1);
  ASSERT_EQ(grazing.document["diagnostics"].size(), 1U) << grazing.errors;
  EXPECT_EQ(grazing.document["diagnostics"][0]["code"], "PRB320");
  EXPECT_NE(grazing.errors.find("0.0002 mm further to the side"), std::string::npos);
  const RunOutput oblique = run_on(sheet + "102.998\n", "oblique.nc", program);
  EXPECT_EQ(notes_of(oblique).count("PRB316"), 1U) << oblique.errors;
}

/// A ring of 40 mm, measured along X, this far beside its middle.
RunOutput measured_beside(double beside, const std::string& more) {
  return run_on(
      "[probe]\nball_diameter = 6.0\nlength = 100.0\n"
      "[[part]]\nname = \"ring\"\nshape = \"ring\"\nbore = 40.0\nheight = 20.0\n"
      "at = [0.0, 0.0, 0.0]\n" +
          more + "[start]\nY = " + std::to_string(beside) + "\nZ = 90.0\n",
      "bore.nc", "O1\nG31 X50. F100.\n#1=#5061\nG00 X0\nG31 X-50. F100.\n#2=#5061\nG00 X0\nM30\n");
}

TEST(TouchNotes, AChordIsShorterThanTheDiameter) {
  const auto notes = notes_of(measured_beside(1.2, ""));
  ASSERT_EQ(notes.size(), 1U);
  const std::string& text = notes.find("PRB318")->second;
  // The ball's centre goes on a circle of 17 mm: 34 - 2 sqrt(17^2 - 1.2^2) = 0.0848 mm.  The
  // facets' own normals would be 0.02 mm off; the figures have three decimals.
  const double rounding = 0.00051;
  EXPECT_NEAR(last_mm(text.substr(0, text.find(" shorter"))), 34.0 - 2.0 * std::sqrt(289.0 - 1.44),
              rounding)
      << text;
  EXPECT_NEAR(last_mm(text.substr(0, text.find(" off centre"))), 1.2, rounding) << text;
  EXPECT_TRUE(notes_of(measured_beside(0.0, "")).empty());
}

}  // namespace
}  // namespace g31::touch_notes_test

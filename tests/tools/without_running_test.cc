// `g31 setup`: what a set-up says against itself and against a program; `g31 new`: a folder to
// begin with.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/new_command.h"
#include "tools/cli/setup_command.h"

namespace g31::cli::without_running_test {
namespace {

using testing::CommandOutput;
using testing::TemporaryFolder;

constexpr const char* kSheet =
    "[start]\nZ = 300.0\n[work_offsets.G54]\nX = 100.0\n[tools.1]\nlength = 120.0\n"
    "[machine.axes.X]\ntravel = [0.0, 500.0]\n[machine.axes.Y]\ntravel = [-200.0, 200.0]\n"
    "[machine.axes.Z]\ntravel = [0.0, 400.0]\n[probe]\nlength = 120.0\n";
constexpr const char* kBlock = "[[part]]\nname = \"block\"\nshape = \"block\"\non = \"G54\"\n";
constexpr const char* kProgram = "O1\nG90 G54 G43 H1 G0 X50. Z-10.\nG31 X20. F100.\nM30\n";

/// What `g31 setup` says of these sheets, and of a program where one is given.
CommandOutput reviewed(const std::string& sheet, const std::string& program = {},
                       bool as_document = false) {
  const TemporaryFolder folder;
  SetupOptions options;
  options.setups = {folder.write("sheet.toml", sheet)};
  if (!program.empty()) {
    options.programs = {folder.write("case.nc", program)};
  }
  options.json = as_document ? "-" : "";
  return testing::captured([&] { return setup_command(options); });
}

/// The text of a finding, without what stands around it.
bool has(const CommandOutput& output, const std::string& text) {
  return output.out.find(text) != std::string::npos;
}

TEST(SetupCommand, HasNothingToSayOfASetUpThatFits) {
  const CommandOutput alone = reviewed(std::string(kSheet) + kBlock);
  EXPECT_EQ(alone.out, "nothing is wrong with the set-up\n");
  EXPECT_EQ(alone.exit_code, 0);
  const CommandOutput with_program = reviewed(std::string(kSheet) + kBlock, kProgram);
  EXPECT_EQ(with_program.out, "nothing is wrong with the set-up\n");
  EXPECT_EQ(with_program.exit_code, 0);
}

TEST(SetupCommand, SaysWhichVariablesNoProgramReads) {
  const std::string variables =
      "[variables]\n\"#500\" = 1.0\n\"#501\" = 2.0\n\"#502\" = 3.0\n\"#503\" = 4.0\n"
      "[expect.variables]\n\"#502\" = 3.0\n";
  const std::string program =
      "O1\n#501=5\nIF[#503LT0]GOTO9\nG90 G54 G43 H1 G0 X50. Z-10.\nG31 X20. F#500\nN9 M30\n";
  const CommandOutput output = reviewed(std::string(kSheet) + kBlock + variables, program);
  EXPECT_EQ(output.exit_code, 0) << "a note";
  EXPECT_TRUE(has(output, "note: no program reads a variable of the sheets: #501 [SUP109]"))
      << output.out;
  for (const char* const read : {"sheets: #500", "sheets: #502", "sheets: #503"}) {
    EXPECT_FALSE(has(output, read)) << output.out;
  }
  EXPECT_TRUE(has(output, "sheet.toml:21:10: ")) << output.out;
  const CommandOutput computed = reviewed(std::string(kSheet) + kBlock + variables,
                                          "O1\nG90 G54 G43 H1 G0 X50. Z-10.\n"
                                          "G31 X20. F#[500+#1]\nM30\n");
  EXPECT_FALSE(has(computed, "SUP109")) << computed.out << "any of them may be read";
  const CommandOutput in_small_letters = reviewed(
      "[control]\nprofile = \"sinumerik-828d\"\n[variables]\nr1 = 5.0\nr2 = 5.0\n", "R3=R1\nM30\n");
  EXPECT_TRUE(has(in_small_letters, "sheets: r2 [SUP109]")) << in_small_letters.out;
}

// X goes from 0 to 500, Y from -200 to 200, Z from 0 to 400.
TEST(SetupCommand, FindsAStartOutsideTheTravel) {
  std::string sheet = std::string(kSheet) + kBlock;
  sheet.replace(sheet.find("Z = 300.0"), 9, "Z = 400.001\nX = 500.0");
  const CommandOutput given = reviewed(sheet);
  EXPECT_EQ(given.exit_code, 1);
  EXPECT_TRUE(has(given,
                  "sheet.toml:2:5: warning: the machine starts outside its travel: Z at "
                  "400.001, it goes from 0 to 400 [SUP110]"))
      << given.out;
  EXPECT_FALSE(has(given, ": X at")) << given.out << "a limit itself may be stood on";
  // Not named: at 0.
  sheet = std::string(kSheet) + kBlock;
  sheet.replace(sheet.find("[0.0, 500.0]"), 12, "[0.5, 500.0]");
  const CommandOutput left_out = reviewed(sheet);
  EXPECT_TRUE(has(left_out,
                  "sheet.toml:8:10: warning: the machine starts outside its travel: X at "
                  "0, it goes from 0.5 to 500 [SUP110]"))
      << left_out.out;
}

TEST(SetupCommand, RefusesNamesThatTheControlHasNot) {
  for (const char* const expected :
       {"[expect.variables]\n\"#99999\" = 3.0\n", "[expect.work_offsets.G505]\nX = 1.0\n",
        "[[characteristic]]\nname = \"A\"\nvariable = \"#99999\"\n"}) {
    const CommandOutput output = reviewed(std::string(kSheet) + kBlock + expected, kProgram);
    EXPECT_EQ(output.exit_code, 2) << expected << output.errors;
    EXPECT_NE(output.errors.find("sheet.toml:"), std::string::npos) << output.errors;
  }
}

TEST(SetupCommand, SaysWhichToolIsNeverFoundByItsName) {
  const std::string twice = std::string(kSheet) + kBlock +
                            "[tools.5]\nname = \"CUT\"\n[tools.6]\nname = \"CUT\"\n[control]\n"
                            "profile = \"sinumerik-828d\"\n";
  const CommandOutput output = reviewed(twice);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_TRUE(has(output,
                  "two tools have one name and one duplo number: 'CUT', [tools.5] and [tools.6] "
                  "[SUP111]"))
      << output.out;
  const CommandOutput told_apart = reviewed(twice + "[variables]\n\"$TC_TP1[6]\" = 2\n");
  EXPECT_FALSE(has(told_apart, "SUP111")) << told_apart.out;
}

/// The ball comes to X 500, the block begins at 670 and the ball is 3 mm: 167 mm.
TEST(SetupCommand, SaysWhichPartIsOutOfReach) {
  const CommandOutput output =
      reviewed(std::string(kSheet) +
               "[[part]]\nname = \"far\"\nshape = \"block\"\nat = [700.0, 0.0, 0.0]\n");
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_TRUE(has(output,
                  "the stylus ball cannot reach a part: 'far' at X 670.000 to 730.000, Y "
                  "-20.000 to 20.000, Z -20.000 to 0.000 is 167.000 mm in X beyond it "
                  "[SUP103]\n"))
      << output.out;
  EXPECT_TRUE(has(output, "sheet.toml:17:9: warning: ")) << output.out;
}

/// The nearest the ball comes is X 50 of G54, 150: the block begins at 370; 217 mm with its radius.
TEST(SetupCommand, SaysWhichPartNoMeasuringMoveComesNear) {
  const CommandOutput output =
      reviewed(std::string(kSheet) +
                   "[[part]]\nname = \"beside\"\nshape = \"block\"\nat = [400.0, 0.0, 0.0]\n",
               kProgram);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_TRUE(has(output,
                  "no measuring move comes near a part: 'beside', 217.000 mm at the nearest "
                  "[SUP106]\n"))
      << output.out;
}

TEST(SetupCommand, TellsTwins) {
  const CommandOutput same = reviewed(std::string(kSheet) + kBlock + kBlock);
  EXPECT_TRUE(has(same, "two parts stand in one place: 'block' and 'block' [SUP102]")) << same.out;
  const CommandOutput named =
      reviewed(std::string(kSheet) + kBlock + kBlock + "at = [0.0, 50.0, 0.0]\n");
  EXPECT_TRUE(has(named, "two parts have one name: 'block' [SUP101]")) << named.out;
}

TEST(SetupCommand, TellsMissingToolsAndOffsets) {
  const CommandOutput tool = reviewed(std::string(kSheet) + kBlock,
                                      "O1\nG90 G54 G43 H7 G0 X50. Z-10.\nG31 X20. F100.\nM30\n");
  EXPECT_TRUE(has(tool, "case.nc:2:")) << tool.out;
  EXPECT_TRUE(has(tool, "[PRB501]") || has(tool, "[PRB503]")) << tool.out;
  const CommandOutput offset =
      reviewed(std::string(kSheet) + kBlock, "O1\nG90 G56 G31 X20. F100.\nM30\n");
  EXPECT_TRUE(has(offset, "[PRB502]")) << offset.out;
}

TEST(SetupCommand, TellsMissingToolsByNameNumberAndEdge) {
  const std::string sheet = "[control]\nprofile = \"sinumerik-828d\"\n" + std::string(kSheet);
  for (const auto& [word, code] :
       {std::pair("T=\"NIX\" D1", "[17191]"), std::pair("T1 D5", "[17181]"),
        std::pair("T99 D1", "[PRB501]")}) {
    const CommandOutput tool = reviewed(sheet, "G54\n" + std::string(word) + " M6\nM30\n");
    EXPECT_EQ(tool.exit_code, 1) << word;
    EXPECT_TRUE(has(tool, "case.nc:2:") && has(tool, code)) << tool.out;
  }
}

TEST(SetupCommand, TellsProbesWhoseLengthTheControlDoesNotKnow) {
  const CommandOutput output =
      reviewed("[tools.1]\nlength = 100.0\n[probe]\nlength = 120.0\n" + std::string());
  EXPECT_TRUE(has(output, "note: no tool of [tools] is as long as the probe: 120.000 mm [SUP105]"))
      << output.out;
  EXPECT_EQ(output.exit_code, 0) << "a note";
  for (const char* const length : {"120.0", "123.0"}) {  // to the middle of the ball, to its end
    const CommandOutput known = reviewed("[tools.1]\nlength = " + std::string(length) +
                                         "\n[probe]\nball_diameter = 6.0\nlength = 120.0\n");
    EXPECT_FALSE(has(known, "SUP105")) << known.out;
  }
}

// A turning tool has its first length along X, its second one along Z.
TEST(SetupCommand, ComparesBothLengthsOfAProbeInATurret) {
  const auto with_place = [](const std::string& at) {
    return reviewed(
        "[control]\nprofile = \"sinumerik-828d\"\n[tools.1]\nname = \"PROBE\"\ntype = 580.0\n"
        "length = 100.0\n[variables]\n\"$TC_DP4[1,1]\" = 30.0\n[probe]\nball_diameter = 6.0\nat "
        "= " +
        at + "\n");
  };
  const CommandOutput right = with_place("[-100.0, 0.0, -30.0]");
  EXPECT_EQ(right.out.find("SUP105"), std::string::npos) << right.out;
  const CommandOutput wrong = with_place("[-100.0, 0.0, -100.0]");
  EXPECT_TRUE(has(wrong,
                  "note: no tool of [tools] is as long as the probe: X 100.000 mm, Z 100.000 "
                  "mm [SUP105]"))
      << wrong.out;
}

TEST(SetupCommand, ComparesTheRadiusOfTheProbeWithItsBall) {
  const auto with_tool = [](const std::string& tool, const std::string& probe) {
    return reviewed("[tools.1]\nlength = 120.0\n" + tool +
                    "\n[probe]\nlength = 120.0\nball_diameter = 6.0\n" + probe);
  };
  const CommandOutput other = with_tool("radius = 2.0", "tool = 1\n");
  EXPECT_TRUE(
      has(other,
          "note: the tool that is the probe has another radius than its ball: [tools.1] 2.000 mm, "
          "[probe] 3.000 mm [SUP112]"))
      << other.out;
  EXPECT_EQ(other.exit_code, 0) << "a note";
  EXPECT_TRUE(has(with_tool("radius = 2.0\ntype = 710.0", ""), "SUP112"));
  for (const auto& [tool, probe] : {std::pair("radius = 2.98", "tool = 1\n"),
                                    std::pair("radius = 3.0\nradius_wear = -0.02", "tool = 1\n"),
                                    std::pair("radius = 2.0", "tool = 2\n"),
                                    std::pair("radius = 2.0", ""), std::pair("", "tool = 1\n")}) {
    const CommandOutput known = with_tool(tool, probe);
    EXPECT_FALSE(has(known, "SUP112")) << tool << probe << known.out;
  }
}

TEST(SetupCommand, TellsParametersWithoutEffectAndLostVariables) {
  const CommandOutput output = reviewed("[parameters]\n\"9999\" = 1\n[variables]\n#500 = 3.0\n");
  EXPECT_TRUE(has(output, "[PRB505]")) << output.out;
  EXPECT_TRUE(has(output, "sheet.toml:4:1: warning: ")) << output.out;
  EXPECT_TRUE(has(output, "[PRB519]")) << output.out;
  EXPECT_EQ(output.exit_code, 1);
}

TEST(SetupCommand, TellsAxesThatAFanucDoesNotHave) {
  const std::string sheet = "[machine.axes.W]\nrapid = 10000.0\n";
  const CommandOutput output = reviewed(sheet);
  EXPECT_TRUE(has(output, "an axis W, which this control does not have [PRB506]")) << output.out;
  EXPECT_EQ(output.exit_code, 1);
  const CommandOutput has_it = reviewed("[control]\nprofile = \"sinumerik-828d\"\n" + sheet);
  EXPECT_FALSE(has(has_it, "PRB506")) << has_it.out;
}

TEST(SetupCommand, SaysHowFarAProgramCouldBeFollowed) {
  const CommandOutput output =
      reviewed(std::string(kSheet) + kBlock, "O1\nIF [#5061 EQ 0] THEN #3000=1 (NOTHING)\nM30\n");
  EXPECT_FALSE(has(output, "the program has no measuring move: ")) << output.out;
  EXPECT_TRUE(has(output, "the program could be followed only so far: ")) << output.out;
  EXPECT_TRUE(has(output, "case.nc:2: ")) << output.out;
}

TEST(SetupCommand, TellsPartsOfAnUnlikelySize) {
  const TemporaryFolder folder;
  // A cube of 0.05: metres that were meant as such.
  std::string mesh;
  for (const char* const p : {"0 0 0", "0.05 0 0", "0 0.05 0", "0 0 0.05"}) {
    mesh += std::string("v ") + p + "\n";
  }
  static_cast<void>(folder.write("part.obj", mesh + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"));
  SetupOptions options;
  options.setups = {folder.write("sheet.toml", "[[part]]\nfile = \"part.obj\"\n")};
  const auto output = testing::captured([&] { return setup_command(options); });
  EXPECT_TRUE(has(output, "a part of an unlikely size: 'part' is 0.05 mm long [SUP104]"))
      << output.out << output.errors;
}

TEST(SetupCommand, RefusesWhatARunRefuses) {
  const CommandOutput key = reviewed("[prob]\n");
  EXPECT_EQ(key.exit_code, 2);
  EXPECT_NE(key.errors.find("did you mean probe?"), std::string::npos) << key.errors;
  const CommandOutput variable = reviewed("[variables]\nR1 = 2\n");
  EXPECT_EQ(variable.exit_code, 5) << variable.errors;
  EXPECT_NE(variable.errors.find("[SET126]"), std::string::npos) << variable.errors;
}

TEST(SetupCommand, WritesADocument) {
  const auto document =
      nlohmann::json::parse(reviewed(std::string(kSheet) + kBlock + kBlock, kProgram, true).out);
  EXPECT_EQ(document["schema"], "g31.setup/1");
  EXPECT_EQ(document["control"], "fanuc-16i");
  EXPECT_EQ(document["reach"]["min"], nlohmann::json::parse("[0.0, -200.0, -120.0]"));
  EXPECT_EQ(document["parts"][0]["max"], nlohmann::json::parse("[130.0, 20.0, 0.0]"));
  ASSERT_EQ(document["findings"].size(), 1U);
  EXPECT_EQ(document["findings"][0]["code"], "SUP102");
  EXPECT_EQ(document["findings"][0]["line"], 21);
}

CommandOutput begun(const std::string& folder, const std::string& control) {
  return testing::captured([&] { return new_command({folder, control}); });
}

/// What begins is right: it runs, it is checked, its set-up fits, and its results are those of the
/// sheet.
TEST(NewCommand, MakesAFolderThatRuns) {
  for (const char* const control : {"", "fanuc-0i", "fanuc-30i", "haas", "meldas", "mazatrol-iso",
                                    "brother", "0i-MF", "sinumerik-828d"}) {
    SCOPED_TRACE(control);
    const TemporaryFolder folder;
    const std::string path = folder.path("deep/starter");
    const CommandOutput made = begun(path, control);
    ASSERT_EQ(made.exit_code, 0) << made.errors;
    const bool is_fanuc = std::string(control) != "sinumerik-828d";
    RunOptions run;
    run.programs = {path + (is_fanuc ? "/measure.nc" : "/MEASURE.MPF")};
    run.setups = {path + "/setup.toml"};
    run.prints = {is_fanuc ? "#503" : "R3", is_fanuc ? "#504" : "R4"};
    const testing::RunOutput output = testing::run_program(run);
    EXPECT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_EQ(output.errors, "");
    EXPECT_NEAR(output.document["variables"][run.prints[0]].get<double>(), 60.0, 1e-9);
    EXPECT_NEAR(output.document["variables"][run.prints[1]].get<double>(), 0.0, 1e-9);
    SetupOptions setup;
    setup.setups = run.setups;
    setup.programs = run.programs;
    const auto review = testing::captured([&] { return setup_command(setup); });
    EXPECT_EQ(review.exit_code, 0) << review.out << review.errors;
    for (const char* const pipeline : {"/.github/workflows/g31.yml", "/.gitlab-ci.yml"}) {
      EXPECT_NE(testing::text_of(path + pipeline).find("g31 run "), std::string::npos) << pipeline;
    }
  }
}

TEST(NewCommand, ChangesNothingWhereAFileIsThere) {
  const TemporaryFolder folder;
  const std::string mine = folder.write("setup.toml", "mine");
  const CommandOutput output = begun(folder.path("."), "");
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("setup.toml is there already: nothing is changed"),
            std::string::npos);
  EXPECT_EQ(testing::text_of(mine), "mine");
  EXPECT_FALSE(std::filesystem::exists(folder.path("measure.nc")));
  EXPECT_EQ(begun(mine, "").exit_code, 2) << "a file is no folder";
  EXPECT_EQ(begun(folder.path("."), "hass").exit_code, 5);
}

}  // namespace
}  // namespace g31::cli::without_running_test

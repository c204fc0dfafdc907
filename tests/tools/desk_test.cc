// What a run says on standard error and in the stream of events, and what a person asks of it.

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/command_line.h"

namespace g31::desk_test {
namespace {

using nlohmann::json;
using testing::CommandOutput;
using testing::TemporaryFolder;

CommandOutput g31(const std::vector<std::string>& words) {
  return testing::g31(words, "1.2.3");
}

/// Runs a program in a folder of its own.
CommandOutput run_of(const std::string& file, const std::string& program,
                     std::vector<std::string> more = {}, const std::string& sheet = {}) {
  const TemporaryFolder folder;
  std::vector<std::string> words = {"run", folder.write(file, program)};
  if (!sheet.empty()) {
    words.insert(words.end(), {"-s", folder.write("s.toml", sheet)});
  }
  words.insert(words.end(), more.begin(), more.end());
  return g31(words);
}

bool has(const std::string& text, const std::string& piece) {
  return text.find(piece) != std::string::npos;
}

std::string last_line(const std::string& text) {
  const std::size_t end = text.rfind('\n');
  const std::size_t begin = end == std::string::npos || end == 0 ? 0 : text.rfind('\n', end - 1);
  return begin == std::string::npos ? text : text.substr(begin == 0 ? 0 : begin + 1);
}

TEST(Desk, ARunEndsWithOneLine) {
  const struct {
    const char* program;
    const char* line;
  } kCases[] = {
      {"O1\nG04 X1.5\nM30\n", "g31: completed: 3 blocks, 0 touches, 1.5 s of machine time\n"},
      {"O1\nG31 X9. F600.\nM30\n",
       "g31: completed, 1 warning: 3 blocks, 0 touches, 0.9 s of machine time\n"},
      {"O1\n#3000=1(STOP)\nM30\n",
       "g31: alarm 3001 STOP: 2 blocks, 0 touches, 0.0 s of machine time\n"},
  };
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.program);
    EXPECT_EQ(last_line(run_of("a.nc", c.program).errors), c.line);
    const CommandOutput quiet = run_of("a.nc", c.program, {"-q"});
    EXPECT_FALSE(has(quiet.errors, "machine time")) << quiet.errors;
  }
}

TEST(Desk, StopsAndMessagesComeAsTheyAre) {
  const std::string program = "O1\nM00\nM01\n#3006=1(LOOK HERE)\nM30\n";
  const CommandOutput said = run_of("a.nc", program);
  EXPECT_TRUE(has(said.errors, "a.nc:2: M00\n")) << said.errors;
  EXPECT_TRUE(has(said.errors, "a.nc:3: M01 passed: --optional-stop is off\n")) << said.errors;
  EXPECT_TRUE(has(said.errors, "a.nc:4: #3006: LOOK HERE\n")) << said.errors;
  const CommandOutput stopped = run_of("a.nc", program, {"--optional-stop"});
  EXPECT_TRUE(has(stopped.errors, "a.nc:3: M01\n")) << stopped.errors;
  EXPECT_EQ(run_of("a.nc", program, {"--quiet"}).errors, "");
  const std::string message = "MSG(\"CLOSE THE DOOR\")\nM30\n";
  EXPECT_EQ(run_of("a.mpf", message).out, "CLOSE THE DOOR\n");
  const CommandOutput taken = run_of("a.mpf", message, {"--json", "-"});
  EXPECT_TRUE(has(taken.errors, "CLOSE THE DOOR\n")) << taken.errors;
}

TEST(Desk, StopsInALoopEndTheirLines) {
  const CommandOutput said = run_of("a.nc", "O1\nWHILE[#1LT2000]DO1\nM00\n#1=#1+1\nEND1\nM30\n");
  EXPECT_TRUE(has(said.errors, "g31: further stops are not shown\n"));
  EXPECT_EQ(std::ranges::count(said.errors, '\n'), 1002);
}

TEST(Desk, SwitchesOfThePanel) {
  const std::string program = "O1\n/2 #100=1\n/3 #101=1\nM30\n";
  const CommandOutput said = run_of("a.nc", program, {"--block-skip", "2", "--print", "#100,#101"});
  EXPECT_EQ(said.out, "#100 = null\n#101 = 1\n");
  EXPECT_EQ(run_of("a.nc", program, {"--block-skip", "0"}).exit_code, 2);
  const TemporaryFolder folder;
  const std::string path = folder.path("r.json");
  run_of("a.nc", "O1\nM01\nM00\nM30\n", {"--json", path});
  const json stops = json::parse(testing::text_of(path)).at("stops");
  EXPECT_EQ(stops.at(0).at("passed"), true);
  EXPECT_FALSE(stops.at(1).contains("passed"));
  const std::string events = folder.path("e.jsonl");
  for (const bool stops_at_m01 : {false, true}) {
    std::vector<std::string> options = {"--jsonl", events};
    if (stops_at_m01) {
      options.emplace_back("--optional-stop");
    }
    run_of("a.nc", "O1\nM01\nM00\nM30\n", options);
    const std::string told = testing::text_of(events);
    EXPECT_EQ(std::ranges::count(told, '\n'), 4) << told;  // start, two stops, end
    EXPECT_EQ(told.find("\"passed\":true") == std::string::npos, stops_at_m01) << told;
  }
}

TEST(Desk, AnAlarmShowsTheLocalsOfItsFrame) {
  const TemporaryFolder folder;
  const std::string path = folder.path("r.json");
  const CommandOutput fanuc = run_of(
      "a.nc", "O1\n#1=9\nG65 P2 A3. B4.\nM30\nO2\n#5=#1*2\n#3000=1(STOP)\nM99\n", {"--json", path});
  EXPECT_TRUE(has(fanuc.errors, "      = with #1 = 3, #2 = 4, #5 = 6\n")) << fanuc.errors;
  EXPECT_EQ(json::parse(testing::text_of(path)).at("alarm").at("locals").dump(),
            R"({"#1":3.0,"#2":4.0,"#5":6.0})");
  EXPECT_EQ(run_of("a.nc", "O1\n#500=8\nM30\n", {"--print", "all,#501"}).out,
            "#501 = null\n#500 = 8\n");
  const CommandOutput sinumerik =
      run_of("a.mpf", "DEF REAL DEPTH=2.5\nDEF STRING[5] WHO=\"ME\"\nSETAL(65001)\nM30\n");
  EXPECT_TRUE(has(sinumerik.errors, "DEPTH = 2.5")) << sinumerik.errors;
  EXPECT_TRUE(has(sinumerik.errors, "WHO = \"ME\"")) << sinumerik.errors;
}

TEST(Desk, ACollisionSaysWhere) {
  const std::string sheet =
      "[work_offsets.G54]\nX = 1.0\n[probe]\nball_diameter = 6.0\nlength = 100.0\n[[part]]\n"
      "name = \"box\"\nshape = \"block\"\nlength = 20.0\nheight = 40.0\nat = [80.0, 0.0, 0.0]\n"
      "[start]\nZ = 80.0\n";
  const CommandOutput said = run_of("a.nc", "O1\nG54\nG01 X100. F500.\nM30\n", {}, sheet);
  EXPECT_EQ(said.exit_code, 4);
  // The ball, 3 mm in radius, meets the face at X 70.
  EXPECT_TRUE(has(said.errors,
                  "      = at X66 Y0 Z80 in work coordinates, X67 Y0 Z80 in those of the "
                  "machine\n      = G1 F500 on the way to X101 Y0 Z80 in those of the machine\n"))
      << said.errors;
  std::string dead = sheet;
  dead.insert(dead.find("length"), "state = \"dead\"\n");
  const CommandOutput measuring = run_of("a.mpf", "MEAS=1 G1 X100 F500\nM30\n", {}, dead);
  EXPECT_EQ(measuring.exit_code, 4);
  EXPECT_TRUE(has(measuring.errors, "      = measuring move F500 on the way to X100 Y0 Z80 in "))
      << measuring.errors;
}

TEST(Desk, VerboseShowsEachMeasuringMove) {
  const std::string sheet = "[[skip_signal]]\naxis = \"X\"\nat = 15.0\n";
  const std::string program = "O1\nG31 X20. F600.\n#1=#5061\nM30\n";
  const CommandOutput said = run_of("a.nc", program, {"-v"}, sheet);
  EXPECT_TRUE(has(said.errors, "a.nc:2: touch at X15 Y0 Z0 (machine X15 Y0 Z0), F600\n"))
      << said.errors;
  EXPECT_FALSE(has(run_of("a.nc", program, {}, sheet).errors, "touch at"));
  EXPECT_EQ(run_of("a.nc", program, {"-v", "-q"}, sheet).exit_code, 2);
}

TEST(Desk, NoColoursButOnATerminal) {
  EXPECT_FALSE(has(run_of("a.nc", "O1\n#3000=1(STOP)\nM30\n").errors, "\033"));
}

TEST(Changes, OfVariablesOffsetsAndTools) {
  const std::string sheet =
      "[variables]\n\"#500\" = 1.0\n\"#501\" = 4.0\n[work_offsets.G54]\nX = 1.0\n[tools.5]\n"
      "length = 10.0\n";
  const CommandOutput fanuc = run_of("a.nc",
                                     "O1\n#500=2\n#501=4\n#100=7\nG10 L2 P1 X3.5\n"
                                     "G10 L10 P5 R10.25\nM30\n",
                                     {"--changes"}, sheet);
  EXPECT_EQ(fanuc.out,
            "#100 = 7 (was null)\n#500 = 2 (was 1)\ntools.5.length = 10.25 (was 10)\n"
            "work_offsets.G54.X = 3.5 (was 1)\n")
      << fanuc.errors;
  const CommandOutput sinumerik =
      run_of("a.mpf", "R1=5\n$P_UIFR[1,X,TR]=3.5\n$TC_DP3[5,1]=10.25\nM30\n", {"--changes"},
             "[work_offsets.G54]\nX = 1.0\n[tools.5]\nlength = 10.0\n");
  EXPECT_EQ(sinumerik.out,
            "$P_UIFR[1,X,TR] = 3.5 (was 1)\n$TC_DP3[5,1] = 10.25 (was 10)\nR1 = 5 (was 0)\n")
      << sinumerik.errors;
}

// Base frames and texts, too; a scale that was never set was 1.
TEST(Changes, OfFramesAndTextsOfSinumerik) {
  const testing::TemporaryFolder folder;
  folder.write("GUD6.DEF", "%_N_GUD6_DEF\nDEF CHAN STRING[20] NOTE\nDEF CHAN REAL DEEP\nM17\n");
  const std::string program = folder.write("a.mpf",
                                           "NOTE=\"DONE\"\nDEEP=2\n$P_UIFR[1,X,SC]=2\n"
                                           "$P_CHBFR[0,Y,TR]=1.5\n$P_SETFR[Z,TR]=-3\nM30\n");
  const CommandOutput output = testing::g31({"run", program, "--changes"});
  EXPECT_EQ(output.out,
            "$P_CHBFR[0,Y,TR] = 1.5 (was 0)\n$P_SETFR[Z,TR] = -3 (was 0)\n"
            "$P_UIFR[1,X,SC] = 2 (was 1)\nDEEP = 2 (was 0)\nNOTE = DONE (was )\n")
      << output.errors;
}

TEST(Endings, OfARunThatIsRefusedHaveTheirLine) {
  const CommandOutput wrong = run_of("a.nc", "O1\nM30\n", {"--print", "nonsense"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(wrong.errors.ends_with("g31: usage: nothing has run\n")) << wrong.errors;
  const CommandOutput sheet = run_of("a.nc", "O1\nM30\n", {}, "[probe]\nlength = true\n");
  EXPECT_TRUE(sheet.errors.ends_with("g31: usage: nothing has run\n")) << sheet.errors;
  const CommandOutput part = run_of("a.nc", "O1\nM30\n", {},
                                    "[[part]]\nshape = \"ring\"\nbore = 50.0\n"
                                    "outer_diameter = 40.0\n");
  EXPECT_TRUE(part.errors.ends_with("g31: setup: nothing has run\n")) << part.errors;
  const CommandOutput quiet = run_of("a.nc", "O1\nM30\n", {"--print", "nonsense", "-q"});
  EXPECT_FALSE(has(quiet.errors, "nothing has run")) << quiet.errors;
}

// Where an axis stands at the start no variable says.
TEST(Settings, OfSinumerikAreOfVariables) {
  for (const auto& [setting, says] :
       {std::pair("X=5", "it is an axis; where it stands at the start says [start]"),
        std::pair("F=500", "variable F: "), std::pair("G=1", "variable G: "),
        std::pair("WIDTH=1", "variable WIDTH: ")}) {
    const CommandOutput output =
        run_of("a.mpf", "R1=$AA_IM[X]\nM30\n", {"--set", setting, "--print", "R1"});
    EXPECT_EQ(output.exit_code, 5) << setting << output.errors;
    EXPECT_TRUE(has(output.errors, says)) << setting << output.errors;
    EXPECT_EQ(output.out, "") << setting;
  }
  const CommandOutput good = run_of("a.mpf", "R1=R2\nM30\n",
                                    {"--set", "R2=5", "--set", "_OVR[4]=1", "--set",
                                     "$P_UIFR[1,X,TR]=2", "--print", "R1,$P_UIFR[1,X,TR]"});
  EXPECT_EQ(good.out, "R1 = 5\n$P_UIFR[1,X,TR] = 2\n") << good.errors;
}

TEST(Prints, AllOfThem) {
  EXPECT_EQ(run_of("a.nc", "O1\n#1=3\n#100=7\n#500=8\nM30\n", {"--print", "all"}).out,
            "#100 = 7\n#500 = 8\n#1 = 3\n");
  const CommandOutput sinumerik =
      run_of("a.mpf", "DEF REAL DEPTH=2.5\nR1=5\nM30\n", {"--print", "all"});
  EXPECT_EQ(sinumerik.out, "R1 = 5\nDEPTH = 2.5\n") << sinumerik.errors;
}

TEST(Documents, SayThatTheLogIsNotWritten) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\n#500=8\nM30\n");
  const std::string document = folder.path("a.json");
  const CommandOutput output = g31({"run", program, "--jsonl", "/dev/full", "--json", document});
  EXPECT_EQ(output.exit_code, 2) << output.errors;
  const json told = json::parse(testing::text_of(document));
  EXPECT_EQ(told.at("exit_code"), 2);
  EXPECT_TRUE(has(told.at("diagnostics").at(0).at("message"), "/dev/full"));
}

TEST(Setup, EndsWithAProgramThatIsNone) {
  const TemporaryFolder folder;
  const std::string sheet = folder.write("a.toml", "[start]\nX = 1.0\n");
  const CommandOutput output =
      g31({"setup", sheet, "--program", folder.write("a.nc", "O1\nG00 X[1+\nM30\n")});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_TRUE(has(output.errors, "a.nc:2: FORMAT ERROR IN MACRO")) << output.errors;
}

TEST(Messages, OfSheetsHaveOneLine) {
  const TemporaryFolder folder;
  const std::string sheet = folder.write("e\x1b[31mx\ny.toml", "[probe]\nbogus=1\n");
  const CommandOutput output = g31({"setup", sheet});
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_TRUE(has(output.errors, "e?[31mx?y.toml:2:1: error: unknown key")) << output.errors;
}

std::vector<json> events_of(const std::string& text) {
  std::vector<json> events;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    events.push_back(json::parse(line));
  }
  return events;
}

TEST(Events, AreALineEach) {
  const TemporaryFolder folder;
  const std::string path = folder.path("e.jsonl");
  const CommandOutput said = run_of(
      "a.nc",
      "O1\nG00 X5.\nG31 X20. F600.\n#1=#5061\nPOPEN\nDPRNT[HELLO]\nPCLOS\nM00\n#3000=1(NO)\n",
      {"--jsonl", path}, "[[skip_signal]]\naxis = \"X\"\nat = 15.0\n");
  EXPECT_EQ(said.exit_code, 3);
  const std::vector<json> events = events_of(testing::text_of(path));
  std::string names;
  for (const json& event : events) {
    names += event.at("event").get<std::string>() + " ";
  }
  EXPECT_EQ(names, "start move move touch output stop diagnostic end ");
  EXPECT_EQ(events.front().at("schema"), "g31.events/1");
  EXPECT_EQ(events.front().at("version"), "1.2.3");
  EXPECT_EQ(events.at(1).at("to").at(0), 5.0);
  EXPECT_EQ(events.at(1).at("line"), 2);
  EXPECT_EQ(events.at(3).at("latched").at(0), 15.0);
  EXPECT_EQ(events.at(4).at("text"), "HELLO\n");
  EXPECT_EQ(events.at(5).at("kind"), "M00");
  EXPECT_EQ(events.at(6).at("code"), "3001");
  EXPECT_EQ(events.back().at("status"), "alarm");
  EXPECT_EQ(events.back().at("exit_code"), 3);
  EXPECT_EQ(events.back().at("touches"), 1);
}

TEST(Events, OnStandardOutputAreAlone) {
  const CommandOutput said =
      run_of("a.mpf", "MSG(\"HELLO\")\nR1=5\nM30\n", {"--jsonl", "-", "--print", "R1"});
  EXPECT_EQ(said.exit_code, 0) << said.errors;
  const auto events = events_of(said.out);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events.at(1).at("event"), "message");
  EXPECT_EQ(run_of("a.nc", "O1\nM30\n", {"--jsonl", "-", "--json", "-"}).exit_code, 2);
}

TEST(Events, HaveTheCharactersOfAMessage) {
  const std::string program =
      "DEF STRING[40] S=\"\u65E5\u672C\"\nMSG(\"\u0141\u00D3D\u0179 \u00D8\u00B10.1 \"<<S)\nM30\n";
  const std::string text = "\u0141\u00D3D\u0179 \u00D8\u00B10.1 \u65E5\u672C\n";
  const auto events = events_of(run_of("a.mpf", program, {"--jsonl", "-"}).out);
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events.at(1).at("text"), text);
  const CommandOutput said = run_of("a.mpf", program, {"--json", "-", "--print", "S"});
  const auto document = nlohmann::json::parse(said.out);
  EXPECT_EQ(document.at("output"), text);
  EXPECT_EQ(document.at("variables").at("S"), "\u65E5\u672C");
  EXPECT_EQ(said.errors.substr(0, text.size()), text);
}

TEST(Events, OfARunThatCannotBegin) {
  const TemporaryFolder folder;
  const std::string path = folder.path("e.jsonl");
  EXPECT_EQ(run_of("a.nc", "O1\nM30\n", {"--jsonl", path, "--control", "none"}).exit_code, 5);
  const auto events = events_of(testing::text_of(path));
  ASSERT_EQ(events.size(), 3U);
  EXPECT_EQ(events.back().at("status"), "setup");
}

TEST(Events, CountAgainstTheOutput) {
  const TemporaryFolder folder;
  const std::string path = folder.path("e.jsonl");
  const CommandOutput said = run_of("a.nc", "O1\nG91\nN1G1X1.F100.\nG1X-1.\nGOTO1\nM30\n",
                                    {"--jsonl", path, "--max-output", "100K"});
  EXPECT_EQ(said.exit_code, 6);
  EXPECT_TRUE(has(said.errors, "moves 100")) << said.errors;
  EXPECT_EQ(events_of(testing::text_of(path)).back().at("status"), "budget");
}

}  // namespace
}  // namespace g31::desk_test

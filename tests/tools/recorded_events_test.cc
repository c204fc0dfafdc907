// What a Fanuc program tells the machine's builder and the management of tools is in the document,
// and in the lines of --jsonl, as it happens.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::testing::recorded_events_test {
namespace {

using nlohmann::json;

constexpr const char* kProgram =
    "%\nO1\n"
    "M80\n"       // line 3: the probe on, no tool yet
    "T5 M06\n"    // a code of the control
    "G04 X2.0\n"  // 2 s
    "M80\n"       // line 6
    "G10 L3\nP1 L20\nT11 H11 D21\nT12 H12\nP2 L30\nT13\nG11\n"
    "G10 L3 P2\nP1\nG11\n"  // line 14: the group is gone again
    "M30\n%\n";

RunOutput run(const std::string& program, const std::string& jsonl = {}) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("main.nc", program)};
  options.control = "fanuc-30i";
  options.jsonl = jsonl;
  return run_program(options);
}

TEST(RecordedEvents, AreCodesOfTheBuilderAndGroupsOfTools) {
  const json events = run(kProgram).document.at("events");
  ASSERT_EQ(events.size(), 6U) << events;
  const json place3 = {{"kind", "m_code"},  {"m", 80},   {"time_s", 0.0},
                       {"file", "main.nc"}, {"line", 3}, {"column", 1}};
  EXPECT_EQ(events.at(0), place3);
  EXPECT_EQ(events.at(1).at("m"), 80);
  EXPECT_EQ(events.at(1).at("tool"), 5);
  EXPECT_EQ(events.at(1).at("line"), 6);
  EXPECT_DOUBLE_EQ(events.at(1).at("time_s").get<double>(), 2.0);
  const std::vector<std::vector<int>> tools = {{1, 20, 11, 9}, {1, 20, 12, 10}, {2, 30, 13, 12}};
  for (std::size_t i = 0; i < tools.size(); ++i) {
    const json& event = events.at(2 + i);
    EXPECT_EQ(event.at("kind"), "tool_life");
    EXPECT_EQ(event.at("group"), tools[i][0]);
    EXPECT_EQ(event.at("life"), tools[i][1]);
    EXPECT_EQ(event.at("tool"), tools[i][2]);
    EXPECT_EQ(event.at("line"), tools[i][3]);
  }
  EXPECT_EQ(events.at(2).at("h"), 11);
  EXPECT_EQ(events.at(2).at("d"), 21);
  EXPECT_FALSE(events.at(3).contains("d"));
  EXPECT_EQ(events.at(5).at("kind"), "tool_life_deleted");
  EXPECT_EQ(events.at(5).at("group"), 1);
  EXPECT_EQ(events.at(5).at("line"), 15);
}

TEST(RecordedEvents, AreLinesOfTheEventsOfARun) {
  const TemporaryFolder folder;
  const std::string path = folder.write("events.jsonl", "");
  run(kProgram, path);
  int recorded = 0;
  std::string text = text_of(path);
  for (std::size_t at = 0; (at = text.find(R"({"event":"recorded")", at)) != std::string::npos;
       ++at) {
    const json line = json::parse(text.substr(at, text.find('\n', at) - at));
    EXPECT_TRUE(line.contains("kind") && line.contains("time_s"));
    ++recorded;
  }
  EXPECT_EQ(recorded, 6);
}

TEST(RecordedEvents, AreNoneWithoutSuchCodes) {
  EXPECT_FALSE(run("%\nO1\nM03 S100\nM05\nT1 M06\nM30\n%\n").document.contains("events"));
}

TEST(RecordedEvents, AToolLifeGroupHasANumber) {
  const RunOutput wrong = run("%\nO1\nG10 L3\nT11\nG11\nM30\n%\n");
  EXPECT_NE(wrong.errors.find("P is missing: the number of its group"), std::string::npos)
      << wrong.errors;
  EXPECT_EQ(wrong.exit_code, 3);
}

TEST(RecordedEvents, TheFirstOnesAreKept) {
  const RunOutput many = run("%\nO1\n#1=0\nWHILE[#1 LT 10003]DO1\n#1=#1+1\nM80\nEND1\nM30\n%\n");
  EXPECT_EQ(many.document.at("events").size(), 10000U);
  EXPECT_EQ(many.document.at("events_left_out"), 3);
}

}  // namespace
}  // namespace g31::testing::recorded_events_test

// What --blocks adds to the document of a run: calls, counts, conditions, values over time.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::run_chronicle_test {
namespace {

using nlohmann::json;
using testing::run_program;
using testing::TemporaryFolder;

json document_of(const std::string& name, const std::string& program, const std::string& control,
                 const std::vector<std::pair<std::string, std::string>>& others = {}) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(name, program)};
  for (const auto& [other, text] : others) {
    folder.write(other, text);
  }
  options.control = control;
  options.moves = true;
  options.blocks = true;
  return run_program(options).document;
}

json counts_of(const json& document, const std::string& file) {
  for (const json& counts : document["counts"]) {
    if (counts["file"] == file) {
      return counts;
    }
  }
  return {};
}

constexpr const char* kLoop =
    "%\n"
    "O1(A LOOP)\n"
    "#1=0\n"
    "WHILE[#1LT3]DO1\n"
    "#1=#1+1(COUNTS)\n"
    "IF[#1EQ2]THEN #2=5\n"
    "END1\n"
    "IF[#1EQ9]GOTO 90\n"
    "G65 P2 A1.\n"
    "M30\n"
    "N90 #3000=1(NEVER)\n"
    "%\n";

// Counted by hand.
TEST(RunChronicle, CountsTheBlocksOfAFanucProgram) {
  const json document =
      document_of("main.nc", kLoop, "fanuc-16i", {{"O0002.nc", "O2\nG4 X1.\nM99\n"}});
  const json counts = counts_of(document, "main.nc");
  EXPECT_EQ(counts["lines"], json({{"3", 1},
                                   {"4", 4},
                                   {"5", 3},
                                   {"6", 3},
                                   {"7", 3},
                                   {"8", 1},
                                   {"9", 1},
                                   {"10", 1},
                                   {"11", 0}}))
      << counts.dump();
  EXPECT_EQ(counts["conditions"], json({{"4", {1, 3}}, {"6", {2, 1}}, {"8", {1, 0}}}))
      << counts.dump();
  EXPECT_EQ(counts_of(document, "O0002.nc")["lines"], json({{"2", 1}, {"3", 1}}));
}

/// Each pass of a call that repeats is a call, made by the block that says how often.
TEST(RunChronicle, TellsEachPassOfACallThatRepeats) {
  const struct {
    const char* name;
    const char* program;
    const char* control;
    std::pair<std::string, std::string> other;
  } kRows[] = {
      {"main.nc", "O1\nM98 P2 L3\nM98 P2\nM30\n", "fanuc-16i", {"O0002.nc", "O2\nG4 X1.\nM99\n"}},
      {"main.nc",
       "O1\nG65 P2 L3 A1.\nG65 P2\nM30\n",
       "fanuc-16i",
       {"O0002.nc", "O2\nG4 X1.\nM99\n"}},
      {"MAIN.MPF",
       "R1=1\nPAUSES P3\nPAUSES\nM30\n",
       "sinumerik-828d",
       {"PAUSES.SPF", "G4 F1\nM17\n"}},
  };
  for (const auto& row : kRows) {
    SCOPED_TRACE(row.program);
    const json document = document_of(row.name, row.program, row.control, {row.other});
    const json& calls = document["calls"];
    ASSERT_EQ(calls.size(), 5U) << calls.dump();
    for (std::size_t i = 1; i < calls.size(); ++i) {
      EXPECT_EQ(calls[i]["level"], 1);
      EXPECT_EQ(calls[i]["line"], i < 4 ? 2 : 3) << calls[i].dump();
      const auto end_s = static_cast<double>(i);
      EXPECT_EQ(calls[i]["time_s"], json({end_s - 1.0, end_s})) << calls[i].dump();
    }
  }
}

TEST(RunChronicle, TellsCallsWithTheirTimes) {
  const json document =
      document_of("main.nc", kLoop, "fanuc-16i", {{"O0002.nc", "O2\nG4 X1.\nM99\n"}});
  ASSERT_EQ(document["calls"].size(), 2U) << document["calls"].dump();
  const json& main = document["calls"][0];
  EXPECT_EQ(main["program"], "main");
  EXPECT_EQ(main["level"], 0);
  EXPECT_EQ(main["time_s"], json({0.0, 1.0}));
  EXPECT_EQ(main["blocks"][1], document["blocks"]);
  const json& call = document["calls"][1];
  EXPECT_EQ(call["program"], "O0002");
  EXPECT_EQ(call["level"], 1);
  EXPECT_EQ(call["line"], 9);
  EXPECT_EQ(call["time_s"], json({0.0, 1.0}));
}

TEST(RunChronicle, TellsWhatVariablesWere) {
  const json document =
      document_of("main.nc", kLoop, "fanuc-16i", {{"O0002.nc", "O2\nG4 X1.\nM99\n"}});
  const json& first = document["history"][0];
  EXPECT_EQ(first["name"], "#1");
  EXPECT_EQ(first["writes"], 4);
  EXPECT_EQ(first["values"], json({{0.0, 0.0}, {0.0, 1.0}, {0.0, 2.0}, {0.0, 3.0}}));
}

// 5,000 writes: strides of 2, 4 and 8; the first and the last value are there.
TEST(RunChronicle, ThinsLongHistories) {
  const json document =
      document_of("main.nc", "O1\n#1=0\nWHILE[#1LT4999]DO1\n#1=#1+1\nEND1\nM30\n", "fanuc-16i");
  const json& history = document["history"][0];
  EXPECT_EQ(history["writes"], 5000);
  const json& values = history["values"];
  EXPECT_LE(values.size(), 1001U);
  EXPECT_GE(values.size(), 500U);
  EXPECT_EQ(values[0][1], 0.0);
  EXPECT_EQ(values[1][1], 8.0);
  EXPECT_EQ(values.back()[1], 4999.0);
}

TEST(RunChronicle, CountsTheBlocksOfASinumerikProgram) {
  const json document = document_of("MAIN.MPF",
                                    "R1=0\n"              // 1
                                    "WHILE R1<2\n"        // 2
                                    "R1=R1+1\n"           // 3
                                    "ENDWHILE\n"          // 4
                                    "IF R1==2\n"          // 5
                                    "R2=1\n"              // 6
                                    "ELSE\n"              // 7
                                    "R2=2\n"              // 8
                                    "ENDIF\n"             // 9
                                    "IF R1>5 GOTOF L1\n"  // 10
                                    "REPEAT\n"            // 11
                                    "R3=R3+1\n"           // 12
                                    "UNTIL R3==3\n"       // 13
                                    "L1: M30\n",          // 14
                                    "sinumerik-828d");
  const json counts = counts_of(document, "MAIN.MPF");
  EXPECT_EQ(counts["conditions"],
            json({{"2", {1, 2}}, {"5", {0, 1}}, {"10", {1, 0}}, {"13", {2, 1}}}))
      << counts.dump();
  EXPECT_EQ(counts["lines"]["3"], 2);
  EXPECT_EQ(counts["lines"]["6"], 1);
  EXPECT_EQ(counts["lines"]["8"], 0);
  EXPECT_EQ(counts["lines"]["12"], 3);
}

// 60 mm at 10 mm/s: 6 s, and 10 mm/s over 2000 mm/s2 = 5 ms for both ramps together.
TEST(RunChronicle, MovesHaveTimeAndPlace) {
  const json document = document_of("main.nc", "O1\nG1 X60. F600.\nG4 X2.\nM30\n", "fanuc-16i");
  ASSERT_EQ(document["moves"].size(), 2U);
  const json& move = document["moves"][0];
  EXPECT_EQ(move["line"], 2);
  EXPECT_NEAR(move["time_s"].get<double>(), 6.005, 1e-9);
  EXPECT_NEAR(document["moves"][1]["time_s"].get<double>(), 8.005, 1e-9);
}

}  // namespace
}  // namespace g31::run_chronicle_test

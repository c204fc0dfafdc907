// Reads that a control which reads ahead would make too early (MB-160 to MB-164).

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::lookahead_test {
namespace {

struct Report {
  std::string code;
  int line;
  friend bool operator==(const Report&, const Report&) = default;
};

void PrintTo(const Report& report, std::ostream* out) {
  *out << report.code << " at line " << report.line;
}

struct Outcome {
  int exit_code = -1;
  std::vector<Report> reports;
};

Outcome run_ahead(const std::string& control, const std::string& text) {
  const testing::TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("ahead.nc", text)};
  options.setups = {folder.write("sheet.toml", "[control]\n" + control + "\n")};
  const auto run = testing::run_program(options);
  Outcome outcome{run.exit_code, {}};
  for (const auto& diagnostic : run.document["diagnostics"]) {
    outcome.reports.push_back({diagnostic["code"], diagnostic["line"]});
  }
  return outcome;
}

struct Case {
  const char* why;
  const char* control;
  const char* text;
  std::vector<Report> reports;
};

TEST(Lookahead, ReportsWhatIsReadWhileAnEarlierBlockMayStillRun) {
  const std::vector<Case> cases = {
      {"the machine position behind a move",
       "lookahead = 1",
       "G0 X1.\n#100=#5021\nM30\n",
       {{"PRB305", 2}}},
      {"the work position", "lookahead = 1", "G0 X1.\n#100=#5041\nM30\n", {{"PRB305", 2}}},
      {"inside a word", "lookahead = 1", "G0 X1.\nG0 X[#5041+1.]\nM30\n", {{"PRB305", 2}}},
      {"by a computed number",
       "lookahead = 1",
       "#1=5041\nG0 X1.\n#100=#[#1+1]\nM30\n",
       {{"PRB305", 3}}},
      {"an input behind an M code", "lookahead = 1", "M19\n#100=#1000\nM30\n", {{"PRB305", 2}}},
      {"the clock", "lookahead = 1", "G1 X1. F100.\n#100=#3001\nM30\n", {{"PRB305", 2}}},
      {"the end of the block before is right all the same",
       "lookahead = 1",
       "G0 X1.\n#100=#5001\nM30\n",
       {{"PRB306", 2}}},
      {"twice in one place is one report",
       "lookahead = 1",
       "WHILE[#1LT2]DO1\nG0 X1.\n#100=#5041\n#1=#1+1\nEND1\nM30\n",
       {{"PRB305", 3}}},
      {"nothing without a depth", "lookahead = 0", "G0 X1.\n#100=#5041\nM30\n", {}},
      {"behind G53, which waits", "lookahead = 1", "G0 X1.\nG53\n#100=#5041\nM30\n", {}},
      {"behind G31, which waits",
       "lookahead = 1",
       "G31 X1. F100.\nG31 X0.\n#100=#5061\nM1\nM30\n",
       {{"PRB301", 2}}},
      {"behind an M code of parameter 3411",
       "lookahead = 1\n[parameters]\n3411 = 53",
       "G0 X1.\nM53\n#100=#5041\nM30\n",
       {}},
      {"a G04 of the 16i waits", "lookahead = 1", "G0 X1.\nG4 P10\n#100=#5041\nM30\n", {}},
      {"a G04 of the 30i does not",
       "lookahead = 1\nprofile = \"fanuc-30i\"",
       "G0 X1.\nG4 P10\n#100=#5041\nM30\n",
       {{"PRB305", 3}}},
      {"too many blocks behind the move for the buffer",
       "lookahead = 1",
       "G0 X1.\nG90\n#100=#5041\nM30\n",
       {}},
      {"a deeper buffer reaches",
       "lookahead = 2",
       "G0 X1.\nG90\n#100=#5041\nM30\n",
       {{"PRB305", 3}}},
      {"before anything moved", "lookahead = 5", "G90 G54\n#100=#5041\nM30\n", {}},
  };
  for (const Case& each : cases) {
    EXPECT_EQ(run_ahead(each.control, each.text).reports, each.reports) << each.why;
  }
}

TEST(Lookahead, AWarningIsAFindingAndANoteIsNone) {
  EXPECT_EQ(run_ahead("lookahead = 1", "G0 X1.\n#100=#5041\nM30\n").exit_code, 1);
  EXPECT_EQ(run_ahead("lookahead = 1", "G0 X1.\n#100=#5001\nM30\n").exit_code, 0);
}

}  // namespace
}  // namespace g31::lookahead_test

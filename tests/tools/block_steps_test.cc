// What a listener hears of blocks, and what can be seen of a run that it has paused.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "machine/base/contract.h"
#include "tests/support/run_program.h"
#include "tests/support/stepper.h"
#include "tools/session/ending.h"

namespace g31::block_steps_test {
namespace {

using runtime::Advance;
using runtime::Scope;
using runtime::Verdict;
using testing::Pauses;
using testing::SteppedRun;
using testing::TemporaryFolder;

/// Hears everything and answers what it is told to at one block.
class Heard final : public runtime::BlockListener {
 public:
  Heard() = default;
  Heard(std::uint64_t number, Verdict verdict) : number_(number), verdict_(verdict) {}
  Verdict on_block(const runtime::BlockPlace& place) override {
    places.push_back(place.where);
    depths.push_back(place.depth);
    skipped.push_back(place.is_skipped);
    shown.push_back(place.is_shown);
    numbers.push_back(place.number);
    return place.number == number_ ? verdict_ : Verdict::Run;
  }
  void on_level(std::uint16_t depth, const std::string& program) override {
    levels.push_back(depth);
    programs.push_back(program);
  }

  /// Where the blocks stand, told behind the run.
  [[nodiscard]] std::vector<int> lines(const SteppedRun& run) const {
    std::vector<int> all;
    for (const source::Location& where : places) {
      all.push_back(run.place(where).line);
    }
    return all;
  }

  std::vector<source::Location> places;
  std::vector<int> depths;
  std::vector<int> levels;
  std::vector<std::string> programs;  ///< of those levels
  std::vector<bool> skipped;
  std::vector<bool> shown;
  std::vector<std::uint64_t> numbers;

 private:
  std::uint64_t number_ = 0;
  Verdict verdict_ = Verdict::Run;
};

/// Programs in a folder of their own; the first one is the main program.
class Job {
 public:
  Job(const std::string& control, const std::vector<std::pair<std::string, std::string>>& programs,
      const std::string& sheet = "") {
    request.control = control;
    for (const auto& [name, text] : programs) {
      const std::string path = folder_.write(name, text);
      if (request.programs.empty()) {
        request.programs = {path};
      }
    }
    request.setups = {folder_.write("sheet.toml", sheet)};
  }
  session::Request request;

 private:
  TemporaryFolder folder_;
};

Job fanuc(const std::string& text, const std::string& sheet = "") {
  return {"fanuc-30i", {{"main.nc", text}}, sheet};
}

TEST(BlockSteps, AListenerHearsEachBlockWithItsPlaceAndLevel) {
  const Job job =
      fanuc("O1\n#1=1\n/#1=9\nG65P2\nM30\nO2\nG4X1.\nM99\n", "control.block_skip = [1]\n");
  Heard heard;
  SteppedRun run(job.request, &heard, {});
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  EXPECT_EQ(heard.lines(run), (std::vector<int>{1, 2, 3, 4, 6, 7, 8, 5}));
  EXPECT_EQ(heard.depths, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 0}));
  EXPECT_EQ(heard.skipped,
            (std::vector<bool>{false, false, true, false, false, false, false, false}));
  EXPECT_EQ(heard.levels, (std::vector<int>{1, 0}));
  EXPECT_EQ(heard.numbers, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6, 7, 8}));
  EXPECT_EQ(run.session().finish().blocks, 8U);
}

TEST(BlockSteps, SinumerikTellsWhichProgramsHideTheirBlocks) {
  const Job job("sinumerik-828d", {{"MAIN.MPF", "R1=1\nHIDDEN\nM30\n"},
                                   {"HIDDEN.SPF", "PROC HIDDEN DISPLOF\nR2=R1+1\nRET\n"}});
  Heard heard;
  SteppedRun run(job.request, &heard, {});
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  ASSERT_GE(heard.places.size(), 4U);
  EXPECT_EQ(heard.levels, (std::vector<int>{1, 0}));
  for (std::size_t i = 0; i < heard.places.size(); ++i) {
    EXPECT_EQ(heard.shown[i], heard.depths[i] == 0) << i;
    EXPECT_EQ(heard.numbers[i], i + 1);
  }
}

TEST(BlockSteps, AStopEndsTheRunBeforeItsBlock) {
  const Job job = fanuc("O1\n#500=1\n#500=2\n#500=3\nM30\n");
  Heard heard(4, Verdict::Stop);
  SteppedRun run(job.request, &heard, {});
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  const runtime::Outcome outcome = run.session().finish();
  EXPECT_EQ(outcome.status, runtime::Status::Interrupted);
  EXPECT_EQ(outcome.blocks, 3U);
  ASSERT_EQ(outcome.diagnostics.size(), 1U);
  EXPECT_EQ(outcome.diagnostics.front().code, "PRB603");
  EXPECT_EQ(testing::shown(run.place(outcome.diagnostics.front().where)), "4:1");
  EXPECT_EQ(run.session().permanent_variables().at("#500"), 2.0);
}

/// Has a defect in its second assignment.
class Broken final : public runtime::BlockListener {
 public:
  Verdict on_block(const runtime::BlockPlace& /*place*/) override { return Verdict::Run; }
  [[nodiscard]] bool hears_writes() const override { return true; }
  void on_write(const runtime::WriteEvent& /*event*/) override { G31_EXPECTS(++writes_ < 2); }

 private:
  int writes_ = 0;
};

TEST(BlockSteps, ADefectEndsTheRunAtItsBlockAndTellsWhatWasDone) {
  struct Program {
    Job job;
    const char* variable;
    const char* place;
  };
  const Program kPrograms[] = {
      {fanuc("O1\n#500=1\n#500=2\n#500=3\nM30\n"), "#500", "3:1"},
      {Job("sinumerik-828d", {{"MAIN.MPF", "R1=5\nG1 X1 F100\nR1=2\nM30\n"}}), "R1", "3:1"},
  };
  for (const Program& program : kPrograms) {
    SCOPED_TRACE(program.variable);
    Broken broken;
    SteppedRun run(program.job.request, &broken, {});
    EXPECT_EQ(run.session().advance(), Advance::Ended);
    const runtime::Outcome outcome = run.session().finish();
    EXPECT_EQ(outcome.status, runtime::Status::Defect);
    EXPECT_EQ(session::ending_of(outcome), session::Ending::Defect);
    ASSERT_EQ(outcome.diagnostics.size(), 1U);
    EXPECT_EQ(outcome.diagnostics.front().code, "PRB606");
    EXPECT_NE(outcome.diagnostics.front().message.find("++writes_ < 2"), std::string::npos);
    EXPECT_EQ(testing::shown(run.place(outcome.diagnostics.front().where)), program.place);
    EXPECT_TRUE(run.session().permanent_variables().contains(program.variable));
  }
}

TEST(BlockSteps, ARunEndsWhereItPausesWhenItIsFinishedThere) {
  const Job job("sinumerik-828d", {{"MAIN.MPF", "R1=1\nR1=2\nR1=3\nM30\n"}});
  Heard heard(2, Verdict::Pause);
  SteppedRun run(job.request, &heard, {});
  EXPECT_EQ(run.session().advance(), Advance::Paused);
  const runtime::Outcome outcome = run.session().finish();
  EXPECT_EQ(outcome.status, runtime::Status::Interrupted);
  EXPECT_EQ(outcome.blocks, 1U);
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  EXPECT_EQ(run.session().permanent_variables().at("R1"), 1.0);
}

TEST(BlockSteps, AProgramThatCannotBeginHasEnded) {
  const Job job = fanuc("O1\n#1=[1\nM30\n");
  Heard heard;
  SteppedRun run(job.request, &heard, {});
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  EXPECT_EQ(run.session().finish().status, runtime::Status::SyntaxError);
  EXPECT_TRUE(heard.places.empty());
  EXPECT_TRUE(run.session().call_levels().empty());
}

/// The variables of a level as name = value.
std::map<std::string, std::string> locals(SteppedRun& run, std::size_t level) {
  std::map<std::string, std::string> found;
  for (const auto& [name, value] : run.session().values(level, Scope::Local)) {
    found[name] = testing::shown(value);
  }
  return found;
}

/// What an expression comes to, or why it comes to nothing.
std::string value(SteppedRun& run, std::size_t level, const std::string& text) {
  const auto found = run.session().evaluate(level, text);
  return found ? testing::shown(found.value()) : "? " + found.error();
}

TEST(BlockSteps, EachFanucLevelShowsItsOwnVariables) {
  const Job job = fanuc("O1\n#1=1\n#100=10\nG65P2A5.B6.\nM30\nO2\nM98P3\nM99\nO3\n#3=7\nM99\n");
  Pauses there = Pauses::at({9});  // O1, #1, #100, G65, O2, M98, O3, #3=7, M99
  SteppedRun run(job.request, &there, {});
  ASSERT_EQ(run.session().advance(), Advance::Paused);
  const auto levels = run.session().call_levels();
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[0].program, "O0003");
  EXPECT_EQ(testing::shown(run.place(levels[0].where)), "11:1");
  EXPECT_EQ(levels[1].program, "O0002");
  EXPECT_EQ(testing::shown(run.place(levels[1].where)), "7:1");
  EXPECT_EQ(levels[2].program, "O0001");
  EXPECT_EQ(testing::shown(run.place(levels[2].where)), "4:1");
  const std::map<std::string, std::string> macro = {{"#1", "5"}, {"#2", "6"}, {"#3", "7"}};
  EXPECT_EQ(locals(run, 0), macro);
  EXPECT_EQ(locals(run, 1), macro) << "M98 shares the locals of its caller";
  EXPECT_EQ(locals(run, 2), (std::map<std::string, std::string>{{"#1", "1"}}));
  EXPECT_EQ(value(run, 0, "#1+#100"), "15");
  EXPECT_EQ(value(run, 2, "#1+#100"), "11");
  EXPECT_EQ(value(run, 2, "#2"), "vacant");
  EXPECT_EQ(value(run, 0, "#1 GT #2"), "0");
  EXPECT_EQ(value(run, 0, "[#1 EQ 5] AND [#3 EQ 7]").front(), '?') << "6006.0 is off";
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  EXPECT_EQ(run.session().finish().status, runtime::Status::Completed);
}

TEST(BlockSteps, AnExpressionThatCannotBeEvaluatedSaysWhy) {
  const Job job = fanuc("O1\n#1=1\nM30\n");
  Pauses each = Pauses::at_each(1);
  SteppedRun run(job.request, &each, {});
  ASSERT_EQ(run.session().advance(), Advance::Paused);
  for (const std::string text :
       {"", "#", "#1 #2=5", "1/0", "#1=5", "G1X5", "#1\nM30", "(A)", "]["}) {
    EXPECT_EQ(value(run, 0, text).front(), '?') << text;
  }
  EXPECT_EQ(run.session().finish().status, runtime::Status::Interrupted);
}

TEST(BlockSteps, TheEndOfARunCanBeLookedAtToo) {
  const Job job = fanuc("O1\n#1=1\n#500=2\nG65P2A5.\nM30\nO2\nM30\n");
  SteppedRun run(job.request, nullptr, {});
  ASSERT_EQ(run.session().advance(), Advance::Ended);
  const auto levels = run.session().call_levels();
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(testing::shown(run.place(levels[0].where)), "7:1") << "the last step of its program";
  EXPECT_EQ(locals(run, 0), (std::map<std::string, std::string>{{"#1", "5"}}));
  EXPECT_EQ(locals(run, 1), (std::map<std::string, std::string>{{"#1", "1"}}));
  EXPECT_EQ(value(run, 1, "#1+#500"), "3");
  EXPECT_EQ(run.session().permanent_variables(), (std::map<std::string, double>{{"#500", 2.0}}));
}

TEST(BlockSteps, EachSinumerikLevelShowsItsOwnVariables) {
  const Job job("sinumerik-828d",
                {{"MAIN.MPF", "DEF INT COUNT=3\nDEF STRING[8] NAME=\"ABC\"\nSUB(2.5,COUNT)\nM30\n"},
                 {"SUB.SPF", "PROC SUB(REAL WIDTH, VAR INT HOW)\nDEF BOOL LIST[2]\nHOW=4\nRET\n"}});
  Heard heard;
  std::vector<int> lines;
  {
    SteppedRun whole(job.request, &heard, {});
    whole.session().advance();
    lines = heard.lines(whole);
  }
  const auto ret = std::ranges::find(lines, 4);
  ASSERT_NE(ret, lines.end());
  Pauses there = Pauses::at({static_cast<std::uint64_t>(ret - lines.begin()) + 1});
  SteppedRun run(job.request, &there, {});
  ASSERT_EQ(run.session().advance(), Advance::Paused);
  const auto levels = run.session().call_levels();
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[0].program, "SUB");
  EXPECT_EQ(levels[1].program, "MAIN");
  EXPECT_EQ(testing::shown(run.place(levels[1].where)), "3:1");
  EXPECT_EQ(locals(run, 0),
            (std::map<std::string, std::string>{
                {"WIDTH", "2.5"}, {"HOW", "4"}, {"LIST[0]", "0"}, {"LIST[1]", "0"}}));
  EXPECT_EQ(locals(run, 1),
            (std::map<std::string, std::string>{{"COUNT", "4"}, {"NAME", "\"ABC\""}}));
  EXPECT_EQ(value(run, 0, "WIDTH*HOW"), "10");
  EXPECT_EQ(value(run, 1, "NAME<<COUNT"), "\"ABC4\"");
  EXPECT_EQ(value(run, 1, "WIDTH").front(), '?');
  EXPECT_EQ(value(run, 0, "1/0").front(), '?');
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  EXPECT_EQ(run.session().finish().status, runtime::Status::Completed);
}

/// What was heard of the writes of a run, a line each: "3: #100 vacant -> 5".
std::string writes_of(const Job& job) {
  testing::WatchedVariables watched(0);
  SteppedRun run(job.request, &watched, {});
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  std::string text;
  for (const runtime::WriteEvent& event : watched.events) {
    text += std::to_string(run.place(event.where).line) + ": " + event.name + " " +
            testing::shown(event.before) + " -> " + testing::shown(event.now) + "\n";
  }
  return text;
}

TEST(BlockSteps, AListenerHearsWhatAFanucProgramWrites) {
  EXPECT_EQ(writes_of(fanuc("O1\n"
                            "#100=5\n"
                            "#1=#100+1\n"
                            "#[99+#1]=2.5\n"
                            "#1=#0\n"
                            "IF[#100EQ5]THEN#500=#100\n"
                            "WHILE[#100GT4]DO1\n"
                            "#100=#100-1\n"
                            "END1\n"
                            "#5221=7.5\n"
                            "G65P2A3.\n"
                            "M30\n"
                            "O2\n"
                            "#1=#1*2\n"
                            "#100=#100\n"
                            "M99\n")),
            "2: #100 vacant -> 5\n"
            "3: #1 vacant -> 6\n"
            "4: #105 vacant -> 2.5\n"
            "5: #1 6 -> vacant\n"
            "6: #500 vacant -> 5\n"
            "8: #100 5 -> 4\n"
            "10: #5221 0 -> 7.5\n"
            "14: #1 3 -> 6\n"
            "15: #100 4 -> 4\n");
}

TEST(BlockSteps, AListenerHearsWhatASinumerikProgramWrites) {
  const Job job("sinumerik-828d", {{"MAIN.MPF",
                                    "DEF INT COUNT=3\n"
                                    "DEF REAL TABLE[2,2]\n"
                                    "DEF STRING[8] NAME\n"
                                    "DEF AXIS WAY\n"
                                    "R1=COUNT+0.5 R[COUNT]=R1\n"
                                    "TABLE[1,0]=R1*2\n"
                                    "TABLE[0,0]=SET(1,2,3)\n"
                                    "NAME=\"A\"<<COUNT\n"
                                    "WAY=Y\n"
                                    "FOR COUNT=1 TO 2\n"
                                    "R1=R1\n"
                                    "ENDFOR\n"
                                    "$P_UIFR[1,X,TR]=10\n"
                                    "EXECSTRING(\"R9=8\")\n"
                                    "SUB(2.5,COUNT)\n"
                                    "M30\n"},
                                   {"SUB.SPF", "PROC SUB(REAL WIDTH, VAR INT HOW)\nHOW=4\nRET\n"}});
  EXPECT_EQ(writes_of(job),
            "1: COUNT 0 -> 3\n"
            "5: R1 0 -> 3.5\n"
            "5: R3 0 -> 3.5\n"
            "6: TABLE[1,0] 0 -> 7\n"
            "7: TABLE[0,0] 0 -> 1\n"
            "7: TABLE[0,1] 0 -> 2\n"
            "7: TABLE[1,0] 7 -> 3\n"
            "8: NAME \"\" -> \"A3\"\n"
            "9: WAY \"\" -> \"Y\"\n"
            "10: COUNT 3 -> 1\n"
            "11: R1 3.5 -> 3.5\n"
            "12: COUNT 1 -> 2\n"
            "11: R1 3.5 -> 3.5\n"
            "12: COUNT 2 -> 3\n"
            "13: $P_UIFR[1,X,TR] 0 -> 10\n"
            "1: R9 0 -> 8\n"
            "2: HOW 3 -> 4\n"
            "2: COUNT 3 -> 4\n");
}

TEST(BlockSteps, AWriteOfAParameterIsOneOfTheVariableBehindIt) {
  const Job job("sinumerik-828d",
                {{"MAIN.MPF",
                  "DEF REAL TABLE[2,2]\n"
                  "DEF STRING[8] NAME\n"
                  "SETV(R5)\n"
                  "SETV(TABLE[1,0])\n"
                  "PASS(R6)\n"
                  "FILL(TABLE,NAME)\n"
                  "M30\n"},
                 {"SETV.SPF", "PROC SETV(VAR REAL X)\nX=7\nX=7\nM17\n"},
                 {"PASS.SPF", "PROC PASS(VAR REAL WAY)\nDEF REAL TABLE=1\nSETV(WAY)\nM17\n"},
                 {"FILL.SPF",
                  "PROC FILL(VAR REAL A[2,2],VAR STRING[8] T)\nA[0,1]=3\n"
                  "A[1,0]=SET(7,9)\nT=\"B\"\nEXECSTRING(\"A[0,0]=2\")\nM17\n"}});
  EXPECT_EQ(writes_of(job),
            "2: X 0 -> 7\n"
            "2: R5 0 -> 7\n"
            "3: X 7 -> 7\n"
            "3: R5 7 -> 7\n"
            "2: X 0 -> 7\n"
            "2: TABLE[1,0] 0 -> 7\n"
            "3: X 7 -> 7\n"
            "3: TABLE[1,0] 7 -> 7\n"
            "2: TABLE 0 -> 1\n"
            "2: X 0 -> 7\n"
            "2: R6 0 -> 7\n"
            "2: WAY 0 -> 7\n"
            "3: X 7 -> 7\n"
            "3: R6 7 -> 7\n"
            "3: WAY 7 -> 7\n"
            "2: A[0,1] 0 -> 3\n"
            "2: TABLE[0,1] 0 -> 3\n"
            "3: A[1,1] 0 -> 9\n"
            "3: TABLE[1,1] 0 -> 9\n"
            "4: T \"\" -> \"B\"\n"
            "4: NAME \"\" -> \"B\"\n"
            "1: A[0,0] 0 -> 2\n"
            "1: TABLE[0,0] 0 -> 2\n");
}

TEST(BlockSteps, TheTimeOfAPauseIsNoTimeOfTheRun) {
  const Job job = fanuc("O1\n#1=1\n#1=2\nM30\n");
  Pauses each = Pauses::at_each(3);
  SteppedRun run(job.request, &each, {1000, 0.05});
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(run.session().advance(), Advance::Paused);
    std::this_thread::sleep_for(std::chrono::milliseconds(60));
  }
  EXPECT_EQ(run.session().advance(), Advance::Ended);
  EXPECT_EQ(run.session().finish().status, runtime::Status::Completed);
}

}  // namespace
}  // namespace g31::block_steps_test

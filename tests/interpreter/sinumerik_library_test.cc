// Files of the SINUMERIK: names, archives, definition files, characters.

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/run/session.h"
#include "tests/support/files_in_memory.h"
#include "tests/support/recording_machine.h"

namespace g31::sinumerik_library_test {
namespace {

using runtime::Cell;
using runtime::ShownValue;
using sinumerik::ProgramLibrary;
using testing::FilesInMemory;

/// A run of "main.mpf" with the folder "lib", and with "shipped" as what comes with the control.
class ProgramRun {
 public:
  explicit ProgramRun(std::map<std::string, std::string> files)
      : files_(std::move(files)), sources_(files_), library_(sources_) {
    library_.add_file("main.mpf");
    library_.add_folder("lib");
    library_.add_shipped_folder("shipped");
    session_ = std::make_unique<sinumerik::Session>(library_, machine_, observer_);
    session_->configure({});
    outcome_ = session_->run({});
  }
  [[nodiscard]] int alarm() const { return outcome_.alarm ? outcome_.alarm->number : 0; }
  [[nodiscard]] const runtime::Outcome& outcome() const { return outcome_; }
  double number(const std::string& name) {
    const auto value = session_->variable(name);
    return value ? std::get<Cell>(value.value()).raw() : -999.0;
  }
  std::string text(const std::string& name) {
    const auto value = session_->variable(name);
    return value ? std::get<std::string>(value.value()) : value.error();
  }
  [[nodiscard]] const FilesInMemory& files() const { return files_; }
  /// "main.mpf:2", or "" where there is no place.
  [[nodiscard]] std::string line_of(const source::Location& where) const {
    const source::ShownPlace place = sources_.show(where);
    return place.file.empty() ? std::string() : place.file + ":" + std::to_string(place.line);
  }

 private:
  FilesInMemory files_;
  source::SourceMap sources_;
  ProgramLibrary library_;
  testing::RecordingMachine machine_;
  runtime::Observer observer_;
  std::unique_ptr<sinumerik::Session> session_;
  runtime::Outcome outcome_;
};

/// NC programming 12/2019, 3.4.1.4: the subprogram first, then the main program, folder by folder.
TEST(SinumerikLibrary, OfASubprogramAndAMainProgramSideBySideACallTakesTheFirst) {
  ProgramRun beside({{"main.mpf", "PART\nM30\n"},
                     {"lib/part.mpf", "R1=2\nM30\n"},
                     {"lib/part.spf", "R1=1\nM17\n"},
                     {"shipped/part.spf", "R1=3\nM17\n"}});
  EXPECT_EQ(beside.number("R1"), 1.0);
  ProgramRun apart({{"main.mpf", "PART\nM30\n"},
                    {"lib/part.mpf", "R1=2\nM17\n"},
                    {"shipped/part.spf", "R1=3\nM17\n"}});
  EXPECT_EQ(apart.number("R1"), 2.0);
}

/// Runs "main.mpf" in a session of its own.  @returns R1 afterwards
double r1_of_session(ProgramLibrary& library, const std::string& assignment, double value) {
  testing::RecordingMachine machine;
  runtime::Observer nobody;
  sinumerik::Session session(library, machine, nobody);
  runtime::ControlSetup setup;
  setup.variables[assignment] = value;
  EXPECT_TRUE(session.configure(setup).empty());
  EXPECT_EQ(session.run({}).status, runtime::Status::Completed);
  return std::get<Cell>(session.variable("R1").value()).raw();
}

TEST(SinumerikSession, AVariableAskedForFromOutsideIsNoReadingOfTheProgram) {
  FilesInMemory files(std::map<std::string, std::string>{{"main.mpf", "R1=1\nM30\n"}});
  source::SourceMap sources(files);
  ProgramLibrary library(sources);
  library.add_file("main.mpf");
  testing::RecordingMachine machine;
  runtime::Observer nobody;
  sinumerik::Session session(library, machine, nobody);
  ASSERT_TRUE(session.configure({}).empty());
  ASSERT_TRUE(session.variable("$AA_MW[X]"));  // nothing has been measured: PRB319 of a program
  EXPECT_TRUE(session.run({}).diagnostics.empty());
  ASSERT_TRUE(session.variable("$AA_MW[X]"));
  EXPECT_TRUE(session.finish().diagnostics.empty());
}

TEST(SinumerikLibrary, IsReadOnceForAllSessionsWhichShareNoVariables) {
  FilesInMemory files({{"main.mpf", "COUNT=COUNT+R2\nTWICE(COUNT)\nM30\n"},
                       {"lib/gud.def", "DEF CHAN REAL COUNT=5\nM17\n"},
                       {"lib/twice.spf", "PROC TWICE(REAL A)\nR1=R1+2*A\nM17\n"}});
  source::SourceMap sources(files);
  ProgramLibrary library(sources);
  library.add_file("main.mpf");
  library.add_folder("lib");
  EXPECT_EQ(r1_of_session(library, "R2", 1.0), 12.0);
  const int reads = files.reads();
  EXPECT_EQ(reads, 3);
  EXPECT_EQ(r1_of_session(library, "R2", 2.0), 14.0);
  EXPECT_EQ(r1_of_session(library, "R1", 1.0), 11.0);
  EXPECT_EQ(files.reads(), reads);
}

TEST(SinumerikLibrary, WhatANameMeansDoesNotDependOnOtherSessions) {
  FilesInMemory files(
      {{"main.mpf", "IF R2==1\nDEEP\nENDIF\nPART\nM30\n"},
       {"lib/all.arc", "%_N_DEEP_SPF\nM17\n%_N_PART_SPF\n;$PATH=/_N_SPF_DIR\nR1=2\nM17\n"},
       {"lib/part.spf", "R1=1\nM17\n"}});
  source::SourceMap sources(files);
  ProgramLibrary library(sources);
  library.add_file("main.mpf");
  library.add_folder("lib");
  EXPECT_EQ(r1_of_session(library, "R2", 0.0), 1.0);
  // Only this session has opened the archive.
  EXPECT_EQ(r1_of_session(library, "R2", 1.0), 2.0);
  EXPECT_EQ(r1_of_session(library, "R2", 0.0), 1.0);
}

TEST(SinumerikLibrary, ReadsMacrosBeforeTheDataThatUseThem) {
  ProgramRun run({{"main.mpf", "R1=KK\nM30\n"},
                  {"lib/mgud.def", "DEF NCK REAL KK=NV\nM17\n"},
                  {"lib/mmac.def", "DEFINE NV AS 999\nM17\n"}});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 999.0);
}

TEST(SinumerikLibrary, MacrosOfAUserDoNotReachIntoWhatComesWithTheControl) {
  ProgramRun run(
      {{"main.mpf", "CYC\nR2=_OFF+ONE\nR3=TWO\nM30\n"},
       {"lib/pmac.def", "DEFINE _OFF AS 40\nDEFINE ONE AS 50\nM17\n"},
       {"shipped/pgud.def", "DEFINE ONE AS 1\nDEFINE TWO AS 2\nDEF NCK REAL _OFF=3\nM17\n"},
       {"shipped/cyc.spf", "PROC CYC\nR1=_OFF+ONE\nM17\n"}});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 4.0);
  EXPECT_EQ(run.number("R2"), 90.0);
  EXPECT_EQ(run.number("R3"), 2.0);
}

TEST(SinumerikLibrary, AMacroTwiceInWhatComesWithTheControlIsAnAlarm) {
  ProgramRun run(
      {{"main.mpf", "M30\n"}, {"shipped/pgud.def", "DEFINE ONE AS 1\nDEFINE ONE AS 2\nM17\n"}});
  EXPECT_EQ(run.alarm(), 12270);
}

TEST(SinumerikLibrary, FindsProgramsInFilesAndArchives) {
  ProgramRun run(
      {{"main.mpf", "SUBA\nL0100\nDEEP\nM30\n"},
       {"lib/suba.spf", "R1=1\nRET\n"},
       {"lib/_N_L0100_SPF", "R2=1\nRET\n"},
       {"lib/L100.spf", "R2=99\nRET\n"},
       {"lib/all.arc", "%_N_OTHER_SPF\nRET\n%_N_DEEP_SPF\n;$PATH=/_N_SPF_DIR\nR3=1\nM17\n"}});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 1.0);
  EXPECT_EQ(run.number("R2"), 1.0);
  EXPECT_EQ(run.number("R3"), 1.0);
}

TEST(SinumerikLibrary, ReadsOnlyWhatIsCalled) {
  std::map<std::string, std::string> files = {{"main.mpf", "SUB7\nM30\n"}};
  for (int i = 0; i < 1000; ++i) {
    files["lib/SUB" + std::to_string(i) + ".SPF"] = "R1=" + std::to_string(i) + "\nRET\n";
  }
  ProgramRun run(std::move(files));
  EXPECT_EQ(run.number("R1"), 7.0);
  EXPECT_EQ(run.files().reads(), 2);
}

TEST(SinumerikLibrary, ChoosesAmongFoldersOfTheControl) {
  const std::string in_spf = "%_N_SUB_SPF\n;$PATH=/_N_SPF_DIR\nR1=R1*10+1\nRET\n";
  const std::string in_a = "%_N_SUB_SPF\n;$PATH=/_N_WKS_DIR/_N_A_WPD\nR1=R1*10+2\nRET\n";
  const std::string in_b =
      "%_N_SUB_SPF\n;$PATH=/_N_WKS_DIR/_N_B_WPD\nR1=R1*10+3\nRET\n"
      "%_N_CALLER_SPF\n;$PATH=/_N_WKS_DIR/_N_B_WPD\nSUB\nRET\n"
      "%_N_ONLY_SPF\n;$PATH=/_N_WKS_DIR/_N_B_WPD\nR2=R2*10+3\nRET\n"
      "%_N_ONLY_SPF\n;$PATH=/_N_WKS_DIR/_N_A_WPD\nR2=R2*10+2\nRET\n";
  ProgramRun run({{"main.mpf",
                   "%_N_MAIN_MPF\n;$PATH=/_N_WKS_DIR/_N_A_WPD\n"
                   "SUB\nCALLER\nPCALL /_N_SPF_DIR/_N_SUB_SPF\n"
                   "CALL \"//NC:/WKS.DIR/B.WPD/SUB.SPF\"\n"
                   "ONLY\nM30\n" +
                       in_spf + in_b + in_a}});
  EXPECT_EQ(run.alarm(), 0);
  // The main program's own folder, the caller's, the two that are named.
  EXPECT_EQ(run.number("R1"), 2313.0);
  EXPECT_EQ(run.number("R2"), 2.0);

  ProgramRun by_path({{"main.mpf",
                       "%_N_MAIN_MPF\nONLY\nCALLPATH(\"/_N_WKS_DIR/_N_A_WPD\")\nONLY\n"
                       "CALLPATH()\nONLY\nM30\n" +
                           in_b}});
  EXPECT_EQ(by_path.number("R2"), 323.0);
}

TEST(SinumerikLibrary, HoldsAnArchiveOfManyFiles) {
  std::string archive = "%_N_MAIN_MPF\n";
  for (int i = 0; i < 260; ++i) {
    archive += "SUB" + std::to_string(i) + "(" + std::to_string(i) + ")\n";
  }
  archive += "M30\n";
  int sum = 0;
  for (int i = 0; i < 260; ++i) {
    archive += "%_N_SUB" + std::to_string(i) + "_SPF\n;$PATH=/_N_SPF_DIR\nPROC SUB" +
               std::to_string(i) + "(INT AA)\nIF AA>9999\nGOTOF NOWHERE\nENDIF\nR1=R1+AA\nM17\n";
    sum += i;
  }
  ProgramRun run({{"main.mpf", archive}});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), sum);
}

TEST(SinumerikDefinitions, CountFromTheStartInAnArchiveOfAFolder) {
  ProgramRun run({{"main.mpf", "R1=COUNTER R2=LIMIT\nDEEP\nR3=COUNTER R4=KEPT\nM30\n"},
                  {"lib/MGUD.DEF", "DEF NCK INT KEPT=5\nM17\n"},
                  {"lib/all.arc",
                   "%_N_UGUD_DEF\n;$PATH=/_N_DEF_DIR\nDEF NCK INT COUNTER=7\nM17\n"
                   "%_N_MGUD_DEF\n;$PATH=/_N_DEF_DIR\nDEF NCK INT KEPT=6\nM17\n"
                   "%_N_UMAC_DEF\n;$PATH=/_N_DEF_DIR\nDEFINE LIMIT AS 12.5\nM17\n"
                   "%_N_DEEP_SPF\n;$PATH=/_N_SPF_DIR\nCOUNTER=COUNTER+1\nM17\n"}});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 7.0);
  EXPECT_EQ(run.number("R2"), 12.5);
  EXPECT_EQ(run.number("R3"), 8.0);
  EXPECT_EQ(run.number("R4"), 5.0);  // the first one of a name counts
}

TEST(SinumerikDefinitions, AreGlobalAndHaveValues) {
  ProgramRun run({{"main.mpf", "R1=GLOB[1] R2=LIMIT\nGLOB[0]=5\nSUBA\nMYCODE\nM30\n"},
                  {"lib/suba.spf", "R3=GLOB[0]\nUSERTXT[2]=\"X\"<<R3\nRET\n"},
                  {"lib/UGUD.DEF",
                   "%_N_UGUD_DEF\n"
                   "DEF NCK REAL GLOB[3]=(1,2.5)\n"
                   "DEF CHAN SYNRW APWP 4 STRING[20] USERTXT[4]\n"
                   "DEFINE LIMIT AS 12\n"
                   "DEFINE MYCODE AS R4=7\n"
                   "M17\n"}});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 2.5);
  EXPECT_EQ(run.number("R2"), 12.0);
  EXPECT_EQ(run.number("R3"), 5.0);
  EXPECT_EQ(run.number("R4"), 7.0);
  EXPECT_EQ(run.text("USERTXT[2]"), "X5");
}

TEST(SinumerikDefinitions, MustHaveAScope) {
  ProgramRun run({{"main.mpf", "M30\n"}, {"lib/UGUD.DEF", "DEF REAL GLOB\nM17\n"}});
  EXPECT_EQ(run.alarm(), 14500);
  EXPECT_EQ(run.line_of(run.outcome().alarm->where), "lib/UGUD.DEF:1");
}

TEST(SinumerikDefinitions, TheFirstFileOfANameCounts) {
  ProgramRun run({{"main.mpf", "R1=GLOB\nM30\n%_N_UGUD_DEF\nDEF NCK REAL GLOB=1\nM17\n"},
                  {"lib/UGUD.DEF", "%_N_UGUD_DEF\nDEF NCK REAL GLOB=2\nM17\n"}});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 1.0);
}

TEST(SinumerikTexts, TakeLatin1AndUtf8) {
  const std::string kMark = "\xEF\xBB\xBF";
  const std::string latin_1 = "DEF STRING[9] TT=\"\xE4\xF6\" ; \xFC\nR1=STRLEN(TT)\nM30\n";
  const std::string utf_8 =
      "DEF STRING[9] TT=\"\xC3\xA4\xC3\xB6\" ; \xC3\xBC\nR1=STRLEN(TT)\nM30\n";
  for (const std::string& text : {latin_1, utf_8, kMark + utf_8}) {
    std::map<std::string, std::string> files;
    files["main.mpf"] = text;
    ProgramRun run(std::move(files));
    EXPECT_EQ(run.alarm(), 0);
    EXPECT_EQ(run.number("R1"), 2.0);
    EXPECT_EQ(run.text("TT"), "\xE4\xF6");
  }
}

TEST(SinumerikTexts, FindAHeaderBehindAByteOrderMark) {
  std::map<std::string, std::string> files;
  files["main.mpf"] = "\xEF\xBB\xBF%_N_PART_MPF\r\nR1=1\r\nM30\r\n";
  ProgramRun run(std::move(files));
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 1.0);
}

TEST(SinumerikTexts, TakeControlCharactersAsBlanks) {
  std::map<std::string, std::string> files;
  files["main.mpf"] = std::string("\0\0R1=5\x1B\n\tR2=6\x7F\nM30\n\x1A\0", 21);
  ProgramRun run(std::move(files));
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 5.0);
  EXPECT_EQ(run.number("R2"), 6.0);
}

TEST(SinumerikAlarms, TellPlaceAndCalls) {
  ProgramRun run({{"main.mpf", "R1=1\nSUBA(2)\nM30\n"},
                  {"lib/suba.spf", "PROC SUBA(INT AA)\n\n  R1=R1/(AA-2)\nRET\n"}});
  ASSERT_TRUE(run.outcome().alarm);
  EXPECT_EQ(run.alarm(), 14051);
  EXPECT_EQ(run.line_of(run.outcome().alarm->where), "lib/suba.spf:3");
  ASSERT_EQ(run.outcome().alarm->calls.size(), 1U);
  EXPECT_EQ(run.line_of(run.outcome().alarm->calls[0].where), "main.mpf:2");
}

/// More text than a window has, without a block.
std::string long_comment() {
  std::string text;
  while (text.size() < 600'000) {
    text += "; nothing to do in this line, nor in the one behind it\n";
  }
  return text;
}

/// A program too long to be compiled at once: `parts`, with many comment lines behind each.
ProgramRun long_run(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) {
    text += part + "\n" + long_comment();
  }
  return ProgramRun({{"main.mpf", text},
                     {"lib/sub.spf", "PROC SUB(INT AA)\nR9=R9+AA\nRET\n"},
                     {"lib/back.spf", "R9=R9+1\nRET(\"HERE\")\n"}});
}

TEST(SinumerikAlarms, EndTheProgramThatWaitsForAText) {
  std::map<std::string, std::string> files;
  files["main.mpf"] = "R1=1\nEXECSTRING(\"R1=2 X=1/0\")\nR1=50\nM30\n";
  ProgramRun run(std::move(files));
  EXPECT_EQ(run.alarm(), 14051);
  EXPECT_EQ(run.number("R1"), 2.0);
}

TEST(SinumerikLongProgram, GoesOnFromWindowToWindow) {
  ProgramRun run = long_run({"G1 F100\nN1 X1", "R1=R1+1 X=R1", "N3 X7 M8", "R1=R1*10\nM30\nR1=5"});
  EXPECT_EQ(run.outcome().status, runtime::Status::Completed);
  EXPECT_EQ(run.number("R1"), 10.0);
  EXPECT_EQ(run.number("$AA_IW[X]"), 7.0);
  EXPECT_EQ(run.outcome().blocks, 6);
}

TEST(SinumerikLongProgram, JumpsCallsAndLoopsReachAllOfIt) {
  ProgramRun jump = long_run({"N10 R1=R1+1", "R2=R2+1", "IF R1<3 GOTOB N10", "R3=R1\nM30"});
  EXPECT_EQ(jump.number("R3"), 3.0);
  EXPECT_EQ(jump.number("R2"), 3.0);

  ProgramRun ahead = long_run({"R1=1", "GOTOF OUT", "R1=2", "OUT: R1=R1+10"});
  EXPECT_EQ(ahead.number("R1"), 11.0);

  ProgramRun calls = long_run({"R9=1", "SUB(10)", "SUB(100)", "R1=R9"});
  EXPECT_EQ(calls.number("R1"), 111.0);

  ProgramRun returns = long_run({"R1=1", "BACK", "R1=R1+10", "HERE: R1=R1+100"});
  EXPECT_EQ(returns.number("R1"), 101.0);
  EXPECT_EQ(returns.number("R9"), 1.0);

  ProgramRun loop = long_run({"R1=0", "FOR R2=1 TO 3\nR1=R1+R2", "ENDFOR", "R1=R1*2"});
  EXPECT_EQ(loop.number("R1"), 12.0);

  ProgramRun part = long_run({"N10 R1=R1+1\nN20 R2=R2+1", "R3=1", "REPEAT N10 N20 P=4"});
  EXPECT_EQ(part.number("R1"), 5.0);
  EXPECT_EQ(part.number("R2"), 5.0);

  const ProgramRun definition = long_run({"R1=1", "R1=2", "EXTERN SUB(INT)", "SUB(1)"});
  EXPECT_EQ(definition.alarm(), 14500);

  ProgramRun macro = long_run({"DEFINE TWICE AS *2", "R1=4", "R1=R1 TWICE", "R1=R1 TWICE"});
  EXPECT_EQ(macro.number("R1"), 16.0);

  ProgramRun local = long_run({"DEF INT NN=3", "R1=4", "R1=R1*NN", "R1=R1*NN"});
  EXPECT_EQ(local.number("R1"), 36.0);

  ProgramRun texts = long_run({"R1=1", "EXECSTRING(\"R1=R1+1\")", "R1=R1*2"});
  EXPECT_EQ(texts.number("R1"), 4.0);
}

TEST(SinumerikLongProgram, TellsTheLineOfAnAlarm) {
  const auto lines_of_comment = std::ranges::count(long_comment(), '\n');
  const auto in_main = [](auto line) { return "main.mpf:" + std::to_string(line); };
  const ProgramRun in_window = long_run({"R1=1", "R1=2", "G1 F100 X=1/0", "M30"});
  EXPECT_EQ(in_window.alarm(), 14051);
  EXPECT_EQ(in_window.line_of(in_window.outcome().alarm->where),
            in_main(2 + 2 * lines_of_comment + 1));
  const ProgramRun in_whole = long_run({"R1=1", "GOTOF HERE\nHERE:", "G1 F100 X=1/0", "M30"});
  EXPECT_EQ(in_whole.alarm(), 14051);
  EXPECT_EQ(in_whole.line_of(in_whole.outcome().alarm->where),
            in_main(3 + 2 * lines_of_comment + 1));
  const ProgramRun wrong_word = long_run({"R1=1", "R1=2", "G1 Q5", "M30"});
  EXPECT_EQ(wrong_word.alarm(), 12050);
  EXPECT_EQ(wrong_word.line_of(wrong_word.outcome().alarm->where),
            in_main(2 + 2 * lines_of_comment + 1));
}

/// Program and line of each.
std::string lines_of(const ProgramRun& run, const std::vector<runtime::CallSite>& sites) {
  std::string lines;
  for (const runtime::CallSite& site : sites) {
    lines += (lines.empty() ? "" : " ") + site.program + "@" + run.line_of(site.where);
  }
  return lines;
}

TEST(SinumerikAlarms, ShowTheCallOfProgramsWithDisplof) {
  struct Case {
    const char* what;
    const char* outer;  ///< attributes of SUBA, which calls SUBB, where the alarm arises
    const char* inner;
    const char* where;
    const char* inside;
    const char* calls;
  };
  const Case kCases[] = {
      {"all show themselves", "", "", "lib/subb.spf:2", "", "SUBA@lib/suba.spf:3 MAIN@main.mpf:2"},
      {"all hide", "DISPLOF", "SAVE DISPLOF", "main.mpf:2",
       "SUBB@lib/subb.spf:2 SUBA@lib/suba.spf:3", ""},
      {"the inner one hides", "SAVE", "DISPLOF", "lib/suba.spf:3", "SUBB@lib/subb.spf:2",
       "MAIN@main.mpf:2"},
      {"only the outer one hides", "DISPLOF", "DISPLON", "lib/subb.spf:2", "",
       "SUBA@lib/suba.spf:3 MAIN@main.mpf:2"},
      {"ACTBLOCNO counts for what is called", "ACTBLOCNO DISPLOF", "DISPLOF", "lib/subb.spf:2", "",
       "SUBA@lib/suba.spf:3 MAIN@main.mpf:2"},
      {"ACTBLOCNO of the inner one", "DISPLOF", "DISPLOF ACTBLOCNO", "lib/subb.spf:2", "",
       "SUBA@lib/suba.spf:3 MAIN@main.mpf:2"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.what);
    ProgramRun run(
        {{"main.mpf", "R1=1\nSUBA(2)\nM30\n"},
         {"lib/suba.spf", std::string("PROC SUBA(INT AA) ") + c.outer + "\n\nSUBB(AA)\nRET\n"},
         {"lib/subb.spf",
          std::string("PROC SUBB(INT AA) ") + c.inner + "\n  R1=R1/(AA-2)\nRET\n"}});
    ASSERT_EQ(run.alarm(), 14051);
    const runtime::Alarm& alarm = *run.outcome().alarm;
    EXPECT_EQ(run.line_of(alarm.where), c.where);
    EXPECT_EQ(lines_of(run, alarm.inside), c.inside);
    EXPECT_EQ(lines_of(run, alarm.calls), c.calls);
  }
}

TEST(SinumerikNumbers, ZeroHasNoSign) {
  ProgramRun run({{"main.mpf", std::string("R1=0\nR2=-R1 R3=R1*(-1)\nM30\n")}});
  EXPECT_FALSE(std::signbit(run.number("R2")));
  EXPECT_FALSE(std::signbit(run.number("R3")));
}

TEST(SinumerikDataFiles, OfAnArchiveAreLoadedBeforeThePrograms) {
  const std::string archive =
      "%_N_PART_MPF\n"
      "R1=$P_UIFR[2,X,TR] R2=R20 R3=GLOB[1] R4=$TC_DP3[3,1]\n"
      "G55 T=\"MILL\" M6\nR5=$P_IFRAME[X,TR] R6=$P_TOOLNO R7=$P_BFRAME[Y,TR]\n"
      "SETUP_INI\nM30\n"
      "%_N_SETUP_INI_SPF\nR8=1\nRET\n"
      "%_N_UFR_INI\n;$PATH=/_N_INI_DIR\nCHANDATA(1)\n"
      "$P_UIFR[2,X,TR]=12.5\n$P_CHBFR[0,Y,TR]=3\nM17\n"
      "%_N_TOA_INI\n$TC_TP2[3]=\"MILL\"\n$TC_DP1[3,1]=120 $TC_DP3[3,1]=80\nM17\n"
      "%_N_RPA_INI\nR[20]=7\nM30\n"
      "%_N_GUD_INI\nGLOB[1]=4\n"
      "%_N_UGUD_DEF\nDEF NCK REAL GLOB[3]\nM17\n";
  ProgramRun run({{"main.mpf", archive}});
  ASSERT_EQ(run.alarm(), 0);
  const double kExpected[] = {12.5, 7.0, 4.0, 80.0, 12.5, 3.0, 3.0, 1.0};
  for (int i = 0; i < 8; ++i) {
    EXPECT_EQ(run.number("R" + std::to_string(i + 1)), kExpected[i]) << "R" << i + 1;
  }
}

TEST(SinumerikDataFiles, OfAFolderAreNotLoaded) {
  ProgramRun run({{"main.mpf", "R1=5\nM30\n"},
                  {"lib/desktop.ini", "[.ShellClassInfo]\n"},
                  {"lib/RPA.INI", "R[2]=7\n"}});
  EXPECT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R2"), 0.0);
}

TEST(SinumerikDataFiles, TellWhichLineIsWrong) {
  struct Case {
    const char* what;
    const char* line;
    int alarm;
  };
  const Case kCases[] = {{"no such offset", "$P_UIFR[200,X,TR]=1", 17020},
                         {"no such variable", "NOGUD=1", 12550},
                         {"no T number", "$TC_DP3[0,1]=1", 17190}};
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.what);
    ProgramRun run({{"main.mpf", std::string("R1=1\nM30\n%_N_UFR_INI\n$P_UIFR[1,X,TR]=5\n") +
                                     c.line + "\nM17\n%_N_RPA_INI\nR[2]=7\n"}});
    EXPECT_EQ(run.alarm(), c.alarm);
    EXPECT_EQ(run.line_of(run.outcome().alarm->where), "main.mpf:5");
    EXPECT_EQ(run.number("R1"), 0.0) << "nothing ran behind it";
    EXPECT_EQ(run.number("R2"), 0.0);
  }
}

// Nothing stands behind them before the main program runs.
TEST(SinumerikDataFiles, CallNoProgramThatNamesVariablesOfTheMainProgram) {
  const std::string text = "DEF REAL SIZE=4\nSUB\nM30\n";
  for (const std::string body : {"R1=SIZE", "EXECSTRING(\"R1=SIZE\")", "DO $R1=SIZE"}) {
    SCOPED_TRACE(body);
    const std::string sub = body + "\nG4 F1\nRET\n";
    ProgramRun loads({{"main.mpf", text + "%_N_UFR_INI\nSUB\nM17\n"}, {"lib/SUB.SPF", sub}});
    EXPECT_EQ(loads.alarm(), 12550);
    ProgramRun runs({{"main.mpf", text}, {"lib/SUB.SPF", sub}});
    EXPECT_EQ(runs.alarm(), 0);
    EXPECT_EQ(runs.number("R1"), 4.0);
  }
}

TEST(SinumerikDataFiles, MayHaveSystemDataThatG31HasNot) {
  const std::string archive =
      "R1=$TC_DP3[3,1] R2=$TC_DP6[3,1]\nM30\n%_N_TOA_INI\nCHANDATA(1)\n"
      "$TC_TP2[3]=\"MILL\" $TC_QAP3[3]=1 $TC_QPP2[3]=2\n"
      "$TC_QPP6[1,(2),3]=$TC_TP9[1]\n$TC_DP3[3,1]=80 $TC_QAP3[4]=1 $TC_DP6[3,1]=5\nM17\n";
  ProgramRun run({{"main.mpf", archive}});
  ASSERT_EQ(run.alarm(), 0);
  EXPECT_EQ(run.number("R1"), 80.0);
  EXPECT_EQ(run.number("R2"), 5.0);
  ASSERT_EQ(run.outcome().diagnostics.size(), 1U);
  const source::Diagnostic& note = run.outcome().diagnostics.front();
  EXPECT_EQ(note.severity, source::Severity::Note);
  EXPECT_EQ(run.line_of(note.where), "main.mpf:5");
  EXPECT_EQ(note.message, "not simulated: 3 data of this file, $TC_QAP3, $TC_QPP2, $TC_QPP6");
}

TEST(SinumerikDataFiles, DoNotRunForEver) {
  ProgramRun run({{"main.mpf", std::string("M30\n%_N_RPA_INI\nAGAIN: R1=R1+1\nGOTOB AGAIN\n")}});
  EXPECT_EQ(run.outcome().status, runtime::Status::Budget);
}

TEST(SinumerikStops, AgainAndAgainWaitForTheOperator) {
  ProgramRun run({{"main.mpf", std::string("LOOP\nMSG(\"CLOSE THE DOOR\")\nM0\nENDLOOP\nM30\n")}});
  EXPECT_EQ(run.outcome().status, runtime::Status::Budget);
  ASSERT_EQ(run.outcome().diagnostics.size(), 1U);
  const source::Diagnostic& end = run.outcome().diagnostics.front();
  EXPECT_EQ(end.code, "PRB604");
  EXPECT_EQ(run.line_of(end.where), "main.mpf:3");
  EXPECT_NE(end.message.find("CLOSE THE DOOR"), std::string::npos) << end.message;
}

TEST(SinumerikStops, OfReadInDisableThatNothingEndsAreTold) {
  ProgramRun run({{"main.mpf", std::string("WHENEVER $A_IN[1]==0 DO RDISABLE\nG4 F1\nM30\n")}});
  EXPECT_EQ(run.outcome().status, runtime::Status::Budget);
  ASSERT_EQ(run.outcome().diagnostics.size(), 1U);
  const source::Diagnostic& end = run.outcome().diagnostics.front();
  EXPECT_EQ(end.code, "PRB604");
  EXPECT_EQ(run.line_of(end.where), "main.mpf:2");
  EXPECT_NE(end.message.find("RDISABLE"), std::string::npos) << end.message;
}

TEST(SinumerikStops, MayBeManyWhileSomethingMoves) {
  ProgramRun run({{"main.mpf", std::string("FOR R1=1 TO 3000\nG0 X=R1\nM0\nENDFOR\n"
                                           "FOR R1=1 TO 900\nM0\nENDFOR\nM30\n")}});
  EXPECT_EQ(run.outcome().status, runtime::Status::Completed);
}

TEST(SinumerikDataFiles, SayWhichToolsThereAre) {
  ProgramRun run({{"main.mpf", std::string("T4 M6\nM30\n%_N_TOA_INI\n$TC_DP3[3,1]=80\nM17\n")}});
  EXPECT_EQ(run.outcome().status, runtime::Status::Setup);
}

}  // namespace
}  // namespace g31::sinumerik_library_test

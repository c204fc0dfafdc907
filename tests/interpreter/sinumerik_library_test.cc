// Files of the SINUMERIK: names, archives, definition files, characters.

#include <map>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/session.h"
#include "tests/support/recording_machine.h"

namespace g31 {
namespace {

using runtime::Cell;
using runtime::ShownValue;
using sinumerik::ProgramLibrary;

/// Files of one folder, "lib", beside a main file.
class Files final : public source::FileSystem {
 public:
  explicit Files(std::map<std::string, std::string> files) : files_(std::move(files)) {}
  std::optional<std::string> read(const std::string& path) override {
    ++reads_;
    const auto found = files_.find(path);
    return found != files_.end() ? std::optional(found->second) : std::nullopt;
  }
  std::vector<std::string> list(const std::string& folder) override {
    std::vector<std::string> names;
    for (const auto& [path, text] : files_) {
      if (path.starts_with(folder + "/")) {
        names.push_back(path.substr(folder.size() + 1));
      }
    }
    return names;
  }
  [[nodiscard]] int reads() const { return reads_; }

 private:
  std::map<std::string, std::string> files_;
  int reads_ = 0;
};

/// A run of "main.mpf" with the folder "lib".
class ProgramRun {
 public:
  explicit ProgramRun(std::map<std::string, std::string> files)
      : files_(std::move(files)), library_(files_) {
    library_.add_file("main.mpf");
    library_.add_folder("lib");
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
  [[nodiscard]] const Files& files() const { return files_; }

 private:
  Files files_;
  ProgramLibrary library_;
  testing::RecordingMachine machine_;
  runtime::Observer observer_;
  std::unique_ptr<sinumerik::Session> session_;
  runtime::Outcome outcome_;
};

TEST(SinumerikProgramName, HasManyForms) {
  struct Case {
    const char* written;
    const char* stem;
    const char* suffix;
  };
  const Case kCases[] = {
      {"part", "PART", ""},
      {"PART.SPF", "PART", "SPF"},
      {"_N_PART_SPF", "PART", "SPF"},
      {"/_N_SPF_DIR/_N_PART_SPF", "PART", "SPF"},
      {"//NC:/SPF.DIR/Part_1.spf", "PART_1", "SPF"},
      {"MPF_1", "MPF_1", ""},
      {" L0100 ", "L0100", ""},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.written);
    EXPECT_EQ(sinumerik::program_name(c.written).stem, c.stem);
    EXPECT_EQ(sinumerik::program_name(c.written).suffix, c.suffix);
  }
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
  EXPECT_EQ(run.outcome().alarm->where.file->name(), "lib/UGUD.DEF");
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
  const source::Location where = run.outcome().alarm->where;
  EXPECT_EQ(where.file->name(), "lib/suba.spf");
  EXPECT_EQ(where.file->line_column(where.span.begin).line, 3);
  ASSERT_EQ(run.outcome().alarm->calls.size(), 1U);
  EXPECT_EQ(run.outcome().alarm->calls[0].where.file->name(), "main.mpf");
}

}  // namespace
}  // namespace g31

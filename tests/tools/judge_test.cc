// `g31 judge`: what a program printed against its plan, from files and over a pseudo-terminal.

#include <chrono>
#include <cstddef>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/played_printer.h"
#include "tests/support/run_program.h"
#include "tools/cli/judge_command.h"
#include "tools/printer/line_code.h"

namespace g31::judge_test {
namespace {

using testing::captured;
using testing::CommandOutput;
using testing::PlayedPrinter;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

struct JudgeOutput : CommandOutput {
  [[nodiscard]] nlohmann::json rows() const { return nlohmann::json::parse(out).at("measures"); }
};

JudgeOutput judged_by(const cli::JudgeOptions& options) {
  return {captured([&] { return cli::judge_command(options); })};
}

std::string plan_of(const std::string& measures) {
  return "{\"schema\": \"g31.plan/1\",\n \"measures\": [" + measures + "]}\n";
}

const char* const kPocket =
    R"({"id": "F1.X", "nominal": 40.0, "tolerance": [-0.05, 0.05]},
       {"id": "F1.Y", "nominal": 25.0, "tolerance": [-0.05, 0.05]},
       {"id": "F1.X.place", "nominal": -3.0, "tolerance": [-0.1, 0.1]})";

JudgeOutput judge(const std::string& printed, const std::string& measures = kPocket) {
  const TemporaryFolder folder;
  cli::JudgeOptions options;
  options.plan = folder.write("plan.json", plan_of(measures));
  options.results = folder.write("results.txt", printed);
  options.json = "-";
  return judged_by(options);
}

TEST(Judge, ComparesWithTheDesign) {
  const JudgeOutput output = judge("%\n; results\nF1-X 40.01200\nF1-Y  24.94000\n%\n");
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(output.errors, "");
  EXPECT_EQ(nlohmann::json::parse(output.out), nlohmann::json::parse(R"({
    "schema": "g31.judgement/1", "measures": [
      {"id": "F1.X", "nominal": 40.0, "actual": 40.012, "deviation": 0.012,
       "tolerance": [-0.05, 0.05], "verdict": "good"},
      {"id": "F1.Y", "nominal": 25.0, "actual": 24.94, "deviation": -0.06,
       "tolerance": [-0.05, 0.05], "verdict": "bad"},
      {"id": "F1.X.place", "nominal": -3.0, "actual": null, "deviation": null,
       "tolerance": [-0.1, 0.1], "verdict": "missing"}]})"));
}

const char* const kMeasure = R"({"id": "F1.X", "nominal": 40.0})";

/// The page of a judgement and what the command came to.
struct JudgedPage {
  int exit_code = 0;
  std::string html;
};

JudgedPage page_of(const std::string& printed, page::Language language,
                   const std::string& measures = kPocket) {
  const TemporaryFolder folder;
  cli::JudgeOptions options;
  options.plan = folder.write("plan.json", plan_of(measures));
  options.results = folder.write("results.txt", printed);
  options.report = folder.path("page.html");
  options.language = language;
  return {judged_by(options).exit_code, testing::text_of(options.report)};
}

int times(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Judge, ShowsItsJudgementAsAPage) {
  const JudgedPage shown =
      page_of("F1-X 40.012\nF1-Y 24.94\nF1-Y 24.94\n", page::Language::English);
  EXPECT_EQ(shown.exit_code, 1);
  for (const char* const part :
       {"Out of tolerance", "F1.Y, F1.X.place are not good.",
        "1 of 3 measures are good, 1 bad, 1 missing.",
        "F1.Y is −60.0 µm off, allowed is −50.0 µm to +50.0 µm", "F1.X.place has no value",
        "results.txt:2: F1.Y comes once more in line 3, which counts", ">40.012</td>", "+12.0 µm",
        "120 %", "g31 judge ", "id=\"results\"", "\"verdict\": \"bad\""}) {
    EXPECT_GE(times(shown.html, part), 1) << part;
  }
  EXPECT_EQ(times(shown.html, "Touches of its call"), 0) << "nobody knows its touches";
  EXPECT_EQ(times(shown.html, "<tr><th scope=\"row\" class=\"name\">"), 3);
}

TEST(Judge, APageSaysWhetherAllIsGoodOrOnlyLacking) {
  const char* const kAll = "F1-X 40.012\nF1-Y 25.01\nF1-X-PLACE -3.01\n";
  const JudgedPage good = page_of(kAll, page::Language::English);
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_EQ(times(good.html, "All measures are good."), 1);
  EXPECT_EQ(times(good.html, "No findings"), 1);
  const JudgedPage lacking = page_of("F1-X 40.012\nF1-Y 25.01\n", page::Language::English);
  EXPECT_EQ(lacking.exit_code, 1);
  EXPECT_GE(times(lacking.html, "Incomplete"), 1);
  EXPECT_EQ(times(lacking.html, "Out of tolerance"), 0);
  EXPECT_EQ(times(page_of(kAll, page::Language::Japanese).html, "すべての測定項目が合格です。"), 1);
}

// Where the nominal is not allowed itself, the middle of what is: 13 um below 40 is 7 of 10 um
// above the middle of -30 to -10, 5 um below it 15 of 10.
TEST(Judge, APageSaysHowMuchOfATolerancesZoneIsTaken) {
  const char* const kBelow = R"({"id": "F1.X", "nominal": 40.0, "tolerance": [-0.03, -0.01]})";
  EXPECT_EQ(times(page_of("F1-X 39.987\n", page::Language::English, kBelow).html, ">70 %<"), 1);
  EXPECT_EQ(times(page_of("F1-X 39.995\n", page::Language::English, kBelow).html, ">150 %<"), 1);
}

TEST(Judge, TakesTheDocumentOfARunForWhatItsProgramPrinted) {
  const JudgeOutput printed = judge(
      R"({"schema": "g31.run/1", "output": "%\nF1-X 40.5\n%\n", "files": {"LOG": "F1-X 41.0"}})",
      kMeasure);
  EXPECT_EQ(printed.errors, "");
  EXPECT_EQ(printed.rows().at(0).at("actual"), 40.5);
  const JudgeOutput written =
      judge(R"({"schema": "g31.run/1", "output": "", "files": {"RESULTS.MPF": "\nF1.X=41\n"}})",
            kMeasure);
  EXPECT_EQ(written.errors, "");
  EXPECT_EQ(written.rows().at(0).at("actual"), 41.0);
}

TEST(Judge, NamesThePlaceWithinTheDocumentOfARun) {
  const JudgeOutput output =
      judge(R"({"schema": "g31.run/1", "output": "", "files": {"LOG": "\nF9.X 1.0"}})", kMeasure);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.errors.find("results.txt: LOG:2: warning: the plan has no measure"),
            std::string::npos)
      << output.errors;
}

TEST(Judge, RefusesDocumentsThatHoldNoResults) {
  const std::pair<const char*, const char*> cases[] = {
      {R"({"schema": "g31.plan/1"})", "expected a document with \"schema\": \"g31.run/1\""},
      {R"({"schema": "g31.run/1", "output": ""})", "its program printed nothing and wrote no file"},
      {R"({"schema": "g31.run/1", "output": "", "files": {"A": "F1.X 1", "B": ""}})",
       "wrote several files: A, B; expected one file of results"},
      {R"({"schema": "g31.run/1", "output": 3, "files": 4})", "its program printed nothing"},
      {"{\n  \"schema\": ", "results.txt:2:13: no JSON from here on"}};
  for (const auto& [document, why] : cases) {
    const JudgeOutput output = judge(document, kMeasure);
    EXPECT_EQ(output.exit_code, 2) << document;
    EXPECT_NE(output.errors.find(why), std::string::npos) << output.errors;
  }
}

TEST(Judge, IsContentWhenAllAreGood) {
  const JudgeOutput output = judge("F1-X 40\nF1.Y=25.05\nF1-X-PLACE -   3.1\n");
  EXPECT_EQ(output.exit_code, 0) << output.out;
  EXPECT_EQ(output.rows()[2].at("actual"), -3.1);
  EXPECT_EQ(judge("F1-X 40. F1-Y 25. F1-X-PLACE = -3").exit_code, 0) << "one line for all";
}

TEST(Judge, PassesOverAByteOrderMark) {
  EXPECT_EQ(judge("\xEF\xBB\xBF"
                  "F1-X 40.\r\nF1-Y 25.\r\nF1-X-PLACE -3.\r\n")
                .exit_code,
            0);
}

TEST(Judge, TakesTheLimitsThemselvesAsGood) {
  const std::string measure = R"({"id": "D", "nominal": 25.0, "tolerance": [-0.1, 0.1]})";
  EXPECT_EQ(judge("D 25.10000\n", measure).exit_code, 0);
  EXPECT_EQ(judge("D 24.90000\n", measure).exit_code, 0);
  EXPECT_EQ(judge("D 25.10001\n", measure).exit_code, 1);
  EXPECT_EQ(judge("D 24.89999\n", measure).exit_code, 1);
}

TEST(Judge, WithoutAToleranceTakesEveryValue) {
  EXPECT_EQ(judge("D 999.0\n", R"({"id": "D", "nominal": 25.0})").exit_code, 0);
  EXPECT_EQ(judge("", R"({"id": "D", "nominal": 25.0})").exit_code, 1) << "but it has to come";
}

TEST(Judge, TellsWhatIsGoodForWantOfATolerance) {
  const TemporaryFolder folder;
  cli::JudgeOptions options;
  options.plan = folder.write("plan.json", plan_of(R"({"id": "D", "nominal": 25.0},
      {"id": "E", "nominal": 1.0, "tolerance": [-0.1, 0.1]})"));
  options.results = folder.write("results.txt", "D 999.0 E 1.05\n");
  const CommandOutput output = captured([&] { return cli::judge_command(options); });
  EXPECT_EQ(output.exit_code, 0) << output.out;
  EXPECT_NE(output.out.find("  -                     good (no tolerance)\n"), std::string::npos)
      << output.out;
  EXPECT_TRUE(output.out.ends_with("2 of 2 good (1 without a tolerance), 0 bad, 0 missing\n"))
      << output.out;
}

TEST(Judge, UsesThePrintedNameOfThePlan) {
  const std::string measures = R"({"id": "a_b", "printed": "A-B", "nominal": 1},
    {"id": "a-b", "printed": "A-B-2", "nominal": 2})";
  const JudgeOutput output = judge("A-B 1.5\nA-B-2 2.5\n", measures);
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_EQ(output.rows()[0].at("deviation"), 0.5);
  EXPECT_EQ(output.rows()[1].at("deviation"), 0.5);
}

TEST(Judge, NamesGarbledLinesAndNeverGuesses) {
  for (const char* const line :
       {"F1-X 40.0.0", "F1-X 4O.0", "F1-X", "F1-X nan", "F1-X inf", "F1-X 1e400", "F1-X 4e1",
        "F1-X 0x28", "F1-X 40.0 mm", "F1-X == 40.0", "F1-X 40,0", "F1-X .", "F1-X --40",
        "F1-X 99999999", "G1-X 40.0", "40.0", "F1-X \xE5\x83\x34"}) {
    SCOPED_TRACE(line);
    const JudgeOutput output = judge(fmt::format("F1-Y 25.0\n{}\nF1-X-PLACE -3.0\n", line));
    EXPECT_EQ(output.exit_code, 1);
    EXPECT_EQ(output.rows()[0].at("verdict"), "missing") << output.out;
    EXPECT_EQ(output.rows()[1].at("verdict"), "good");
    EXPECT_EQ(output.rows()[2].at("verdict"), "good");
    EXPECT_NE(output.errors.find("results.txt:2: warning: "), std::string::npos) << output.errors;
  }
}

TEST(Judge, QuotesALineWithoutItsControlCharacters) {
  const JudgeOutput output = judge("F1-X \x1B[2J40.0\n");
  EXPECT_NE(output.errors.find("not readable as names and values: \"F1-X \\x1B[2J40.0\""),
            std::string::npos)
      << output.errors;
  EXPECT_EQ(output.errors.find('\x1B'), std::string::npos);
}

TEST(Judge, CountsTheLastOfTwoLines) {
  const std::string rest = "F1-Y 25\nF1-X-PLACE -3\n";
  const JudgeOutput good = judge("F1-X 41\nF1-X 40\n" + rest);
  EXPECT_EQ(good.exit_code, 0);
  EXPECT_NE(good.errors.find("results.txt:1: warning: F1.X comes once more in line 2"),
            std::string::npos)
      << good.errors;
  const JudgeOutput garbled = judge("F1-X 40\nF1-X 4?\n" + rest);
  EXPECT_EQ(garbled.exit_code, 1);
  EXPECT_EQ(garbled.rows()[0].at("verdict"), "missing");
}

TEST(Judge, ReadsLinesHoweverTheyEnd) {
  EXPECT_EQ(judge("F1-X 40\r\nF1-Y 25\rF1-X-PLACE -3").exit_code, 0);
  EXPECT_EQ(judge("\x12"
                  "F1-X 40\nF1-Y 25\nF1-X-PLACE -3\n\x14")
                .exit_code,
            0);
  EXPECT_EQ(judge(std::string(2, '\0') + "F1-X 40\nF1-Y 25\nF1-X-PLACE -3\n").exit_code, 0);
}

/// As a control sends it: ISO code, even parity in bit 8.
std::string in_iso_code(const std::string& text) {
  constexpr auto kIso = runtime::PrintCode::Iso;
  return printer::encoded(text, kIso, {"", 19200, printer::Parity::None, 8, 1}).value();
}

TEST(Judge, DecodesIsoCode) {
  const std::string printed = "F1-X 40.012\nF1-Y 25.000\nF1-X-PLACE -3.0\n";
  std::string iso = in_iso_code(printed);
  ASSERT_NE(iso, printed);
  EXPECT_EQ(judge(iso).exit_code, 0);
  const std::size_t digit = printed.find("12");
  iso[digit] = static_cast<char>(iso[digit] ^ 1);
  const JudgeOutput output = judge(iso);
  EXPECT_EQ(output.rows()[0].at("verdict"), "missing") << "one bit is wrong";
  EXPECT_EQ(output.rows()[1].at("verdict"), "good");
}

#define PLAN(measures) "{\"schema\": \"g31.plan/1\", \"measures\": " measures "}"
TEST(Judge, RefusesWrongPlansAtTheirPlace) {
  const struct {
    const char* text;
    const char* message;
  } kCases[] = {{"", "plan.json:1:1: no JSON"},
                {"{\n \"a\": [1,\n", "plan.json:3:1: no"},
                {"[]", "expected a document with"},
                {"{\"schema\": \"g31.run/1\"}", "\"g31.plan/1\""},
                {PLAN("5"), "measures: expected a list"},
                {PLAN("[]"), "measures: expected a list of 1 to 100000"},
                {PLAN("[5]"), "measures[0]: expected an object"},
                {PLAN("[{\"nominal\": 1}]"), "measures[0]: id: expected 1 to 64"},
                {PLAN("[{\"id\": \"D\", \"printed\": 7, \"nominal\": 1}]"),
                 "measures[0]: printed: expected 1 to 64"},
                {PLAN("[{\"id\": \"A B\", \"nominal\": 1}]"), "measures[0]: id: "},
                {PLAN("[{\"id\": \"A\"}]"), "measures[0]: nominal: expected a length"},
                {PLAN("[{\"id\": \"A\", \"nominal\": 1e7}]"), "measures[0]: nominal: "},
                {PLAN("[{\"id\": \"A\", \"nominal\": 1e400}]"), "number that is too large"},
                {PLAN("[{\"id\": \"A\", \"nominal\": 1, \"tolerance\": [0.1, -0.1]}]"),
                 "measures[0]: tolerance: expected [lower, upper]"},
                {PLAN("[{\"id\": \"A\", \"nominal\": 1}, {\"id\": \"A\", \"nominal\": 1}]"),
                 "measures[1]: A: another measure"},
                {PLAN("[{\"id\": \"A.B\", \"nominal\": 1}, {\"id\": \"A_B\", \"nominal\": 1}]"),
                 "measures[1]: A_B: another measure"}};
  for (const auto& wrong : kCases) {
    SCOPED_TRACE(wrong.text);
    const TemporaryFolder folder;
    cli::JudgeOptions options;
    options.plan = folder.write("plan.json", wrong.text);
    options.results = folder.write("results.txt", "F1-X 40\n");
    const JudgeOutput output = judged_by(options);
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_EQ(output.out, "");
    EXPECT_NE(output.errors.find(wrong.message), std::string::npos) << output.errors;
  }
}
#undef PLAN

TEST(Judge, RefusesPlansWhoseListsNestWithoutEnd) {
  const TemporaryFolder folder;
  const std::string lists = std::string(200'000, '[') + std::string(200'000, ']');
  cli::JudgeOptions options;
  options.plan =
      folder.write("plan.json", "{\"schema\": \"g31.plan/1\", \"measures\": " + lists + "}");
  options.results = folder.write("results.txt", "F1-X 40\n");
  const JudgeOutput output = judged_by(options);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("100 deep inside one another"), std::string::npos) << output.errors;
}

TEST(Judge, SaysWhichFileCannotBeRead) {
  const TemporaryFolder folder;
  cli::JudgeOptions options;
  options.plan = folder.write("plan.json", plan_of(kPocket));
  options.results = folder.path("none.txt");
  EXPECT_EQ(judged_by(options).exit_code, 2);
  options.results = folder.path("");
  EXPECT_EQ(judged_by(options).exit_code, 2) << "a folder";
  options.results = "/dev/none,19200,e,7,2";
  EXPECT_EQ(judged_by(options).exit_code, 2);
  options.results = "/dev/none,19200,x,7,2";
  EXPECT_EQ(judged_by(options).exit_code, 2);
  options.plan = options.results = "-";
  EXPECT_EQ(judged_by(options).exit_code, 2);
}

void say(const PlayedPrinter& line, const std::string& bytes) {
  for (const char c : bytes) {
    line.say(c);
  }
}

JudgeOutput judge_line(const PlayedPrinter& line, const char* settings, double wait_s) {
  const TemporaryFolder folder;
  cli::JudgeOptions options;
  options.plan = folder.write("plan.json", plan_of(kPocket));
  options.results = line.device() + settings;
  options.json = "-";
  options.wait_s = wait_s;
  return judged_by(options);
}

TEST(JudgeOverALine, EndsOnceEveryMeasureHasCome) {
  const PlayedPrinter line;
  std::thread program([&line] {
    say(line, in_iso_code("\x12"
                          "F1-X 40.012\nF1-Y 25.0"));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    say(line, in_iso_code("1\nF1-X-PLACE -3.0\n\x14"));
  });
  const auto begin = std::chrono::steady_clock::now();
  const JudgeOutput output = judge_line(line, ",19200,e,7,2", 30.0);
  program.join();
  EXPECT_EQ(output.exit_code, 0) << output.out << output.errors;
  EXPECT_EQ(output.rows()[1].at("actual"), 25.01) << "a line counts when it has ended";
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(JudgeOverALine, CallsMissingWhatSilenceLeavesOut) {
  const PlayedPrinter line;
  say(line, "F1-X 40.012\nF1-Y 25.01\n");
  const JudgeOutput output = judge_line(line, ",19200,n,8,1", 0.5);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(output.rows()[1].at("verdict"), "good");
  EXPECT_EQ(output.rows()[2].at("verdict"), "missing");
}

TEST(JudgeOverALine, ANumberThatWasCutOffDoesNotCount) {
  for (const char* const rest : {"F1-Y 25", "F1-Y 25\x14"}) {
    const PlayedPrinter line;
    say(line, std::string("F1-X 40.012\n") + rest);
    const JudgeOutput output = judge_line(line, ",19200,n,8,1", 0.5);
    EXPECT_EQ(output.exit_code, 1);
    EXPECT_EQ(output.rows()[0].at("verdict"), "good");
    EXPECT_EQ(output.rows()[1].at("verdict"), "missing");
    EXPECT_NE(output.errors.find("does not count: \"F1-Y 25\""), std::string::npos)
        << output.errors;
  }
  const PlayedPrinter line;
  say(line, "F1-X 40\nF1-Y 25\nF1-X-PLACE -3\n%\x14");
  const JudgeOutput whole = judge_line(line, ",19200,n,8,1", 30.0);
  EXPECT_EQ(whole.exit_code, 0);
  EXPECT_EQ(whole.errors, "") << "the end of a tape is no line";
}

TEST(JudgeOverALine, ReadsWhatARunPrints) {
  const TemporaryFolder folder;
  PlayedPrinter printer;
  cli::RunOptions run;
  run.programs = {folder.write("p.nc",
                               "O1\n#1=40.01234\n#2=24.94\n#3=-3.\nPOPEN\nDPRNT[F1-X*#1[35]]\n"
                               "DPRNT[F1-Y*#2[35]]\nDPRNT[F1-X-PLACE*#3[35]]\nPCLOS\nM30\n")};
  run.printer = printer.device() + ",19200,e,7,2";
  printer.start();
  const RunOutput ran = run_program(run);
  ASSERT_EQ(ran.exit_code, 0) << ran.errors;
  const PlayedPrinter line;
  say(line, printer.heard());
  const JudgeOutput output = judge_line(line, ",19200,e,7,2", 30.0);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(output.errors, "");
  const nlohmann::json rows = output.rows();
  EXPECT_EQ(rows[0].at("actual"), 40.01234);
  EXPECT_EQ(rows[1].at("verdict"), "bad");
  EXPECT_EQ(rows[2].at("actual"), -3.0);
}

}  // namespace
}  // namespace g31::judge_test

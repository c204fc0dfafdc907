// What `g31 check` writes for other programs: fixes, baselines, SARIF; and progress for people.

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/check_command.h"
#include "tools/cli/progress.h"

namespace g31::check_formats_test {
namespace {

using nlohmann::json;
using testing::TemporaryFolder;

json document_of(cli::CheckOptions options, int exit_code = 1) {
  options.format = cli::CheckOptions::Format::Json;
  const auto said = testing::captured([&] { return cli::check_command(options); });
  EXPECT_EQ(said.exit_code, exit_code) << said.out;
  return json::parse(said.out);
}

/// Where a line and a column, in characters of one byte each, are in a text.
std::size_t offset_of(const std::string& text, int line, int column) {
  std::size_t begin = 0;
  for (int i = 1; i < line; ++i) {
    begin = text.find('\n', begin) + 1;
  }
  return begin + static_cast<std::size_t>(column) - 1;
}

/// A program with the fixes of all its findings, which are on places of their own.
std::string mended(std::string text, const json& findings) {
  for (auto finding = findings.rbegin(); finding != findings.rend(); ++finding) {
    if (finding->at("fix").is_null()) {
      continue;
    }
    for (const json& edit : finding->at("fix").at("edits")) {
      const std::size_t begin = offset_of(text, edit.at("line"), edit.at("column"));
      const std::size_t end = offset_of(text, edit.at("end_line"), edit.at("end_column"));
      text.replace(begin, end - begin, edit.at("text").get<std::string>());
    }
  }
  return text;
}

TEST(CheckFixes, TakeAwayCommentsWithoutUse) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  const std::string program =
      "O1\nX1.  (g31: disable=NC005 why)\n  (g31: disable=NC004) \r\nX2. (g31: "
      "disable=NC001,NC002)\nM30\n(g31: disable=NC003)";
  options.files = {folder.write("a.nc", program)};
  const json findings = document_of(options).at("findings");
  ASSERT_EQ(findings.size(), 5U);
  EXPECT_EQ(findings[0].at("fix").at("title"), "remove the comment");
  // One of two rules may still be of use some day: nothing is certain.
  EXPECT_TRUE(findings[2].at("fix").is_null());
  EXPECT_EQ(mended(program, findings), "O1\nX1.\nX2. (g31: disable=NC001,NC002)\nM30\n");
}

TEST(CheckFixes, TurnAJumpRoundWhereItsLabelLiesTheOtherWay) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  const std::string program =
      "AGAIN: R1=R1+1\nIF R1==1 GOTOB BEHIND\nR2=1\nBEHIND:\ngotof AGAIN\nGOTOF GONE\nM30\n";
  options.files = {folder.write("A.MPF", program)};
  const json findings = document_of(options).at("findings");
  ASSERT_EQ(findings.size(), 3U);
  EXPECT_EQ(findings[0].at("fix").at("title"), "write GOTOF");
  EXPECT_TRUE(findings[2].at("fix").is_null());
  EXPECT_EQ(mended(program, findings),
            "AGAIN: R1=R1+1\nIF R1==1 GOTOF BEHIND\nR2=1\nBEHIND:\ngotoB AGAIN\nGOTOF GONE\nM30\n");
}

TEST(CheckFixes, PutPlainCharactersWhereOthersLookLikeThem) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("a.nc",
                                "O1\nG0 X\xE2\x80\x93"
                                "5.\nM30\n"),
                   folder.write("A.MPF",
                                "G0 X\xE2\x88\x92"
                                "5\nM30\n")};
  const json findings = document_of(options).at("findings");
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].at("fix"), json::parse(R"j({"title": "write '-' for the dash (U+2013)",
    "edits": [{"line": 2, "column": 5, "end_line": 2, "end_column": 6, "text": "-"}]
})j"));
  EXPECT_EQ(findings[1].at("fix"),
            json::parse(R"j({"title": "write '-' for the minus sign (U+2212)",
    "edits": [{"line": 1, "column": 5, "end_line": 1, "end_column": 6, "text": "-"}]
})j"));
}

TEST(CheckBaseline, LeavesOutEarlierFindingsWhereverTheirLineIsNow) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("a.nc", "O1\nG65 P71\nGOTO 7\nM30\n")};
  options.json = folder.path("known.json");
  (void)testing::captured([&] { return cli::check_command(options); });
  options.json = "";
  options.baseline = folder.path("known.json");
  EXPECT_TRUE(document_of(options, 0).at("findings").empty());
  // Other lines in front; a new place of the same rule; the same line with another mistake.
  folder.write("a.nc", "O1\nX1.\nX2.\nG65 P71\nG65 P72\nGOTO 8\nM30\n");
  const json findings = document_of(options).at("findings");
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].at("line_text"), "G65 P72");
  EXPECT_EQ(findings[1].at("line_text"), "GOTO 8");
}

TEST(CheckBaseline, HasOfALongLineItsBeginning) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("a.nc", "O1\nG65 P71 (" + std::string(2000, 'A') + ")\nM30\n")};
  const json finding = document_of(options).at("findings").at(0);
  EXPECT_EQ(finding.at("line_text"), "G65 P71 (" + std::string(991, 'A'));
}

TEST(CheckBaseline, OfAnotherFileLeavesNothingOut) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("a.nc", "O1\nG65 P71\nM30\n")};
  options.baseline = folder.write("known.json", R"({"schema": "g31.check/1", "findings": [
    {"rule": "NC005", "file": "b.nc", "line_text": "G65 P71"}]})");
  EXPECT_EQ(document_of(options).at("findings").size(), 1U);
}

TEST(CheckBaseline, ThatIsNoneIsRefused) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("a.nc", "O1\nM30\n")};
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"{", "is no document g31.check/1"},
      {"[]", "is no document g31.check/1"},
      {R"({"schema": "g31.run/1"})", "is no document g31.check/1"},
      {R"({"schema": "g31.check/1", "findings": [{"rule": "NC005", "file": "a.nc"}]})",
       "finding 1 has no text `line_text`"},
      {R"({"schema": "g31.check/1", "findings": [7]})", "finding 1 has no text `rule`"}};
  for (const auto& [text, message] : wrong) {
    options.baseline = folder.write("known.json", text);
    const auto said = testing::captured([&] { return cli::check_command(options); });
    EXPECT_EQ(said.exit_code, 2) << text;
    EXPECT_NE(said.errors.find(message), said.errors.npos) << said.errors;
    EXPECT_EQ(said.out, "");
  }
  options.baseline = folder.path("gone.json");
  EXPECT_EQ(testing::captured([&] { return cli::check_command(options); }).exit_code, 2);
}

// The members that the schema of SARIF 2.1.0 requires, and those that code hosts read.
TEST(CheckSarif, HasTheShapeOfTheStandard) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("a b:c.nc", "O1\nG65 P71\nX1. (g31: disable=NC004)\nM30\n")};
  options.format = cli::CheckOptions::Format::Sarif;
  options.version = "1.2.3";
  const auto said = testing::captured([&] { return cli::check_command(options); });
  EXPECT_EQ(said.exit_code, 1);
  const json log = json::parse(said.out);
  EXPECT_EQ(log.at("version"), "2.1.0");
  ASSERT_EQ(log.at("runs").size(), 1U);
  const json& run = log.at("runs")[0];
  EXPECT_EQ(run.at("columnKind"), "unicodeCodePoints");
  const json& driver = run.at("tool").at("driver");
  EXPECT_EQ(driver.at("name"), "g31");
  EXPECT_EQ(driver.at("version"), "1.2.3");
  ASSERT_EQ(run.at("results").size(), 2U);
  for (const json& result : run.at("results")) {
    const json& rule = driver.at("rules").at(result.at("ruleIndex").get<std::size_t>());
    EXPECT_EQ(rule.at("id"), result.at("ruleId"));
    EXPECT_EQ(rule.at("defaultConfiguration").at("level"), result.at("level"));
    EXPECT_FALSE(result.at("message").at("text").get<std::string>().empty());
    const json& place = result.at("locations").at(0).at("physicalLocation");
    const std::string uri = place.at("artifactLocation").at("uri");
    EXPECT_TRUE(uri.starts_with("file:///")) << uri;
    EXPECT_TRUE(uri.ends_with("/a%20b%3Ac.nc")) << uri;
    EXPECT_TRUE(result.at("partialFingerprints").contains("primaryLocationLineHash"));
  }
  const json& missing = run.at("results")[0];
  EXPECT_EQ(missing.at("ruleId"), "NC005");
  EXPECT_EQ(missing.at("locations")[0].at("physicalLocation").at("region"),
            json::parse(R"({"startLine": 2, "startColumn": 5, "endLine": 2, "endColumn": 8})"));
  EXPECT_FALSE(missing.contains("fixes"));
  const json& change = run.at("results")[1].at("fixes").at(0).at("artifactChanges").at(0);
  EXPECT_EQ(change.at("artifactLocation"),
            missing.at("locations")[0].at("physicalLocation").at("artifactLocation"));
  EXPECT_EQ(change.at("replacements").at(0), json::parse(R"({
    "deletedRegion": {"startLine": 3, "startColumn": 4, "endLine": 3, "endColumn": 25},
    "insertedContent": {"text": ""}})"));
}

std::vector<std::string> fingerprints_of(const std::string& program) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("a.nc", program)};
  options.format = cli::CheckOptions::Format::Sarif;
  const auto said = testing::captured([&] { return cli::check_command(options); });
  std::vector<std::string> fingerprints;
  const json log = json::parse(said.out);
  for (const json& result : log.at("runs")[0].at("results")) {
    fingerprints.push_back(result.at("partialFingerprints").at("primaryLocationLineHash"));
  }
  return fingerprints;
}

// FNV-1a of "G65P71", reckoned by hand of its definition.
TEST(CheckSarif, AFindingIsKnownAgainWhereverItsLineGoes) {
  const std::vector<std::string> twice = {"e6584dc2f496727d:1", "e6584dc2f496727d:2"};
  EXPECT_EQ(fingerprints_of("O1\nG65 P71\nG65 P71\nM30\n"), twice);
  EXPECT_EQ(fingerprints_of("O1\nX1.\n\n  G65P71\nY2.\nG65 P 71\nM30\n"), twice);
}

TEST(CheckFormats, TwoDocumentsDoNotShareStandardOutput) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write("a.nc", "O1\nM30\n")};
  options.json = "-";
  options.format = cli::CheckOptions::Format::Sarif;
  const auto said = testing::captured([&] { return cli::check_command(options); });
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_EQ(said.out, "");
  EXPECT_NE(said.errors.find("--json and --format cannot both be standard output"),
            std::string::npos);
}

TEST(CheckRules, AreADocument) {
  cli::CheckOptions options;
  options.lists_rules = true;
  options.json = "-";
  const auto said = testing::captured([&] { return cli::check_command(options); });
  const json document = json::parse(said.out);
  EXPECT_EQ(document.at("schema"), "g31.check/1");
  EXPECT_TRUE(document.at("findings").empty());
  EXPECT_EQ(document.at("rules").at(0).at("rule"), "NC001");
  EXPECT_EQ(document.at("rules").at(0).at("level"), "error");
}

TEST(Progress, ShowsOnceWorkHasTakenASecond) {
  const auto said = testing::captured([] {
    cli::Progress progress(4, "files", true);
    progress.one_done();
    std::this_thread::sleep_for(std::chrono::milliseconds(1050));
    progress.one_done();
    return cli::ExitCode::Completed;
  });
  EXPECT_EQ(said.out, "");
  EXPECT_TRUE(
      said.errors.starts_with("\r[####################....................] 2 of 4 files, "))
      << said.errors;
  EXPECT_TRUE(said.errors.ends_with(" s left\033[K\r\033[K")) << said.errors;
  const auto silent = testing::captured([] {
    cli::Progress progress(2, "files", false);
    std::this_thread::sleep_for(std::chrono::milliseconds(1050));
    progress.one_done();
    return cli::ExitCode::Completed;
  });
  EXPECT_EQ(silent.errors, "");
}

// Comments of old programs are in Shift-JIS; a document has them as people read them.
TEST(CheckFormats, LinesOfShiftJisAreReadableAndTheirColumnsCountCharacters) {
  const testing::TemporaryFolder folder;
  const std::string file = folder.write("jis.nc", "O1\n(\x91\xAA\x92\xE8) #1=1/0\nM30\n");
  const auto output = testing::g31({"check", file, "--json", "-"});
  const auto document = nlohmann::json::parse(output.out);
  const auto& finding = document.at("findings").at(0);
  EXPECT_EQ(finding.at("line_text"), "(測定) #1=1/0");
  EXPECT_EQ(finding.at("line"), 2);
  EXPECT_EQ(finding.at("column"), 9);
  EXPECT_EQ(finding.at("end_column"), 12);
}

}  // namespace
}  // namespace g31::check_formats_test

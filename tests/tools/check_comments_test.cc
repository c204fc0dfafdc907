// Comments in programs that disable findings of `g31 check`, and those that leave nothing out.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/check_command.h"
#include "tools/session/message_comments.h"

namespace g31::check_comments_test {
namespace {

using nlohmann::json;
using testing::TemporaryFolder;

/// The findings of one program as "line RULE", in their order.
std::vector<std::string> found_in(const std::string& name, const std::string& program,
                                  const std::vector<std::string>& disabled = {}) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {folder.write(name, program)};
  options.disabled = disabled;
  options.format = cli::CheckOptions::Format::Json;
  const auto said = testing::captured([&] { return cli::check_command(options); });
  std::vector<std::string> found;
  const json document = json::parse(said.out);
  for (const json& finding : document.at("findings")) {
    found.push_back(std::to_string(finding.at("line").get<int>()) + " " +
                    finding.at("rule").get<std::string>());
  }
  EXPECT_EQ(said.exit_code, found.empty() ? 0 : 1);
  return found;
}

using Found = std::vector<std::string>;

TEST(CheckComments, HoldForTheirOwnLine) {
  EXPECT_EQ(found_in("a.nc", "O1\nG65 P71 (g31: disable=NC005 of the machine)\nG65 P72\nM30\n"),
            (Found{"3 NC005"}));
  EXPECT_EQ(found_in("A.MPF", "NOPE1 ; g31: disable=NC005 of the machine\nNOPE2\nM30\n"),
            (Found{"2 NC005"}));
}

TEST(CheckComments, AloneOnALineHoldForTheNext) {
  EXPECT_EQ(found_in("a.nc", "O1\nX1.\n(g31: disable=NC005)\n\nG65 P71\nG65 P72\nM30\n"),
            (Found{"6 NC005"}));
  EXPECT_EQ(found_in("A.MPF", "R1=1\n; g31: disable=NC005\nNOPE1\nNOPE2\nM30\n"),
            (Found{"4 NC005"}));
  EXPECT_EQ(found_in("A.MPF", "R1=1\r; g31: disable=NC005\rNOPE1\rNOPE2\rM30\r"),
            (Found{"4 NC005"}));
}

TEST(CheckComments, BeforeTheFirstBlockHoldForTheFile) {
  EXPECT_EQ(found_in("a.nc",
                     "%\nO1 (PART)\n(g31: disable=NC005)\nG65 P71\nG65 P72\nM30\nO2\nG65 "
                     "P73\nM99\n"),
            Found{});
  EXPECT_EQ(found_in("A.MPF", "; g31: disable=NC005\nNOPE1\nNOPE2\nM30\n"), Found{});
}

TEST(CheckComments, MayNameSeveralRulesInSmallLetters) {
  EXPECT_EQ(found_in("a.nc", "O1\n(G31: DISABLE = nc005, nc004 both)\nG65 P71\nGOTO 9\nM30\n"),
            Found{});
}

TEST(CheckComments, WithoutUseAreFindings) {
  EXPECT_EQ(found_in("a.nc", "O1\nX1. (g31: disable=NC005)\nM30\n"), (Found{"2 NC010"}));
  // A finding of another line.
  EXPECT_EQ(found_in("a.nc", "O1\nX1. (g31: disable=NC005)\nG65 P71\nM30\n"),
            (Found{"2 NC010", "3 NC005"}));
  EXPECT_EQ(found_in("a.nc", "O1\nX1.\n(g31: disable=)\nM30\n"), (Found{"3 NC010"}));
  // One of two is used.
  EXPECT_EQ(found_in("a.nc", "O1\nG65 P71 (g31: disable=NC004,NC005)\nM30\n"), (Found{"2 NC010"}));
  // What runs are told is nothing to check, and no other comment is.
  EXPECT_EQ(found_in("a.nc", "O1\nX1. (g31: allow PRB301)\n(G31: SKIP)\nM30\n"), Found{});
}

TEST(CheckComments, WithoutUseMayBeDisabledThemselves) {
  EXPECT_EQ(found_in("a.nc", "O1\nX1. (g31: disable=NC005) (g31: disable=NC010)\nM30\n"), Found{});
  EXPECT_EQ(found_in("a.nc", "O1\nX1. (g31: disable=NC010)\nM30\n"), (Found{"2 NC010"}));
  EXPECT_EQ(found_in("a.nc", "O1\nX1. (g31: disable=NC005)\nM30\n", {"nc010"}), Found{});
  // What the command line leaves out all the same has its use.
  EXPECT_EQ(found_in("a.nc", "O1\nG65 P71 (g31: disable=NC005)\nM30\n", {"NC005"}), Found{});
}

TEST(CheckComments, AnUnknownRuleIsToldWithTheNearestOne) {
  const TemporaryFolder folder;
  cli::CheckOptions options;
  options.files = {
      folder.write("a.nc", "O1\nX1. (g31: disable=NC05)\nX2. (g31: disable=PRB301)\nM30\n")};
  const auto said = testing::captured([&] { return cli::check_command(options); });
  EXPECT_NE(said.out.find("NC05 is no rule, did you mean NC005?"), said.out.npos) << said.out;
  EXPECT_NE(said.out.find("PRB301 is a message of g31 run"), said.out.npos) << said.out;
  options.disabled = {"PRB301"};
  EXPECT_EQ(testing::captured([&] { return cli::check_command(options); }).exit_code, 2);
}

TEST(MessageComments, SayCodesReasonAndLines) {
  using session::CommentForm;
  using session::MessageComment;
  const std::string text =
      "O1\nX1. (g31: allow PRB301, PRB316 PRB317 as meant) (g31: disable=x)\r\n";
  const auto all = session::message_comments(text, CommentForm::Parentheses);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0].code, "PRB301");
  EXPECT_EQ(all[1].code, "PRB316");
  EXPECT_EQ(all[2].code, "PRB317");
  EXPECT_EQ(all[2].reason, "as meant");
  EXPECT_EQ(all[2].column, 5);
  EXPECT_EQ(text.substr(all[2].begin, all[2].length),
            "(g31: allow PRB301, PRB316 PRB317 as meant)");
  EXPECT_EQ(all[3].verb, MessageComment::Verb::Disable);
  EXPECT_EQ(all[3].code, "");
  EXPECT_EQ(all[3].named, "x");
  EXPECT_EQ(all[3].text.back(), ')');
  EXPECT_EQ(all[3].first_line, 2);
  EXPECT_EQ(all[3].last_line, 2);
  // In a text of SINUMERIK it is no comment.
  const auto quoted =
      session::message_comments("MSG(\"; g31: allow PRB301\")\n", CommentForm::Semicolon);
  EXPECT_TRUE(quoted.empty());
}

TEST(MessageComments, OfALineTheFirstTwentyCount) {
  std::string line = "O1\nX1.";
  for (int i = 0; i < 100; ++i) {
    line += "(g31: allow PRB301)";
  }
  const auto all = session::message_comments(line, session::CommentForm::Parentheses);
  ASSERT_EQ(all.size(), 20U);
  EXPECT_EQ(all[19].column, 4 + 19 * 19);
  EXPECT_EQ(all[19].text, "");  // longer than 1,000 bytes
}

}  // namespace
}  // namespace g31::check_comments_test

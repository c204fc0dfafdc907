// The document of another run, which a page shows beside its own.

#include "tools/page/other_run.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace g31::other_run_test {
namespace {

std::string document(const std::string& moves, const std::string& touches) {
  return R"({"schema": "g31.run/1", "variables": {"#1": 2.5, "#2": null}, "moves": [)" + moves +
         R"(], "touches": [)" + touches + R"(], "counts": [{"file": "a.nc", "lines": {"1": 1}}]})";
}

constexpr const char* kMove = R"({"g": 1, "to": [1, 2, 3]})";
constexpr const char* kTouch =
    R"({"latched": [1, 2, 3, 0, 90, 0], "contact": null, "normal": null})";

TEST(OtherRun, TellsVariablesAndWaysAndLeavesLinesOut) {
  const auto other =
      page::other_run(document(std::string(kMove) + R"(, {"g": 0, "to": [1, 2, 7]})", kTouch), {});
  ASSERT_TRUE(other.ok());
  EXPECT_EQ(other.value().variables.size(), 1U);
  EXPECT_EQ(other.value().variables.at("#1"), 2.5);
  EXPECT_FALSE(other.value().has_times);
  const nlohmann::json told = nlohmann::json::parse(other.value().figures);
  EXPECT_EQ(told.at("figures").at("ways").size(), 1U);
  EXPECT_EQ(told.at("figures").at("ways").at(0).at("kind"), "rapid");
  EXPECT_EQ(told.at("document").at("moves").size(), 2U);
  EXPECT_FALSE(told.at("document").contains("counts"));
}

TEST(OtherRun, OfValuesOfWrongKindsIsRefusedByThePlaceOfTheFirst) {
  struct Case {
    std::string moves, touches, place;
  };
  const std::vector<Case> cases = {
      {"null", kTouch, "moves[0] is"},
      {std::string(kMove) + R"(, {"g": 1, "to": [1]})", kTouch, "moves[1].to is"},
      {R"({"g": 1, "to": "abc"})", kTouch, "moves[0].to is"},
      {R"({"g": 1, "to": [1, 2, 1e308]})", kTouch, "moves[0].to is"},
      {R"({"g": "a", "to": [1, 2, 3]})", kTouch, "moves[0].g is"},
      {R"({"g": 1, "to": [1, 2, 3], "time_s": null})", kTouch, "moves[0].time_s is"},
      {kMove, "7", "touches[0] is"},
      {kMove, "{}", "touches[0].latched is"},
      {kMove, R"({"latched": [1, "x", 3]})", "touches[0].latched is"},
      {kMove, R"({"latched": [1, 2, 3], "contact": [1, 2]})", "touches[0].contact is"},
      {kMove, R"({"latched": [1, 2, 3], "normal": [1, 2, 3, 4]})", "touches[0].normal is"},
  };
  for (const Case& each : cases) {
    const auto other = page::other_run(document(each.moves, each.touches), {});
    ASSERT_FALSE(other.ok()) << each.place;
    EXPECT_TRUE(other.error().starts_with(each.place)) << other.error();
  }
}

}  // namespace
}  // namespace g31::other_run_test

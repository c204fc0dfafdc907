// `g31 judge`: what a program printed against its plan, from files and over a pseudo-terminal.

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <termios.h>
#include <unistd.h>

#include "tests/support/run_program.h"
#include "tools/cli/judge_command.h"

namespace g31::judge_test {
namespace {

using testing::TemporaryFolder;

struct JudgeOutput {
  int exit_code = -1;
  std::string out;
  std::string errors;

  [[nodiscard]] nlohmann::json rows() const { return nlohmann::json::parse(out).at("measures"); }
};

JudgeOutput judged_by(const cli::JudgeOptions& options) {
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  JudgeOutput output;
  output.exit_code = static_cast<int>(cli::judge_command(options));
  output.out = ::testing::internal::GetCapturedStdout();
  output.errors = ::testing::internal::GetCapturedStderr();
  return output;
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

TEST(Judge, IsContentWhenAllAreGood) {
  const JudgeOutput output = judge("F1-X 40\nF1.Y=25.05\nF1-X-PLACE -   3.1\n");
  EXPECT_EQ(output.exit_code, 0) << output.out;
  EXPECT_EQ(output.rows()[2].at("actual"), -3.1);
  EXPECT_EQ(judge("F1-X 40. F1-Y 25. F1-X-PLACE = -3").exit_code, 0) << "one line for all";
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

TEST(Judge, UsesThePrintedNameOfThePlan) {
  const std::string measures = R"({"id": "a_b", "printed": "A-B", "nominal": 1},
    {"id": "a-b", "printed": "A-B-2", "nominal": 2})";
  const JudgeOutput output = judge("A-B 1.5\nA-B-2 2.5\n", measures);
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_EQ(output.rows()[0].at("deviation"), 0.5);
  EXPECT_EQ(output.rows()[1].at("deviation"), 0.5);
}

class GarbledLines : public ::testing::TestWithParam<const char*> {};

TEST_P(GarbledLines, AreNamedAndNeverGuessed) {
  const JudgeOutput output = judge(fmt::format("F1-Y 25.0\n{}\nF1-X-PLACE -3.0\n", GetParam()));
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(output.rows()[0].at("verdict"), "missing") << output.out;
  EXPECT_EQ(output.rows()[1].at("verdict"), "good");
  EXPECT_EQ(output.rows()[2].at("verdict"), "good");
  EXPECT_NE(output.errors.find("results.txt:2: warning: "), std::string::npos) << output.errors;
}

INSTANTIATE_TEST_SUITE_P(All, GarbledLines,
                         ::testing::Values("F1-X 40.0.0", "F1-X 4O.0", "F1-X", "F1-X nan",
                                           "F1-X inf", "F1-X 1e400", "F1-X 4e1", "F1-X 0x28",
                                           "F1-X 40.0 mm", "F1-X == 40.0", "F1-X 40,0", "F1-X .",
                                           "F1-X --40", "F1-X 99999999", "G1-X 40.0", "40.0",
                                           "F1-X \xE5\x83\x34"));

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

/// Even parity in bit 8, as the ISO code has it.
std::string with_parity(std::string text) {
  for (char& c : text) {
    auto ones = 0;
    for (int bit = 0; bit < 7; ++bit) {
      ones += (c >> bit) & 1;
    }
    c = static_cast<char>(ones % 2 == 0 ? c : c | '\x80');
  }
  return text;
}

TEST(Judge, DecodesIsoCode) {
  const std::string printed = "F1-X 40.012\nF1-Y 25.000\nF1-X-PLACE -3.0\n";
  std::string iso = with_parity(printed);
  ASSERT_NE(iso, printed);
  EXPECT_EQ(judge(iso).exit_code, 0);
  const std::size_t digit = printed.find("12");
  iso[digit] = static_cast<char>(iso[digit] ^ 1);
  const JudgeOutput output = judge(iso);
  EXPECT_EQ(output.rows()[0].at("verdict"), "missing") << "one bit is wrong";
  EXPECT_EQ(output.rows()[1].at("verdict"), "good");
}

class WrongPlans : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(WrongPlans, AreRefusedAtTheirPlace) {
  const TemporaryFolder folder;
  cli::JudgeOptions options;
  options.plan = folder.write("plan.json", GetParam().first);
  options.results = folder.write("results.txt", "F1-X 40\n");
  const JudgeOutput output = judged_by(options);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_EQ(output.out, "");
  EXPECT_NE(output.errors.find(GetParam().second), std::string::npos) << output.errors;
}

#define PLAN(measures) "{\"schema\": \"g31.plan/1\", \"measures\": " measures "}"
INSTANTIATE_TEST_SUITE_P(
    All, WrongPlans,
    ::testing::Values(
        std::pair("", "plan.json:1:1: no JSON"), std::pair("{\n \"a\": [1,\n", "plan.json:3:1: no"),
        std::pair("[]", "expected a document with"),
        std::pair("{\"schema\": \"g31.run/1\"}", "\"g31.plan/1\""),
        std::pair(PLAN("5"), "measures: expected a list"),
        std::pair(PLAN("[5]"), "measures[0]: expected an object"),
        std::pair(PLAN("[{\"nominal\": 1}]"), "measures[0]: id: expected 1 to 64"),
        std::pair(PLAN("[{\"id\": \"A B\", \"nominal\": 1}]"), "measures[0]: id: "),
        std::pair(PLAN("[{\"id\": \"A\"}]"), "measures[0]: nominal: expected a length"),
        std::pair(PLAN("[{\"id\": \"A\", \"nominal\": 1e7}]"), "measures[0]: nominal: "),
        std::pair(PLAN("[{\"id\": \"A\", \"nominal\": 1e400}]"), "number that is too large"),
        std::pair(PLAN("[{\"id\": \"A\", \"nominal\": 1, \"tolerance\": [0.1, -0.1]}]"),
                  "measures[0]: tolerance: expected [lower, upper]"),
        std::pair(PLAN("[{\"id\": \"A\", \"nominal\": 1}, {\"id\": \"A\", \"nominal\": 1}]"),
                  "measures[1]: A: another measure"),
        std::pair(PLAN("[{\"id\": \"A.B\", \"nominal\": 1}, {\"id\": \"A_B\", \"nominal\": 1}]"),
                  "measures[1]: A_B: another measure")));
#undef PLAN

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

/// The end of a pseudo-terminal that the program prints into.
class Line {
 public:
  Line() : far_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_EQ(::grantpt(far_) + ::unlockpt(far_), 0);
    device_ = ::ptsname(far_);
    near_ = ::open(device_.c_str(), O_RDWR | O_NOCTTY);
    termios raw = {};
    ::tcgetattr(near_, &raw);
    ::cfmakeraw(&raw);
    EXPECT_EQ(::tcsetattr(near_, TCSANOW, &raw), 0);
  }
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;
  ~Line() {
    ::close(near_);
    ::close(far_);
  }

  void send(const std::string& bytes) const {
    EXPECT_EQ(::write(far_, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  }
  [[nodiscard]] std::string settings(const char* rest) const { return device_ + rest; }

 private:
  int far_;
  int near_ = -1;
  std::string device_;
};

TEST(JudgeOverALine, EndsOnceEveryMeasureHasCome) {
  const TemporaryFolder folder;
  const Line line;
  cli::JudgeOptions options;
  options.plan = folder.write("plan.json", plan_of(kPocket));
  options.results = line.settings(",19200,e,7,2");
  options.json = "-";
  options.wait_s = 30.0;
  std::thread program([&line] {
    line.send(
        with_parity("\x12"
                    "F1-X 40.012\nF1-Y 25.0"));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    line.send(with_parity("1\nF1-X-PLACE -3.0\n\x14"));
  });
  const auto begin = std::chrono::steady_clock::now();
  const JudgeOutput output = judged_by(options);
  program.join();
  EXPECT_EQ(output.exit_code, 0) << output.out << output.errors;
  EXPECT_EQ(output.rows()[1].at("actual"), 25.01) << "a line counts when it has ended";
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST(JudgeOverALine, CallsMissingWhatSilenceLeavesOut) {
  const TemporaryFolder folder;
  const Line line;
  cli::JudgeOptions options;
  options.plan = folder.write("plan.json", plan_of(kPocket));
  options.results = line.settings(",19200,n,8,1");
  options.json = "-";
  options.wait_s = 0.5;
  line.send("F1-X 40.012\nF1-Y 25.01\n");
  const JudgeOutput output = judged_by(options);
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(output.rows()[1].at("verdict"), "good");
  EXPECT_EQ(output.rows()[2].at("verdict"), "missing");
}

}  // namespace
}  // namespace g31::judge_test

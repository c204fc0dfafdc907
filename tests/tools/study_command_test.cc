// `g31 study`: the same bytes however the work is shared out, and what becomes of runs that fail.

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tests/support/run_study.h"

namespace g31::study_command_test {
namespace {

using nlohmann::json;
using testing::run_program;
using testing::run_study;
using testing::study_document;
using testing::StudyOutput;
using testing::TemporaryFolder;

const char* const kRingStudy = "parts/library/ring_gauge/ring_study.toml";

/// A program that only computes, on the ideal machine: #1 and #2 of the sheet, and what it makes.
class SmallStudy {
 public:
  explicit SmallStudy(const std::string& program = "#101= #501*#501\n#102= #501+#502\n") {
    folder_.write("small.nc", "%\nO1\n" + program + "M30\n%\n");
    folder_.write("sheet.toml", "[variables]\n\"#501\" = 3.0\n\"#502\" = 4.0\n");
  }

  /// @param head  further lines of [study]; @param tail  tables behind it
  [[nodiscard]] cli::StudyOptions options(const std::string& head, const std::string& tail) const {
    cli::StudyOptions made;
    made.study = folder_.write("study.toml",
                               "[study]\nprogram = \"small.nc\"\n"
                               "setup = \"sheet.toml\"\n" +
                                   head + "\n" + tail);
    return made;
  }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

const char* const kSquare = "[results.square]\nvalue = \"#101\"\n";

json document_of(const StudyOutput& output) {
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_EQ(output.errors, "");
  return json::parse(output.out);
}

TEST(Study, ATableShowsSmallNumbersByTheirDigits) {
  const SmallStudy study("#101= 0.000004\n");
  cli::StudyOptions options = study.options("repeats = 2", kSquare);
  const std::string table = run_study(options).out;
  EXPECT_NE(table.find("4.0e-06"), std::string::npos) << table;
  EXPECT_NE(table.find("0.00000"), std::string::npos) << "the deviation: " << table;
}

TEST(Study, ThreadsMakeNoDifference) {
  cli::StudyOptions options;
  options.study = kRingStudy;
  options.repeats = 24;
  options.threads = 1;
  const StudyOutput one = study_document(options);
  ASSERT_EQ(one.exit_code, 0) << one.errors;
  for (const std::size_t threads : {2U, 7U}) {
    options.threads = threads;
    EXPECT_EQ(study_document(options).out, one.out) << threads;
  }
}

TEST(Study, FourShardsMergeToTheBytesOfOneRun) {
  TemporaryFolder folder;
  cli::StudyOptions options;
  options.study = kRingStudy;
  options.repeats = 10;  // not a multiple of four
  options.json = folder.path("whole.json");
  options.csv = folder.path("whole.csv");
  const StudyOutput whole = run_study(options);
  ASSERT_EQ(whole.exit_code, 0) << whole.errors;

  cli::StudyOptions merge;
  for (int i = 4; i >= 1; --i) {
    cli::StudyOptions shard = options;
    shard.csv.clear();
    shard.shard = fmt::format("{}/4", i);
    shard.json = folder.path(fmt::format("part_{}.json", i));
    shard.threads = static_cast<std::size_t>(i);
    const StudyOutput part = run_study(shard);
    ASSERT_EQ(part.exit_code, 0) << part.errors;
    EXPECT_EQ(part.out, "");
    merge.merge.push_back(shard.json);
  }
  merge.json = folder.path("merged.json");
  merge.csv = folder.path("merged.csv");
  const StudyOutput merged = run_study(merge);
  ASSERT_EQ(merged.exit_code, 0) << merged.errors;
  EXPECT_EQ(merged.out, whole.out);
  for (const char* const ending : {"json", "csv"}) {
    EXPECT_EQ(testing::text_of_file(folder.path(std::string("merged.") + ending)),
              testing::text_of_file(folder.path(std::string("whole.") + ending)));
  }
}

TEST(Study, MergeRefusesWhatIsNotTheWholeStudy) {
  const SmallStudy small;
  const auto shard = [&](const std::string& which, const std::string& head) {
    cli::StudyOptions options = small.options(head, kSquare);
    options.shard = which;
    options.json = small.folder().path("p" + which.substr(0, 1) + head.substr(head.size() - 1));
    EXPECT_EQ(run_study(options).exit_code, 0);
    return options.json;
  };
  const std::string first = shard("1/2", "repeats = 4");
  const std::string second = shard("2/2", "repeats = 4");
  const std::string other = shard("2/2", "repeats = 4\nseed = 9");
  const std::string no_json = small.folder().write("no.json", "{\"schema\": 1}");
  struct Case {
    std::vector<std::string> parts;
    const char* message;
  };
  const Case kCases[] = {
      {{first}, "run 3 of 4 is in none of the parts"},
      {{second}, "run 1 of 4 is in none of the parts"},
      {{first, second, first}, "run 1 appears twice"},
      {{first, other}, "the parts are not of the same study"},
      {{first, no_json}, "is not a shard of a study"},
      {{first, small.folder().path("absent.json")}, "cannot read the shard"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.message);
    cli::StudyOptions merge;
    merge.merge = c.parts;
    const StudyOutput output = run_study(merge);
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_NE(output.errors.find(c.message), std::string::npos) << output.errors;
  }
  cli::StudyOptions merge;
  merge.merge = {second, first};
  EXPECT_EQ(run_study(merge).exit_code, 0);
}

TEST(Study, ListsMakeEveryCombination) {
  const SmallStudy small;
  const json document = document_of(study_document(
      small.options("",
                    "[results.sum]\nvalue = \"#102\"\nexpected = 10.0\n[results.twice]\nvalue = "
                    "\"2*#101\"\n[[vary]]\nkey = \"variables.#501\"\nvalues = [1, 2, "
                    "3]\n[[vary]]\nkey = \"variables.#502\"\nvalues = [10, 20]\n")));
  ASSERT_EQ(document.at("points").size(), 6U);
  for (std::size_t i = 0; i < 6; ++i) {
    const double a = 1.0 + static_cast<double>(i / 2);
    const double b = i % 2 == 0 ? 10.0 : 20.0;
    const json& point = document.at("points").at(i);
    EXPECT_EQ(point.at("values").at("variables.#501"), fmt::format("{}", a));
    EXPECT_EQ(point.at("results").at("sum").at("mean"), a + b);
    EXPECT_EQ(point.at("results").at("sum").at("bias"), a + b - 10.0);
    EXPECT_EQ(point.at("results").at("twice").at("mean"), 2.0 * a * a);
  }
}

TEST(Study, DrawnValuesHaveTheirDistributionAndReachTheRun) {
  const SmallStudy small;
  constexpr int kRuns = 2000;
  const json document = document_of(study_document(small.options(
      "repeats = 2000\nseed = 5",
      "[results.square]\nvalue = \"#101\"\n[results.sum]\nvalue = \"#102\"\n"
      "[[vary]]\nkey = \"variables.#501\"\ndistribution = \"normal\"\nmean = 7.0\ndeviation = 0.5\n"
      "[[vary]]\nkey = \"variables.#502\"\ndistribution = \"uniform\"\nlow = -1.0\nhigh = 3.0\n")));
  double sum_a = 0.0;
  double squares_a = 0.0;
  double sum_b = 0.0;
  double squares_b = 0.0;
  double products = 0.0;
  for (const json& row : document.at("rows")) {
    const double a = row.at("drawn").at(0);
    const double b = row.at("drawn").at(1);
    EXPECT_EQ(row.at("results").at(0), a * a);
    EXPECT_EQ(row.at("results").at(1), a + b);
    EXPECT_GE(b, -1.0);
    EXPECT_LE(b, 3.0);
    sum_a += a - 7.0;
    squares_a += (a - 7.0) * (a - 7.0);
    sum_b += b - 1.0;
    squares_b += (b - 1.0) * (b - 1.0);
    products += (a - 7.0) * (b - 1.0);
  }
  // Five standard deviations of each estimate.
  EXPECT_NEAR(sum_a / kRuns, 0.0, 5.0 * 0.5 / std::sqrt(kRuns));
  EXPECT_NEAR(squares_a / kRuns, 0.25, 5.0 * 0.25 * std::sqrt(2.0 / kRuns));
  const double uniform = 4.0 / std::sqrt(12.0);
  EXPECT_NEAR(sum_b / kRuns, 0.0, 5.0 * uniform / std::sqrt(kRuns));
  EXPECT_NEAR(squares_b / kRuns, uniform * uniform, 5.0 * uniform * uniform / std::sqrt(kRuns));
  EXPECT_NEAR(products / kRuns, 0.0, 5.0 * 0.5 * uniform / std::sqrt(kRuns));
}

TEST(Study, ARunCanBeRepeatedByItsSeed) {
  TemporaryFolder folder;
  cli::StudyOptions options;
  options.study = folder.write(
      "study.toml",
      fmt::format("[study]\nprogram = \"{0}/measure_ring.nc\"\nsetup = [\"{0}/ring.toml\", "
                  "\"{0}/scattering_probe.toml\"]\nrepeats = 3\n[results.x]\nvalue = \"#164\"\n",
                  std::filesystem::absolute("parts/library/ring_gauge").string()));
  const json document = document_of(study_document(options));
  std::set<double> readings;
  for (const json& row : document.at("rows")) {
    cli::RunOptions run;
    run.programs = {"parts/library/ring_gauge/measure_ring.nc"};
    run.setups = {"parts/library/ring_gauge/ring.toml",
                  "parts/library/ring_gauge/scattering_probe.toml"};
    run.prints = {"#164"};
    run.seed = row.at("seed").get<std::uint64_t>();
    const double reading = run_program(run).document.at("variables").at("#164");
    EXPECT_EQ(row.at("results").at(0), reading);
    readings.insert(reading);
  }
  EXPECT_EQ(readings.size(), 3U);
}

TEST(Study, FailedRunsAreRowsAndStayOutOfTheStatistics) {
  // One run in about six alarms: #501 below 2 of a normal distribution 3 +- 1.
  const SmallStudy small(
      "IF [#501 LT 2] GOTO 9\n#101= #501\nGOTO 10\nN9 #3000= 7 (TOO SMALL)\nN10\n");
  cli::StudyOptions options = small.options(
      "repeats = 60", std::string(kSquare) +
                          "[[vary]]\nkey = \"variables.#501\"\ndistribution = \"normal\"\nmean = "
                          "3.0\ndeviation = 1.0\n");
  const StudyOutput output = study_document(options);
  EXPECT_EQ(output.exit_code, 3);
  const json document = json::parse(output.out);
  double sum = 0.0;
  std::size_t good = 0;
  for (const json& row : document.at("rows")) {
    const double drawn = row.at("drawn").at(0);
    const bool alarms = drawn < 2.0;
    EXPECT_EQ(row.at("status"), alarms ? "alarm" : "completed");
    EXPECT_EQ(row.at("exit"), alarms ? 3 : 0);
    EXPECT_EQ(row.at("results").at(0).is_null(), alarms);
    if (alarms) {
      EXPECT_NE(row.at("note").get<std::string>().find("TOO SMALL [3007]"), std::string::npos);
    } else {
      sum += drawn;
      ++good;
    }
  }
  ASSERT_GT(good, 30U);
  ASSERT_LT(good, 60U);
  const json& square = document.at("points").at(0).at("results").at("square");
  EXPECT_EQ(square.at("n"), good);
  EXPECT_NEAR(square.at("mean").get<double>(), sum / static_cast<double>(good), 1e-12);
  EXPECT_EQ(document.at("runs").at("alarm"), 60 - good);
  EXPECT_NE(output.errors.find(fmt::format(
                "g31: warning: {} of 60 runs ended with alarm and are left out", 60 - good)),
            std::string::npos)
      << output.errors;
}

TEST(Study, AVacantResultIsLeftOutWithAWarning) {
  const SmallStudy small("#101= #0\n");
  const StudyOutput output = run_study(small.options("repeats = 2", kSquare));
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(output.errors.find("result square is vacant or not a number in 2 of 2 runs"),
            std::string::npos);
}

TEST(Study, ProgramsBeforeLeaveTheirPermanentVariables) {
  const SmallStudy small("#101= #501\n");
  small.folder().write("before.nc", "%\nO2\n#501= #501+1\n#100= 55\nM30\n%\n");
  for (const char* const when : {"once", "each"}) {
    SCOPED_TRACE(when);
    const json document = document_of(study_document(small.options(
        fmt::format("before = [\"before.nc\", \"before.nc\"]\nbefore_when = \"{}\"\nrepeats = 3",
                    when),
        kSquare)));
    for (const json& row : document.at("rows")) {
      EXPECT_EQ(row.at("results").at(0), 5.0);
    }
  }
}

TEST(Study, AFailureBeforeEndsEveryRunOfItsSetUp) {
  const SmallStudy small;
  small.folder().write("before.nc", "%\nO2\n#3000= 5 (NO RING)\nM30\n%\n");
  const StudyOutput output =
      study_document(small.options("before = \"before.nc\"\nrepeats = 2", kSquare));
  EXPECT_EQ(output.exit_code, 3);
  const json document = json::parse(output.out);
  for (const json& row : document.at("rows")) {
    EXPECT_EQ(row.at("status"), "alarm");
    EXPECT_TRUE(row.at("note").get<std::string>().starts_with("before: "));
  }
}

TEST(Study, PartsMayBeVariedAndDrawn) {
  TemporaryFolder folder;
  cli::StudyOptions options;
  const std::string head = fmt::format(
      "[study]\nprogram = \"{0}/measure_ring.nc\"\nsetup = \"{0}/ring.toml\"\n"
      "repeats = 2\n[results.x]\nvalue = \"#164\"\n",
      std::filesystem::absolute("parts/library/ring_gauge").string());
  options.study = folder.write(
      "listed.toml", head + "[[vary]]\nkey = \"part.ring.bore\"\nvalues = [39.0, 41.0]\n");
  const json listed = document_of(study_document(options));
  EXPECT_NEAR(listed.at("points").at(0).at("results").at("x").at("mean").get<double>(), 39.0, 1e-9);
  EXPECT_NEAR(listed.at("points").at(1).at("results").at("x").at("mean").get<double>(), 41.0, 1e-9);
  options.study =
      folder.write("drawn.toml", head +
                                     "[[vary]]\nkey = \"part.ring.bore\"\ndistribution = "
                                     "\"uniform\"\nlow = 39.0\nhigh = 41.0\n");
  const json drawn = document_of(study_document(options));
  for (const json& row : drawn.at("rows")) {
    EXPECT_NEAR(row.at("results").at(0).get<double>(), row.at("drawn").at(0).get<double>(), 1e-9);
  }
  EXPECT_NE(drawn.at("rows").at(0).at("results"), drawn.at("rows").at(1).at("results"));
}

TEST(Study, TheCsvHasOneLineForEachRun) {
  const SmallStudy small;
  cli::StudyOptions options =
      small.options("repeats = 2", std::string(kSquare) +
                                       "[[vary]]\nkey = \"variables.#501\"\nvalues = [1.5, 2.0]\n"
                                       "labels = [\"a, \\\"b\\\"\", \"c\"]\n");
  options.csv = "-";
  const std::string text = run_study(options).out;
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size(); at = text.find("\r\n", at) + 2) {
    lines.push_back(text.substr(at, text.find("\r\n", at) - at));
  }
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0], "run,seed,status,exit,variables.#501,square,note");
  EXPECT_TRUE(lines[1].starts_with("1,"));
  EXPECT_TRUE(lines[1].ends_with(",completed,0,\"a, \"\"b\"\"\",2.25,")) << lines[1];
  EXPECT_TRUE(lines[4].ends_with(",completed,0,c,4,")) << lines[4];
}

}  // namespace
}  // namespace g31::study_command_test

// Tables 3 and 4 of Hirose's paper as studies.

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tests/support/run_study.h"

namespace g31::study_tables_test {
namespace {

using nlohmann::json;
using testing::run_study;
using testing::study_document;

json document_of(const cli::StudyOptions& options) {
  const auto output = study_document(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  return json::parse(output.out);
}

double number(const json& results, const std::string& name, const char* what) {
  return results.at(name).at(what).get<double>();
}

TEST(Table3, HasThePapersLayoutAndScatter) {
  cli::StudyOptions options;
  options.study = "parts/library/ring_gauge/table_3.toml";
  testing::TemporaryFolder folder;
  options.json = folder.path("table_3.json");
  const std::string table = run_study(options).out;
  for (const char* const line : {"\n1  ", "\n7  ", "\nmean  ", "\nstandard deviation  "}) {
    EXPECT_NE(table.find(line), std::string::npos) << line << table;
  }
  EXPECT_NE(table.find("Assumed:"), std::string::npos);

  const json document = json::parse(testing::text_of_file(options.json));
  ASSERT_EQ(document.at("rows").size(), 7U);
  for (const json& row : document.at("rows")) {
    const double reading = row.at("results").at(0);
    EXPECT_NEAR(reading * 1000.0, std::round(reading * 1000.0), 1e-9);
  }
  // Two triggers of 0.0007 mm, rounding by 0.001 mm; 7 readings leave a factor of 0.4 to 1.6.
  const json& results = document.at("points").at(0).at("results");
  const double expected = std::sqrt(2.0 * 0.0007 * 0.0007 + 0.001 * 0.001 / 12.0);
  EXPECT_GT(number(results, "diameter", "standard_deviation"), 0.4 * expected);
  EXPECT_LT(number(results, "diameter", "standard_deviation"), 1.6 * expected);
  EXPECT_NEAR(number(results, "diameter", "mean"), 39.996, 0.002);

  const json& published = results.at("diameter").at("published");
  const double kPaper[] = {39.997, 39.996, 39.995, 39.998, 39.996, 39.996, 39.996};
  ASSERT_EQ(published.size(), std::size(kPaper));
  for (std::size_t i = 0; i < std::size(kPaper); ++i) {
    EXPECT_EQ(published[i].at("value"), kPaper[i]);
    const double z = (kPaper[i] - number(results, "diameter", "mean")) /
                     number(results, "diameter", "standard_deviation");
    EXPECT_NEAR(published[i].at("z").get<double>(), z, 1e-9);
  }
  EXPECT_NE(table.find("\npublished  unit     value  from mean"), std::string::npos) << table;
}

TEST(Table3, ManyReadingsScatterAsTwoTriggersDo) {
  cli::StudyOptions options;
  options.study = "parts/library/ring_gauge/table_3.toml";
  options.repeats = 30;
  const json document = document_of(options);
  const json& results = document.at("points").at(0).at("results");
  const double expected = std::sqrt(2.0 * 0.0007 * 0.0007 + 0.001 * 0.001 / 12.0);
  // Of 30 readings the deviation is known to 1 / sqrt(58); four of these.
  EXPECT_NEAR(number(results, "diameter", "standard_deviation") / expected, 1.0, 0.53);
}

/// The study once, with the document in a file and the table on standard output.
struct Table4Run {
  json points;
  std::string table;
};

Table4Run run_table_4() {
  testing::TemporaryFolder folder;
  cli::StudyOptions options;
  options.study = "parts/library/hirose_specimen/table_4.toml";
  options.json = folder.path("table_4.json");
  const auto output = run_study(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  return {json::parse(testing::text_of_file(options.json)).at("points"), output.out};
}

void expect_true_sizes(const json& measured) {
  const std::map<std::string, double> kSizes = {
      {"1", 69.9774}, {"2", 59.993},   {"3", 30.0032},  {"4", 30.0596}, {"5", 7.0206},
      {"6", 19.668},  {"7R", 10.0568}, {"7L", 10.0104}, {"8", 4.9946},  {"9", 15.0034},
      {"10", 24.97},  {"11", 25.0146}, {"12", 25.0102},
  };
  ASSERT_EQ(measured.size(), kSizes.size());
  for (const auto& [place, size] : kSizes) {
    SCOPED_TRACE(place);
    EXPECT_NEAR(number(measured, place, "mean"), size, 1e-9);
    EXPECT_NEAR(number(measured, place, "standard_deviation"), 0.0, 1e-12);
  }
}

TEST(Table4, ThirteenPlacesOnTwoMachines) {
  const Table4Run run = run_table_4();
  for (const char* const text :
       {"place", "size", "tolerance", "difference", "\n7R ", "\n12 ", "R 10", "0/-0.03"}) {
    EXPECT_NE(run.table.find(text), std::string::npos) << text << run.table;
  }
  const json& measured = run.points.at(1).at("results");
  expect_true_sizes(measured);

  const json& machining = run.points.at(0).at("results");
  constexpr double kTrigger = 0.002;
  const double two_touches = std::sqrt(2.0) * kTrigger;
  const double most = number(machining, "6", "standard_deviation");
  for (const auto& [place, result] : machining.items()) {
    SCOPED_TRACE(place);
    const auto deviation = result.at("standard_deviation").get<double>();
    if (place != "6") {
      EXPECT_LT(deviation, most);
      EXPECT_LT(deviation, 2.5 * two_touches);
    }
    EXPECT_GT(deviation, 0.2 * kTrigger);
    // Errors of the machine and scatter: no more than the largest difference of the paper.
    EXPECT_LT(std::fabs(result.at("mean").get<double>() - number(measured, place, "mean")), 0.016);
  }
  // Three touches 1.4 mm apart in height, prolonged to the floor 4.6 mm below the upper two.
  const double lower = (15.0034 - 10.4) / 1.4;
  const double upper = (lower - 1.0) / std::sqrt(2.0);
  const double at_floor = std::hypot(lower, upper) * kTrigger;
  const double along_edge = at_floor / std::cos(std::acos(-1.0) / 6.0) * std::sqrt(2.0);
  // Of five readings the deviation is known to 35 %.
  EXPECT_GT(most, 0.3 * along_edge);
  EXPECT_LT(most, 2.0 * along_edge);
}

}  // namespace
}  // namespace g31::study_tables_test

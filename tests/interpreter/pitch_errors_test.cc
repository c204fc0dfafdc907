// Stored pitch error compensation of a Fanuc, against the manual's example.

#include "interpreter/dialects/fanuc/state/pitch_errors.h"

#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace g31::fanuc::pitch_errors_test {
namespace {

Parameters parameters(const std::map<std::string, double>& entries) {
  return Parameters::from(entries).value();
}

/// B-63980EN/01 pp. 99 and 100: -400 to 400 mm and one interval more in steps of 50, the point
/// before the reference position is 40.
std::map<std::string, double> manual() {
  std::map<std::string, double> entries = {
      {"3620.X", 40}, {"3621.X", 33}, {"3622.X", 49}, {"3623.X", 1}, {"3624.X", 50.0}};
  const int kValues[] = {2, 1, 1, -2, 0, -1, 0, -1, 2, 1, 0, -1, -1, -2, 0, 1, 2};
  int number = 10033;
  for (const int value : kValues) {
    entries[std::to_string(number++)] = value;
  }
  return entries;
}

TEST(PitchErrors, AddUpFromTheReferencePosition) {
  const auto tables = pitch_error_tables(parameters(manual()));
  ASSERT_EQ(tables.size(), 1U);
  EXPECT_EQ(tables.front().compensated, 0);
  ASSERT_EQ(tables.front().factors.size(), 1U);
  const auto& factor = tables.front().factors.front();
  EXPECT_EQ(factor.axis, 0);
  EXPECT_EQ(factor.period, 0.0);
  const double kAmounts[] = {0, 2, 3, 4, 2, 2, 1, 1, 0, 2, 3, 3, 2, 1, -1, -1, 0, 2};  // by hand
  ASSERT_EQ(factor.points.size(), std::size(kAmounts));
  for (std::size_t i = 0; i < factor.points.size(); ++i) {
    EXPECT_NEAR(factor.points[i].first, -400.0 + 50.0 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(factor.points[i].second, 0.001 * kAmounts[i], 1e-12) << factor.points[i].first;
  }
}

TEST(PitchErrors, NeedPointsAnIntervalAndAMagnification) {
  struct Case {
    const char* name;
    double value;
    std::size_t tables;
  };
  const Case kCases[] = {{"3623.X", 3, 1},    {"3623.X", 0, 0},  {"3624.X", 0, 0},
                         {"3622.X", 32, 0},   {"3621.X", -1, 0}, {"3622.X", 1024, 0},
                         {"3622.X", 1023, 1}, {"3620.X", 0, 1},  {"3620.X", 1023, 1}};
  for (const Case& c : kCases) {
    SCOPED_TRACE(fmt::format("{} {}", c.name, c.value));
    auto entries = manual();
    entries[c.name] = c.value;
    EXPECT_EQ(pitch_error_tables(parameters(entries)).size(), c.tables);
  }
  EXPECT_TRUE(pitch_error_tables(Parameters()).empty());
}

TEST(PitchErrors, OfTwoAxesHaveTheirOwnPoints) {
  auto entries = manual();
  entries.insert({{"3620.Z", 100},
                  {"3621.Z", 101},
                  {"3622.Z", 102},
                  {"3623.Z", 5},
                  {"3624.Z", 12.5},
                  {"10101", -3},
                  {"10102", 7}});
  const auto tables = pitch_error_tables(parameters(entries));
  ASSERT_EQ(tables.size(), 2U);
  const auto& z = tables.back().factors.front().points;
  ASSERT_EQ(z.size(), 3U);
  EXPECT_EQ(tables.back().compensated, 2);
  EXPECT_EQ(z[0], std::pair(0.0, 0.0));
  EXPECT_NEAR(z[1].second, -0.015, 1e-12);
  EXPECT_NEAR(z[2].second, 0.020, 1e-12);
  EXPECT_NEAR(z[2].first, 25.0, 1e-12);
}

}  // namespace
}  // namespace g31::fanuc::pitch_errors_test

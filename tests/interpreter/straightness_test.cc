// Straightness compensation of a Fanuc, by hand.

#include "interpreter/dialects/fanuc/state/straightness.h"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace g31::fanuc::straightness_test {
namespace {

/// Points of X every 50 mm, 8 the one that ends at coordinate 0; Z is moved.
std::map<std::string, double> entries() {
  return {{"3620.X", 8},  {"3621.X", 1}, {"3622.X", 20}, {"3624.X", 50.0}, {"5711", 1},
          {"5721", 3},    {"5731", 2},   {"5732", 8},    {"5733", 9},      {"5734", 20},
          {"5761", -4.0}, {"5762", 0.0}, {"5763", 7.5},  {"5764", 12.0}};
}

TEST(Straightness, MovesAnAxisByThePlaceOfAnother) {
  const auto tables = straightness_tables(Parameters::from(entries()).value());
  ASSERT_TRUE(tables.ok());
  ASSERT_EQ(tables.value().size(), 1U);
  const machine::CompensationTable& table = tables.value().front();
  EXPECT_EQ(table.compensated, 2);
  ASSERT_EQ(table.factors.size(), 1U);
  EXPECT_EQ(table.factors[0].axis, 0);
  const std::vector<std::pair<double, double>> kByHand = {
      {-300.0, -0.004}, {0.0, 0.0}, {50.0, 0.0075}, {600.0, 0.012}};
  EXPECT_EQ(table.factors[0].points, kByHand);
}

TEST(Straightness, OfThreePairs) {
  auto given = entries();
  given.insert({{"5713", 1},
                {"5723", 2},
                {"5751", 1},
                {"5752", 1},
                {"5753", 20},
                {"5754", 20},
                {"5781", 3},
                {"5782", 9},
                {"5783", -3},
                {"5784", 9}});
  const auto tables = straightness_tables(Parameters::from(given).value());
  ASSERT_TRUE(tables.ok());
  ASSERT_EQ(tables.value().size(), 2U);
  EXPECT_EQ(tables.value()[1].compensated, 1);
  const std::vector<std::pair<double, double>> kByHand = {{-350.0, 0.003}, {600.0, -0.003}};
  EXPECT_EQ(tables.value()[1].factors[0].points, kByHand)
      << "a point that is there twice counts once";
  EXPECT_TRUE(straightness_tables(Parameters()).value().empty());
}

TEST(Straightness, WhatContradictsItselfIsAlarm5046) {
  struct Case {
    const char* name;
    double value;
    const char* says;
  };
  const Case kCases[] = {
      {"5711", 0, "parameter 5711"},  {"5711", 4, "parameter 5711"}, {"5711", 2, "has no points"},
      {"5721", 1, "parameter 5721"},  {"5721", 7, "parameter 5721"}, {"5732", 1, "parameter 5732"},
      {"5734", 21, "parameter 5734"}, {"5731", 0, "are 1 to 20"},    {"3624.X", 0, "3620 to 3624"}};
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    auto given = entries();
    given[c.name] = c.value;
    const auto tables = straightness_tables(Parameters::from(given).value());
    ASSERT_FALSE(tables.ok());
    EXPECT_EQ(tables.error().id, AlarmId::BadStraightness);
    EXPECT_NE(tables.error().detail.find(c.says), std::string::npos) << tables.error().detail;
  }
}

}  // namespace
}  // namespace g31::fanuc::straightness_test

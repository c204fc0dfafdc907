// The statistics of a study against printed tables and a second way of computing.

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "tools/study/statistics.h"
#include "tools/study/student_t.h"

namespace g31::study::study_statistics_test {
namespace {

TEST(StudentT, QuantilesAreThoseOfThePrintedTable) {
  struct Case {
    double p;
    std::size_t freedom;
    double t;
  };
  // Three decimals, as statistics books print them.
  const Case kCases[] = {
      {0.975, 1, 12.706}, {0.975, 2, 4.303},   {0.975, 4, 2.776},   {0.975, 6, 2.447},
      {0.975, 9, 2.262},  {0.975, 30, 2.042},  {0.975, 120, 1.980}, {0.95, 1, 6.314},
      {0.95, 5, 2.015},   {0.95, 10, 1.812},   {0.995, 1, 63.657},  {0.995, 6, 3.707},
      {0.995, 20, 2.845}, {0.9995, 3, 12.924}, {0.90, 7, 1.415},
  };
  for (const Case& c : kCases) {
    EXPECT_NEAR(student_t_quantile(c.p, c.freedom), c.t, 0.0005) << c.p << ", " << c.freedom;
    EXPECT_NEAR(student_t_quantile(1.0 - c.p, c.freedom), -c.t, 0.0005);
  }
  EXPECT_EQ(student_t_quantile(0.5, 4), 0.0);
}

TEST(StudentT, QuantilesOfOneTwoAndFourDegreesHaveClosedForms) {
  for (const double p : {0.5000001, 0.6, 0.9, 0.975, 0.999, 0.999999}) {
    SCOPED_TRACE(p);
    const double one = std::tan(std::numbers::pi * (p - 0.5));
    EXPECT_NEAR(student_t_quantile(p, 1) / one, 1.0, 1e-9);
    const double a = 4.0 * p * (1.0 - p);
    const double two = 2.0 * (p - 0.5) * std::sqrt(2.0 / a);
    EXPECT_NEAR(student_t_quantile(p, 2) / two, 1.0, 1e-9);
    const double q = std::cos(std::acos(std::sqrt(a)) / 3.0) / std::sqrt(a);
    EXPECT_NEAR(student_t_quantile(p, 4), 2.0 * std::sqrt(q - 1.0), 1e-6);
  }
}

// What goes beyond the numbers is left out; none of it is infinite.
TEST(Statistics, OfReadingsTooFarApartHaveNoDeviation) {
  const Summary wide = summarise(std::vector<double>{-1e200, 1e200}, 0.95, 0.0);
  EXPECT_EQ(wide.mean, 0.0);
  EXPECT_EQ(wide.max, 1e200);
  EXPECT_FALSE(wide.standard_deviation || wide.mean_confidence || wide.expanded_uncertainty);
  const Summary wider = summarise(std::vector<double>{-1.7e308, 1.7e308}, 0.95, 0.0);
  EXPECT_EQ(wider.n, 2U);
  EXPECT_FALSE(wider.mean || wider.bias || wider.standard_deviation);
}

TEST(StudentT, ManyDegreesAreTheNormalDistribution) {
  for (const double p : {0.6, 0.9, 0.975, 0.999}) {
    const double z = random_detail::normal_quantile(p);
    // Cornish-Fisher: t = z + (z^3 + z) / 4n.
    const double n = 1e6;
    EXPECT_NEAR(student_t_quantile(p, 1000000), z + (z * z * z + z) / (4.0 * n), 1e-9);
  }
}

TEST(StudentT, ProbabilityAndQuantileAreInverse) {
  for (const std::size_t freedom : {1U, 2U, 3U, 7U, 50U, 1999U}) {
    for (const double p : {1e-6, 0.01, 0.3, 0.7, 0.99}) {
      EXPECT_NEAR(student_t_probability(student_t_quantile(p, freedom), freedom) / p, 1.0, 1e-9)
          << p << ", " << freedom;
    }
  }
}

TEST(Statistics, OfTable3AreThoseOfThePaper) {
  const std::vector<double> readings = {39.997, 39.996, 39.995, 39.998, 39.996, 39.996, 39.996};
  const Summary s = summarise(readings, 0.95, 39.996);
  EXPECT_EQ(s.n, 7U);
  EXPECT_NEAR(*s.mean, 39.99629, 0.000005);
  EXPECT_NEAR(*s.standard_deviation, 0.000951, 0.0000005);
  // 2.447 is t of 6 degrees at 97.5 %.
  const double reach = 2.447 * 0.000951 / std::sqrt(7.0);
  EXPECT_NEAR(s.mean_confidence->high - *s.mean, reach, 1e-6);
  EXPECT_NEAR(*s.mean - s.mean_confidence->low, reach, 1e-6);
  EXPECT_NEAR(*s.bias, 0.00029, 0.000005);
  EXPECT_NEAR(*s.expanded_uncertainty, 2.0 * 0.000951 + 0.000286, 1e-6);
  EXPECT_EQ(*s.min, 39.995);
  EXPECT_EQ(*s.max, 39.998);
}

TEST(Statistics, AValueLiesSoManyDeviationsFromTheMean) {
  const Summary s = summarise(std::vector<double>{1.0, 2.0, 3.0}, 0.95, std::nullopt);
  EXPECT_NEAR(z_score(4.5, s).value(), 2.5, 1e-12);
  EXPECT_NEAR(z_score(1.0, s).value(), -1.0, 1e-12);
  EXPECT_EQ(z_score(1.0, summarise(std::vector<double>{2.0, 2.0}, 0.95, std::nullopt)),
            std::nullopt);
  EXPECT_EQ(z_score(1.0, summarise(std::vector<double>{2.0}, 0.95, std::nullopt)), std::nullopt);
}

TEST(Statistics, SmallScatterOnALargeValueKeepsItsDigits) {
  for (const double offset : {0.0, 40.0, -1e6, 1e9}) {
    SCOPED_TRACE(offset);
    std::vector<double> readings(5000);
    long double sum = 0.0L;
    for (std::size_t i = 0; i < readings.size(); ++i) {
      readings[i] = offset + 0.25 * std::round(1000.0 * standard_normal({7, 1}, i));
      sum += readings[i];
    }
    const long double mean = sum / static_cast<long double>(readings.size());
    long double squares = 0.0L;
    for (const double reading : readings) {
      squares += (reading - mean) * (reading - mean);
    }
    const long double deviation =
        std::sqrt(squares / static_cast<long double>(readings.size() - 1));
    const Summary s = summarise(readings, 0.95, std::nullopt);
    EXPECT_NEAR(*s.mean, static_cast<double>(mean), 1e-15 * std::fabs(offset) + 1e-12);
    EXPECT_NEAR(*s.standard_deviation / static_cast<double>(deviation), 1.0, 1e-14);
  }
}

TEST(Statistics, TheIntervalHoldsTheTrueMeanAsOftenAsItSays) {
  constexpr int kStudies = 4000;
  constexpr std::size_t kReadings = 5;
  int held = 0;
  for (int study = 0; study < kStudies; ++study) {
    std::vector<double> readings(kReadings);
    for (std::size_t i = 0; i < kReadings; ++i) {
      readings[i] = 10.0 + standard_normal({11, 2}, static_cast<std::uint64_t>(study) * 5 + i);
    }
    const Summary s = summarise(readings, 0.90, std::nullopt);
    held += s.mean_confidence->low <= 10.0 && 10.0 <= s.mean_confidence->high ? 1 : 0;
  }
  // 3600 are expected, with a standard deviation of 19.
  EXPECT_NEAR(held, 3600, 95);
}

TEST(Statistics, FewReadingsSayOnlyWhatTheyCan) {
  const Summary none = summarise({}, 0.95, 1.0);
  EXPECT_EQ(none.n, 0U);
  EXPECT_FALSE(none.mean || none.bias || none.min || none.standard_deviation);
  const std::vector<double> single = {2.5};
  const Summary one = summarise(single, 0.95, 2.0);
  EXPECT_EQ(one.mean, 2.5);
  EXPECT_EQ(one.bias, 0.5);
  EXPECT_FALSE(one.standard_deviation || one.mean_confidence || one.expanded_uncertainty);
  const std::vector<double> same = {2.5, 2.5};
  EXPECT_EQ(summarise(same, 0.95, std::nullopt).standard_deviation, 0.0);
}

}  // namespace
}  // namespace g31::study::study_statistics_test

// What errors and the middle of a circle lead to expect of its ends.

#include "probe/metrology/circle_expectation.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace g31::circle_expectation_test {
namespace {

using metrology::CircleErrors;
using metrology::CircleTurn;
using metrology::kDegree;

constexpr double kPi = std::numbers::pi;
constexpr double kRadius = 40.0;
constexpr int kSteps = 3600;  // of a turn
constexpr metrology::ReversalWindows kNoWindows = {0.0, 0.0};

/// One turn from 45 degrees on whose radius is larger by `off` of the way in rad.
struct Record {
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;

  template <typename Off>
  explicit Record(Off off) {
    for (int i = 0; i <= kSteps; ++i) {
      const double way = 2.0 * kPi * i / kSteps;
      const double radius = kRadius + off(way);
      t.push_back(1e-3 * i);
      x.push_back(radius * std::cos(way + 0.25 * kPi));
      y.push_back(radius * std::sin(way + 0.25 * kPi));
    }
  }
  [[nodiscard]] metrology::PlaneSamples samples() const { return {t, x, y}; }
  [[nodiscard]] CircleTurn turn() const {
    return {0, t.size(), 1, 0.25 * kPi, 2.0 * kPi, 2.0 * kPi / t.back()};
  }
};

CircleErrors ideal() {
  CircleErrors errors;
  errors.radius = kRadius;
  return errors;
}

double degrees_from_start(std::size_t sample) {
  return 360.0 * static_cast<double>(sample) / kSteps;
}

}  // namespace

TEST(CircleExpectation, TheMiddleLeavesAMarginOrAQuarterAtEitherEnd) {
  const Record record([](double) { return 0.0; });
  const metrology::Circle circle{{0.0, 0.0}, kRadius};
  const CircleTurn whole = record.turn();
  const CircleTurn core = metrology::core_of(record.samples(), whole, circle, 45.0 * kDegree);
  EXPECT_NEAR(degrees_from_start(core.begin), 45.0, 0.11);
  EXPECT_NEAR(degrees_from_start(core.end - 1), 315.0, 0.11);
  const CircleTurn half = metrology::core_of(record.samples(), whole, circle, 170.0 * kDegree);
  EXPECT_NEAR(degrees_from_start(half.begin), 90.0, 0.11);
  EXPECT_NEAR(degrees_from_start(half.end - 1), 270.0, 0.11);
}

TEST(CircleExpectation, TheBandIsWhatWasSeenAndFourTimesTheScatter) {
  constexpr double kForm = 0.002;
  const Record record([](double way) { return kForm * std::sin(8.0 * way); });
  const auto expected =
      metrology::expectation_of(record.samples(), {record.turn()}, ideal(), kNoWindows);
  // Half of the sizes of a sine are under sin 45 deg; 1.4826 makes that a deviation.
  const double scatter = 1.4826 * kForm * std::sqrt(0.5);
  // The 2 degrees before each of three reversals, of 270, do not count.
  const double left_out = 6.0 / 270.0;
  EXPECT_NEAR(expected.scatter, scatter, 1.5 * left_out * scatter);
  EXPECT_NEAR(expected.described.greatest, kForm + 4.0 * expected.scatter, 1e-7);
  EXPECT_NEAR(expected.described.least, -kForm - 4.0 * expected.scatter, 1e-7);
}

TEST(CircleExpectation, APathWithoutErrorsHasABandOfNearlyNothing) {
  const Record record([](double) { return 0.0; });
  const auto expected =
      metrology::expectation_of(record.samples(), {record.turn()}, ideal(), kNoWindows);
  EXPECT_NEAR(expected.described.greatest, 4e-11 * kRadius, 1e-12);
  EXPECT_NEAR(expected.described.least, -4e-11 * kRadius, 1e-12);
}

TEST(CircleExpectation, APieceGrowsToWhereItsEndsLeaveTheCircle) {
  // The first 20 degrees fall away from the circle as a tangent does, squared by the angle.
  const auto off = [](double way) {
    const double before = std::max(0.0, 20.0 * kDegree - way);
    return kRadius * (1.0 / std::cos(before) - 1.0);
  };
  const Record record(off);
  const auto middle = metrology::core_of(record.samples(), record.turn(), {{0.0, 0.0}, kRadius},
                                         metrology::kLongestLead);
  const auto expected = metrology::expectation_of(record.samples(), {middle}, ideal(), kNoWindows);
  const auto whole =
      metrology::expected_part(record.samples(), record.turn(), middle, expected, {2.0 * kPi, 0.0});
  ASSERT_TRUE(whole.has_value());
  EXPECT_NEAR(degrees_from_start(whole->begin), 20.0, 0.2);
  EXPECT_EQ(whole->end, record.t.size());
  const auto more = metrology::expected_part(record.samples(), record.turn(), middle, expected,
                                             {10.0 * kDegree, 0.0});
  ASSERT_TRUE(more.has_value());
  EXPECT_NEAR(degrees_from_start(more->begin), degrees_from_start(middle.begin) - 10.0, 0.2);
}

TEST(CircleExpectation, APieceWhoseMiddleIsOffIsNone) {
  const Record record([](double) { return 0.0; });
  const auto expected =
      metrology::expectation_of(record.samples(), {record.turn()}, ideal(), kNoWindows);
  const Record larger([](double) { return 0.1; });
  EXPECT_FALSE(metrology::expected_part(larger.samples(), larger.turn(), larger.turn(), expected,
                                        {2.0 * kPi, 0.0}));
}

}  // namespace g31::circle_expectation_test

#include "interpreter/runtime/turn_time.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

namespace g31::runtime::turn_time_test {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// The slow way: the middles of many short pieces.
double mean_of_pieces(const TurnTime& time, double from, double to) {
  constexpr int kPieces = 100'000;
  double sum = 0.0;
  for (int i = 0; i < kPieces; ++i) {
    sum += time.at(from + (to - from) * (i + 0.5) / kPieces);
  }
  return sum / kPieces;
}

TEST(TurnTime, IsTheCircumferenceOverTheSpeed) {
  const TurnTime time(100'000.0, 0.0, kNoLimit);
  EXPECT_NEAR(time.at(50.0), 3.14159265358979e-3, 1e-15);
  EXPECT_EQ(time.at(-50.0), time.at(50.0));
  EXPECT_EQ(time.at(0.0), 0.0);
}

TEST(TurnTime, StaysBetweenTheSpeeds) {
  const TurnTime time(100'000.0, 200.0, 2000.0);
  EXPECT_EQ(time.at(0.0), 1.0 / 2000.0);
  EXPECT_EQ(time.at(1000.0), 1.0 / 200.0);
  const TurnTime contradicts(100'000.0, 3000.0, 2000.0);
  EXPECT_EQ(contradicts.at(1000.0), 1.0 / 2000.0);
}

TEST(TurnTime, MeanIsThatOfManyPieces) {
  const TurnTime kTimes[] = {{100'000.0, 0.0, kNoLimit},
                             {100'000.0, 0.0, 2000.0},
                             {100'000.0, 200.0, 2000.0},
                             {100'000.0, 3000.0, 2000.0}};
  constexpr double kWays[][2] = {{50.0, 10.0},  {50.0, 0.0},   {50.0, -20.0}, {3.0, 1.0},
                                 {200.0, 90.0}, {-1.0, 200.0}, {7.0, 7.0}};
  for (const TurnTime& time : kTimes) {
    for (const auto& way : kWays) {
      const double slow = mean_of_pieces(time, way[0], way[1]);
      EXPECT_NEAR(time.mean(way[0], way[1]), slow, 1e-8 * slow) << way[0] << " to " << way[1];
    }
  }
}

TEST(TurnTime, MeanOverAnArcIsThatOfManyPieces) {
  constexpr int kPieces = 100'000;
  constexpr double kSweep = 2.5;
  const TurnTime kTimes[] = {
      {100'000.0, 0.0, kNoLimit}, {100'000.0, 0.0, 1000.0}, {100'000.0, 700.0, 900.0}};
  for (const TurnTime& time : kTimes) {
    for (const double centre : {-30.0, 0.0, 20.0}) {
      const auto x_at = [&](double share) {
        return centre + 12.0 * std::cos(kSweep * share) + 5.0 * std::sin(kSweep * share);
      };
      double slow = 0.0;
      for (int i = 0; i < kPieces; ++i) {
        slow += time.at(x_at((i + 0.5) / kPieces)) / kPieces;
      }
      EXPECT_NEAR(mean_over_arc(time, kSweep, x_at), slow, 1e-7 * slow) << centre;
    }
  }
  // A quarter of a circle about 20: x is 20 + 20 / pi in the mean.
  const double quarter = mean_over_arc(kTimes[0], std::numbers::pi / 2.0, [](double share) {
    return 20.0 + 10.0 * std::cos(share * std::numbers::pi / 2.0);
  });
  EXPECT_NEAR(quarter, 2.0 * std::numbers::pi * (20.0 + 20.0 / std::numbers::pi) / 100'000.0,
              1e-14);
}

}  // namespace
}  // namespace g31::runtime::turn_time_test

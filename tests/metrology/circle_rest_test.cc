// How much axes that start from rest or stop may be off the path that they have at speed.

#include "probe/metrology/circle_rest.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace g31::circle_rest_test {
namespace {

using metrology::CircleTurn;

constexpr double kRadius = 50.0;
constexpr double kOmega = 1.0;       // rad/s
constexpr double kPeriod = 1e-4;     // s, of samples
constexpr double kWay = 3.0;         // rad
constexpr double kTolerance = 1e-3;  // mm: a sample moves the lost time by 0.5 percent

/// A circle of samples at the angles that a motion of time has.
struct Record {
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> way;
  CircleTurn turn;

  template <typename Motion>
  Record(double duration, Motion angle_at) {
    for (double now = 0.0; now <= duration; now += kPeriod) {
      const double angle = angle_at(now);
      t.push_back(now);
      x.push_back(kRadius * std::cos(angle));
      y.push_back(kRadius * std::sin(angle));
    }
  }
  [[nodiscard]] double angle_at(std::size_t i) const { return std::atan2(y[i], x[i]); }
  /// @param begin, end  samples of the piece
  metrology::RestAllowances allowances(std::size_t begin, std::size_t end) {
    way.clear();
    for (std::size_t i = begin; i < end; ++i) {
      way.push_back(angle_at(i) - angle_at(begin));
    }
    turn = {begin, end, 1, angle_at(begin), way.back(), kOmega};
    return metrology::rest_allowances({t, x, y}, turn, way, {{0.0, 0.0}, kRadius});
  }
};

/// The angle of a loop of lag `tau` behind a command that starts at time 0 with its full speed.
double started(double now, double tau) {
  return kOmega * (now - tau * (1.0 - std::exp(-now / tau)));
}

/// Twice (v tau)^2 / 2R.
double twice_the_cut(double tau) {
  return kRadius * kOmega * kOmega * tau * tau;
}

}  // namespace

TEST(CircleRest, NothingIsAllowedAtSpeed) {
  Record record(kWay, [](double now) { return kOmega * now; });
  const auto rest = record.allowances(0, record.t.size());
  EXPECT_NEAR(rest.start, 0.0, 1e-6);
  EXPECT_NEAR(rest.stop, 0.0, 1e-6);
}

TEST(CircleRest, TheTimeThatAStartCostsIsTheLagOfTheLoop) {
  for (const double tau : {0.01, 0.02, 0.03}) {
    Record record(kWay, [tau](double now) { return started(now, tau); });
    const auto rest = record.allowances(0, record.t.size());
    EXPECT_NEAR(rest.start, twice_the_cut(tau), kTolerance) << tau;
    EXPECT_NEAR(rest.stop, 0.0, kTolerance) << tau;
  }
}

TEST(CircleRest, AStopIsAStartBackwards) {
  constexpr double kTau = 0.02;
  Record record(kWay, [](double now) { return kWay - started(kWay - now, kTau); });
  const auto rest = record.allowances(0, record.t.size());
  EXPECT_NEAR(rest.start, 0.0, kTolerance);
  EXPECT_NEAR(rest.stop, twice_the_cut(kTau), kTolerance);
}

TEST(CircleRest, APieceThatBeginsShortlyBehindItsStartIsTimedFromThere) {
  constexpr double kTau = 0.02;
  constexpr double kStandsFor = 0.5;
  Record record(kStandsFor + kWay, [](double now) {
    return now < kStandsFor ? 0.0 : started(now - kStandsFor, kTau);
  });
  std::size_t begin = 0;
  while (record.y[begin] < 0.9 * metrology::kStandstill * kRadius) {
    ++begin;
  }
  const auto rest = record.allowances(begin, record.t.size());
  // From 1e-4 rad on it counts as moving: sqrt(2 tau 1e-4 / omega) = 2 ms behind the start.
  EXPECT_NEAR(rest.start, kRadius * std::pow(kOmega * (kTau - 0.002), 2), 2.0 * kTolerance);
}

TEST(CircleRest, NoMoreIsAllowedThanAHundredthOfTheRadius) {
  constexpr double kTau = 0.15;
  Record record(kWay, [](double now) { return started(now, kTau); });
  EXPECT_NEAR(record.allowances(0, record.t.size()).start, 0.01 * kRadius, 1e-12);
}

}  // namespace g31::circle_rest_test

// Feeds that a filter behind the interpolation smooths: corners, circles and times against their
// closed forms; printed values are those of the specification of motions.

#include "machine/sim/command_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/trace_samples.h"

namespace g31::machine::command_filter_test {
namespace {

using testing::TraceSamples;

AxisPositions axes(double x, double y, double z) {
  return (AxisPositions() << x, y, z, 0, 0, 0).finished();
}

struct Smoothed {
  FeedFilter shape;
  double filter_s;
  double lag_s;
};

MachineSetup setup_of(const Smoothed& how) {
  MachineSetup setup;
  for (std::size_t i = 0; i < 3; ++i) {
    setup.axes[i].servo_gain = how.lag_s > 0.0 ? 0.06 / how.lag_s : 0.0;
    setup.axes[i].acceleration_per_s2 = 1e5;
  }
  return setup;
}

void smooth(MachiningCentre& centre, const Smoothed& how) {
  AxisData data = centre.axis_data();
  data.feed_filter = how.shape;
  data.filter_s = axes(how.filter_s, how.filter_s, how.filter_s);
  centre.set_axis_data(data);
}

constexpr double kFeed = 3000.0;  // mm/min
constexpr double kSpeed = 50.0;   // mm/s

LinearMove feed(const AxisPositions& q_M_end, BlockEnd ends = BlockEnd::PassOn) {
  return {q_M_end, Traverse::Feed, kFeed, ends};
}

struct Corner {
  double miss = 0.0;     // along the ray at 45 degrees
  double slowest = 0.0;  // mm/s
};

/// From (-50, 0) to the origin and on to (0, 50).
Corner corner_of(const Smoothed& how) {
  MachineSetup setup = setup_of(how);
  setup.q_M_start = axes(-50, 0, 0);
  MachiningCentre centre(setup, nullptr);
  smooth(centre, how);
  TraceSamples samples;
  constexpr double kPeriodS = 1e-5;
  centre.trace(kPeriodS, samples);
  EXPECT_TRUE(centre.move(feed(axes(0, 0, 0))).ok());
  EXPECT_TRUE(centre.move(feed(axes(0, 50, 0), BlockEnd::ExactStop)).ok());
  Corner corner{0.0, kSpeed};
  for (std::size_t i = 1; i < samples.list.size(); ++i) {
    const AxisPositions& q_M = samples.list[i].q_M_encoder;
    corner.miss = std::max(corner.miss, std::numbers::sqrt2 * std::min(-q_M[0], q_M[1]));
    if (samples.list[i].time_s > 0.8 && samples.list[i].time_s < 1.5) {
      corner.slowest =
          std::min(corner.slowest, (q_M - samples.list[i - 1].q_M_encoder).norm() / kPeriodS);
    }
  }
  return corner;
}

TEST(CommandFilter, CornersAreMissedByTheClosedForms) {
  struct Case {
    Smoothed how;
    double miss;
  };
  const double ray = std::numbers::sqrt2 * kSpeed;
  const double each_s = 0.064 / std::numbers::sqrt2;
  const Case kCases[] = {
      {{FeedFilter::Linear, 0.064, 0.0}, 0.5657},
      {{FeedFilter::Linear, 0.064, 0.0}, ray * 0.064 / 8.0},
      {{FeedFilter::Exponential, 0.03, 0.0}, ray * 0.03 / std::numbers::e},
      {{FeedFilter::Bell, 0.064, 0.0}, ray * each_s / 6.0},
      {{FeedFilter::Exponential, 0.0117, 1.0 / 30.0}, 0.9310},
      {{FeedFilter::Exponential, 0.064, 1.0 / 30.0}, 1.9257},
      {{FeedFilter::Linear, 0.04385, 1.0 / 30.0}, 0.9310},
      {{FeedFilter::Linear, 0.064, 1.0 / 30.0}, 1.0066},
      {{FeedFilter::Linear, 0.1, 0.02}, 1.0168},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.how.filter_s);
    const Corner corner = corner_of(c.how);
    EXPECT_NEAR(corner.miss, c.miss, 2e-4);
    EXPECT_NEAR(corner.slowest, kSpeed / std::numbers::sqrt2, 0.01);
  }
}

// A mean over T multiplies a rotation by sin(wT/2) / (wT/2), two of T / sqrt(2) by the square of
// that, a lag by 1 / sqrt(1 + (wT)^2).  To second order all are (wT)^2 / 24 but for the lag's 1/2.
TEST(CommandFilter, CirclesShrinkByTheClosedForms) {
  constexpr double kRadius = 50.0;
  constexpr double kTime = 0.1;
  const double turn = 2000.0 / 60.0 / kRadius * kTime;
  const auto mean = [](double angle) { return std::sin(angle / 2.0) / (angle / 2.0); };
  const std::pair<FeedFilter, double> kCases[] = {
      {FeedFilter::Linear, mean(turn)},
      {FeedFilter::Bell, std::pow(mean(turn / std::numbers::sqrt2), 2.0)},
      {FeedFilter::Exponential, 1.0 / std::sqrt(1.0 + turn * turn)}};
  for (const auto& [shape, share] : kCases) {
    MachineSetup setup = setup_of({shape, kTime, 0.0});
    setup.q_M_start = axes(kRadius, 0, 0);
    MachiningCentre centre(setup, nullptr);
    smooth(centre, {shape, kTime, 0.0});
    TraceSamples samples;
    centre.trace(0.01, samples);
    ArcMove circle;
    circle.q_M_end = axes(kRadius, 0, 0);
    circle.turn = Turn::Counterclockwise;
    circle.feed_mm_min = 2000.0;
    ASSERT_TRUE(centre.move(circle).ok());
    int seen = 0;
    for (const TraceSample& sample : samples.list) {
      // A lag of 0.1 s has died away to 1e-8 behind 3 s.
      if (sample.time_s > 3.0 && sample.time_s < 9.0) {
        EXPECT_NEAR(sample.q_M_encoder.head<2>().norm(), kRadius * share, 1e-7);
        ++seen;
      }
    }
    EXPECT_GT(seen, 500);
    centre.dwell(0.05);
    EXPECT_NEAR((samples.list.back().q_M_encoder - axes(kRadius, 0, 0)).norm(), 0.0, 1e-9);
  }
}

// 2 s at the feed, the filter's time, and the lag until it is within 0.01 mm: 2.194828 s.
TEST(CommandFilter, AStopWaitsForTheFilterAndTheLag) {
  const double lag_s = 1.0 / 30.0;
  const double left = kSpeed * lag_s * lag_s / 0.04385 * (1.0 - std::exp(-0.04385 / lag_s));
  const double seconds = 2.0 + 0.04385 + lag_s * std::log(left / 0.01);
  EXPECT_NEAR(seconds, 2.194828, 1e-6);
  for (const int blocks : {1, 2, 1000}) {
    const Smoothed how{FeedFilter::Linear, 0.04385, lag_s};
    MachiningCentre centre(setup_of(how), nullptr);
    smooth(centre, how);
    for (int i = 1; i <= blocks; ++i) {
      ASSERT_TRUE(centre
                      .move(feed(axes(100.0 * i / blocks, 0, 0),
                                 i == blocks ? BlockEnd::ExactStop : BlockEnd::PassOn))
                      .ok());
    }
    EXPECT_NEAR(centre.time_s(), seconds, 1e-9) << blocks;
  }
}

// 2 s at the feed, and the exponential until half an increment is left.
TEST(CommandFilter, AStopWaitsForTheLastIncrementOfAnExponential) {
  const double time_s = 0.1;
  const double left = kSpeed * time_s * (1.0 - std::exp(-2.0 / time_s));
  const double seconds = 2.0 + time_s * std::log(left / 5e-4);
  const Smoothed how{FeedFilter::Exponential, time_s, 0.0};
  MachiningCentre centre(setup_of(how), nullptr);
  smooth(centre, how);
  ASSERT_TRUE(centre.move(feed(axes(100, 0, 0), BlockEnd::ExactStop)).ok());
  EXPECT_NEAR(centre.time_s(), seconds, 1e-9);
  ASSERT_TRUE(centre.move(feed(axes(200, 0, 0), BlockEnd::ExactStop)).ok());
  EXPECT_NEAR(centre.time_s(), 2.0 * seconds, 1e-9);
}

// Without an exact stop what waits waits for the filter: a dwell, a rapid, a look at the clock.
TEST(CommandFilter, WhatComesBehindAFeedBeginsWhenItsCommandStands) {
  const Smoothed how{FeedFilter::Linear, 0.05, 0.0};
  MachiningCentre centre(setup_of(how), nullptr);
  smooth(centre, how);
  TraceSamples samples;
  centre.trace(0.001, samples);
  ASSERT_TRUE(centre.move(feed(axes(100, 0, 0))).ok());
  EXPECT_NEAR(centre.time_s(), 2.05, 1e-12);
  centre.dwell(0.5);
  EXPECT_NEAR(centre.time_s(), 2.55, 1e-12);
  EXPECT_EQ(samples.list.back().q_M_encoder, axes(100, 0, 0));
  const auto at_s = [&](double time_s) {
    return samples.list[static_cast<std::size_t>(std::lround(time_s / 0.001))].q_M_encoder[0];
  };
  // The ramp: v t^2 / 2T in, the same out.
  EXPECT_NEAR(at_s(0.02), kSpeed * 0.02 * 0.02 / 0.1, 1e-9);
  EXPECT_NEAR(at_s(1.0), kSpeed * (1.0 - 0.025), 1e-9);
  EXPECT_NEAR(at_s(2.03), 100.0 - kSpeed * 0.02 * 0.02 / 0.1, 1e-9);
}

TEST(CommandFilter, CanBeTakenAway) {
  const Smoothed how{FeedFilter::Linear, 0.2, 0.0};
  MachiningCentre centre(setup_of(how), nullptr);
  smooth(centre, how);
  ASSERT_TRUE(centre.move(feed(axes(50, 0, 0))).ok());
  smooth(centre, {FeedFilter::Linear, 0.0, 0.0});
  EXPECT_NEAR(centre.time_s(), 1.2, 1e-12);
  ASSERT_TRUE(centre.move(feed(axes(100, 0, 0))).ok());
  ASSERT_TRUE(centre.move(feed(axes(150, 0, 0))).ok());
  centre.stand_still();
  EXPECT_NEAR(centre.time_s(), 3.2 + kSpeed / 1e5, 1e-12);
}

// What is planned ahead does not pass the filter, and bends no corner.
TEST(CommandFilter, PlannedMovesDoNotPassIt) {
  const Smoothed how{FeedFilter::Bell, 0.1, 0.0};
  for (const bool has_filter : {false, true}) {
    MachiningCentre centre(setup_of(how), nullptr);
    if (has_filter) {
      smooth(centre, how);
    }
    TraceSamples samples;
    centre.trace(0.001, samples);
    for (const AxisPositions& q_M_end : {axes(20, 0, 0), axes(20, 20, 0)}) {
      LinearMove move = feed(q_M_end);
      move.contour_control = ContourControl::LookAhead;
      ASSERT_TRUE(centre.move(move).ok());
    }
    centre.stand_still();
    EXPECT_NEAR(centre.time_s(), 0.8, 0.01);
    for (const TraceSample& sample : samples.list) {
      EXPECT_NEAR(std::min(20.0 - sample.q_M_encoder[0], sample.q_M_encoder[1]), 0.0, 1e-9);
    }
  }
}

}  // namespace
}  // namespace g31::machine::command_filter_test

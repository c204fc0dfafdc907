// Sato's method on motions and works that are known.

#include "probe/metrology/two_point.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "machine/base/random.h"

namespace g31::two_point_test {
namespace {

constexpr double kBetweenA = 2.57e-3;  // mm: table 1, case I
constexpr double kBetweenB = 1.04e-3;

/// A motion and a work of 5 m in steps of 100 mm, both ends of the motion at 0.
struct Bench {
  std::size_t n = 50;
  double noise = 0.0;
  std::uint64_t seed = 1;
  double tip_b = kBetweenA;
  double tip_c = kBetweenA + kBetweenB;

  [[nodiscard]] double motion(std::size_t k) const {
    const double s = static_cast<double>(k) / static_cast<double>(n);
    return 0.12 * s * (1.0 - s) + 0.01 * std::sin(9.0 * 3.14159265358979323846 * s);
  }
  [[nodiscard]] double work(std::size_t k) const {
    const double s = static_cast<double>(k) / static_cast<double>(n);
    return 0.15 * s + 0.02 * std::cos(11.0 * s) - 0.02;
  }
  [[nodiscard]] double read(std::size_t k, std::size_t sensor, double tip) const {
    const double draw = standard_normal(Stream{seed, 2}, 3 * k + sensor);
    return 0.6 + work(k + sensor) - motion(k) + tip + noise * draw;
  }
  [[nodiscard]] std::vector<double> readings(std::size_t sensor, std::size_t spacing = 1) const {
    const double tip = sensor == 0 ? 0.0 : sensor == 1 ? tip_b : tip_c;
    std::vector<double> all;
    for (std::size_t k = 0; k <= n; k += spacing) {
      all.push_back(read(k, sensor, tip));
    }
    return all;
  }
};

TEST(TwoPoints, SeparateMotionAndWork) {
  const Bench bench;
  // Sensors 100 mm apart with steps of 100 mm, and 200 mm apart with steps of 200 mm.
  for (const std::size_t spacing : {1U, 2U}) {
    const auto shapes = metrology::separate_two_points(bench.readings(0, spacing),
                                                       bench.readings(spacing, spacing));
    EXPECT_NEAR(shapes.delta, spacing == 1 ? bench.tip_b : bench.tip_c, 1e-12);
    for (std::size_t k = 0; k < shapes.motion.size(); ++k) {
      EXPECT_NEAR(shapes.motion[k], bench.motion(spacing * k), 1e-9);
      EXPECT_NEAR(shapes.work[k], bench.work(spacing * k) - bench.work(0), 1e-9);
    }
  }
}

TEST(TwoPoints, OfThreeSensorsCloseAsInTable1) {
  struct Case {
    double delta_1;
    double delta_2;
    double printed;  // the sum in the paper's table, um
  };
  for (const Case& c : {Case{2.57, 1.04, 3.81}, Case{-0.44, -0.48, -0.94}}) {
    Bench bench;
    bench.tip_b = 1e-3 * c.delta_1;
    bench.tip_c = 1e-3 * (c.delta_1 + c.delta_2);
    for (const std::size_t n : {50U, 49U}) {
      bench.n = n;
      const auto a = bench.readings(0);
      const auto b = bench.readings(1);
      const auto third = bench.readings(2);
      const auto first = metrology::separate_two_points(a, b);
      EXPECT_NEAR(first.delta, bench.tip_b, 1e-12);
      EXPECT_NEAR(metrology::separate_two_points(b, third).delta, 1e-3 * c.delta_2, 1e-12);
      EXPECT_NEAR(metrology::tip_offset_over_two(a, third, first.motion), bench.tip_c, 1e-12);
    }
    // With readings that scatter by 1 um the sums close as well as in the paper: deltas scatter by
    // sqrt(2 / N) um over steps of L and 2 / sqrt(N) um over steps of 2 L.
    bench.n = 50;
    bench.noise = 1e-3;
    double square = 0.0;
    constexpr int kRuns = 200;
    for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
      bench.seed = seed;
      const auto a = bench.readings(0);
      const auto b = bench.readings(1);
      const auto third = bench.readings(2);
      const auto first = metrology::separate_two_points(a, b);
      const double delta_2 = metrology::separate_two_points(b, third).delta;
      const double delta = metrology::tip_offset_over_two(a, third, first.motion);
      EXPECT_NEAR(first.delta, bench.tip_b, 5.0 * 1e-3 * std::sqrt(2.0 / 50.0));
      square += std::pow(1e3 * (delta - first.delta - delta_2), 2) / kRuns;
    }
    const double printed = std::abs(c.printed - c.delta_1 - c.delta_2);  // 0.20 and 0.02
    EXPECT_LT(printed, 2.0 * std::sqrt(square));
    EXPECT_LT(std::sqrt(square), 0.5);
  }
}

TEST(TwoPoints, UncertaintiesGrowWithTheSteps) {
  for (const std::size_t n : {14U, 50U}) {
    Bench bench;
    bench.n = n;
    bench.noise = 1e-3;
    constexpr int kRuns = 2000;
    std::vector<double> motion(n + 1, 0.0);
    std::vector<double> work(n + 1, 0.0);
    for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
      bench.seed = seed;
      const auto shapes = metrology::separate_two_points(bench.readings(0), bench.readings(1));
      for (std::size_t k = 0; k <= n; ++k) {
        motion[k] += std::pow(shapes.motion[k] - bench.motion(k), 2) / kRuns;
        work[k] += std::pow(shapes.work[k] - (bench.work(k) - bench.work(0)), 2) / kRuns;
      }
    }
    // 2000 runs know a standard deviation within 1.6 percent.
    for (std::size_t k = 1; k < n; ++k) {
      EXPECT_NEAR(std::sqrt(motion[k]) / (1e-3 * metrology::motion_uncertainty(k, n)), 1.0, 0.07);
      EXPECT_NEAR(std::sqrt(work[k]) / (1e-3 * metrology::work_uncertainty(k, n)), 1.0, 0.07);
    }
    EXPECT_NEAR(metrology::motion_uncertainty(n / 2, n), std::sqrt(static_cast<double>(n) / 2.0),
                1e-12);
  }
}

// The offset is linear in the readings: each is moved by itself.
TEST(TwoPoints, TheThirdSensorsOffsetIsAsUncertainAsItsReadingsMakeIt) {
  for (const std::size_t n : {2U, 3U, 4U, 7U, 50U, 51U}) {
    std::array<std::vector<double>, 3> readings;
    readings.fill(std::vector<double>(n + 1, 0.0));
    double variance = 0.0;
    for (auto& sensor : readings) {
      for (double& reading : sensor) {
        reading = 1.0;
        const auto& [a, b, c] = readings;
        const auto motion = metrology::separate_two_points(a, b).motion;
        variance += std::pow(metrology::tip_offset_over_two(a, c, motion), 2);
        reading = 0.0;
      }
    }
    EXPECT_NEAR(metrology::tip_offset_over_two_uncertainty(n), std::sqrt(variance), 1e-12) << n;
  }
}

TEST(TwoPoints, RadiiComeFromTheDiameter) {
  // A sensor 30 mm from the axis, radii 10.004, 9.998 and 10.001 at 0, 180 and 60 degrees.
  const double gap_0 = 30.0 - 10.004;
  const double gap_180 = 30.0 - 9.998;
  const double gap_60 = 30.0 - 10.001;
  EXPECT_NEAR(metrology::radius_at(20.002, -gap_0, -gap_180, -gap_60), 10.001, 1e-12);
}

}  // namespace
}  // namespace g31::two_point_test

// The smallest zone of two circles: closed forms, and brute force over the centre.

#include "probe/metrology/minimum_zone_circle.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "machine/base/random.h"

namespace g31::metrology::minimum_zone_circle_test {
namespace {

struct Path {
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;

  [[nodiscard]] PlaneSamples samples() const { return {t, x, y}; }
  [[nodiscard]] std::vector<CircleTurn> turns() const { return {{0, x.size(), 1, 0.0, 6.28, 1.0}}; }
};

/// @param radius  by the angle from the centre, rad
Path path_of(const Eigen::Vector2d& centre, const std::function<double(double)>& radius,
             std::size_t count = 7200) {
  Path path;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    path.t.push_back(static_cast<double>(i));
    path.x.push_back(centre.x() + radius(angle) * std::cos(angle));
    path.y.push_back(centre.y() + radius(angle) * std::sin(angle));
  }
  return path;
}

double width_about(const Path& path, const Eigen::Vector2d& centre) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (std::size_t i = 0; i < path.x.size(); ++i) {
    const double distance = (path.samples().at(i) - centre).norm();
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  return most - least;
}

/// Ever finer grids of centres about the best one so far.
double by_search(const Path& path, Eigen::Vector2d centre, double reach) {
  double best = width_about(path, centre);
  for (; reach > 1e-9; reach *= 0.9) {
    Eigen::Vector2d next = centre;
    for (int i = -5; i <= 5; ++i) {
      for (int k = -5; k <= 5; ++k) {
        const Eigen::Vector2d there = centre + 0.2 * reach * Eigen::Vector2d(i, k);
        if (const double width = width_about(path, there); width < best) {
          best = width;
          next = there;
        }
      }
    }
    centre = next;
  }
  return best;
}

TEST(MinimumZoneOfACircle, OfLobesIsTheirHeight) {
  for (const int lobes : {2, 3, 4, 8}) {
    SCOPED_TRACE(lobes);
    const Path path =
        path_of({300.0, -120.0}, [&](double a) { return 50.0 + 0.004 * std::cos(lobes * a); });
    const auto zone = minimum_zone_of(path.samples(), path.turns(), {{300.002, -120.003}, 50.0});
    ASSERT_TRUE(zone);
    EXPECT_NEAR(*zone, 0.008, 1e-9);
  }
}

TEST(MinimumZoneOfACircle, OfAPerfectCircleIsNothing) {
  const Path path = path_of({0.0, 0.0}, [](double) { return 50.0; });
  const auto zone = minimum_zone_of(path.samples(), path.turns(), {{0.01, 0.02}, 50.0});
  ASSERT_TRUE(zone);
  EXPECT_NEAR(*zone, 0.0, 1e-9);
}

/// Two spikes a quarter apart, as friction makes them: the centre moves away from them.
TEST(MinimumZoneOfACircle, AgreesWithASearchForTheCentre) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE(seed);
    const auto draw = [&](std::uint64_t which) { return uniform(Stream{seed, 7}, which); };
    const auto bump = [&](double angle, double at, double height) {
      const double off = std::remainder(angle - at, 2.0 * std::numbers::pi) / 0.1;
      return height * std::exp(-off * off);
    };
    const Path path = path_of(
        {10.0, 20.0},
        [&](double a) {
          return 50.0 + bump(a, 0.3, 0.01 * draw(0)) + bump(a, 1.9, 0.01 * draw(1)) +
                 0.003 * draw(2) * std::cos(2.0 * a) + 0.002 * draw(3) * std::sin(5.0 * a);
        },
        90);
    const auto zone = minimum_zone_of(path.samples(), path.turns(), {{10.001, 20.002}, 50.0});
    ASSERT_TRUE(zone);
    EXPECT_NEAR(*zone, by_search(path, {10.0, 20.0}, 0.02), 1e-7);
    EXPECT_LE(*zone, width_about(path, {10.0, 20.0}));
  }
}

TEST(MinimumZoneOfACircle, NeedsThreePlaces) {
  const Path path = path_of(
      {0.0, 0.0}, [](double) { return 50.0; }, 2);
  EXPECT_FALSE(minimum_zone_of(path.samples(), path.turns(), {{0.0, 0.0}, 50.0}));
}

}  // namespace
}  // namespace g31::metrology::minimum_zone_circle_test

#include "machine/sim/straight_path.h"

#include <random>

#include <gtest/gtest.h>

namespace g31::machine::straight_path_test {
namespace {

AxisPositions axes(double x, double y, double z, double a = 0, double c = 0) {
  return (AxisPositions() << x, y, z, a, 0, c).finished();
}

TEST(StraightPath, LengthIsWhatTheFeedCounts) {
  struct Case {
    const char* name;
    double length;
    AxisPositions q_M_from, q_M_to;
    double mm_per_degree = 0.0;
  };
  const Case kCases[] = {
      {"one axis", 7, axes(1, 2, 3), axes(1, 2, -4)},
      {"one axis, tiny", 1e-200, axes(0, 0, 0), axes(0, 1e-200, 0)},
      {"one axis, huge", 1e200, axes(0, 0, 0), axes(0, 1e200, 0)},
      {"three axes", 7, axes(0, 0, 0), axes(2, 3, 6)},
      {"linear and rotary: mm only", 5, axes(0, 0, 0, 0), axes(3, 4, 0, 90)},
      {"rotary only: degrees", 5, axes(1, 1, 1, 0), axes(1, 1, 1, 3, -4)},
      {"rotary with rounding noise in X: degrees", 90, axes(0, 0, 0, 0), axes(1e-13, 0, 0, 90)},
      {"a degree counts as a mm", 13, axes(0, 0, 0, 0), axes(3, 4, 0, 12), 1.0},
      {"a degree counts as an inch", 127, axes(0, 0, 0), axes(76.2, 0, 0, 4), 25.4},
      {"rotary only, a degree counts as an inch", 101.6, axes(1, 0, 0), axes(1, 0, 0, -4), 25.4},
      {"linear only, degrees would count", 5, axes(1, 0, 0), axes(1, 3, 4), 25.4},
      {"nothing moves", 0, axes(1, 2, 3, 4, 5), axes(1, 2, 3, 4, 5)},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const StraightPath path(c.q_M_from, c.q_M_to, c.mm_per_degree);
    EXPECT_DOUBLE_EQ(path.length(), c.length);
    EXPECT_EQ(path.moves(), c.length > 0.0);
  }
}

TEST(StraightPath, PointsStayBetweenStartAndEnd) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-1000.0, 1000.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 100'000; ++i) {
    const AxisPositions q_M_from = AxisPositions::NullaryExpr([&] { return coordinate(random); });
    // Ends near 0 have the finest spacing of doubles: there the rounding of from + f * (to - from)
    // with f next to 1 would show.
    AxisPositions q_M_to = AxisPositions::NullaryExpr([&] { return 1e-3 * coordinate(random); });
    q_M_to[i % 6] = q_M_from[i % 6];
    const StraightPath path(q_M_from, q_M_to);
    const double fraction = i % 2 == 0 ? share(random) : 1.0 - 1e-16 * static_cast<double>(i % 7);
    const AxisPositions q_M = path.at(fraction);
    ASSERT_EQ(q_M[i % 6], q_M_from[i % 6]);
    ASSERT_TRUE((q_M.array() >= q_M_from.cwiseMin(q_M_to).array()).all());
    ASSERT_TRUE((q_M.array() <= q_M_from.cwiseMax(q_M_to).array()).all());
    ASSERT_EQ(path.at(1.0), q_M_to);
    ASSERT_EQ(path.at(0.0), q_M_from);
  }
}

}  // namespace
}  // namespace g31::machine::straight_path_test

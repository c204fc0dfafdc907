#include "machine/sim/straight_path.h"

#include <random>

#include <gtest/gtest.h>

namespace g31::machine {
namespace {

AxisPositions axes(double x, double y, double z, double a = 0, double b = 0, double c = 0) {
  return (AxisPositions() << x, y, z, a, b, c).finished();
}

TEST(StraightPath, LengthIsWhatTheFeedCounts) {
  struct Case {
    const char* name;
    AxisPositions q_M_from, q_M_to;
    double length;
  };
  const Case kCases[] = {
      {"one axis", axes(1, 2, 3), axes(1, 2, -4), 7},
      {"one axis, tiny", axes(0, 0, 0), axes(0, 1e-200, 0), 1e-200},
      {"one axis, huge", axes(0, 0, 0), axes(0, 1e200, 0), 1e200},
      {"three axes", axes(0, 0, 0), axes(2, 3, 6), 7},
      {"linear and rotary: mm only", axes(0, 0, 0, 0), axes(3, 4, 0, 90), 5},
      {"rotary only: degrees", axes(1, 1, 1, 0), axes(1, 1, 1, 3, 0, -4), 5},
      {"rotary with rounding noise in X: degrees", axes(0, 0, 0, 0), axes(1e-13, 0, 0, 90), 90},
      {"nothing moves", axes(1, 2, 3, 4, 5, 6), axes(1, 2, 3, 4, 5, 6), 0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const StraightPath path(c.q_M_from, c.q_M_to);
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
    AxisPositions q_M_to = AxisPositions::NullaryExpr([&] { return coordinate(random); });
    q_M_to[i % 6] = q_M_from[i % 6];
    const StraightPath path(q_M_from, q_M_to);
    // Close to the end, where the rounding of from + f * (to - from) could overshoot.
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
}  // namespace g31::machine

#include "machine/units/turn_from_z.h"

#include <vector>

#include <gtest/gtest.h>

#include "machine/base/random.h"

namespace g31::turn_from_z_test {
namespace {

constexpr double kRounding = 4e-16;

TEST(TurnFromZ, LeadsIntoTheDirectionByTheShortestWay) {
  std::vector<Point> directions = {Point::UnitX(),  -Point::UnitX(), Point::UnitY(),
                                   -Point::UnitY(), Point::UnitZ(),  -Point::UnitZ(),
                                   {3.0, -4.0, 0.0}};
  for (const double off : {1e-3, 1e-7, 1e-12, 1e-17, 1e-200}) {
    directions.insert(directions.end(),
                      {{off, 0.0, -1.0}, {-off, 2.0 * off, -7.0}, {0.0, off, 5.0}});
  }
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const auto draw = [&](std::uint64_t which) { return uniform({7, 0}, 3 * i + which) - 0.5; };
    directions.emplace_back(draw(0), draw(1), draw(2));
  }
  for (const Point& along : directions) {
    const Eigen::Quaterniond turn = turn_from_z(along);
    EXPECT_NEAR(turn.norm(), 1.0, kRounding) << along.transpose();
    const Point off = turn * Point::UnitZ() - along.normalized();
    EXPECT_LE(off.norm(), 2.0 * kRounding) << along.transpose();
    // Half the angle is at most a quarter of a turn, and nothing turns about Z.
    EXPECT_GE(turn.w(), 0.0) << along.transpose();
    EXPECT_EQ(turn.z(), 0.0) << along.transpose();
  }
}

TEST(TurnFromZ, StraightDownIsHalfATurnAboutX) {
  EXPECT_EQ(turn_from_z({0.0, 0.0, -12.0}).coeffs(),
            Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0).coeffs());
}

}  // namespace
}  // namespace g31::turn_from_z_test

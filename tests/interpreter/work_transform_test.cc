// Mirror, scaling and rotation against complex numbers and against their own inverses.

#include "interpreter/dialects/fanuc/state/work_transform.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

namespace g31::fanuc::work_transform_test {
namespace {

using Complex = std::complex<double>;

constexpr Plane kPlanes[] = {plane_of({17, 0}), plane_of({18, 0}), plane_of({19, 0})};

AxisPositions point(double x, double y, double z) {
  AxisPositions q = AxisPositions::Zero();
  q.head<3>() << x, y, z;
  q[3] = 15.0;
  return q;
}

Complex in_plane(const AxisPositions& q, const Plane& plane) {
  return {q[plane.first], q[plane.second]};
}

TEST(WorkTransform, ThatIsNoneKeepsEveryBit) {
  const AxisPositions q = point(0.1, -200.3, 1e-9);
  const WorkTransform none;
  EXPECT_EQ(none.apply(q), q);
  EXPECT_EQ(none.undo(q), q);
  EXPECT_TRUE(none.is_identity());
}

TEST(WorkTransform, TurnsAPlaneAsComplexNumbersTurn) {
  const AxisPositions q = point(12.5, -3.75, 8.0);
  for (const Plane& plane : kPlanes) {
    for (const double angle_deg : {30.0, 90.0, 123.4, -45.0, 350.0}) {
      const Eigen::Vector2d centre(5.0, -2.0);
      const WorkTransform map = WorkTransform::rotation(plane, centre, angle_deg);
      const Complex about(centre.x(), centre.y());
      const Complex expected = about + (in_plane(q, plane) - about) *
                                           std::polar(1.0, angle_deg * std::numbers::pi / 180.0);
      const AxisPositions turned = map.apply(q);
      EXPECT_LT(std::abs(in_plane(turned, plane) - expected), 1e-13);
      EXPECT_EQ(turned[plane.across], q[plane.across]);
      EXPECT_EQ(turned[3], q[3]);
      EXPECT_FALSE(map.reverses_turns(plane));
      EXPECT_NEAR(map.stretch(plane.first), 1.0, 1e-15);
    }
  }
}

TEST(WorkTransform, QuarterTurnsAreExact) {
  const WorkTransform map =
      WorkTransform::rotation(plane_of({17, 0}), Eigen::Vector2d(5.0, 5.0), 90.0);
  EXPECT_EQ(map.apply(point(10.0, 5.0, 1.0)), point(5.0, 10.0, 1.0));
}

TEST(WorkTransform, MirrorsOneAxis) {
  const WorkTransform map = WorkTransform::mirror(0, 10.0);
  EXPECT_EQ(map.apply(point(4.0, 1.0, 2.0)), point(16.0, 1.0, 2.0));
  EXPECT_TRUE(map.reverses_turns(plane_of({17, 0})));
  EXPECT_TRUE(map.reverses_turns(plane_of({18, 0})));
  EXPECT_FALSE(map.reverses_turns(plane_of({19, 0})));
}

TEST(WorkTransform, ScalesAboutACentreThatStays) {
  const WorkTransform map = WorkTransform::scaling({1.0, 2.0, 3.0}, {2.0, -0.5, 1.0});
  EXPECT_EQ(map.apply(point(1.0, 2.0, 3.0)), point(1.0, 2.0, 3.0));
  EXPECT_EQ(map.apply(point(4.0, 4.0, 0.0)), point(7.0, 1.0, 0.0));
  EXPECT_EQ(map.stretch(0), 2.0);
  EXPECT_EQ(map.stretch(1), 0.5);
  EXPECT_TRUE(map.reverses_turns(plane_of({17, 0})));
}

TEST(WorkTransform, TwoMirrorsOfOnePlaneTurnArcsBack) {
  const WorkTransform map = WorkTransform::mirror(0, 0.0).then(WorkTransform::mirror(1, 0.0));
  EXPECT_FALSE(map.reverses_turns(plane_of({17, 0})));
}

TEST(WorkTransform, IsUndoneByItsInverse) {
  TransformStages stages;
  stages.mirrored_at[1] = -7.0;
  stages.mirrored_at[3] = 2.0;
  stages.scaling = Scaling{{3.0, -1.0, 40.0}, {1.5, 0.25, -2.0}};
  stages.rotation = Rotation{plane_of({18, 0}), Eigen::Vector2d(11.0, -6.0), 37.0};
  const WorkTransform map = stages.all();
  for (int i = 0; i < 50; ++i) {
    const AxisPositions q = point(700.0 - 31.0 * i, 0.37 * i * i, -500.0 + i);
    EXPECT_LT((map.undo(map.apply(q)) - q).norm(), 1e-11);
  }
}

/// Mirror comes first, then scaling, then rotation, whatever the order of the commands was.
TEST(TransformStages, GoInTheOrderOfTheControl) {
  TransformStages stages;
  stages.rotation = Rotation{plane_of({17, 0}), Eigen::Vector2d(0.0, 0.0), 90.0};
  stages.scaling = Scaling{{0.0, 0.0, 0.0}, {2.0, 1.0, 1.0}};
  stages.mirrored_at[0] = 1.0;
  // (4, 3) -> mirror at 1: (-2, 3) -> scaled: (-4, 3) -> turned: (-3, -4)
  EXPECT_EQ(stages.all().apply(point(4.0, 3.0, 0.0)), point(-3.0, -4.0, 0.0));
}

}  // namespace
}  // namespace g31::fanuc::work_transform_test

// Circles through points and frames through points, against what the points were made of.

#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/execute/circle_through.h"
#include "interpreter/dialects/sinumerik/execute/point_fit.h"

namespace g31::sinumerik::sinumerik_geometry_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

Vector2d on_circle(const PlaneCircle& circle, double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  return circle.centre + circle.radius * Vector2d(std::cos(angle), std::sin(angle));
}

class CirclePoints : public ::testing::TestWithParam<PlaneCircle> {};

TEST_P(CirclePoints, GiveTheCircleThatTheyWereMadeOf) {
  const PlaneCircle made = GetParam();
  const std::array<Vector2d, 4> points = {on_circle(made, 10.0), on_circle(made, 75.0),
                                          on_circle(made, 200.0), on_circle(made, 290.0)};
  for (const std::size_t count : {std::size_t{3}, std::size_t{4}}) {
    const auto found = circle_through(std::span(points).first(count));
    ASSERT_TRUE(found);
    EXPECT_NEAR((found->centre - made.centre).norm(), 0.0, 1e-9);
    EXPECT_NEAR(found->radius, made.radius, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Geometry, CirclePoints,
                         ::testing::Values(PlaneCircle{{0.0, 0.0}, 1.0},
                                           PlaneCircle{{-700.5, 350.25}, 12.5},
                                           PlaneCircle{{3.0, -4.0}, 0.05},
                                           PlaneCircle{{120.0, 80.0}, 400.0}));

TEST(CirclePoints, OnALineOrTogetherGiveNone) {
  const std::array<Vector2d, 3> line = {Vector2d(0.0, 0.0), Vector2d(1.0, 2.0), Vector2d(3.0, 6.0)};
  EXPECT_FALSE(circle_through(line));
  const std::array<Vector2d, 3> twice = {Vector2d(5.0, 5.0), Vector2d(5.0, 5.0),
                                         Vector2d(3.0, 6.0)};
  EXPECT_FALSE(circle_through(twice));
}

TEST(PointFit, FindsTheMotionThatThePointsMade) {
  Matrix3d from;
  from << 0.0, 100.0, 20.0, 0.0, 5.0, 80.0, -10.0, 0.0, 7.0;
  for (int i = 0; i < 36; ++i) {
    const Vector3d about = Vector3d(1.0, 0.1 * i, -2.0 + 0.2 * i).normalized();
    const Matrix3d turn = Eigen::AngleAxisd(0.3 * i, about).toRotationMatrix();
    const Vector3d shift(50.0 - i, 2.0 * i, -300.0);
    const auto fit = fitted(from, (turn * from).colwise() + shift);
    ASSERT_TRUE(fit) << i;
    EXPECT_NEAR((fit->turn - turn).norm(), 0.0, 1e-9) << i;
    EXPECT_NEAR((fit->shift - shift).norm(), 0.0, 1e-8) << i;
    EXPECT_NEAR(fit->left_over, 0.0, 1e-8) << i;
  }
}

/// No small motion on top of the one found makes the sum of the squares less.
TEST(PointFit, LeavesTheLeastSquares) {
  Matrix3d from;
  from << 0.0, 100.0, 20.0, 0.0, 5.0, 80.0, -10.0, 0.0, 7.0;
  Matrix3d to;
  to << 1.0, 102.0, 18.5, 0.2, 4.0, 83.0, -10.5, 1.0, 6.0;
  const auto fit = fitted(from, to);
  ASSERT_TRUE(fit);
  const Matrix3d brought = (fit->turn * from).colwise() + fit->shift;
  const double least = (brought - to).squaredNorm();
  const Vector3d middle = brought.rowwise().mean();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double step : {-1e-4, 1e-4}) {
      const Matrix3d turned = (Eigen::AngleAxisd(step, Vector3d::Unit(axis)).toRotationMatrix() *
                               (brought.colwise() - middle))
                                  .colwise() +
                              middle;
      EXPECT_GT((turned - to).squaredNorm(), least);
      EXPECT_GT((brought.colwise() + step * Vector3d::Unit(axis) - to).squaredNorm(), least);
    }
  }
}

}  // namespace
}  // namespace g31::sinumerik::sinumerik_geometry_test

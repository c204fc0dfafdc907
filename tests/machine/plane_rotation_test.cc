// Each way to say a tilted plane, against the worked examples of the five-axis specification and
// against rotations in long double.

#include "machine/kinematics/plane_rotation.h"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "machine/base/random.h"

namespace g31::machine::plane_rotation_test {
namespace {

using Exact = Eigen::Matrix<long double, 3, 3>;

constexpr int kX = 0;
constexpr int kY = 1;
constexpr int kZ = 2;

Eigen::Matrix3d turned(const AxisTurn& a, const AxisTurn& b, const AxisTurn& c) {
  return about_turned_axes({a, b, c});
}

Eigen::Matrix3d fixed(const AxisTurn& a, const AxisTurn& b, const AxisTurn& c) {
  return about_fixed_axes({a, b, c});
}

void expect_plane(const Eigen::Matrix3d& plane, const Point& x, const Point& z, const char* what) {
  EXPECT_LT((plane.col(0) - x).cwiseAbs().maxCoeff(), 6e-7) << what << '\n' << plane;
  EXPECT_LT((plane.col(2) - z).cwiseAbs().maxCoeff(), 6e-7) << what << '\n' << plane;
  EXPECT_LT((plane.transpose() * plane - Eigen::Matrix3d::Identity()).norm(), 1e-14) << what;
  EXPECT_GT(plane.determinant(), 0.0) << what;
}

TEST(PlaneRotation, AxisByAxisAndSolidAnglesAreThoseOfTheSpecification) {
  const double a = 20, b = -15, c = 40;
  expect_plane(turned({kX, a}, {kY, b}, {kZ, c}), {0.739942, 0.536212, 0.406156},
               {-0.258819, -0.330366, 0.907673}, "X Y Z");
  expect_plane(turned({kX, a}, {kZ, b}, {kY, c}), {0.739942, 0.033536, -0.671834},
               {0.620885, -0.418335, 0.662946}, "X Z Y");
  expect_plane(turned({kY, a}, {kX, b}, {kZ, c}), {0.662946, 0.620885, -0.418335},
               {0.330366, 0.258819, 0.907673}, "Y X Z");
  expect_plane(turned({kY, a}, {kZ, b}, {kX, c}), {0.907673, -0.258819, -0.330366},
               {0.105670, -0.620885, 0.776747}, "Y Z X");
  expect_plane(turned({kZ, a}, {kX, b}, {kY, c}), {0.776747, 0.105670, -0.620885},
               {0.536212, 0.406156, 0.739942}, "Z X Y");
  expect_plane(turned({kZ, a}, {kY, b}, {kX, c}), {0.907673, 0.330366, 0.258819},
               {0.033536, -0.671834, 0.739942}, "Z Y X");
  expect_plane(turned({kZ, 50}, {kY, 35}, {}), {0.526541, 0.627507, -0.573576},
               {0.368688, 0.439385, 0.819152}, "solid angles");
}

TEST(PlaneRotation, RollPitchYawAndEulerAnglesAreThoseOfG68_2) {
  const double i = 20, j = -15, k = 40;
  expect_plane(turned({kZ, 35}, {kX, -25}, {kZ, 10}), {0.716439, 0.693780, -0.073387},
               {-0.242404, 0.346189, 0.906308}, "Euler");
  expect_plane(fixed({kX, i}, {kY, j}, {kZ, k}), {0.739942, 0.620885, 0.258819},
               {0.033536, -0.418335, 0.907673}, "Q123");
  expect_plane(fixed({kZ, k}, {kY, j}, {kX, i}), {0.739942, 0.536212, 0.406156},
               {-0.258819, -0.330366, 0.907673}, "Q321");
  const Eigen::Matrix3d base = turned({kZ, 35}, {kX, -25}, {kZ, 0});
  expect_plane(base * turned({kZ, 0}, {kX, 15}, {kZ, 0}), {0.819152, 0.573576, 0},
               {-0.099601, 0.142244, 0.984808}, "incremental");
  const Point origin = Point(60, -40, -3) + base * Point(5, 0, 2);
  EXPECT_LT((origin - Point(63.610952, -36.439741, -1.187384)).cwiseAbs().maxCoeff(), 6e-7);
}

TEST(PlaneRotation, ProjectionAnglesKeepOneLineInItsOldPlane) {
  const auto plane = by_projection_angles({20, -15, 10}, kZ);
  ASSERT_TRUE(plane);
  expect_plane(*plane, {0.936345, 0.163819, 0.310518}, {-0.244169, -0.331668, 0.911251}, "X and Y");
  // Each pair is the one before it with the letters moved on by one.
  const Eigen::Matrix3d next = (Eigen::Matrix3d() << 0, 0, 1, 1, 0, 0, 0, 1, 0).finished();
  const auto by_yz = by_projection_angles({10, 20, -15}, kX);
  const auto by_zx = by_projection_angles({-15, 10, 20}, kY);
  ASSERT_TRUE(by_yz && by_zx);
  EXPECT_LT((*by_yz - next * *plane * next.transpose()).norm(), 1e-15);
  EXPECT_LT((*by_zx - next * next * *plane * (next * next).transpose()).norm(), 1e-15);
  const auto flat = by_projection_angles({20, -15, 0}, kZ);
  EXPECT_LT(std::abs((*flat)(kY, 0)), 1e-16) << "X stays in the old ZX plane";
  const auto upright = by_projection_angles({20, 0, 30}, kY);
  EXPECT_LT(std::abs((*upright)(kX, 2)), 1e-16) << "Z stays in the old YZ plane";
  const auto side = by_projection_angles({0, 20, 30}, kX);
  EXPECT_LT(std::abs((*side)(kZ, 1)), 1e-16) << "Y stays in the old XY plane";
  EXPECT_FALSE(by_projection_angles({90, 90, 0}, kZ)) << "both lines upright";
}

TEST(PlaneRotation, PointsAndVectorsMakeThePlaneOfTheSpecification) {
  const auto points = by_three_points({10, 20, 5}, {60, 25, -15}, {5, 70, 25});
  ASSERT_TRUE(points);
  expect_plane(*points, {0.924500, 0.092450, -0.369800}, {0.379635, -0.310610, 0.871435}, "P2");
  const auto vectors = by_x_and_z({1, 0.2, -0.1}, {0.3, -0.5, 2});
  ASSERT_TRUE(vectors);
  expect_plane(*vectors, {0.975900, 0.195180, -0.097590}, {0.144005, -0.240008, 0.960031}, "P3");
  const auto tool = by_z_and_upright({0.3213938048, -0.3830222216, 0.8660254038}, {0, 0, 1});
  ASSERT_TRUE(tool);
  expect_plane(*tool, {0.766044, 0.642788, 0}, {0.321394, -0.383022, 0.866025}, "G68.3");
  expect_plane(*tool * turn_about(AxisTurn{kZ, 12}), {0.633566, 0.766673, 0.103956},
               {0.321394, -0.383022, 0.866025}, "G68.3 R12");
  EXPECT_FALSE(by_three_points({0, 0, 0}, {1, 1, 1}, {3, 3, 3}));
  EXPECT_FALSE(by_x_and_z({0, 0, 2}, {0, 0, 1}));
  EXPECT_FALSE(by_x_and_z({0, 0, 0}, {0, 0, 1}));
  EXPECT_FALSE(by_z_and_upright({0, 0, 1}, {0, 0, -3}));
}

Exact exact_turn(int axis, double deg) {
  const long double r = static_cast<long double>(deg) * std::numbers::pi_v<long double> / 180.0L;
  Exact turn = Exact::Identity();
  const int a = (axis + 1) % 3;
  const int b = (axis + 2) % 3;
  turn(a, a) = turn(b, b) = std::cos(r);
  turn(b, a) = std::sin(r);
  turn(a, b) = -std::sin(r);
  return turn;
}

TEST(PlaneRotation, AgreesWithLongDoubleInEveryOrder) {
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 3}, n++) - 1.0); };
  for (int i = 0; i < 3000; ++i) {
    std::array<AxisTurn, 3> turns;
    for (AxisTurn& turn : turns) {
      turn = {static_cast<int>(uniform({22, 4}, n++) * 3.0), random(720.0)};
    }
    const Exact first = exact_turn(turns[0].axis, turns[0].deg);
    const Exact second = exact_turn(turns[1].axis, turns[1].deg);
    const Exact third = exact_turn(turns[2].axis, turns[2].deg);
    EXPECT_LT((about_turned_axes(turns).cast<long double>() - first * second * third).norm(),
              4e-15L);
    EXPECT_LT((about_fixed_axes(turns).cast<long double>() - third * second * first).norm(),
              4e-15L);
  }
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const Eigen::Matrix3d turn = turn_about(AxisTurn{kZ, 90.0 * quarter});
    EXPECT_EQ(turn, Eigen::Matrix3d(turn.array().round())) << "quarter turns are exact";
    EXPECT_LT((turn.cast<long double>() - exact_turn(kZ, 90.0 * quarter)).norm(), 1e-15L);
  }
}

TEST(PlaneRotation, AnglesAreLessWholeTurns) {
  EXPECT_EQ(within_half_turn(190.0), -170.0);
  EXPECT_EQ(within_half_turn(-180.0), 180.0);
  EXPECT_EQ(within_half_turn(180.0), 180.0);
  EXPECT_EQ(within_half_turn(725.0), 5.0);
  EXPECT_NEAR(angle_about({0, 0, 1}, {1, 0, 5}, {0, -2, 1}), -90.0, 1e-13);
  EXPECT_EQ(angle_about({0, 0, 1}, {0, 0, 5}, {0, -2, 1}), 0.0);
}

}  // namespace
}  // namespace g31::machine::plane_rotation_test

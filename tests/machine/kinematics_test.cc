// From places of the part to axis positions and back: against the worked examples of the five-axis
// specification and against matrices written out.

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "machine/kinematics/transformation.h"
#include "tests/support/worked_machines.h"

namespace g31::machine::kinematics_test {
namespace {

using namespace worked;  // NOLINT(google-build-using-namespace)

/// A machine of the specification and where it has the work origin.
struct Worked {
  const char* name;
  AxisChainSetup chain;
  Point p_M_origin;
};

/// The tip is held at one place of the part: there the axes are at xyz, and the tool points there.
void expect_held(const Worked& machine, const AxisPositions& turned, const Point& xyz,
                 const Point& tool) {
  SCOPED_TRACE(machine.name);
  const Point w(30, -20, 10);
  const Transformation held(TransformationKind::FiveAxis, machine.chain, kTool);
  const auto q_M = held.axes_for(machine.p_M_origin + w, turned);
  ASSERT_TRUE(q_M);
  EXPECT_LT((linear_axes(*q_M) - xyz).cwiseAbs().maxCoeff(), 1e-6) << q_M->transpose();
  EXPECT_EQ(rotary_axes(*q_M), rotary_axes(turned));
  const Point points = AxisChain(machine.chain, kTool).for_part(*q_M).tilt * Point::UnitZ();
  EXPECT_LT((points - tool).cwiseAbs().maxCoeff(), 1e-6) << points.transpose();
}

AxisPositions abc(double a, double b, double c) {
  return axes(0, 0, 0, a, b, c);
}

TEST(Transformation, HoldsTheTipOnTablesAsTheSpecificationWorksItOut) {
  const Point up(0, 0, 1);
  const Worked table{"K1", k1(), {40, -25, -380}};
  expect_held(table, abc(0, 0, 0), {70, -45, -250}, up);
  expect_held(table, abc(35, 0, -70), {66.698399, 85.312448, -278.070302},
              {-0.538986, -0.196175, 0.819152});
  expect_held(table, abc(-60, 0, 110), {-56.698399, -84.139619, -350.375112},
              {-0.813798, -0.296198, 0.5});
  expect_held(table, abc(90, 0, 45), {21.263456, 100, -231.339574}, {0.707107, -0.707107, 0});
  const Worked inclined{"K6", k6(), {20, -30, -380}};
  expect_held(inclined, abc(0, 0, 0), {50, -50, -250}, up);
  expect_held(inclined, abc(0, 60, 25), {-15.895858, -49.029210, -274.464075},
              {0.449343, 0.485377, 0.75});
  expect_held(inclined, abc(0, 180, 90), {145, -10, -295}, {-1, 0, 0});
}

TEST(Transformation, HoldsTheTipUnderHeadsAsTheSpecificationWorksItOut) {
  const Point up(0, 0, 1);
  const Worked mixed{"K2", k2(), {230, -120, -420}};
  expect_held(mixed, abc(0, 0, 0), {260, -140, -290}, up);
  expect_held(mixed, abc(0, 35, -70), {381.388734, -90.198241, -349.990151},
              {0.196175, -0.538986, 0.819152});
  expect_held(mixed, abc(0, -90, 110), {-121.124282, -209.801759, -580}, {0.342020, -0.939693, 0});
  const Worked half{"K3", k3(), {30, 40, -350}};
  expect_held(half, abc(0, 0, 0), {60, 20, -220}, up);
  expect_held(half, abc(0, 90, 30), {242.273753, 114.820508, -347.5}, {0.362372, 0.786566, 0.5});
  expect_held(half, abc(0, 180, -45), {28.284271, 311.568542, -475}, {0.707107, 0.707107, 0});
  const Worked head{"K4", k4(), {300, 100, -500}};
  expect_held(head, abc(0, 0, 0), {330, 80, -370}, up);
  expect_held(head, abc(-40, 0, 30), {217.290284, 270.218954, -444.402588},
              {-0.321394, 0.556670, 0.766044});
  expect_held(head, abc(75, 0, -120), {55.049636, 233.742667, -629.728931},
              {-0.836516, 0.482963, 0.258819});
  const Worked nutating{"K5", k5(), {300, 100, -500}};
  expect_held(nutating, abc(0, 90, 60), {305.010452, 301.716833, -500}, {-0.079459, 0.862372, 0.5});
  // The direction is printed with +Y there; the XYZ beside it are those of -Y.
  expect_held(nutating, abc(0, 180, -135), {517.383297, -112.383297, -630},
              {0.707107, -0.707107, 0});
}

TEST(Transformation, CarriesTheToolsLengthAlong) {
  struct Case {
    AxisChainSetup chain;
    AxisPositions turned;
    Point effective;  // length: from the tip to the gauge point
  };
  const std::vector<Case> cases = {
      {k2(), axes(0, 0, 0), {0, 0, 120}},
      {k2(), axes(0, 0, 0, 0, 30, 0), {148.660254, 0, 74.807621}},
      {k2(), axes(0, 0, 0, 0, 90, 0), {290, 0, -190}},
      {k3(), axes(0, 0, 0, 0, 90, 0), {180.312229, 127.5, -7.5}},
      {k4(), axes(0, 0, 0, -40, 0, 30), {-112.709716, 190.218954, 45.597412}},
      {k5(), axes(0, 0, 0, 0, 90, 60), {-24.989548, 221.716833, -10}},
  };
  const Point tip(11, -7, 3);
  for (const Case& c : cases) {
    const Transformation carried(TransformationKind::ToolCarrier, c.chain, kTool);
    const auto q_M = carried.axes_for(tip, c.turned);
    EXPECT_LT((linear_axes(*q_M) - tip - c.effective).cwiseAbs().maxCoeff(), 1e-6)
        << q_M->transpose();
    const Transformation none(TransformationKind::None, c.chain, kTool);
    EXPECT_EQ(linear_axes(*none.axes_for(tip, c.turned)), tip - kTool);
  }
}

/// What the tip is off where the control wants it, in the part.
void expect_error(const Worked& believed, const AxisChainSetup& truth, const AxisPositions& turned,
                  const Point& expected) {
  SCOPED_TRACE(believed.name);
  const Point wanted = believed.p_M_origin + Point(30, -20, 10);
  const Transformation held(TransformationKind::FiveAxis, believed.chain, kTool);
  const auto q_M = held.axes_for(wanted, turned);
  ASSERT_TRUE(q_M);
  const Point error = linear_axes(AxisChain(truth, kTool).for_part(*q_M).q) + kTool - wanted;
  EXPECT_LT((error - expected).cwiseAbs().maxCoeff(), 1e-9) << error.transpose();
}

TEST(Transformation, BringsTheTipWhereATrueMachineThatIsNotTheBelievedOneHasIt) {
  Worked centre{"C is believed beside its centre", k1(), {40, -25, -380}};
  centre.chain.rotary[2].p_M_centre = {5.03, -3.02, 0};
  expect_error(centre, k1(), abc(0, 0, 0), {0, 0, 0});
  expect_error(centre, k1(), abc(35, 0, -70), {-0.038533248, -0.015031181, 0});
  expect_error(centre, k1(), abc(-60, 0, 110), {-0.021466752, 0.055031181, 0});
  expect_error(centre, k1(), abc(90, 0, 45), {0.005355339, 0.027071068, 0});

  const Worked upright{"C is really tilted by 20 seconds of arc", k1(), {40, -25, -380}};
  AxisChainSetup tilted = k1();
  const double tilt = 20.0 / 3600.0 * std::numbers::pi / 180.0;
  tilted.rotary[2].axis_M = {0, -std::sin(tilt), std::cos(tilt)};
  expect_error(upright, tilted, abc(35, 0, -70), {-0.033712818, 0.023606386, -0.008599777});
  expect_error(upright, tilted, abc(-60, 0, 110), {0.033712406, 0.048146283, 0.000461865});
  expect_error(upright, tilted, abc(90, 0, 45), {0.025368062, 0.010507637, 0.003264826});

  const Worked pivot{"the pivot is really higher", k2(), {230, -120, -420}};
  AxisChainSetup high = k2();
  high.rotary[1].p_M_centre.z() = 180.05;
  expect_error(pivot, high, abc(0, 35, -70), {-0.009808735, 0.026949277, 0.009042398});
  expect_error(pivot, high, abc(0, -90, 110), {-0.017101007, 0.046984631, 0.05});
}

/// The second way: one 4x4 matrix an axis, Rodrigues' formula written out.
Eigen::Matrix4d matrix_of(const AxisChainSetup& setup, char letter, const AxisPositions& q_M) {
  const int axis = axis_index(letter);
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if (is_linear_axis(axis)) {
    matrix(axis, 3) = q_M[axis];
    return matrix;
  }
  const RotaryLine& line = setup.rotary.at(static_cast<std::size_t>(axis - kLinearAxisCount));
  const Point u = line.axis_M / std::sqrt(line.axis_M.dot(line.axis_M));
  const double angle = q_M[axis] * std::numbers::pi / 180.0;
  Eigen::Matrix3d cross;
  cross << 0, -u.z(), u.y(), u.z(), 0, -u.x(), -u.y(), u.x(), 0;
  const Eigen::Matrix3d turn = std::cos(angle) * Eigen::Matrix3d::Identity() +
                               (1.0 - std::cos(angle)) * u * u.transpose() +
                               std::sin(angle) * cross;
  matrix.topLeftCorner<3, 3>() = turn;
  matrix.topRightCorner<3, 1>() = line.p_M_centre - turn * line.p_M_centre;
  return matrix;
}

Point tip_by_matrices(const AxisChainSetup& setup, const AxisPositions& q_M, const Point& p_T) {
  Eigen::Matrix4d product = Eigen::Matrix4d::Identity();
  for (const char letter : setup.table_side + setup.tool_side) {
    product = product * matrix_of(setup, letter, q_M);
  }
  return (product * p_T.homogeneous()).head<3>();
}

TEST(AxisChain, EqualChainsHaveNoErrorAtAnyPosition) {
  AxisChainSetup slides = chain("CAXY", "ZB");
  slides.rotary = {RotaryLine{{3, -4, 90}, {1, 0.2, 0}}, RotaryLine{{0, 1, 200}, {0.1, 1, 0.3}},
                   RotaryLine{{-20, 8, 0}, {0, 0.01, 2}}};
  const std::vector<AxisChainSetup> machines = {k1(), k2(), k3(), k4(), k5(), k6(), slides};
  double worst = 0.0;
  double worst_place = 0.0;
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({7, 1}, n++) - 1.0); };
  for (int i = 0; i < 14000; ++i) {
    const AxisChainSetup& setup = machines[static_cast<std::size_t>(i) % machines.size()];
    const Point p_T(random(5.0), random(5.0), -120.0 + random(80.0));
    const AxisChain machine(setup, p_T);
    const AxisPositions q_M =
        axes(random(500), random(500), random(500), random(180), random(180), random(180));
    const Point tip = tip_by_matrices(setup, q_M, p_T);
    worst_place = std::max(worst_place, (linear_axes(machine.for_part(q_M).q) + p_T - tip).norm());
    const auto back = machine.axes_for(tip, q_M);
    if (!back) {
      ADD_FAILURE() << "no way back from " << q_M.transpose();
      continue;
    }
    EXPECT_EQ(rotary_axes(*back), rotary_axes(q_M));
    worst = std::max(worst, (linear_axes(*back) - linear_axes(q_M)).norm());
    const Point again = linear_axes(machine.for_part(*back).q) + p_T;
    worst_place = std::max(worst_place, (again - tip).norm());
  }
  std::printf("worst %.3g mm, of an axis %.3g\n", worst_place, worst);
  EXPECT_LT(worst_place, kChainErrorMm);
  EXPECT_LT(worst, kChainErrorMm);
}

TEST(AxisChain, SaysWhereTheLinearAxesDoNotLeadEverywhere) {
  // A slide X on a turning table: at C 90 it goes along Y.
  const AxisChain crossed(chain("XC", "YZ"), kTool);
  EXPECT_TRUE(crossed.axes_for(Point(1, 2, 3), axes(0, 0, 0, 0, 0, 89.0)));
  EXPECT_FALSE(crossed.axes_for(Point(1, 2, 3), axes(0, 0, 0, 0, 0, 90.0)));
  // A lathe with a C axis has no Y.
  const AxisChain lathe(chain("C", "XZ"), kTool);
  EXPECT_FALSE(lathe.axes_for(Point(1, 2, 3), axes(0, 0, 0, 0, 0, 30.0)));
  EXPECT_TRUE(lathe.axes_for(Point(1, 2, 3), axes(0, 0, 0)));
}

TEST(AxisChainSetup, IsAValueThatTellsBeliefFromTruth) {
  EXPECT_EQ(k1(), k1());
  AxisChainSetup off = k1();
  off.rotary[2].p_M_centre.x() += 1e-9;
  EXPECT_NE(off, k1());
  AxisChainSetup turned = k1();
  turned.rotary[0].axis_M = -turned.rotary[0].axis_M;
  EXPECT_NE(turned, k1());
}

}  // namespace
}  // namespace g31::machine::kinematics_test

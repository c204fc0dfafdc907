// The vectors of tool carriers against the worked examples of the five-axis specification, and
// against the chains that they are of.

#include "machine/kinematics/kinematic_vectors.h"

#include <cstdint>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "machine/kinematics/plane_rotation.h"
#include "tests/support/worked_machines.h"

namespace g31::machine::kinematic_vectors_test {
namespace {

using namespace worked;  // NOLINT(google-build-using-namespace)

void expect_near(const Point& a, const Point& b, double within) {
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), within) << a.transpose() << " or " << b.transpose();
}

TEST(KinematicVectors, AreTheFeetOfTheCommonPerpendicular) {
  const auto table = vectors_of(k1());
  ASSERT_TRUE(table);
  EXPECT_EQ(table->type, KinematicType::Part);
  EXPECT_EQ(table->axes, (std::array{axis_index('A'), axis_index('C')}));
  EXPECT_EQ(table->i2, Point(5, 20, -450));
  EXPECT_EQ(table->i3, Point(0, -23, 0));
  EXPECT_EQ(table->i4, Point(-5, 3, 450));
  EXPECT_EQ(table->v1, Point(-1, 0, 0));
  EXPECT_EQ(table->v2, Point(0, 0, -1));
  const auto mixed = vectors_of(k2());
  ASSERT_TRUE(mixed);
  EXPECT_EQ(mixed->type, KinematicType::Mixed);
  EXPECT_EQ(mixed->i2, Point(10, 0, 180));
  EXPECT_EQ(mixed->i3, Point(200, -150, -500));
  EXPECT_EQ(mixed->v1, Point(0, 1, 0));
  EXPECT_EQ(mixed->v2, Point(0, 0, -1));
  const auto head = vectors_of(k4());
  ASSERT_TRUE(head);
  EXPECT_EQ(head->type, KinematicType::Tool);
  EXPECT_EQ(head->axes, (std::array{axis_index('C'), axis_index('A')}));
  // The lines X = 0, Y = 5 and Y = -8, Z = 220: their feet.
  EXPECT_EQ(head->i3, Point(0, -8, 220));
  EXPECT_EQ(head->i2, Point(0, 13, 0));
  EXPECT_EQ(head->i1, Point(0, -5, -220));
  EXPECT_FALSE(vectors_of(chain("XC", "YZ"))) << "a slide on the table";
  EXPECT_TRUE(vectors_of(chain("CAXY", "ZB")).has_value() == false) << "three rotary axes";
  EXPECT_TRUE(vectors_of(chain("CXY", "ZB")));
}

TEST(KinematicVectors, CarryTheToolsLengthAsTheSpecificationWorksItOut) {
  const Point length(0, 0, 120);
  const auto mixed = *vectors_of(k2());
  expect_near(mixed.tool_length(length, {0, 0}), {0, 0, 120}, 1e-12);
  expect_near(mixed.tool_length(length, {30, 77}), {148.660254, 0, 74.807621}, 6e-7);
  expect_near(mixed.tool_length(length, {90, 0}), {290, 0, -190}, 1e-12);
  expect_near(vectors_of(k3())->tool_length(length, {90, 0}), {180.312229, 127.5, -7.5}, 6e-7);
  expect_near(vectors_of(k4())->tool_length(length, {30, -40}),
              {-112.709716, 190.218954, 45.597412}, 6e-7);
  expect_near(vectors_of(k5())->tool_length(length, {60, 90}), {-24.989548, 221.716833, -10}, 6e-7);
}

TEST(KinematicVectors, ThePrintedTableShiftsTheZeroPoint) {
  // W1 p. 4-3: one table axis about +Y at 45 degrees, I4 = (0, 0, 15), a tool of 13.
  KinematicVectors table;
  table.type = KinematicType::Part;
  table.i4 = {0, 0, 15};
  table.v1 = {0, 1, 0};
  const Point zero = table.part_motion({45, 0}) * Point::Zero();
  expect_near(zero, {10.606602, 0, 10.606602}, 6e-7);
  // The shift counts from the vectors as given: 15 lower.
  expect_near(zero - Point(0, 0, 15), {10.606602, 0, -4.393398}, 6e-7);
  expect_near(zero - Point(0, 0, 15) + Point(0, 10, 0) + Point(0, 0, 13), {10.606602, 10, 8.606602},
              6e-7);
}

TEST(KinematicVectors, TheTablesMotionIsThePartFrameOfTheSpecification) {
  const auto table = *vectors_of(k1());
  const Point origin(40, -25, -380);
  const Eigen::Isometry3d minus = table.part_motion({-25, 35});
  const Eigen::Isometry3d plus = table.part_motion({25, -145});
  expect_near(minus.translation(), {2.624969, -186.196901, -49.631131}, 6e-7);
  expect_near(plus.translation(), {7.375031, 184.506743, -30.190691}, 6e-7);
  expect_near(minus * origin - origin, {-18.948360, -39.955530, -32.378960}, 6e-7);
  expect_near(plus * origin - origin, {-51.051640, 88.265372, -12.938520}, 6e-7);
  const Eigen::Matrix3d expected = turn_about(AxisTurn{2, -32.399357}) *
                                   turn_about(AxisTurn{1, 14.028463}) *
                                   turn_about(AxisTurn{0, 20.905700});
  EXPECT_LT((minus.linear() - expected).cwiseAbs().maxCoeff(), 3e-8);
  // G254: the work offset goes with the table.
  const Eigen::Isometry3d tilted = table.part_motion({30, 45});
  expect_near(tilted * origin, {14.192388, 0.176187, -357.725678}, 6e-7);
}

TEST(KinematicVectors, AreTheChainThatTheyAreOf) {
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 9}, n++) - 1.0); };
  std::vector<AxisChainSetup> machines = {
      k1(), k2(), k3(), k4(), k5(), k6(), chain("C", "XYZ"), chain("", "XYZB"), chain("CXY", "ZB")};
  double worst = 0.0;
  for (int i = 0; i < 9000; ++i) {
    AxisChainSetup setup = machines[static_cast<std::size_t>(i) % machines.size()];
    for (RotaryLine& line : setup.rotary) {
      line.p_M_centre += Point(random(30), random(30), random(30));
      line.axis_M += Point(random(0.3), random(0.3), random(0.3));
    }
    const auto vectors = vectors_of(setup);
    ASSERT_TRUE(vectors);
    const std::array<double, 2> deg = {random(180), random(180)};
    AxisPositions turned = AxisPositions::Zero();
    for (std::size_t k = 0; k < 2; ++k) {
      if (vectors->axes.at(k) >= 0) {
        turned[vectors->axes.at(k)] = deg.at(k);
      }
    }
    const Point p(random(300), random(300), random(300));
    const Point length(random(10), random(10), 120);
    const Point expected = linear_axes(AxisChain(setup, -length).axes_for(p, turned).value());
    const Point xyz = vectors->part_motion(deg) * p + vectors->tool_length(length, deg);
    worst = std::max(worst, (xyz - expected).norm());
    const VectorChain back = chain_of(*vectors, setup);
    worst = std::max({worst, back.tool_shift.norm(), back.part_shift.norm()});
    const Point again = linear_axes(AxisChain(back.chain, -length).axes_for(p, turned).value());
    worst = std::max(worst, (again - expected).norm());
  }
  EXPECT_LT(worst, 1e-10) << "mm; lines 25 degrees from parallel have far feet";
}

TEST(KinematicVectors, OpenVectorsShiftToolAndPart) {
  KinematicVectors open = *vectors_of(k2());
  open.i1 += Point(1, 2, 3);
  open.i4 += Point(-4, 5, 6);
  const VectorChain chain = chain_of(open, k2());
  expect_near(chain.tool_shift, {1, 2, 3}, 1e-12);
  expect_near(chain.part_shift, {-4, 5, 6}, 1e-12);
  const Point p(30, -20, 10);
  const Point length(0, 0, 120);
  const AxisPositions turned = axes(0, 0, 0, 0, 35, -70);
  const Point expected = open.part_motion({35, -70}) * p + open.tool_length(length, {35, -70});
  const Point xyz =
      linear_axes(AxisChain(chain.chain, -length).axes_for(p + chain.part_shift, turned).value()) +
      chain.tool_shift;
  expect_near(xyz, expected, 1e-11);
}

}  // namespace
}  // namespace g31::machine::kinematic_vectors_test

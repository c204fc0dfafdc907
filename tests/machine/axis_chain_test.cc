// The forward transform of machines with tables that turn, against rotations written out, and
// touches on such a table.

#include "machine/kinematics/axis_chain.h"

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

#include <Eigen/QR>
#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/world_of_pieces.h"

namespace g31::machine::axis_chain_test {
namespace {

AxisPositions axes(double x, double y, double z, double a = 0, double b = 0, double c = 0) {
  return (AxisPositions() << x, y, z, a, b, c).finished();
}

AxisChainSetup chain(const std::string& table_side, const std::string& tool_side) {
  AxisChainSetup setup;
  setup.table_side = table_side;
  setup.tool_side = tool_side;
  return setup;
}

void expect_near(const Point& a, const Point& b, const char* what) {
  EXPECT_LT((a - b).norm(), 1e-11) << what << ": " << a.transpose() << " or " << b.transpose();
}

TEST(AxisChain, WithRotaryAxesAtZeroNothingChangesBitForBit) {
  AxisChainSetup setup = chain("CA", "XYZ");
  setup.rotary[0].p_M_centre = {0.1, 0.2, -400.3};
  const AxisChain five(setup, {0.01, 0.02, -120.7});
  const AxisPositions q_M = axes(1.0 / 3.0, -2.0 / 7.0, 99.1);
  EXPECT_EQ(five.for_part(q_M).q, q_M);
  EXPECT_TRUE(five.has_rotary_axes());
  EXPECT_FALSE(AxisChain(chain("XY", "Z"), Point::Zero()).has_rotary_axes());
}

TEST(AxisChain, ATableTurnsThePartTheOtherWay) {
  // C at 90: the tool goes a quarter turn right-handed about Z round the part.
  AxisChainSetup setup = chain("C", "XYZ");
  setup.rotary[2].p_M_centre = {10.0, 20.0, 0.0};
  const Point p_T(0.5, 0.0, -100.0);
  const AxisChain table(setup, p_T);
  const Point tip(10.0 - (23.0 - 20.0), 20.0 + (15.0 + 0.5 - 10.0), 7.0 - 100.0);
  expect_near(linear_axes(table.for_part(axes(15, 23, 7, 0, 0, 90)).q), tip - p_T, "quarter turn");
  expect_near(linear_axes(table.for_part(axes(15, 23, 7, 0, 0, 450)).q), tip - p_T,
              "and a whole one");
}

/// Right-handed turns written out.
Point about_x(const Point& p, double deg) {
  const double r = deg * std::numbers::pi / 180.0, c = std::cos(r), s = std::sin(r);
  return {p.x(), c * p.y() - s * p.z(), s * p.y() + c * p.z()};
}
Point about_y(const Point& p, double deg) {
  const double r = deg * std::numbers::pi / 180.0, c = std::cos(r), s = std::sin(r);
  return {c * p.x() + s * p.z(), p.y(), -s * p.x() + c * p.z()};
}
Point about_z(const Point& p, double deg) {
  const double r = deg * std::numbers::pi / 180.0, c = std::cos(r), s = std::sin(r);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}

TEST(AxisChain, TableTableMachinesTurnFirstAboutTheAxisNearestTheBed) {
  const Point p_T(0, 0, -120);
  const Point pivot(3, -4, -450);
  const Point c_axis(1, 2, 0);
  const Point tip = Point(50, 60, -30) + p_T;

  AxisChainSetup setup = chain("CA", "XYZ");
  setup.rotary[0].p_M_centre = pivot;
  setup.rotary[2].p_M_centre = c_axis;
  const Point tilted = pivot + about_x(tip - pivot, -35.0);
  expect_near(linear_axes(AxisChain(setup, p_T).for_part(axes(50, 60, -30, -35, 0, 70)).q) + p_T,
              c_axis + about_z(tilted - c_axis, 70.0), "A and C");

  setup = chain("CB", "XYZ");
  setup.rotary[1].p_M_centre = pivot;
  setup.rotary[2].p_M_centre = c_axis;
  const Point swung = pivot + about_y(tip - pivot, 48.0);
  expect_near(linear_axes(AxisChain(setup, p_T).for_part(axes(50, 60, -30, 0, 48, -20)).q) + p_T,
              c_axis + about_z(swung - c_axis, -20.0), "B and C");
}

TEST(AxisChain, AHeadTurnsTheTool) {
  AxisChainSetup setup = chain("", "XYZB");
  setup.rotary[1].p_M_centre = {0, 0, 40};
  const Point p_T(0, 0, -120);
  const Point tip = Point(50, 60, -30) + Point(0, 0, 40) + about_y(Point(0, 0, -160), 30.0);
  expect_near(linear_axes(AxisChain(setup, p_T).for_part(axes(50, 60, -30, 0, 30, 0)).q) + p_T, tip,
              "B in the head");
}

TEST(AxisChain, WhichLinearAxesAreUnderTheTableDoesNotMatterForTheTouchOnIt) {
  const Point p_T(0, 0, -120);
  const AxisPositions q_M = axes(50, 60, -30, -35, 0, 70);
  const AxisChain on_bed(chain("CA", "XYZ"), p_T);
  const AxisChain on_slides(chain("CAXY", "Z"), p_T);
  expect_near(linear_axes(on_bed.for_part(q_M).q), linear_axes(on_slides.for_part(q_M).q),
              "for part");
  const Point p_P(1, 2, 3);
  expect_near(on_bed.part_from_machine(q_M).inverse() * p_P,
              on_slides.part_from_machine(q_M).inverse() * p_P, "contact");
}

TEST(RealAxes, AContactGoesBackToTheMachine) {
  MachineSetup setup;
  setup.chain = chain("CA", "XYZ");
  setup.chain.rotary[0].p_M_centre = {0, 5, -450};
  setup.p_T_tip = {0.25, 0, -120};
  const RealAxes table(setup);
  const AxisPositions q_M = axes(50, 60, -30, -35, 0, 70);
  const Point& p_T = setup.p_T_tip;
  // Where the tip is for the part, there it is for the machine: at the axes.
  const Point tip_of_part = linear_axes(table.tip(q_M).q_M) + p_T;
  const Contact contact = table.in_machine(q_M, {tip_of_part, Point::UnitZ(), "cube"});
  expect_near(contact.p_M_point, linear_axes(q_M) + p_T, "point");
  // C does not move its own axis; A at -35 turns the table by +35 about X.
  expect_near(contact.n_M, about_x(Point::UnitZ(), 35.0), "normal");
  EXPECT_EQ(contact.part, "cube");
}

/// A plane of the part: all points p with n p = d; touched by the tip itself.
class PlaneOfPart final : public testing::WorldOfPieces {
 public:
  PlaneOfPart(const Point& n, double d, const Point& p_T) : n_(n), d_(d), p_T_(p_T) {}

 private:
  std::optional<SkipTrigger> trigger_on(const Sweep& sweep) override {
    const double from = n_.dot(linear_axes(sweep.q_M_from) + p_T_) - d_;
    const double to = n_.dot(linear_axes(sweep.q_M_to) + p_T_) - d_;
    if (from * to > 0.0) {
      return std::nullopt;
    }
    const double part = from / (from - to);
    const AxisPositions q = sweep.q_M_from + part * (sweep.q_M_to - sweep.q_M_from);
    return SkipTrigger{part, false, 0.0, Contact{linear_axes(q) + p_T_, n_, "plane"}};
  }

  Point n_;
  double d_;
  Point p_T_;
};

MachineSetup five_axis(const Point& p_T) {
  MachineSetup setup;
  setup.chain = chain("CA", "XYZ");
  setup.axes[3].present = setup.axes[5].present = true;
  setup.p_T_tip = p_T;
  setup.stopping = Stopping::Ideal;
  return setup;
}

TEST(FiveAxisMachine, TouchesAFaceOfATiltedPartWhereItIs) {
  const Point p_T(0, 0, -100);
  for (const double tilt : {-30.0, -90.0}) {
    for (const double turn : {0.0, 45.0, 200.0}) {
      // The face z = 10 of the part; where the probe comes down along Z.
      PlaneOfPart face({0, 0, 1}, 10.0, p_T);
      MachineSetup setup = five_axis(p_T);
      setup.q_M_start = axes(0, -40, 250, 0, 0, 0);
      MachiningCentre centre(setup, &face);
      ASSERT_TRUE(centre.move({axes(0, -40, 250, tilt, 0, turn), Traverse::Feed, 5000.0}).ok());
      LinearMove down{axes(0, -40, 50, tilt, 0, turn), Traverse::Feed, 300.0};
      if (tilt == -90.0) {
        down.q_M_end = axes(0, 90, 250, tilt, 0, turn);  // the face looks along +Y
      }
      const auto outcome = centre.move_until_skip(down);
      const auto* touched = std::get_if<Touched>(&outcome.value());
      // A at t turns the table by -t: normal (0, sin t, cos t), C does not matter for it.
      const double r = tilt * std::numbers::pi / 180.0;
      const Point n(0.0, std::sin(r), std::cos(r));
      if (touched == nullptr) {
        ADD_FAILURE() << tilt << ' ' << turn;
        continue;
      }
      const Point tip = linear_axes(touched->q_M_latched) + p_T;
      EXPECT_NEAR(n.dot(tip), 10.0, 1e-9) << tilt << ' ' << turn;
      EXPECT_LT((touched->contact->n_M - n).norm(), 1e-12);
      EXPECT_LT((touched->contact->p_M_point - tip).norm(), 1e-6);
    }
  }
}

/// Where no axis leads the tip there, it comes as near as any step of the axes brings it; the
/// distance is that of a complete orthogonal decomposition.
TEST(AxisChain, ComesAsNearAsItsAxesLead) {
  struct Lacking {
    const char* table_side;
    const char* tool_side;
    AxisPositions turned;
    const char* still;  // axes that add no direction
  };
  const Lacking kChains[] = {{"C", "XZ", axes(0, 0, 0, 0, 0, 30), "Y"},
                             {"BC", "Y", axes(0, 0, 0, 0, -25, 70), "XZ"},
                             {"XC", "YZ", axes(0, 0, 0, 0, 0, 90), "Y"},
                             {"XYB", "Z", axes(0, 0, 0, 0, 90, 0), "Z"}};
  const Point p_P(12.5, -40.0, 7.25);
  for (const Lacking& lacking : kChains) {
    const AxisChain machine(chain(lacking.table_side, lacking.tool_side), Point(1.0, 2.0, -80.0));
    const auto tip_from = [&](const AxisPositions& q_M) {
      return Point(linear_axes(machine.for_part(q_M).q) + Point(1.0, 2.0, -80.0));
    };
    const AxisPositions q_M = machine.axes_near(p_P, lacking.turned);
    const double distance = (tip_from(q_M) - p_P).norm();
    Eigen::Matrix3d directions;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      AxisPositions one = lacking.turned;
      one[axis] += 1.0;
      directions.col(axis) = tip_from(one) - tip_from(lacking.turned);
      for (const double step : {-0.01, 0.01}) {
        AxisPositions beside = q_M;
        beside[axis] += step;
        EXPECT_GE((tip_from(beside) - p_P).norm(), distance - 1e-12) << lacking.tool_side << axis;
      }
    }
    const Point way = p_P - tip_from(lacking.turned);
    const Point steps = directions.completeOrthogonalDecomposition().solve(way);
    EXPECT_NEAR(distance, (way - directions * steps).norm(), 1e-11) << lacking.tool_side;
    for (const char still : std::string_view(lacking.still)) {
      EXPECT_EQ(q_M[axis_index(still)], 0.0) << lacking.tool_side << still;
    }
  }
}

TEST(FiveAxisMachine, ATurningTableBringsThePartToTheProbe) {
  // The tip stands at (50, 0); the face x = 30 of the part turns to it: 50 cos C = 30.
  const Point p_T(0, 0, -100);
  PlaneOfPart face({1, 0, 0}, 30.0, p_T);
  MachineSetup setup = five_axis(p_T);
  setup.q_M_start = axes(50, 0, 100);
  MachiningCentre centre(setup, &face);
  const auto outcome =
      centre.move_until_skip(LinearMove{axes(50, 0, 100, 0, 0, 80), Traverse::Feed, 600.0});
  const auto& touched = std::get<Touched>(outcome.value());
  EXPECT_NEAR(touched.q_M_latched[5], std::acos(0.6) * 180.0 / std::numbers::pi, 1e-5);
}

}  // namespace
}  // namespace g31::machine::axis_chain_test

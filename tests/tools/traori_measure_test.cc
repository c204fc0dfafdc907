// MEAS under TRAORI while rotary axes turn: the ball's centre goes straight for the part, so where
// it touches a face, and how far the axes have turned by then, is known in closed form.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "tests/support/effort.h"
#include "tests/support/five_axis_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::traori_measure_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

const Point kOrigin(20, -30, -400);
constexpr double kBallRadiusMm = 3.0;

/// A machine, and the letters of its axes.
struct Machine {
  machine::AxisChainSetup chain;
  std::string axes;
};

std::vector<Machine> machines() {
  return {{k1(), "AC"}, {k2(), "BC"}, {k3(), "BC"}, {k4(), "CA"}, {k5(), "CB"}, {k6(), "BC"}};
}

/// A block whose top is the plane Z = 0 of G54.
const std::string kBlock =
    "[[part]]\nname = \"block\"\nshape = \"block\"\non = \"G54\"\nat = [0.0, 0.0, 0.0]\n"
    "length = 200.0\nwidth = 200.0\nheight = 50.0\n";

/// The tip that TRAORI leads is the ball's centre.
const std::string kBegin = "T1 M6\nG54 D1\n$TC_DP3[1,1]=117\nD1\nTRAORI\n";

const std::vector<std::string> kReadings = {"R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9"};

std::string read(const std::string& axes) {
  return fmt::format(
      "R1=$AA_MW[X] R2=$AA_MW[Y] R3=$AA_MW[Z] R4=$AA_MW[{0}] R5=$AA_MW[{1}] R6=$AC_MEA[1]\n"
      "R7=$AA_IW[Z] R8=$AA_MM[{0}] R9=$AA_IM[{0}]\n",
      axes[0], axes[1]);
}

/// A way of the ball's centre in the part and of both axes.
struct Way {
  Point from;
  Point to;
  Eigen::Vector2d from_deg;
  Eigen::Vector2d to_deg;
};

std::string program(const Machine& machine, const Way& way, const std::string& measure) {
  const auto words = [&](const Point& p, const Eigen::Vector2d& deg) {
    return fmt::format("X{:.12f} Y{:.12f} Z{:.12f} {}={:.12f} {}={:.12f}", p.x(), p.y(), p.z(),
                       machine.axes[0], deg[0], machine.axes[1], deg[1]);
  };
  return kBegin + "G0 " + words(way.from, way.from_deg) + "\n" + measure + " G1 F600 " +
         words(way.to, way.to_deg) + "\n" + read(machine.axes);
}

TEST(TraoriMeasure, AFaceIsTouchedWhereTheBallGetsThereAlongItsTrueWay) {
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 31}, n++) - 1.0); };
  double worst = 0.0;
  const int runs = of_many(60);
  for (int i = 0; i < runs; ++i) {
    const Machine m = machines().at(static_cast<std::size_t>(i) % 6);
    Way way;
    way.from = {random(30), random(30), 12.0 + random(3)};
    way.to = {random(30), random(30), -4.0 + random(3)};
    // Axes that tilt the ball's stem only so far that it stays off the block.
    const auto turned = [&](char axis) { return random(axis == 'C' ? 120.0 : 15.0); };
    way.from_deg = {turned(m.axes[0]), turned(m.axes[1])};
    way.to_deg = {turned(m.axes[0]), turned(m.axes[1])};
    const MeasuringRun run = run_on_sheets(
        program(m, way, "MEAS=1"),
        {five_axis_sheet(m.chain, kOrigin), kBlock, "[machine]\nstopping = \"ideal\"\n"},
        kReadings);
    SCOPED_TRACE(fmt::format("way {} on {}\n{}", i, m.axes, run.output.errors));
    ASSERT_EQ(run.alarm(), 0);
    const double share = (way.from.z() - kBallRadiusMm) / (way.from.z() - way.to.z());
    const Point at = way.from + share * (way.to - way.from);
    const Eigen::Vector2d deg = way.from_deg + share * (way.to_deg - way.from_deg);
    EXPECT_EQ(run.at("R6"), 1.0);
    EXPECT_NEAR(run.at("R4"), deg[0], 1e-5);
    EXPECT_NEAR(run.at("R5"), deg[1], 1e-5);
    EXPECT_NEAR(run.at("R8"), deg[0], 1e-5);
    EXPECT_NEAR(run.at("R9"), deg[0], 1e-5) << "the rest of the way is not travelled";
    EXPECT_NEAR(run.at("R7"), kBallRadiusMm, 1e-6);
    const Point measured(run.at("R1"), run.at("R2"), run.at("R3"));
    EXPECT_LT((measured - at).norm(), 1e-5);
    worst = std::max(worst, std::abs(measured.z() - kBallRadiusMm));
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(TraoriMeasure, WithoutATouchItGoesToItsEndAndMeawsGoesOn) {
  const Way above{{5, 5, 20}, {-5, 8, 10}, {0, 0}, {20, 60}};
  const Way down{{5, 5, 20}, {-5, 8, 2.5}, {0, 0}, {20, 60}};
  for (const Machine& m : machines()) {
    const std::vector<std::string> sheets = {five_axis_sheet(m.chain, kOrigin), kBlock};
    const MeasuringRun none = run_on_sheets(program(m, above, "MEAS=1"), sheets, kReadings);
    EXPECT_EQ(none.alarm(), 0) << none.output.errors;
    EXPECT_EQ(none.at("R6"), 0.0);
    EXPECT_NEAR(none.at("R7"), 10.0, 1e-9);
    EXPECT_NEAR(none.at("R9"), 20.0, 1e-12);
    const MeasuringRun on = run_on_sheets(program(m, down, "MEAW=1"), sheets, kReadings);
    EXPECT_EQ(on.alarm(), 0) << on.output.errors;
    EXPECT_EQ(on.at("R6"), 1.0);
    EXPECT_NEAR(on.at("R3"), kBallRadiusMm, 1e-6);
    EXPECT_NEAR(on.at("R7"), 2.5, 1e-9);
    EXPECT_NEAR(on.at("R9"), 20.0, 1e-12);
  }
}

TEST(TraoriMeasure, ItReadsOffByWhatTheControlBelievesWrongly) {
  // The centre of C is believed off by e: the tip is R e - e from where the control has it, R
  // about C by its angle; square to the face that does not show, along it it does.
  const Point e(0.05, -0.04, 0.0);
  machine::AxisChainSetup believed = k1();
  believed.rotary[2].p_M_centre += e;
  const Way way{{40, 10, -20}, {-10, 10, -20}, {0, 0}, {0, 90}};
  const std::string wall =
      "[[part]]\nname = \"wall\"\nshape = \"block\"\non = \"G54\"\nat = [-50.0, 0.0, 10.0]\n"
      "length = 100.0\nwidth = 200.0\nheight = 80.0\n";  // its face is X = 0
  const MeasuringRun run =
      run_on_sheets(program({k1(), "AC"}, way, "MEAS=1"),
                    {five_axis_sheet(k1(), kOrigin), wall, believed_sheet(believed)}, kReadings);
  ASSERT_EQ(run.alarm(), 0) << run.output.errors;
  // X_true = x + ((R - 1) e)_x = 3, with x = 40 - 50 s and C = 90 s.
  double low = 0.0;
  double high = 1.0;
  for (int i = 0; i < 200; ++i) {
    const double s = 0.5 * (low + high);
    const double c = s * std::numbers::pi / 2.0;
    const double x = 40.0 - 50.0 * s + (std::cos(c) - 1.0) * e.x() - std::sin(c) * e.y();
    (x > kBallRadiusMm ? low : high) = s;
  }
  EXPECT_NEAR(run.at("R1"), 40.0 - 50.0 * low, 1e-6);
  EXPECT_NEAR(run.at("R5"), 90.0 * low, 1e-5);
  EXPECT_GT(std::abs(run.at("R1") - kBallRadiusMm), 0.005);
}

TEST(TraoriMeasure, APushTooDeepIsACollisionOnTheCurvedWay) {
  const Way deep{{5, 5, 20}, {-5, 8, -10}, {0, 0}, {20, 60}};
  const Machine m = machines().front();
  const MeasuringRun run = run_on_sheets(
      program(m, deep, "MEAW=1"),
      {five_axis_sheet(m.chain, kOrigin), kBlock, "[machine]\nstopping = \"ideal\"\n"}, kReadings);
  EXPECT_EQ(run.output.exit_code, 4) << run.output.errors;
}

/// The tool's direction for the part, as the axes stand.
std::string direction(int first) {
  return fmt::format("R{}=$P_TOOLO[1] R{}=$P_TOOLO[2] R{}=$P_TOOLO[3]\n", first, first + 1,
                     first + 2);
}

/// From (10, 5, 20) to (-5, 15, -10): the ball's centre is 3 above the face after 17 of 30 mm, and
/// the tool 17/30 of the angle between its directions on from the first.
TEST(TraoriMeasure, AlongAGreatCircleTheToolIsWhereTheCircleHasIt) {
  const double fraction = 17.0 / 30.0;
  const Point at = Point(10, 5, 20) + fraction * Point(-15, 10, -30);
  for (const Machine& m : machines()) {
    for (const char* const path : {"ORIVECT", "ORIAXES"}) {
      SCOPED_TRACE(m.axes + " " + path);
      const bool is_great = std::string(path) == "ORIVECT";
      const MeasuringRun run =
          run_on_sheets(kBegin + path + "\nG0 X10 Y5 Z20 A3=0.5 B3=0.1 C3=1\n" + direction(11) +
                            "MEAS=1 G1 F600 X-5 Y15 Z-10 A3=-0.2 B3=0.6 C3=1\n"
                            "R1=$AA_MW[X] R2=$AA_MW[Y] R3=$AA_MW[Z] R6=$AC_MEA[1]\n" +
                            fmt::format("R4=$AA_MW[{0}] R5=$AA_MW[{1}]\nG0 Z50\n{0}=R4 {1}=R5\n",
                                        m.axes[0], m.axes[1]) +
                            direction(21),
                        {five_axis_sheet(m.chain, kOrigin), kBlock},
                        {"R1", "R2", "R3", "R6", "R11", "R12", "R13", "R21", "R22", "R23"});
      EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
      EXPECT_EQ(run.at("R6"), 1.0);
      EXPECT_EQ(run.output.document.at("touches").size(), 1U);
      if (is_great) {
        EXPECT_NEAR(run.at("R1"), at.x(), 1e-5);
        EXPECT_NEAR(run.at("R2"), at.y(), 1e-5);
        EXPECT_NEAR(run.at("R3"), 3.0, 1e-5);
      }
      const Point from = Point(0.5, 0.1, 1).normalized();
      const Point to = Point(-0.2, 0.6, 1).normalized();
      EXPECT_NEAR(run.at("R11"), from.x(), 1e-9);
      const double angle = std::acos(from.dot(to));
      const Point there =
          (std::sin((1 - fraction) * angle) * from + std::sin(fraction * angle) * to) /
          std::sin(angle);
      const double off = (Point(run.at("R21"), run.at("R22"), run.at("R23")) - there).norm();
      // A piece of 1 degree strays by 0.00004; where the axes go evenly, they lead elsewhere.
      EXPECT_EQ(off < 3e-4, is_great) << off;
    }
  }
}

}  // namespace
}  // namespace g31::testing::traori_measure_test

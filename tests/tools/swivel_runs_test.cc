// CYCLE800 on machines with Hirth axes, 45 degree heads and fork heads, and its retractions: where
// the axes go, and that places of the plane are where they are in the part although the tool may
// not be quite square to it.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "machine/kinematics/plane_rotation.h"
#include "tests/support/effort.h"
#include "tests/support/five_axis_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::swivel_runs_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

const Point kOrigin(60, -40, -420);

struct Machine {
  const char* name;
  machine::AxisChainSetup chain;
  std::string axes;  ///< letters of rotary axes 1 and 2
};

std::vector<Machine> machines() {
  return {{"tables", k1(), "AC"},
          {"head and table", k2(), "BC"},
          {"45 degree head", k3(), "BC"},
          {"fork head", k4(), "CA"},
          {"45 degree and fork", k5(), "CB"},
          {"45 degree table", k6(), "BC"}};
}

/// Where the tip is in the part, the axes at q_M, by matrices of the machine.
Point tip_at(const machine::AxisChainSetup& chain, const AxisPositions& q_M) {
  const machine::AxisChain forward(chain, kTool);
  return linear_axes(forward.for_part(q_M).q) + kTool;
}

const std::vector<std::string> kReadings = {"R1", "R2", "R3", "R4",  "R5",  "R6",
                                            "R7", "R8", "R9", "R11", "R12", "R13"};

/// Reads both rotary axes without teeth (R1, R2), with them (R3, R4), and the axes at two places.
std::string read_twice(const std::string& axes, const std::string& call, const std::string& teeth) {
  return fmt::format(
      "T1 M6\nG54 D1\n{0}\nR1=$AA_IM[{1}] R2=$AA_IM[{2}]\nCYCLE800()\n{3}\n{0}\n"
      "R3=$AA_IM[{1}] R4=$AA_IM[{2}]\nG0 X0 Y0 Z0\n"
      "R5=$AA_IM[X] R6=$AA_IM[Y] R7=$AA_IM[Z]\nX15 Y-10 Z2\n"
      "R11=$AA_IM[X] R12=$AA_IM[Y] R13=$AA_IM[Z]\nR8=0 R9=0\n",
      call, axes[0], axes[1], teeth);
}

AxisPositions position(const MeasuringRun& run, const Machine& m, int first) {
  AxisPositions q_M = AxisPositions::Zero();
  for (int i = 0; i < 3; ++i) {
    q_M[i] = run.at(fmt::format("R{}", first + i));
  }
  q_M[axis_index(m.axes[0])] = run.at("R3");
  q_M[axis_index(m.axes[1])] = run.at("R4");
  return q_M;
}

TEST(SwivelRuns, HirthAxesStandOnTheNearestToothAndTheFrameTakesTheRest) {
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 91}, n++) - 1.0); };
  const int runs = of_many(60);
  double most_rest = 0.0;
  for (int i = 0; i < runs; ++i) {
    const Machine m = machines().at(static_cast<std::size_t>(i) % 6);
    const Point before(random(40), random(40), random(20));
    const Point angles(random(30), random(30), random(60));
    const double pitch1 = 2.0 + i % 5;  // whole parts of a turn
    const double pitch2 = 1.0 + 0.5 * (i % 4);
    const double offset1 = std::round(random(5.0));
    const std::string call = fmt::format(
        "CYCLE800(0,\"\",0,57,{:.9f},{:.9f},{:.9f},{:.9f},{:.9f},{:.9f},0,0,0,{})", before.x(),
        before.y(), before.z(), angles.x(), angles.y(), angles.z(), i % 2 == 0 ? 1 : -1);
    const std::string teeth = fmt::format(
        "$TC_CARR28[1]={:.1f} $TC_CARR29[1]={:.1f} $TC_CARR26[1]={:.1f}", pitch1, pitch2, offset1);
    SCOPED_TRACE(fmt::format("set-up {} on {}: {} {}", i, m.name, call, teeth));
    const MeasuringRun run = run_on_sheets(read_twice(m.axes, call, teeth),
                                           {five_axis_sheet(m.chain, kOrigin)}, kReadings);
    ASSERT_EQ(run.alarm(), 0) << run.output.errors;
    const double rest1 = run.at("R3") - run.at("R1");
    const double rest2 = run.at("R4") - run.at("R2");
    EXPECT_LE(std::abs(std::remainder(rest1, 360.0)), pitch1 / 2.0 + 1e-9);
    EXPECT_LE(std::abs(std::remainder(rest2, 360.0)), pitch2 / 2.0 + 1e-9);
    EXPECT_NEAR(std::remainder(run.at("R3") - offset1, pitch1), 0.0, 1e-9);
    EXPECT_NEAR(std::remainder(run.at("R4"), pitch2), 0.0, 1e-9);
    most_rest = std::max(most_rest, std::abs(std::remainder(rest1, 360.0)));
    const Eigen::Matrix3d tilt = machine::about_turned_axes(
        {machine::AxisTurn{0, angles[0]}, {1, angles[1]}, {2, angles[2]}});
    const Point origin = kOrigin + before;
    EXPECT_LT((tip_at(m.chain, position(run, m, 5)) - origin).norm(), 1e-9);
    const Point aside = origin + tilt * Point(15, -10, 2);
    EXPECT_LT((tip_at(m.chain, position(run, m, 11)) - aside).norm(), 1e-9);
  }
  EXPECT_GT(most_rest, 1.0) << "teeth that make no difference show nothing";
}

/// Without teeth the same planes are square to the tool: its direction is the plane's normal.
TEST(SwivelRuns, TheToolIsSquareToThePlaneOnEveryKindOfMachine) {
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 92}, n++) - 1.0); };
  const int runs = of_many(60);
  for (int i = 0; i < runs; ++i) {
    const Machine m = machines().at(static_cast<std::size_t>(i) % 6);
    const Point angles(random(40), random(40), random(90));
    const std::string call =
        fmt::format("CYCLE800(0,\"\",0,57,0,0,0,{:.9f},{:.9f},{:.9f},0,0,0,{})", angles.x(),
                    angles.y(), angles.z(), i % 2 == 0 ? 1 : -1);
    SCOPED_TRACE(fmt::format("set-up {} on {}: {}", i, m.name, call));
    const MeasuringRun run =
        run_on_sheets(read_twice(m.axes, call, ""), {five_axis_sheet(m.chain, kOrigin)}, kReadings);
    ASSERT_EQ(run.alarm(), 0) << run.output.errors;
    const machine::AxisChain forward(m.chain, kTool);
    const Point tool = forward.for_part(position(run, m, 5)).tilt * Point(Point::UnitZ());
    const Eigen::Matrix3d tilt = machine::about_turned_axes(
        {machine::AxisTurn{0, angles[0]}, {1, angles[1]}, {2, angles[2]}});
    EXPECT_LT((tool - tilt.col(2)).norm(), 1e-10);
  }
}

struct Retraction {
  const char* arguments;  ///< _FR
  double way;             ///< _FR_I
  Point expected;
};

TEST(SwivelRuns, RetractionsGoWhereTheDataHaveThem) {
  // Limits at 3000 mm; the data say X 50, Y -70, Z 200.
  const Point begin(100, -60, -180);  // X40 Y-20 Z120 of G54, and the tool
  const std::vector<Retraction> rows = {
      {"0", 0, begin},
      {"1", 0, {begin.x(), begin.y(), 200}},
      {"2", 0, {50, -70, 200}},
      {"4", 0, {begin.x(), begin.y(), 3000}},
      {"5", 35.5, {begin.x(), begin.y(), begin.z() + 35.5}},
      {"6", 0, {begin.x(), begin.y(), 200}},
      {"7", 0, {50, begin.y(), begin.z()}},
      {"8", 0, {begin.x(), -70, begin.z()}},
  };
  for (const Machine& m : machines()) {
    for (const Retraction& row : rows) {
      SCOPED_TRACE(fmt::format("{} _FR {}", m.name, row.arguments));
      const MeasuringRun run = run_on_sheets(
          fmt::format("T1 M6\nG54 D1\n$TC_CARR38[1]=50 $TC_CARR39[1]=-70 $TC_CARR40[1]=200\n"
                      "G0 X40 Y-20 Z120\nCYCLE800({},\"\",0,57,0,0,0,15,0,0,0,0,0,1,{})\n"
                      "R5=$AA_IM[X] R6=$AA_IM[Y] R7=$AA_IM[Z] R3=$AA_IM[{}] R4=$AA_IM[{}]\n",
                      row.arguments, row.way, m.axes[0], m.axes[1]),
          {five_axis_sheet(m.chain, kOrigin)}, kReadings);
      ASSERT_EQ(run.alarm(), 0) << run.output.errors;
      EXPECT_GT(std::abs(run.at("R3")) + std::abs(run.at("R4")), 1.0) << "the axes turn behind it";
      const Point at(run.at("R5"), run.at("R6"), run.at("R7"));
      EXPECT_LT((at - row.expected).norm(), 1e-9) << at.transpose();
    }
  }
}

TEST(SwivelRuns, RetractionInTheToolsDirectionFollowsATurnedHead) {
  // B 30 of the head: the tool points along (sin 30, 0, cos 30); X or Z ends the way first.
  const Machine m = machines().at(1);
  const std::string sheet = five_axis_sheet(m.chain, kOrigin);
  const Point along(0.5, 0.0, std::sqrt(0.75));
  const auto at = [&](const std::string& again, int first) {
    const MeasuringRun run = run_on_sheets(
        "T1 M6\nG54 D1\nCYCLE800(0,\"\",0,192,0,0,0,30,0,0,0,0,0,1)\nG0 X0 Y0 Z10\n"
        "R5=$AA_IM[X] R6=$AA_IM[Y] R7=$AA_IM[Z]\n" +
            again + "\nR11=$AA_IM[X] R12=$AA_IM[Y] R13=$AA_IM[Z] R3=0 R4=0\n",
        {sheet}, kReadings);
    EXPECT_EQ(run.alarm(), 0) << run.output.errors;
    return Point(position(run, m, first).head<3>());
  };
  const std::string by_way = "CYCLE800(5,\"\",0,192,0,0,0,0,0,0,0,0,0,1,80)";
  EXPECT_LT((at(by_way, 11) - (at(by_way, 5) + 80.0 * along)).norm(), 1e-9);
  const std::string to_limit = "CYCLE800(4,\"\",0,192,0,0,0,0,0,0,0,0,0,1)";
  const Point from = at(to_limit, 5);
  const double way = std::min((3000.0 - from.x()) / along.x(), (3000.0 - from.z()) / along.z());
  EXPECT_LT((at(to_limit, 11) - (from + way * along)).norm(), 1e-6);
}

TEST(SwivelRuns, AlarmsAboutRotationsInFramesAreShownWhereTheyAreWanted) {
  const std::string sheet = five_axis_sheet(k1(), kOrigin);
  const std::string swivel = "\nCYCLE800(0,\"\",0,57,0,0,0,10,0,0,0,0,0,1)";
  const auto alarm_of = [&](const std::string& before) {
    return run_on_sheets("T1 M6\n" + before + swivel, {sheet}, {}).alarm();
  };
  const std::string turned_offset = "$P_UIFR[1]=CROT(Z,5)\nG54 D1\n";
  const std::string turned_base = "$P_CHBFR[0]=CROT(Z,5)\n";
  EXPECT_EQ(alarm_of(turned_offset), 0);
  EXPECT_EQ(alarm_of("$SCS_MILL_SWIVEL_ALARM_MASK=2\n" + turned_offset), 0);
  EXPECT_EQ(alarm_of("$SCS_MILL_SWIVEL_ALARM_MASK=1\n" + turned_offset), 61186);
  EXPECT_EQ(alarm_of("$SCS_MILL_SWIVEL_ALARM_MASK=1\n" + turned_base + "G54 D1\n"), 61186);
  EXPECT_EQ(alarm_of("$SCS_MILL_SWIVEL_ALARM_MASK=1\n" + turned_base + "G500 D1\n"), 0);
  EXPECT_EQ(alarm_of("$SCS_MILL_SWIVEL_ALARM_MASK=2\n" + turned_base + "G500 D1\n"), 61187);
  EXPECT_EQ(alarm_of("$SCS_MILL_SWIVEL_ALARM_MASK=3\nG54 D1\n"), 0);
}

}  // namespace
}  // namespace g31::testing::swivel_runs_test

// ORIVECT: the tool turns along a great circle to a programmed direction, on straight ways and on
// arcs, whatever the machine: each direction on the way is in the plane of the first and the last.

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/five_axis_run.h"
#include "tests/support/run_program.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::great_circle_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

const Point kOrigin(20, -30, -400);
const std::vector<machine::AxisChainSetup> kMachines = {k1(), k2(), k3(), k4(), k5(), k6()};

/// Where the axes stand at the end of each move.
std::vector<AxisPositions> ends_of(const machine::AxisChainSetup& machine,
                                   const std::string& program) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(
      "main.mpf", "G710 G90 G17 G40\nT1 M6\nG54 D1\nTRAORI\nORIWKS\n" + program + "M30\n")};
  options.setups = {folder.write("machine.toml", five_axis_sheet(machine, kOrigin))};
  options.control = "sinumerik-828d";
  options.moves = true;
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  std::vector<AxisPositions> ends;
  for (const auto& move : output.document["moves"]) {
    AxisPositions q_M = AxisPositions::Zero();
    for (std::size_t i = 0; i < move["to"].size(); ++i) {
      q_M[static_cast<Eigen::Index>(i)] = move["to"][i];
    }
    ends.push_back(q_M);
  }
  return ends;
}

Point direction_at(const machine::AxisChainSetup& machine, const AxisPositions& q_M) {
  return machine::AxisChain(machine, Point::Zero()).for_part(q_M).tilt * Point::UnitZ();
}

/// Work coordinates of the tip.
Point tip_at(const machine::AxisChainSetup& machine, const AxisPositions& q_M) {
  return linear_axes(machine::AxisChain(machine, kTool).for_part(q_M).q) + kTool - kOrigin;
}

/// How far directions, also half way between two of them, are off the great circle through `from`
/// and `to`.
double off_circle(const machine::AxisChainSetup& machine, const std::vector<AxisPositions>& ends,
                  const Point& from, const Point& to) {
  const Point normal = from.cross(to).normalized();
  double worst = 0.0;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    const AxisPositions middle = (ends[i - 1] + ends[i]) / 2.0;
    worst = std::max(worst, std::abs(direction_at(machine, ends[i]).dot(normal)));
    worst = std::max(worst, std::abs(direction_at(machine, middle).dot(normal)));
  }
  return worst;
}

/// Behind the first turn, a dwell.
std::vector<AxisPositions> behind_dwell(const std::vector<AxisPositions>& ends) {
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i] == ends[i - 1]) {
      return {ends.begin() + static_cast<std::ptrdiff_t>(i), ends.end()};
    }
  }
  ADD_FAILURE() << "no dwell";
  return ends;
}

TEST(GreatCircle, NoMachineJumpsToItsOtherPosition) {
  const Point from = Point(.1, -.3, 1).normalized();
  const Point to = Point(.1, .3, 1).normalized();
  for (const machine::AxisChainSetup& machine : kMachines) {
    const auto ends = behind_dwell(
        ends_of(machine, "G1 F3000 X10 Y5 Z3\nA3=.1 B3=-.3 C3=1\nG4 F0.3\nA3=.1 B3=.3 C3=1\n"));
    EXPECT_GT(ends.size(), 30U);
    EXPECT_LT((direction_at(machine, ends.front()) - from).norm(), 1e-6);
    EXPECT_LT((direction_at(machine, ends.back()) - to).norm(), 1e-6);
    EXPECT_LT(off_circle(machine, ends, from, to), 1e-3);
  }
}

TEST(GreatCircle, IsKeptOnArcs) {
  const Point from = Point(.3, .3, 1).normalized();
  const Point to = Point(.3, -.3, 1).normalized();
  for (const machine::AxisChainSetup& machine : kMachines) {
    const auto ends = behind_dwell(ends_of(
        machine,
        "G1 F3000 X0 Y0 Z3\nA3=.3 B3=.3 C3=1\nG4 F0.3\nG2 X20 Y0 I10 J0 F500 A3=.3 B3=-.3 C3=1\n"));
    EXPECT_LT((direction_at(machine, ends.back()) - to).norm(), 1e-6);
    EXPECT_LT(off_circle(machine, ends, from, to), 1e-3);
    for (const AxisPositions& q_M : ends) {
      const Point tip = tip_at(machine, q_M);
      EXPECT_NEAR(std::hypot(tip.x() - 10.0, tip.y()), 10.0, 1e-6);
      EXPECT_NEAR(tip.z(), 3.0, 1e-6);
    }
  }
}

TEST(GreatCircle, OneBlockIsOneForCutterCompensation) {
  for (const machine::AxisChainSetup& machine : kMachines) {
    const auto ends =
        ends_of(machine, "G0 X0 Y0 Z10\nG41 G1 X5 Y0 F1000\nX20\nA3=.2 C3=1\nY20\nG40 X30\n");
    EXPECT_GT(ends.size(), 10U);
    const Point tip = tip_at(machine, ends.back());
    EXPECT_LT((tip - Point(30, 20, 10)).norm(), 1e-6);
  }
}

/// The tip and a point of the holder go through the mirror alike.
TEST(GreatCircle, AMirrorMirrorsDirections) {
  const Point to = Point(-.3, 0, 1).normalized();
  for (const machine::AxisChainSetup& machine : kMachines) {
    const auto ends = ends_of(machine, "MIRROR X0\nG1 F3000 X10 Y5 Z3\nA3=.3 C3=1\n");
    EXPECT_LT((direction_at(machine, ends.back()) - to).norm(), 1e-6);
    const auto angles =
        ends_of(machine, "MIRROR X0\nG1 F3000 X10 Y5 Z3\nORIRPY\nA2=0 B2=20 C2=0\n");
    const double deg = std::numbers::pi / 180.0;
    EXPECT_LT(
        (direction_at(machine, angles.back()) - Point(-std::sin(20 * deg), 0, std::cos(20 * deg)))
            .norm(),
        1e-6);
  }
}

}  // namespace
}  // namespace g31::testing::great_circle_test

// The measuring cycles in planes that CYCLE800 swivels, on machines by chance: every feature reads
// its true size and place in the coordinates of the plane, and a work offset that is corrected
// there leaves nothing to correct.

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numbers>
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

namespace g31::testing::swivelled_cycles_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

/// A part in the plane, its origin 0.2 and -0.15 beside that of the plane, turned by `yaw_deg` in
/// it.
struct Feature {
  const char* name;
  const char* shape;
  const char* sizes;
  double height;  ///< of the part's origin above the plane
  double yaw_deg;
  const char* program;
  std::vector<ExpectedValue> expected;
};

const Feature kFeatures[] = {
    {"hole",
     "ring",
     "bore = 40.03",
     0,
     0,
     "Z-5\nCYCLE977(1,,,1,40,,,2,5)",
     {{"_OVR[4]", 40.03}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.15}}},
    {"spigot",
     "cylinder",
     "diameter = 30.03",
     0,
     0,
     "Z5\nCYCLE977(2,,,1,30,,,3,5,,-15)",
     {{"_OVR[4]", 30.03}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.15}}},
    {"groove",
     "groove",
     "width = 20.04",
     0,
     0,
     "Z-5\nCYCLE977(3,,,1,20,,,2,5,,,,,1)",
     {{"_OVR[4]", 20.04}, {"_OVR[5]", 0.2}}},
    {"rib along the 1st axis",
     "rib",
     "width = 20.04",
     0,
     90,
     "Z5\nCYCLE977(4,,,1,20,,,2,5,,-12,,,2)",
     {{"_OVR[4]", 20.04}, {"_OVR[6]", -0.15}}},
    {"pocket",
     "pocket",
     "length = 60.02\nwidth = 40.05",
     0,
     0,
     "Z-5\nCYCLE977(5,,,1,,60,40,2,5)",
     {{"_OVR[4]", 60.02}, {"_OVR[5]", 40.05}, {"_OVR[6]", 0.2}, {"_OVR[7]", -0.15}}},
    {"block",
     "block",
     "length = 60.02\nwidth = 40.05",
     0,
     0,
     "Z5\nCYCLE977(6,,,1,,60,40,3,5,,-12)",
     {{"_OVR[4]", 60.02}, {"_OVR[5]", 40.05}, {"_OVR[6]", 0.2}, {"_OVR[7]", -0.15}}},
    {"side",
     "block",
     "length = 60.02",
     0,
     0,
     "X-45\nZ-5\nCYCLE978(0,,,1,-30,5,5,1,1)",
     {{"_OVR[4]", 0.2 - 30.01}}},
    {"top",
     "block",
     "length = 60.02",
     0.12,
     0,
     "Z8\nCYCLE978(0,,,1,0,3,5,3,2)",
     {{"_OVR[4]", 0.12}}},
    {"arc of a hole",
     "ring",
     "bore = 40.03\nsagitta = 0.000002",
     0,
     0,
     "Z-5\nCYCLE979(1,,,1,40,2,5,0,0,10,70)",
     {{"_OVR[4]", 40.03}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.15}}},
    {"arc of a spigot, probe turned along",
     "cylinder",
     "diameter = 30.03\nsagitta = 0.000002",
     0,
     0,
     "X-30\nZ-5\nCYCLE979(21002,,,1,30,5,5,0,0,180,-60)",
     {{"_OVR[4]", 30.03}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.15}}},
    {"corner",
     "block",
     "",
     0,
     3,
     "X-42 Y-32\nZ-5\nCYCLE961(16,,1,-10,-32,15,-32,-42,0,,,,,,,,12,15)",
     {{"_OVR[4]", 3.0}}},
    {"edge",
     "block",
     "",
     0,
     3,
     "X-20 Y-27\nZ-5\nCYCLE998(5,,,1,,,,6,5,102,1,30)",
     {{"_OVR[4]", 3.0}}},
    {"ball",
     "sphere",
     "diameter = 25.03",
     0.12,
     0,
     "Z20\nCYCLE997(1101019,,1,25,2,5,15,90,0,0,0)",
     {{"_OVR[4]", 25.03}, {"_OVR[5]", 0.2}, {"_OVR[6]", -0.15}, {"_OVR[7]", 0.12}}},
    {"ball, probe turned along, then the offset",
     "sphere",
     "diameter = 25.03",
     0.12,
     0,
     "Z20\nCYCLE997(1102119,1,1,25,2,5,15,90,0,0,0)\nG54\nX0 Y0\nR1=_OVR[5]\n"
     "CYCLE997(1101019,,1,25,2,5,15,90,0,0,0)",
     {{"R1", 0.2}, {"_OVR[5]", 0.0}, {"_OVR[6]", 0.0}, {"_OVR[7]", 0.0}}},
    {"hole, then the offset",
     "ring",
     "bore = 40.03",
     0,
     0,
     "Z-5\nCYCLE977(101,10001,,1,40,,,2,5)\nG54\nX0 Y0\nCYCLE977(1,,,1,40,,,2,5)",
     {{"_OVR[5]", 0.0}, {"_OVR[6]", 0.0}}},
};

/// How CYCLE800 turns: its digits, the axes in their order, and the most that the third angle is.
/// 64 is a solid angle: about Z, then about the new Y.
struct Mode {
  int digits;
  std::array<int, 3> axes;
  double third_deg = 30.0;
};
const Mode kModes[] = {{57, {0, 1, 2}}, {45, {0, 2, 1}}, {54, {1, 0, 2}},     {30, {1, 2, 0}},
                       {39, {2, 0, 1}}, {27, {2, 1, 0}}, {64, {2, 1, 2}, 0.0}};

/// A machine by chance: one of the six, its lines moved and tilted.
machine::AxisChainSetup by_chance(std::uint64_t& n, std::size_t which) {
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 7}, n++) - 1.0); };
  machine::AxisChainSetup chain = std::vector{k1(), k2(), k3(), k4(), k5(), k6()}.at(which % 6);
  for (machine::RotaryLine& line : chain.rotary) {
    line.p_M_centre += Point(random(20), random(20), random(20));
    line.axis_M += Point(random(0.02), random(0.02), random(0.02));
  }
  return chain;
}

std::string placed(const Feature& feature, const Point& at, const Eigen::Matrix3d& turn) {
  const Point rotate = Point(std::atan2(turn(2, 1), turn(2, 2)), std::asin(-turn(2, 0)),
                             std::atan2(turn(1, 0), turn(0, 0))) *
                       180.0 / std::numbers::pi;
  return fmt::format(
      "[[part]]\nname = \"{0}\"\nshape = \"{0}\"\non = \"G54\"\nat = [{1:.17g}, {2:.17g}, "
      "{3:.17g}]\nrotate_deg = [{4:.17g}, {5:.17g}, {6:.17g}]\n{7}\n",
      feature.shape, at.x(), at.y(), at.z(), rotate.x(), rotate.y(), rotate.z(), feature.sizes);
}

/// @param set_up  chooses machine, direction and what holds the tip
void expect_feature(const Feature& feature, std::size_t set_up, const Mode& mode,
                    std::uint64_t& n) {
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 7}, n++) - 1.0); };
  const machine::AxisChainSetup chain = by_chance(n, set_up);
  const Point before(random(40), random(40), random(20));
  const Point angles(random(30), random(30), random(mode.third_deg));
  const Point after(random(5), random(5), random(3));
  const Eigen::Matrix3d tilt =
      machine::about_turned_axes({machine::AxisTurn{mode.axes[0], angles[0]},
                                  {mode.axes[1], angles[1]},
                                  {mode.axes[2], angles[2]}});
  const Point at = before + tilt * (after + Point(0.2, -0.15, feature.height));
  const std::string part =
      placed(feature, at, tilt * machine::turn_about(machine::AxisTurn{2, feature.yaw_deg}));
  const std::string program = fmt::format(
      "T1 M6\nG54 D1\n{}CYCLE800(0,\"\",{},{},{:.12f},{:.12f},{:.12f},{:.12f},{:.12f},{:.12f},"
      "{:.12f},{:.12f},{:.12f},{})\nG0 X0 Y0 Z50\n{}\n",
      set_up % 3 == 1 ? "TRAORI\n" : "", set_up % 5 == 0 ? 10 : 0, mode.digits, before.x(),
      before.y(), before.z(), angles[0], angles[1], angles[2], after.x(), after.y(), after.z(),
      set_up % 2 == 0 ? 1 : -1, feature.program);
  SCOPED_TRACE(fmt::format("{}, set-up {}\n{}\n{}", feature.name, set_up, part, program));
  const Point offset(random(100), random(100), -400 + random(30));
  const MeasuringRun run =
      run_on_sheets(program, {five_axis_sheet(chain, offset), part}, names_of(feature.expected));
  expect_values(run, feature.expected, 1e-6);
}

TEST(SwivelledCycles, EveryFeatureReadsItsTrueSizeAndPlace) {
  std::uint64_t n = 0;
  std::size_t tried = 0;
  const std::size_t set_ups = of_many(6U);
  for (const Feature& feature : kFeatures) {
    for (std::size_t i = 0; i < set_ups; ++i) {
      expect_feature(feature, i, kModes[tried++ % std::size(kModes)], n);
    }
  }
}

}  // namespace
}  // namespace g31::testing::swivelled_cycles_test

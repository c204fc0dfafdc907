// The same hole in the same tilted plane, measured by CYCLE977 on a SINUMERIK and by G31 on a
// Fanuc to the same programmed points of the plane: both controls reckon the axes their own way,
// CYCLE800 against G68.2 and G53.1, and may choose other positions of the rotary axes.  Touch by
// touch they read the same place, and the ball meets the same point of the part.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
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

namespace g31::testing::dialects_agree_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

/// As programs of both controls write it: three decimals.
double written(double value) {
  return std::round(value * 1000.0) / 1000.0;
}

/// A plane and a hole in it.
struct Hole {
  Point p_W_plane;
  Point angles_deg;  ///< about X, the new Y, the new Z
  Point aside;       ///< in the plane, off its origin
  double bore = 0.0;
};

struct Touch {
  Point p_work;       ///< latched, as the program sees it
  Point p_commanded;  ///< the same of the programmed end
  Point p_P_contact;  ///< in the part
  AxisPositions q_M;  ///< latched
};

Point point_of(const nlohmann::json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

std::vector<Touch> touches_of(const RunOutput& output, const machine::AxisChainSetup& chain) {
  std::vector<Touch> touches;
  const machine::AxisChain true_chain(chain, kTool);
  for (const nlohmann::json& row : output.document.at("touches")) {
    if (!row.at("triggered").get<bool>()) {
      continue;  // a move that looks whether the way is free
    }
    Touch touch;
    touch.p_work = point_of(row.at("work"));
    touch.p_commanded = point_of(row.at("work_commanded"));
    touch.q_M = AxisPositions::Zero();
    for (std::size_t i = 0; i < row.at("latched").size(); ++i) {
      touch.q_M[static_cast<Eigen::Index>(i)] = row.at("latched").at(i).get<double>();
    }
    touch.p_P_contact = true_chain.part_from_machine(touch.q_M) * point_of(row.at("contact"));
    touches.push_back(touch);
  }
  return touches;
}

std::string ring_of(const Hole& hole) {
  const Eigen::Matrix3d tilt = machine::about_turned_axes(
      {machine::AxisTurn{0, hole.angles_deg[0]}, {1, hole.angles_deg[1]}, {2, hole.angles_deg[2]}});
  const Point at = hole.p_W_plane + tilt * hole.aside;
  // The ring is turned about X, then Y, then Z.
  const Point turned(std::atan2(tilt(2, 1), tilt(2, 2)), std::asin(-tilt(2, 0)),
                     std::atan2(tilt(1, 0), tilt(0, 0)));
  const Point rotate = turned * 180.0 / std::numbers::pi;
  return fmt::format(
      "[[part]]\nname = \"ring\"\nshape = \"ring\"\non = \"G54\"\nat = [{:.17g}, {:.17g}, "
      "{:.17g}]\nrotate_deg = [{:.17g}, {:.17g}, {:.17g}]\nbore = {:.17g}\n",
      at.x(), at.y(), at.z(), rotate.x(), rotate.y(), rotate.z(), hole.bore);
}

/// The sheet of the same machine for the other control.
std::string as_fanuc(std::string sheet) {
  const std::string begin = "[control]\nprofile = \"sinumerik-828d\"\n";
  EXPECT_TRUE(sheet.starts_with(begin));
  sheet.replace(0, begin.size(), "[control]\nprofile = \"fanuc-30i\"\n");
  sheet.resize(sheet.find("[variables]"));
  const std::string of_tool = "type = 710.0\nname = \"PROBE\"\n";
  sheet.erase(sheet.find(of_tool), of_tool.size());
  return sheet;
}

/// @returns what CYCLE977 touched
std::vector<Touch> by_cycle(const machine::AxisChainSetup& chain, const std::string& sheet,
                            const Hole& hole, int direction) {
  const std::string program = fmt::format(
      "T1 M6\nG54 D1\nCYCLE800(0,\"\",0,57,{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},0,0,0,{})\n"
      "G0 X{:.3f} Y{:.3f} Z50\nZ-5\nCYCLE977(1,,,1,{:.2f},,,2,5)\n",
      hole.p_W_plane.x(), hole.p_W_plane.y(), hole.p_W_plane.z(), hole.angles_deg.x(),
      hole.angles_deg.y(), hole.angles_deg.z(), direction, hole.aside.x(), hole.aside.y(),
      hole.bore);
  const MeasuringRun run = run_on_sheets(program, {sheet, ring_of(hole)}, {"_OVR[4]"});
  EXPECT_EQ(run.alarm(), 0) << program << run.output.errors;
  return run.alarm() == 0 ? touches_of(run.output, chain) : std::vector<Touch>();
}

/// G31 to the same programmed points, each from 6 mm before it.
/// @returns what it touched
std::vector<Touch> by_skips(const machine::AxisChainSetup& chain, const std::string& sheet,
                            const Hole& hole, const std::vector<Touch>& as) {
  std::string program = fmt::format(
      "%\nO1\nG54 G90 G0\nG43 H1\nG68.2 P1 Q321 X{:.3f} Y{:.3f} Z{:.3f} I{:.3f} J{:.3f} K{:.3f}\n"
      "G53.1\nG0 X{:.3f} Y{:.3f} Z50.\nZ-5.\n",
      hole.p_W_plane.x(), hole.p_W_plane.y(), hole.p_W_plane.z(), hole.angles_deg.x(),
      hole.angles_deg.y(), hole.angles_deg.z(), hole.aside.x(), hole.aside.y());
  for (const Touch& touch : as) {
    const Point from = touch.p_commanded - 6.0 * (touch.p_commanded - touch.p_work).normalized();
    program += fmt::format(
        "G0 X{:.3f} Y{:.3f} Z{:.3f}\nG31 X{:.3f} Y{:.3f} Z{:.3f} F300.\nG0 X{:.3f} Y{:.3f}\n",
        from.x(), from.y(), from.z(), touch.p_commanded.x(), touch.p_commanded.y(),
        touch.p_commanded.z(), hole.aside.x(), hole.aside.y());
  }
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("part.nc", program + "G69\nM30\n%\n")};
  options.setups = {folder.write("machine.toml", as_fanuc(sheet)),
                    folder.write("ring.toml", ring_of(hole))};
  options.touches = true;
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << program << output.errors;
  return output.exit_code == 0 ? touches_of(output, chain) : std::vector<Touch>();
}

TEST(DialectsAgree, TouchByTouchInTiltedPlanesOfMachinesByChance) {
  std::uint64_t n = 0;
  const auto random = [&n](double most) { return most * (2.0 * uniform({22, 77}, n++) - 1.0); };
  double worst = 0.0;
  double worst_written = 0.0;
  int compared = 0;
  int otherwise_turned = 0;
  const int runs = of_many(200);
  for (int i = 0; i < runs; ++i) {
    machine::AxisChainSetup chain =
        std::vector{k1(), k2(), k3(), k4(), k5(), k6()}.at(static_cast<std::size_t>(i) % 6);
    for (machine::RotaryLine& line : chain.rotary) {
      line.p_M_centre += Point(random(20), random(20), random(20));
    }
    Hole hole;
    hole.p_W_plane = {written(random(40)), written(random(40)), written(random(20))};
    hole.angles_deg = {written(random(30)), written(random(30)), written(random(60))};
    hole.aside = {written(random(3)), written(random(3)), 0.0};
    hole.bore = std::round(100.0 * (30.0 + random(5.0))) / 100.0;
    const Point offset(written(random(100)), written(random(100)), written(-400 + random(30)));
    const std::string sheet = five_axis_sheet(chain, offset);
    SCOPED_TRACE(fmt::format("set-up {}", i));
    const std::vector<Touch> cycle = by_cycle(chain, sheet, hole, i % 2 == 0 ? 1 : -1);
    ASSERT_EQ(cycle.size(), 4U);
    const std::vector<Touch> skips = by_skips(chain, sheet, hole, cycle);
    ASSERT_EQ(skips.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        worst_written = std::max(worst_written, std::abs(cycle[k].p_commanded[axis] -
                                                         written(cycle[k].p_commanded[axis])));
      }
      worst = std::max({worst, (cycle[k].p_work - skips[k].p_work).norm(),
                        (cycle[k].p_commanded - skips[k].p_commanded).norm(),
                        (cycle[k].p_P_contact - skips[k].p_P_contact).norm()});
      ++compared;
    }
    otherwise_turned += (cycle[0].q_M - skips[0].q_M).tail<3>().norm() > 1.0 ? 1 : 0;
  }
  EXPECT_EQ(compared, 4 * runs);
  EXPECT_LT(worst_written, 1e-9) << "the cycle's points are such as both controls write";
  EXPECT_LT(worst, 1e-9);
  EXPECT_GT(otherwise_turned, runs / 10) << "else the axes would be compared with themselves";
  std::printf("worst of %d touches %.3g mm, %d of %d set-ups with other rotary positions\n",
              compared, worst, otherwise_turned, runs);
}

}  // namespace
}  // namespace g31::testing::dialects_agree_test

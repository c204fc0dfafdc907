// $P_TOOLROT: where the rotary axes have turned the side of the tool that looks along the plane's
// 1st axis; and TRAORI with values left out.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/five_axis_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::tool_rotation_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

double in_rad(double deg) {
  return deg * std::numbers::pi / 180.0;
}

MeasuringRun at(const machine::AxisChainSetup& chain, const std::string& program) {
  return run_on_sheets("T1 M6\nG54 D1\n" + program +
                           "\nR1=$P_TOOLROT[1] R2=$P_TOOLROT[2] R3=$P_TOOLROT[3] R4=$P_TOOLROT",
                       {five_axis_sheet(chain, Point(40, -25, -380))}, {"R1", "R2", "R3", "R4"});
}

void expect_side(const MeasuringRun& run, const Point& side) {
  expect_values(run, {{"R1", side.x()}, {"R2", side.y()}, {"R3", side.z()}, {"R4", 0.0}}, 1e-12);
}

TEST(ToolRotation, IsAlongTheFirstAxisWhereNothingTurnsTheTool) {
  expect_side(at(k1(), ""), Point::UnitX());
  expect_side(at(k1(), "G19"), Point::UnitY());
  expect_side(at(k4(), "G0 C30 A-40"), Point::UnitX());
}

/// Rz(30) Rx(-40) of X; in G18 of Z.
TEST(ToolRotation, FollowsAHead) {
  for (const char* const with : {"TRAORI\n", "TCARR=1 TCOABS\n"}) {
    SCOPED_TRACE(with);
    const std::string turns = "G0 C30 A-40\n";
    expect_side(at(k4(), turns + with), Point(std::cos(in_rad(30)), std::sin(in_rad(30)), 0));
    const Point along_z(0, std::sin(in_rad(40)), std::cos(in_rad(40)));
    expect_side(at(k4(), turns + "G18\n" + with),
                Point(-std::sin(in_rad(30)) * along_z.y(), std::cos(in_rad(30)) * along_z.y(),
                      along_z.z()));
  }
}

/// Against the part: Rz(-70) Rx(35) of X.
TEST(ToolRotation, FollowsATableAgainstThePart) {
  expect_side(at(k1(), "TRAORI\nG0 A35 C-70"),
              Point(std::cos(in_rad(70)), -std::sin(in_rad(70)), 0));
}

TEST(ToolRotation, AFourthComponentIsRefused) {
  EXPECT_EQ(run_on_sheets("R1=$P_TOOLROT[4]", {five_axis_sheet(k1(), Point::Zero())}, {}).alarm(),
            17020);
}

/// What stands before the last value may be left out.
TEST(Traori, ValuesMayBeLeftOut) {
  const std::vector<std::string> names = {"R1", "R2", "R3"};
  const auto place = [&](const std::string& on) {
    const MeasuringRun run = run_on_sheets("T1 M6\nG54 D1\n" + on +
                                               "\nG0 X3 Y4 Z50 A20 C-35\nR1=$AA_IM[X] "
                                               "R2=$AA_IM[Y] R3=$AA_IM[Z]",
                                           {five_axis_sheet(k1(), Point(40, -25, -380))}, names);
    EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
    return Point(run.at("R1"), run.at("R2"), run.at("R3"));
  };
  EXPECT_EQ(place("TRAORI(,,,,10,20)"), place("TRAORI(1,0,0,0,10,20)"));
  EXPECT_EQ(place("TRAORI(1,,,1)"), place("TRAORI(1,0,0,1)"));
  EXPECT_NE(place("TRAORI(,,,,10,20)"), place("TRAORI"));
}

}  // namespace
}  // namespace g31::testing::tool_rotation_test

// G68, G51, G51.1 and G16 as programs use them; the ends are worked out by hand (MB-298 to MB-301).

#include <gtest/gtest.h>

#include "tests/support/last_moves.h"

namespace g31::fanuc::transforms_test {
namespace {

using testing::ControlRun;
using testing::expect_last_moves;
using testing::LastMove;

TEST(Rotation, MovesOnTurnedAxes) {
  const LastMove kCases[] = {
      {"about the origin", "G68X0Y0R90.\nG0X10.Y0", "move 0.000 10.000 0.000 rapid"},
      {"about a point", "G68X5.Y5.R90.\nG0X10.Y5.", "move 5.000 10.000 0.000 rapid"},
      {"a bare angle counts thousandths of a degree", "G68X0Y0R90000\nG0X10.Y0",
       "move 0.000 10.000 0.000 rapid"},
      {"about where the tool stands when no centre is named", "G0X3.Y4.\nG68R90.\nG91G0X2.",
       "move 3.000 6.000 0.000 rapid"},
      {"increments turn from the present point", "G0X10.Y0\nG68X0Y0R90.\nG91G0X5.",
       "move 10.000 5.000 0.000 rapid"},
      {"a centre is a coordinate under G91, too", "G0X10.Y0\nG91G68X1.Y0R180.\nG90G0X10.Y0",
       "move -8.000 0.000 0.000 rapid"},
      {"in the ZX plane, Z towards X", "G18G68Z0X0R90.\nG0Z10.X0", "move 10.000 0.000 0.000 rapid"},
      {"in the YZ plane, Y towards Z", "G19G68Y0Z0R90.\nG0Y10.Z0", "move 0.000 0.000 10.000 rapid"},
      {"G69 may stand before its motion", "G68X0Y0R90.\nG0X5.Y0\nG69G0X10.Y5.",
       "move 10.000 5.000 0.000 rapid"},
      {"an incremental move after G69 goes on from there", "G68X0Y0R90.\nG0X5.Y0\nG69\nG91G0X1.",
       "move 1.000 5.000 0.000 rapid"},
      {"the work offset is not turned", "G10L2P1X100.\nG68X0Y0R90.\nG0X10.Y0",
       "move 100.000 10.000 0.000 rapid"},
      {"the tool offset is not turned", "#11001=50.\nG18G68Z0X0R90.\nG43H1G0Z10.X0",
       "move 10.000 0.000 50.000 rapid"},
      {"an arc goes along", "G68X0Y0R90.\nG0X10.Y0\nG3X0Y10.I-10.J0F100",
       "arc ccw -10.000 0.000 0.000 centre X0.000 Y0.000 F100"},
      {"G53 is not turned", "G68X0Y0R90.\nG53G0X10.", "move 10.000 0.000 0.000 rapid"},
      {"a second G68 replaces the first", "G68X0Y0R90.\nG68X0Y0R180.\nG0X10.Y0",
       "move -10.000 0.000 0.000 rapid"},
  };
  expect_last_moves(kCases);
}

TEST(Rotation, AnglesAddUnderG91WhenTheParameterSaysSo) {
  runtime::ControlSetup setup;
  setup.parameters["5400.0"] = 1;
  const LastMove kCases[] = {
      {"G91 adds", "G68X0Y0R60.\nG91G68R30.\nG90G0X10.Y0", "move 0.000 10.000 0.000 rapid"},
      {"G90 replaces", "G68X0Y0R60.\nG68X0Y0R90.\nG0X10.Y0", "move 0.000 10.000 0.000 rapid"},
  };
  expect_last_moves(kCases, setup);
}

TEST(Rotation, TakesItsUsualAngleFromAParameter) {
  runtime::ControlSetup setup;
  setup.parameters["5410"] = 90.0;
  const LastMove kCases[] = {{"no R", "G68X0Y0\nG0X10.Y0", "move 0.000 10.000 0.000 rapid"}};
  expect_last_moves(kCases, setup);
}

TEST(Scaling, EnlargesAboutItsCentre) {
  const LastMove kCases[] = {
      {"about the origin", "G51X0Y0Z0P2000\nG0X10.Y5.Z1.", "move 20.000 10.000 2.000 rapid"},
      {"about a point", "G51X10.Y0Z0P500\nG0X20.Y8.", "move 15.000 4.000 0.000 rapid"},
      {"about where the tool stands", "G0X10.\nG51P2000\nG0X15.", "move 20.000 0.000 0.000 rapid"},
      {"increments grow", "G51X0Y0Z0P3000\nG91G0X2.", "move 6.000 0.000 0.000 rapid"},
      {"P as a variable counts thousandths", "#1=1500\nG51X0Y0Z0P#1\nG0X10.",
       "move 15.000 0.000 0.000 rapid"},
      {"an arc by R grows", "G51X0Y0Z0P2000\nG2X10.Y0R5.F100",
       "arc cw 20.000 0.000 0.000 centre X10.000 Y0.000 F100"},
      {"an arc by I J grows", "G51X0Y0Z0P2000\nG2X10.Y0I5.F100",
       "arc cw 20.000 0.000 0.000 centre X10.000 Y0.000 F100"},
      {"G50 ends it", "G51X0Y0Z0P2000\nG0X10.\nG50\nG0X10.Y0", "move 10.000 0.000 0.000 rapid"},
      {"rotation comes behind, its centre is scaled too", "G51X0Y0Z0P2000\nG68X5.Y0R90.\nG0X10.Y0",
       "move 10.000 10.000 0.000 rapid"},
  };
  expect_last_moves(kCases);
}

TEST(Scaling, ByAxisWhenTheParameterSaysSo) {
  runtime::ControlSetup setup;
  setup.parameters["5400.6"] = 1;
  setup.parameters["5421.Z"] = 3000;
  const LastMove kCases[] = {
      {"each axis its own", "G51X0Y0Z0I2000J500\nG0X10.Y10.Z1.", "move 20.000 5.000 3.000 rapid"},
      {"below 0 mirrors, and turns arcs round", "G51X0Y0Z0I-1000J1000K1000\nG2X10.Y0I5.F100",
       "arc ccw -10.000 0.000 0.000 centre X-5.000 Y0.000 F100"},
      {"an arc by R takes the larger factor", "G51X0Y0Z0I2000J1000K1000\nG0X0Y0\nG2X10.Y0R10.F100",
       "arc cw 20.000 0.000 0.000 centre X10.000 Y-17.321 F100"},
      {"P still serves all axes", "G51X0Y0Z0P2000\nG0X1.Y1.", "move 2.000 2.000 0.000 rapid"},
  };
  expect_last_moves(kCases, setup);
}

/// Unequal factors: the arc keeps the radius of its start, and a line goes on to the scaled end.
TEST(Scaling, EndsAnUnequallyScaledArcWithALine) {
  runtime::ControlSetup setup;
  setup.parameters["5400.6"] = 1;
  ControlRun run("fanuc-16i", "G0X0Y100.\nG51X0Y0Z0I2000J1000K1000\nG2X100.Y0I0J-100.F500", setup);
  EXPECT_EQ(run.alarm(), 0);
  const auto& log = run.machine().log();
  ASSERT_EQ(log.size(), 3u);
  EXPECT_EQ(log[1], "arc cw 100.000 0.000 0.000 centre X0.000 Y0.000 F500");
  EXPECT_EQ(log[2], "move 200.000 0.000 0.000 F500");
}

TEST(Scaling, FactorWithAPointIsForTheSeries30i) {
  ControlRun later("fanuc-30i", "G51X0Y0Z0P1.5\nG0X10.");
  EXPECT_EQ(later.machine().log().back(), "move 15.000 0.000 0.000 rapid");
  ControlRun earlier("fanuc-16i", "G51X0Y0Z0P1.5\nG0X10.");
  EXPECT_EQ(earlier.alarm(), 7);
}

TEST(Scaling, RefusesFactorsThatFlatten) {
  EXPECT_EQ(ControlRun("fanuc-16i", "G51X0Y0Z0P0").alarm(), 142);
  EXPECT_EQ(ControlRun("fanuc-16i", "G51X0Y0Z0P-1000").alarm(), 142);
}

TEST(Mirror, TurnsSidesAndArcsRound) {
  const LastMove kCases[] = {
      {"at the origin", "G51.1X0\nG0X10.Y5.", "move -10.000 5.000 0.000 rapid"},
      {"at a coordinate", "G51.1X20.\nG0X15.", "move 25.000 0.000 0.000 rapid"},
      {"two axes", "G51.1X0Y0\nG0X1.Y2.", "move -1.000 -2.000 0.000 rapid"},
      {"one of two ends", "G51.1X0Y0\nG50.1X0\nG0X1.Y2.", "move 1.000 -2.000 0.000 rapid"},
      {"G50.1 alone ends all", "G51.1X0Y0\nG50.1\nG0X1.Y2.", "move 1.000 2.000 0.000 rapid"},
      {"arcs turn the other way", "G51.1X0\nG2X10.Y0I5.F100",
       "arc ccw -10.000 0.000 0.000 centre X-5.000 Y0.000 F100"},
      {"by R, too", "G51.1X0\nG3X10.Y10.R10.F100",
       "arc cw -10.000 10.000 0.000 centre X0.000 Y10.000 F100"},
      {"arcs in a plane without the axis stay", "G51.1X0\nG19G2Y10.Z0J5.F100",
       "arc cw 0.000 10.000 0.000 centre Y5.000 Z0.000 F100"},
      {"two mirrors turn arcs back", "G51.1X0Y0\nG2X10.Y0I5.F100",
       "arc cw -10.000 0.000 0.000 centre X-5.000 Y0.000 F100"},
      {"a rotation turns the other way and about the mirrored centre",
       "G51.1X0\nG68X5.Y0R90.\nG0X10.Y0", "move -5.000 5.000 0.000 rapid"},
      {"a rotary axis", "G51.1A0\nG0A30.", "move 0.000 0.000 0.000 A-30.000 rapid"},
  };
  expect_last_moves(kCases);
}

TEST(Polar, TakesRadiusAndAngle) {
  const LastMove kCases[] = {
      {"radius and angle", "G16\nG0X10.Y30.", "move 8.660 5.000 0.000 rapid"},
      {"the radius stays", "G16\nG0X10.Y0\nY90.", "move 0.000 10.000 0.000 rapid"},
      {"the angle stays", "G16\nG0X10.Y90.\nX4.", "move 0.000 4.000 0.000 rapid"},
      {"incremental angles add", "G16\nG0X10.Y30.\nG91Y60.", "move 0.000 10.000 0.000 rapid"},
      {"an incremental radius counts from the present point", "G16\nG0X10.Y0\nG91X5.Y90.",
       "move 10.000 5.000 0.000 rapid"},
      {"under G91 G16 the present point is the pole", "G0X3.Y4.\nG91G16\nX10.Y90.",
       "move 3.000 14.000 0.000 rapid"},
      {"without a radius word the present one", "G0X6.Y8.\nG16\nY0",
       "move 10.000 0.000 0.000 rapid"},
      {"in the ZX plane Z is the radius", "G18G16\nG0Z10.X90.", "move 10.000 0.000 0.000 rapid"},
      {"the third axis goes straight", "G16\nG0X10.Y90.Z5.", "move 0.000 10.000 5.000 rapid"},
      {"G15 ends it", "G16\nG0X10.Y90.\nG15\nX3.", "move 3.000 10.000 0.000 rapid"},
      {"the pole is the work origin", "G10L2P1X100.\nG16G0X10.Y90.",
       "move 100.000 10.000 0.000 rapid"},
      {"with a rotation", "G68X0Y0R60.\nG16\nG0X10.Y30.", "move 0.000 10.000 0.000 rapid"},
      {"arcs by R", "G16\nG0X10.Y0\nG3Y90.R10.F100",
       "arc ccw 0.000 10.000 0.000 centre X0.000 Y0.000 F100"},
  };
  expect_last_moves(kCases);
}

TEST(Transforms, ShowInTheModalGroups) {
  ControlRun run("fanuc-16i",
                 "G51.1X0Y0\nG51X0Y0Z0P1000\nG68X0Y0R0\nG16\n"
                 "#101=#4022\n#102=#4011\n#103=#4016\n#104=#4017\n"
                 "G15G69G50\nG50.1X0\n#105=#4022\nG50.1Y0\n#106=#4022\n#107=#4011\n#108=#4016");
  EXPECT_EQ(run.value("#101"), 51.1);
  EXPECT_EQ(run.value("#102"), 51);
  EXPECT_EQ(run.value("#103"), 68);
  EXPECT_EQ(run.value("#104"), 16);
  EXPECT_EQ(run.value("#105"), 51.1);
  EXPECT_EQ(run.value("#106"), 50.1);
  EXPECT_EQ(run.value("#107"), 50);
  EXPECT_EQ(run.value("#108"), 69);
}

TEST(Transforms, LeaveTheProgrammedPointAndTheTruePositionToTheirVariables) {
  ControlRun run("fanuc-16i",
                 "G68X0Y0R90.\nG0X10.Y2.\n#101=#5001\n#102=#5002\n#103=#5041\n#104=#5042");
  EXPECT_NEAR(*run.value("#101"), 10.0, 1e-12);
  EXPECT_NEAR(*run.value("#102"), 2.0, 1e-12);
  EXPECT_NEAR(*run.value("#103"), -2.0, 1e-12);
  EXPECT_NEAR(*run.value("#104"), 10.0, 1e-12);
}

TEST(Transforms, SkipMovesOnTurnedAxesAndLatchesOnWorkAxes) {
  AxisPositions q_M_touch = AxisPositions::Zero();
  q_M_touch[1] = 7.0;
  ControlRun run("fanuc-16i", "G68X0Y0R90.\nG31X20.Y0F100\n#101=#5061\n#102=#5062\n#103=#5001", {},
                 {q_M_touch});
  EXPECT_EQ(run.machine().log().back(), "skip 0.000 20.000 0.000 F100");
  EXPECT_NEAR(*run.value("#101"), 0.0, 1e-12);
  EXPECT_NEAR(*run.value("#102"), 7.0, 1e-12);
  EXPECT_NEAR(*run.value("#103"), 7.0, 1e-12);  // where it stopped, as the program sees it
  ASSERT_EQ(run.outcome().diagnostics.size(), 1u);
  EXPECT_EQ(run.outcome().diagnostics[0].code, "PRB303");
}

TEST(Transforms, AnArcAcrossTheTurnedPlaneIsRefused) {
  EXPECT_EQ(ControlRun("fanuc-16i", "G68X0Y0R90.\nG18G2X10.Z0I5.F100").alarm(), 144);
}

}  // namespace
}  // namespace g31::fanuc::transforms_test

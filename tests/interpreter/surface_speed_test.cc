// G96 and G97: FANUC operator's manuals, constant surface speed control, parameters 3770 to 3772;
// M700V programming manual, constant surface speed control and spindle clamp speed setting.

#include <gtest/gtest.h>

#include "tests/support/last_moves.h"

namespace g31::fanuc::surface_speed_test {
namespace {

using testing::ControlRun;
using testing::expect_last_moves;
using testing::LastMoveOn;

/// At 100 m/min a turn takes 2 pi x / 100000 minutes, so a feed of 0.2 a turn is 20000 / (2 pi x).
TEST(SurfaceSpeed, FeedAlongAWayIsThatOfItsTime) {
  constexpr LastMoveOn kCases[] = {
      {"at x = 50 throughout", "fanuc-16i", "G0X50.\nG95G96S100G1Y10.F.2",
       "move 50.000 10.000 0.000 F63.662"},
      {"from 50 to 10 as at 30", "fanuc-16i", "G0X50.\nG95G96S100G1X10.F.2",
       "move 10.000 0.000 0.000 F106.103"},
      {"up to 500 rev/min, which are reached at 31.83", "fanuc-16i",
       "G0X50.\nG92S500\nG95G96S100G1X0F.2", "move 0.000 0.000 0.000 F90.6037"},
      {"G92 S0 takes the limit away", "fanuc-16i", "G0X50.\nG92S50\nG92S0\nG95G96S100G1Y10.F.2",
       "move 50.000 10.000 0.000 F63.662"},
      {"in inches 100 feet, at 2 inches 95.493 rev/min", "fanuc-16i",
       "G20G0X2.\nG95G96S100G1Y1.F.01", "move 50.800 25.400 0.000 F24.2552"},
      {"from the origin of the work offset", "fanuc-16i",
       "G10L2P1X100.\nG0X50.\nG95G96S100G1Y10.F.2", "move 150.000 10.000 0.000 F63.662"},
      {"a quarter of a circle about 20, whose mean x is 20 + 20/pi", "fanuc-16i",
       "G0X30.\nG95G96S100G3X20.Y10.I-10.F.2",
       "arc ccw 20.000 10.000 0.000 centre X20.000 Y0.000 F120.727"},
      {"a skip move", "fanuc-16i", "G0X50.\nG95G96S100G31X10.F.2",
       "skip 10.000 0.000 0.000 F106.103"},
      {"feeds per minute stay", "fanuc-16i", "G0X50.\nG96S100G1X10.F70.",
       "move 10.000 0.000 0.000 F70"},
      {"Q of G92 is the lowest speed of a MELDAS", "meldas",
       "G0X100.\nG92S5000Q400\nG95G96S100G1Y10.F.2", "move 100.000 10.000 0.000 F80"},
  };
  expect_last_moves(kCases);
}

TEST(SurfaceSpeed, G97KeepsTheSpeedUntilItsS) {
  constexpr LastMoveOn kCases[] = {
      {"318.31 rev/min as at 50", "fanuc-16i", "G0X50.\nG96S100\nG97\nG0X10.\nG95G1Y10.F.2",
       "move 10.000 10.000 0.000 F63.662"},
      {"its own S", "fanuc-16i", "G0X50.\nG96S100\nG97S200\nG95G1X10.F.2",
       "move 10.000 0.000 0.000 F40"},
      {"and G96 its own again", "fanuc-16i", "G0X50.\nG96S100\nG97S200\nG96\nG95G1Y10.F.2",
       "move 50.000 10.000 0.000 F63.662"},
      {"S of G92 is no speed", "fanuc-16i", "S200\nG92S100\nG95G1X10.F.2",
       "move 10.000 0.000 0.000 F40"},
  };
  expect_last_moves(kCases);
  ControlRun modal("fanuc-16i", "G96S100\n#100=#4013\nG97\n#101=#4013");
  EXPECT_EQ(modal.value("#100"), 96.0);
  EXPECT_EQ(modal.value("#101"), 97.0);
}

TEST(SurfaceSpeed, ParametersLimitIt) {
  runtime::ControlSetup setup;
  setup.parameters = {{"3772", 100.0}};
  constexpr LastMoveOn kHighest[] = {
      {"3772 with G97", "fanuc-16i", "G95S500G1X10.F.2", "move 10.000 0.000 0.000 F20"},
      {"3772 with G96", "fanuc-16i", "G0X1.\nG95G96S100G1Y10.F.2", "move 1.000 10.000 0.000 F20"}};
  expect_last_moves(kHighest, setup);
  setup.parameters = {{"3771", 400.0}};
  constexpr LastMoveOn kLowest[] = {
      {"3771", "fanuc-16i", "G0X100.\nG95G96S100G1Y10.F.2", "move 100.000 10.000 0.000 F80"}};
  expect_last_moves(kLowest, setup);
}

TEST(SurfaceSpeed, AxisOfTheRadius) {
  runtime::ControlSetup setup;
  setup.parameters = {{"3770", 2.0}, {"1181", 2.0}};
  constexpr LastMoveOn kCases[] = {
      {"3770: Y, 20 from its origin", "fanuc-16i", "G0X50.Y20.\nG95G96S100G1X40.F.2",
       "move 40.000 20.000 0.000 F159.155"},
      {"P1: X, from 50 to 40", "fanuc-16i", "G0X50.Y20.\nG95G96P1S100G1X40.F.2",
       "move 40.000 20.000 0.000 F70.7355"},
      {"P0 is the parameter's", "fanuc-16i", "G0X50.Y20.\nG95G96P0S100G1X40.F.2",
       "move 40.000 20.000 0.000 F159.155"},
      {"1181 on a MELDAS", "meldas", "G0X50.Y20.\nG95G96S100G1X40.F.2",
       "move 40.000 20.000 0.000 F159.155"},
  };
  expect_last_moves(kCases, setup);
  constexpr LastMoveOn kWithout[] = {{"without the parameter X, P or not", "fanuc-16i",
                                      "G0X50.Y20.\nG95G96P2S100G1X40.F.2",
                                      "move 40.000 20.000 0.000 F70.7355"}};
  expect_last_moves(kWithout);
  EXPECT_EQ(ControlRun("fanuc-16i", "G96P9S100", setup).alarm(), 190);
  EXPECT_EQ(ControlRun("fanuc-16i", "G96P6S100", setup).alarm(), 190);
  EXPECT_EQ(ControlRun("meldas", "G96P9S100", setup).alarm(), 133);
}

TEST(SurfaceSpeed, TurnsTheSpindle) {
  ControlRun run("fanuc-16i", "G0X50.\nG96S100M3");
  ASSERT_FALSE(run.machine().commands().empty());
  EXPECT_EQ(run.machine().commands().front(), "spindle 1 cw 318.31");
  ControlRun centre("fanuc-16i", "G96S100M3");
  ASSERT_FALSE(centre.machine().commands().empty());
  EXPECT_EQ(centre.machine().commands().front(), "spindle 1 cw 0") << "no limit is known";
}

TEST(SurfaceSpeed, WithoutASpeedThereIsNoFeed) {
  EXPECT_EQ(ControlRun("fanuc-16i", "G0X50.\nG95G96G1X10.F.2").alarm(), 11);
  EXPECT_EQ(ControlRun("fanuc-16i", "G95G96S100G1Y10.F.2").alarm(), 11) << "at the centre";
  EXPECT_EQ(ControlRun("fanuc-16i", "G92S500\nG95G96S100G1Y10.F.2").alarm(), 0);
  EXPECT_EQ(ControlRun("haas", "G96S100").alarm(), 10);
  EXPECT_EQ(ControlRun("meldas", "G93G96S100").alarm(), 125);
}

}  // namespace
}  // namespace g31::fanuc::surface_speed_test

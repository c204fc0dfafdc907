// Which spindle turns a tool: on a lathe its own one, by number or as the master; never that of the
// part.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"
#include "tests/support/turning_run.h"

namespace g31::testing::tool_spindle_test {
namespace {

/// Tool 6 has two teeth: at 0 degrees one of 25 mm, to +X, opposite one of 24 mm.
constexpr const char* kDriven = R"([machine]
tool_side = "ZX"
[tools.6]
length = 0.0
radius = 25.0
type = 140.0
[[tool]]
number = 6
length = 90.0
diameter = 50.0
teeth = [{ angle_deg = 0.0 }, { angle_deg = 180.0, radius = 24.0 }]
)";

/// The side of the plate is at X110; the tool comes from X200.
MeasuringRun touch_behind(const std::string& spindle, const std::string& more = {}) {
  return run_on_sheets("T6 M6\nG18 DIAMOF D0\n" + spindle +
                           "\nG0 SUPA X200 Z-120\nMEAS=2 G1 X100 F100\nSTOPRE\nR1=$AA_MM[X]\n"
                           "R2=$AC_MSNUM R3=$P_S[3] R4=$AC_SDIR[3] R5=$P_S[1] R6=$AC_SDIR[1]",
                       {kLatheProbe, "[machine]\ntool_spindle = 3\n", kDriven, more},
                       {"R1", "R2", "R3", "R4", "R5", "R6"});
}

struct Case {
  const char* spindle;
  double x;  ///< of the tool's axis at the touch
};

TEST(ToolSpindle, OfALatheIsItsOwn) {
  constexpr double kShort = 110.0 + 24.0;
  constexpr double kLong = 110.0 + 25.0;
  const Case kRows[] = {
      {"", kShort},
      {"SPOS=180", kShort},
      {"SPOS[1]=180", kShort},
      {"M19", kShort},
      {"S600 M3", kShort},
      {"SPOS[2]=180", kShort},
      {"SPOS[3]=180", kLong},
      {"SETMS(3)\nSPOS=180", kLong},
      {"SETMS(3)\nSPOS[1]=180", kShort},
      {"SETMS(3)\nSPOS=180\nSETMS\nSPOS=0", kLong},
      {"SPOS[3]=180\nM3=19", kShort},
  };
  for (const Case& row : kRows) {
    SCOPED_TRACE(row.spindle);
    const MeasuringRun run = touch_behind(row.spindle);
    ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
    EXPECT_NEAR(run.at("R1"), row.x, 1e-6);
  }
}

/// At 600 rev/min and 100 mm/min the long tooth comes within 1/6 mm of its deepest place.
TEST(ToolSpindle, TurnsByItsNumberOrAsTheMaster) {
  for (const char* const spindle : {"S3=600 M3=3", "M3=4 S3=600", "SETMS(3)\nS600 M3"}) {
    SCOPED_TRACE(spindle);
    const MeasuringRun run = touch_behind(spindle);
    ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
    EXPECT_LE(run.at("R1"), 135.0);
    EXPECT_GT(run.at("R1"), 135.0 - 100.0 / 600.0);
  }
  const MeasuringRun stopped = touch_behind("S3=600 M3=3\nM3=5\nSPOS[3]=0");
  EXPECT_NEAR(stopped.at("R1"), 134.0, 1e-6);
}

TEST(ToolSpindle, IsTheOneThatTheSheetNames) {
  EXPECT_NEAR(touch_behind("SPOS=180", "[machine]\ntool_spindle = 1\n").at("R1"), 135.0, 1e-6);
  EXPECT_NEAR(touch_behind("SPOS[4]=180", "[machine]\ntool_spindle = 4\n").at("R1"), 135.0, 1e-6);
  EXPECT_NEAR(touch_behind("SPOS[3]=180", "[machine]\ntool_spindle = 4\n").at("R1"), 134.0, 1e-6);
}

TEST(ToolSpindle, WordsWithoutANumberAreOfTheMaster) {
  const MeasuringRun run = touch_behind("S1=100 M1=4\nSETMS(3)\nS500 M3\nS1=200\nM5");
  EXPECT_EQ(run.at("R2"), 3.0);
  EXPECT_EQ(run.at("R3"), 500.0);
  EXPECT_EQ(run.at("R4"), 5.0);
  EXPECT_EQ(run.at("R5"), 200.0);
  EXPECT_EQ(run.at("R6"), 4.0);
  for (const char* const none : {"SETMS(0)", "SETMS(99)"}) {
    EXPECT_EQ(touch_behind(none).alarm(), 12560) << none;
  }
}

/// A probe in a mill's spindle is turned by that alone.
TEST(ToolSpindle, AProbeTurnsWithItsOwnSpindle) {
  const std::string sheet = "[probe]\ntool = 1\n" + part("block", 100.0, 50.0, -300.0);
  const char* const touch = "\nX-45 Z-5\nMEAS=1 G1 X-20 F100\nSTOPRE\nR1=$AA_MM[X]";
  const auto complains = [&](const char* spindle) {
    const MeasuringRun run = run_measuring(std::string(spindle) + touch, {sheet}, {"R1"});
    return run.output.errors.find("PRB313") != std::string::npos;
  };
  EXPECT_TRUE(complains("S100 M3"));
  EXPECT_TRUE(complains("S1=100 M1=3"));
  EXPECT_FALSE(complains("S2=100 M2=3"));
  EXPECT_FALSE(complains("SETMS(2)\nS100 M3"));
}

/// A probe in a turret touches a part that stands.
TEST(ToolSpindle, OfALatheTheSpindleOfThePartIsToStand) {
  const std::string shaft = part("shaft", 0.0, 0.0, 200.0, "diameter = 50.0\nheight = 100.0");
  const auto complains = [&](const std::string& spindle, const std::string& sheet) {
    const MeasuringRun run =
        run_turning(spindle + "\nG0 X50 Z-20\nMEAS=1 G1 X20 F100\nSTOPRE\nR1=$AA_MM[X]",
                    {kProbeToMinusX, shaft, sheet}, {"R1"});
    return run.output.errors.find("PRB313") != std::string::npos;
  };
  const std::string tool = "[probe]\ntool = 1\n";
  EXPECT_TRUE(complains("S500 M4", tool));
  EXPECT_FALSE(complains("S500 M4\nM5", tool));
  EXPECT_FALSE(complains("SPOS=90", tool));
  EXPECT_TRUE(complains("S500 M4", "")) << "whoever brings the probe";
  EXPECT_FALSE(complains("S500 M4\nM5", ""));
  EXPECT_FALSE(complains("S500 M4", tool + "may_turn = true\n"));
}

}  // namespace
}  // namespace g31::testing::tool_spindle_test

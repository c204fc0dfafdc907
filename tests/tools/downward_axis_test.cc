// Work coordinates whose 3rd axis points at the part, as ROT X180 makes them: the 2nd axis lies to
// the right of the 1st one as the probe sees them, and the tip is the ball's upper end.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/measuring_run.h"

namespace g31::testing::downward_axis_test {
namespace {

/// A ball beside the axis, and where the calibration has it.
constexpr const char* kBallAside = R"([probe]
eccentricity = [0.02, 0.05]
[variables]
"$SNS_MEA_WP_POS_DEV_AX1[0]" = 0.02
"$SNS_MEA_WP_POS_DEV_AX2[0]" = 0.05
)";

/// Turned by 180 degrees about X, then Y; the part's place 0.2, -0.3 in G54.
struct Turn {
  const char* program;
  double x;
  double y;
};
const Turn kTurns[] = {
    {"ROT X180", 0.2, 0.3}, {"ROT Y180", -0.2, -0.3}, {"MIRROR X0 Z0", -0.2, -0.3}};

TEST(DownwardAxis, ABoreIsWhereItIs) {
  for (const Turn& turn : kTurns) {
    SCOPED_TRACE(turn.program);
    expect_measured(fmt::format("{}\nX0 Y0 Z5\nCYCLE977(1,,,1,40,,,2,5)", turn.program),
                    {ring_aside(), kCalibrated, kBallAside},
                    {{"_OVR[4]", 40.0}, {"_OVR[5]", turn.x}, {"_OVR[6]", turn.y}}, 1e-4);
  }
}

TEST(DownwardAxis, ASpindleThatTurnsAlongMovesTheBallAsTheProbeSeesIt) {
  const std::string one_side =
      "[variables]\n\"$SNS_MEA_WP_BALL_DIAM[0]\" = 5.99\n"
      "\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]\" = 2.995\n"
      "\"$SNS_MEA_WP_POS_DEV_AX1[0]\" = 0.02\n\"$SNS_MEA_WP_POS_DEV_AX2[0]\" = -0.03\n";
  for (const int kind : {10001, 20001}) {
    const std::vector<std::string> sheets = {ring_aside(), kCalibrated,
                                             std::string(kBentProbe) + one_side};
    for (const Turn& turn : kTurns) {
      SCOPED_TRACE(fmt::format("{} {}", turn.program, kind));
      expect_measured(fmt::format("{}\nX0 Y0 Z5\nCYCLE977({},,,1,40,,,2,5)", turn.program, kind),
                      sheets, {{"_OVR[4]", 40.0}, {"_OVR[5]", turn.x}, {"_OVR[6]", turn.y}}, 1e-4);
    }
  }
}

/// Faces at X -29.8 and 30.2, Y -20.3 and 19.7, the top at Z 0 of G54.
std::vector<std::string> block(const std::string& triggers) {
  return {part("block", 100.2, 49.7, -300.0), kCalibrated, kBallAside, triggers};
}

TEST(DownwardAxis, FacesAreWhereTheyAre) {
  const MeasuringCase kCases[] = {
      {"+X", "", "X-40\nZ5\nCYCLE978(0,,,1,-30,5,1,1,1)", {{"_OVR[4]", -29.8}}},
      {"-X", "", "X40\nZ5\nCYCLE978(0,,,1,30,5,1,1,2)", {{"_OVR[4]", 30.2}}},
      {"+Y", "", "Y-30\nZ5\nCYCLE978(0,,,1,-20,5,1,2,1)", {{"_OVR[4]", -19.7}}},
      {"-Y", "", "Y30\nZ5\nCYCLE978(0,,,1,20,5,1,2,2)", {{"_OVR[4]", 20.3}}},
      {"+Z", "", "CYCLE978(0,,,1,0.1,5,1,3,1)", {{"_OVR[4]", 0.0}, {"_OVR[16]", -0.1}}},
  };
  for (const MeasuringCase& c : kCases) {
    SCOPED_TRACE(c.name);
    expect_measured(fmt::format("ROT X180\n{}", c.program), block(""), c.expected);
  }
}

// Of triggers that differ that of the probe's own direction counts: towards -Y of these
// coordinates the probe goes in +Y, towards +Z in -Z.
TEST(DownwardAxis, TriggersAreThoseOfTheProbesOwnDirections) {
  const std::string uneven =
      "[variables]\n\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]\" = 3.05\n"
      "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]\" = -2.98\n"
      "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]\" = -0.04\n";
  const MeasuringCase kCases[] = {
      {"-Y", "", "Y30\nZ5\nCYCLE978(0,,,1,20,5,1,2,2)", {{"_OVR[4]", 20.25}}},
      {"+Y", "", "Y-30\nZ5\nCYCLE978(0,,,1,-20,5,1,2,1)", {{"_OVR[4]", -19.72}}},
      {"+Z", "", "CYCLE978(0,,,1,0.1,5,1,3,1)", {{"_OVR[4]", 0.04}}},
  };
  for (const MeasuringCase& c : kCases) {
    SCOPED_TRACE(c.name);
    expect_measured(fmt::format("ROT X180\n{}", c.program), block(uneven), c.expected);
  }
}

TEST(DownwardAxis, NothingIsCalibratedThere) {
  const MeasuringRun run =
      run_measuring("ROT X180\nX0 Y0 Z5\nCYCLE976(1,,1,40,,2,5)", {ring_aside(), kCalibrated}, {});
  EXPECT_EQ(run.alarm(), 61330);
}

}  // namespace
}  // namespace g31::testing::downward_axis_test

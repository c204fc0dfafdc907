// CYCLE971 with tools that lie along Y and X: G18 and G19, on a head that is turned to them.

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/tool_measuring_run.h"

namespace g31::testing::tool_probe_planes_test {
namespace {

/// A cube of 25 mm that looks to the tool: its place along the axes of the plane is 200, -300, and
/// -100 along the tool.
struct PlaneCase {
  const char* plane;
  const char* turned;   ///< the head: the tool points to minus of the 3rd axis
  const char* letters;  ///< the axes of the plane and the 3rd
  std::string machine;  ///< sheet: head and tool probe
  /// Radii of the teeth, as rising spindle positions bring them to minus of axis 1.
  std::vector<double> teeth;
};

std::string head(char axis, const char* direction, const char* at, const char* rotated) {
  return fmt::format(
      "[machine]\ntool_side = \"XYZ{0}\"\n[machine.axes.{0}]\ndirection = {1}\n"
      "travel = [-360.0, 360.0]\n[machine.axes.X]\ntravel = [-3000.0, 3000.0]\n"
      "[machine.axes.Y]\ntravel = [-3000.0, 3000.0]\n[machine.axes.Z]\n"
      "travel = [-3000.0, 3000.0]\n[[tool_probe]]\nsize = 25.0\nat = {2}\nrotate_deg = {3}\n",
      axis, direction, at, rotated);
}

std::vector<PlaneCase> planes() {
  return {
      {"G18",
       "A-90",
       "ZXY",
       head('A', "[1.0, 0.0, 0.0]", "[-300.0, -100.0, 200.0]", "[-90.0, 0.0, 0.0]"),
       // +Y of the tool, 90 degrees, points to -Z: 70 for the tooth at 20, then 160 for 290.
       {8.0, 7.97, 7.99, 7.98}},
      {"G19",
       "B90",
       "YZX",
       head('B', "[0.0, 1.0, 0.0]", "[-100.0, 200.0, -300.0]", "[0.0, 90.0, 0.0]"),
       // -Y of the tool, 270 degrees, points to -Y: 70 for the tooth at 200, then 160 for 110.
       {7.99, 7.98, 8.0, 7.97}},
  };
}

constexpr const char* kApproximate = R"([machine_data]
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]" = 212.9
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]" = 187.2
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]" = -287.3
"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]" = -312.7
"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]" = -100.4
)";

/// The tool 30 mm above the middle of the cube.
std::string above(const PlaneCase& row, int tool) {
  return fmt::format("T{} M6\n{} D1\nG0 SUPA {}100 {}\n", tool, row.plane, row.letters[2],
                     row.turned) +
         fmt::format("G0 SUPA {}200 {}-300\nG0 SUPA {}-70\n", row.letters[0], row.letters[1],
                     row.letters[2]);
}

TEST(ToolProbeInOtherPlanes, IsCalibratedFromAboveAndAllSides) {
  for (const PlaneCase& row : planes()) {
    SCOPED_TRACE(row.plane);
    expect_tools(above(row, 9) + "CYCLE971(100000,0,1,0,0,0,5,2)", {row.machine, kApproximate},
                 {{"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]", 212.5},
                  {"$SNS_MEA_TP_TRIG_PLUS_DIR_AX1[0]", 187.5},
                  {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX2[0]", -287.5},
                  {"$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]", -312.5},
                  {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]", -100.0},
                  {"_OVR[16]", -100.0}},
                 1e-6);
  }
}

TEST(ToolProbeInOtherPlanes, ToolsAreMeasuredStandingTurningAndToothByTooth) {
  for (const PlaneCase& row : planes()) {
    SCOPED_TRACE(row.plane);
    const std::string calibrate = above(row, 9) + "CYCLE971(100000,0,1,0,0,0,5,2)\n";
    const std::string up = fmt::format("G0 SUPA {}-70\n", row.letters[2]);
    const std::string limits = ",0,5,2,,0.0001,1)\n";
    expect_tools(calibrate + "$TC_DP3[5,1]=100.3 $TC_DP6[5,1]=7.8\n" + above(row, 5) +
                     "CYCLE971(1,0,1,103,2" + limits + "CYCLE971(1,0,1,1,2" + limits + up +
                     "CYCLE971(1,0,1,2,1" + limits,
                 {row.machine, kApproximate},
                 {{"$TC_DP3[5,1]", 100.0}, {"$TC_DP6[5,1]", 8.0}, {"_OVR[11]", 0.0}}, 1e-6);
    expect_tools(calibrate + "$TC_DPNT[6,1]=4\n" + above(row, 6) + "CYCLE971(102,0,1,1,2" + limits,
                 {row.machine, kApproximate},
                 {{"_OVR[100]", row.teeth[0]},
                  {"_OVR[101]", row.teeth[1]},
                  {"_OVR[102]", row.teeth[2]},
                  {"_OVR[103]", row.teeth[3]}},
                 1e-4);
  }
}

/// _DMODE 2 and 3 are G18 and G19 inside of the cycle alone; the program is in G17 at the calls.
TEST(ToolProbeInOtherPlanes, ThePlaneOfTheCallIsThatOfTheCycle) {
  for (const PlaneCase& row : planes()) {
    SCOPED_TRACE(row.plane);
    const std::string digit = row.plane == std::string("G18") ? "2)\n" : "3)\n";
    const std::string behind = ",,,,,,,,,," + digit;
    expect_tools(above(row, 9) + "G17\nCYCLE971(100000,0,1,0,0,0,5,2,,," + behind +
                     "R1=$P_GG[6] R2=$SNS_MEA_TP_TRIG_PLUS_DIR_AX2[0]\n" +
                     "$TC_DP3[5,1]=100.3 $TC_DP6[5,1]=7.8\n" + above(row, 5) +
                     "G17\nCYCLE971(1,0,1,103,2,0,5,2,,0.0001,1" + behind +
                     "CYCLE971(1,0,1,1,2,0,5,2,,0.0001,1" + behind,
                 {row.machine, kApproximate},
                 {{"R1", 1.0},
                  {"R2", -312.5},
                  {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX1[0]", 212.5},
                  {"$SNS_MEA_TP_TRIG_MINUS_DIR_AX3[0]", -100.0},
                  {"$TC_DP3[5,1]", 100.0},
                  {"$TC_DP6[5,1]", 8.0},
                  {"_OVR[11]", 0.2},
                  {"$P_GG[6]", 1.0}},
                 1e-6);
  }
}

}  // namespace
}  // namespace g31::testing::tool_probe_planes_test

// CYCLE995: a spindle that is out of parallel with the tool axis, by a ball that the probe's ball
// and a second one on its shaft touch.  The head of the machine carries a rotary axis that tilts
// the spindle by what is put in, while the control counts the tool as upright.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/measuring_run.h"

namespace g31::testing::spindle_angle_test {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// The spindle can be tilted about Y (B) and X (A); a ball of 4 mm on the shaft, 100 mm above.
constexpr const char* kTiltedSpindle = R"([machine]
table_side = ""
tool_side = "XYZAB"
[machine.axes.A]
travel = [-30.0, 30.0]
centre = [0.0, 0.0, 100.0]
[machine.axes.B]
travel = [-30.0, 30.0]
centre = [0.0, 0.0, 100.0]
[tools.1]
length = 220.0
[probe]
length = 217.0
stem_diameter = 2.0
stem_length = 150.0
[[probe.ball]]
at = [0.0, 0.0, 100.0]
diameter = 4.0
[[probe.body]]
name = "probe body"
length = 67.0
diameter = 40.0
)";

std::string ball(double x = 100.0, double y = 50.0) {
  return part("sphere", x, y, -300.0, "diameter = 25.0");
}

/// The pole is 12.5 above G54's origin, 3 mm (S_FA) below the end of the probe's ball.
std::string at_pole(const std::string& tilt, const std::string& call) {
  return tilt + "\nZ15.5\n" + call;
}

void run_tilted(const std::string& program, const std::vector<ExpectedValue>& expected,
                double tolerance) {
  expect_measured(program, {ball(), kCalibrated, kTiltedSpindle}, expected, tolerance);
}

/// D-3 of the worked examples: 0.05 and -0.02 at a distance of 100 are 0.028648 and 0.011459
/// degrees.
TEST(SpindleAngle, IsTheShaftsDistanceFromTheBallOverTheirHeight) {
  const double b = std::atan(0.05 / 100.0) * kDegrees;
  const double a = std::atan(0.02 / 100.0) * kDegrees;
  run_tilted(
      at_pole(fmt::format("A={:.12f} B={:.12f}", a, -b), "CYCLE995(102015,0,1,25,3,5,0,,100)"),
      {{"_OVR[2]", 0.028648}, {"_OVR[3]", 0.011459}, {"_OVR[4]", 100.0},    {"_OVR[5]", 0.0},
       {"_OVR[6]", 0.0},      {"_OVR[7]", 0.05},     {"_OVR[8]", 0.02},     {"_OVR[10]", 25.0},
       {"_OVR[14]", 25.0},    {"_OVR[18]", 0.0},     {"_OVR[22]", 25.0},    {"_OVR[27]", 0.05},
       {"_OVR[28]", 0.02},    {"_OVI[2]", 995.0},    {"_OVI[3]", 102015.0}, {"_OVI[5]", 1.0},
       {"_OVI[9]", 0.0},      {"$AA_IW[X]", 0.0},    {"$AA_IW[Y]", 0.0},    {"$AA_IW[Z]", 15.5}},
      1e-6);
}

/// A spindle that looks along Y or X: the same deviations along the axes of the plane.
TEST(SpindleAngle, IsMeasuredInTheOtherPlanesToo) {
  const double c = std::atan(0.05 / 100.0) * kDegrees;
  const double d = std::atan(0.02 / 100.0) * kDegrees;
  struct Plane {
    std::string machine;
    std::string frame;  ///< where the control has the ball, by how the head truly holds the probe
    std::string code;
    std::string stands;
    std::string above;
  };
  const std::string axes =
      "[machine.axes.A]\ntravel = [-120.0, 120.0]\ncentre = [0.0, 0.0, 100.0]\n"
      "[machine.axes.B]\ntravel = [-120.0, 120.0]\ncentre = [0.0, 0.0, 100.0]\n";
  const Plane planes[] = {{"[machine]\ntable_side = \"\"\ntool_side = \"XYZAB\"\n" + axes,
                           "$P_UIFR[2]=CTRANS(X,100,Y,150,Z,-400)", "G18",
                           fmt::format("A={:.12f} B={:.12f}", -90.0 - c, -d), "X0 Z0 Y"},
                          {"[machine]\ntable_side = \"\"\ntool_side = \"XYZBA\"\n" + axes,
                           "$P_UIFR[2]=CTRANS(X,200,Y,50,Z,-400)", "G19",
                           fmt::format("B={:.12f} A={:.12f}", 90.0 + d, c), "Y0 Z0 X"}};
  for (const Plane& plane : planes) {
    SCOPED_TRACE(plane.code);
    const std::string whole = kTiltedSpindle;
    const std::string probe = whole.substr(whole.find("[tools.1]"));
    const MeasuringRun run =
        run_measuring("G0 Z300\n" + plane.frame + "\nD0 G0 " + plane.stands + "\n" + plane.code +
                          " G55 D1\nG0 " + plane.above + "=60\n" + plane.above.substr(6) +
                          "=15.5\nCYCLE995(102015,0,1,25,3,5,0,,100)",
                      {ball(), kCalibrated, plane.machine + probe},
                      {"_OVR[2]", "_OVR[3]", "_OVR[4]", "_OVR[7]", "_OVR[8]", "_OVR[14]"});
    EXPECT_EQ(run.alarm(), 0) << run.output.errors;
    expect_values(run,
                  {{"_OVR[2]", c},
                   {"_OVR[3]", d},
                   {"_OVR[4]", 100.0},
                   {"_OVR[7]", 0.05},
                   {"_OVR[8]", 0.02},
                   {"_OVR[14]", 25.0}},
                  1e-6);
  }
}

TEST(SpindleAngle, IsZeroWhereTheSpindleIsTrueWhateverTheShaft) {
  // A bent shaft turns with the spindle: what it is off lies in the direction of each touch.
  const char* const bent = "[[probe.ball]]\nat = [0.3, -0.2, 100.0]\ndiameter = 4.0\n";
  expect_measured(at_pole("", "CYCLE995(5,0,1,25,3,5,30,,100)"),
                  {ball(100.2, 49.7), kCalibrated, kTiltedSpindle, bent},
                  {{"_OVR[2]", 0.0},
                   {"_OVR[3]", 0.0},
                   {"_OVR[11]", 0.0},
                   {"_OVR[13]", 0.0},
                   {"_OVR[15]", 0.2},
                   {"_OVR[16]", -0.3},
                   {"_OVR[17]", 0.0},
                   {"_OVR[19]", 0.2},
                   {"_OVR[20]", -0.3},
                   {"_OVR[23]", 0.2},
                   {"_OVR[26]", -0.3}},
                  1e-6);
}

TEST(SpindleAngle, TheDiameterMayBeMeasured) {
  expect_measured(at_pole("", "CYCLE995(1102015,0,1,24.98,3.01,5,0,,100)"),
                  {ball(), kCalibrated, kTiltedSpindle},
                  {{"_OVR[10]", 24.98}, {"_OVR[14]", 25.0}, {"_OVR[18]", 0.02}});
}

TEST(SpindleAngle, IsHeldAgainstItsTolerance) {
  const std::string tilt = "A=0.02 B=-0.05";
  run_tilted(at_pole(tilt, "CYCLE995(102015,0,1,25,3,5,0,,100,,,,0.03,0,,,,1)"),
             {{"_OVR[2]", 0.05},
              {"_OVR[3]", 0.02},
              {"_OVR[5]", 0.02},
              {"_OVR[6]", 0.0},
              {"_OVR[9]", 0.03},
              {"_OVI[9]", 61304.0}},
             1e-5);
  run_tilted(at_pole(tilt, "CYCLE995(102015,0,1,25,3,5,0,,100,,,,0.03,0.025,,,,1)"),
             {{"_OVR[3]", 0.0},
              {"_OVR[8]", 0.0},
              {"_OVR[28]", 0.034907},
              {"_OVR[7]", 0.087266},
              {"_OVI[9]", 61304.0}},
             1e-5);
  run_tilted(at_pole(tilt, "CYCLE995(102015,0,1,25,3,5,0,,100,,,,0.03,0.025)"),
             {{"_OVR[3]", 0.02}, {"_OVR[5]", 0.0}, {"_OVI[9]", 0.0}}, 1e-5);
}

TEST(SpindleAngle, IsLogged) {
  const MeasuringRun run = run_measuring(
      at_pole("A=0.02 B=-0.05", "CYCLE150(10,1001,\"LOG.TXT\")\nCYCLE995(5,0,1,25,3,5,0,,100)"),
      {ball(), kCalibrated, kTiltedSpindle}, {});
  ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
  const std::string log = run.output.document.at("files").at("LOG.TXT");
  EXPECT_NE(log.find("Results measure:Angular deviation of the spindle / CYCLE995\n"), log.npos)
      << log;
  EXPECT_NE(log.find("Angle XZ         0.0000           0.0500           0.0500 deg\n"
                     "Angle YZ         0.0000           0.0200           0.0200 deg\n"),
            log.npos)
      << log;
}

TEST(SpindleAngle, EachMistakeIsAnAlarm) {
  const struct {
    const char* name;
    const char* call;
    int alarm;
  } kFaults[] = {
      {"not the spindle", "CYCLE995(102019,0,1,25,3,5,0,,100)", 61307},
      {"with a correction", "CYCLE995(102115,0,1,25,3,5,0,,100)", 61307},
      {"without turning along", "CYCLE995(101015,0,1,25,3,5,0,,100)", 61307},
      {"three balls", "CYCLE995(112015,0,1,25,3,5,0,,100)", 61307},
      {"a target", "CYCLE995(102015,1,1,25,3,5,0,,100)", 61307},
      {"no path", "CYCLE995(102015,0,1,25,0,5,0,,100)", 61308},
      {"no distance", "CYCLE995(102015,0,1,25,3,5,0,,0)", 61308},
      {"a distance downwards", "CYCLE995(102015,0,1,25,3,5,0,,-100)", 61308},
      {"no such record", "CYCLE995(102015,0,41,25,3,5,0,,100)", 61313},
      {"no diameter", "CYCLE995(102015,0,1,0,3,5,0,,100)", 61316},
      {"an angle beyond a turn", "CYCLE995(102015,0,1,25,3,5,400,,100)", 61331},
      {"not calibrated", "CYCLE995(102015,0,2,25,3,5,0,,100)", 61341},
      {"a probe of one direction", "$TC_DP1[1,1]=712\nCYCLE995(102015,0,1,25,3,5,0,,100)", 61309},
      {"no spindle to turn", "$MCS_AXIS_USAGE_ATTRIB[6]=512\nCYCLE995(5,0,1,25,3,5,0,,100)", 61372},
      {"the ball is elsewhere", "X-1.2\nCYCLE995(5,0,1,25,3,1,0,,100)", 61303},
      {"the shaft is too far from the ball", "B-0.5\nX-2.766\nCYCLE995(5,0,1,25,3,0.5,0,,100)",
       61303},
      {"no ball within the path", "X-40\nCYCLE995(5,0,1,25,3,5,0,,100)", 61301},
  };
  for (const auto& fault : some_of(kFaults)) {
    SCOPED_TRACE(fault.name);
    const MeasuringRun run =
        run_measuring(at_pole("", fault.call), {ball(), kCalibrated, kTiltedSpindle},
                      {"_OVI[9]", "$P_UIFR[1,X,FI]"});
    EXPECT_EQ(run.alarm(), fault.alarm) << run.output.errors;
    EXPECT_EQ(run.at("_OVI[9]"), fault.alarm);
    EXPECT_EQ(run.at("$P_UIFR[1,X,FI]"), 0.0);
  }
}

}  // namespace
}  // namespace g31::testing::spindle_angle_test

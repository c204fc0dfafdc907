// Touches on machines whose errors, heads and delays matter, against closed forms: what turns with
// a head, what leans with an axis, which of two signals comes first, where a turning tool touches.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::touches_of_real_machines_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

struct Program {
  const char* name;
  std::string text;
  std::string sheet;
};

/// What variables read after a program that must run through.
std::vector<double> read(const Program& program, const std::vector<std::string>& names) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(program.name, program.text)};
  options.setups = {folder.write("s.toml", program.sheet)};
  options.prints = names;
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  std::vector<double> values;
  for (const std::string& name : names) {
    values.push_back(output.document["variables"][name].get<double>());
  }
  return values;
}

constexpr double kUmPerM = 1e-6;

// X rolls by 100 um/m.  The head holds the stylus along -Y, 120 mm from the gauge point: the ball
// rises by their product, and so the axis comes 0.012 mm further down.
TEST(TouchesOfRealMachines, WhatAnAxisTiltsIsTheToolAsTheHeadHoldsIt) {
  const auto z = read({"head.nc", "O1\nG90G54G00A-90.\nZ50.\nG31Z-5.F100\n#500=#5063\nM30\n",
                       R"([control]
profile = "fanuc-30i"
[probe]
length = 120.0
stem_diameter = 2.0
[start]
Z = 100.0
[machine]
tool_side = "XYZA"
[machine.axes.A]
centre = [0.0, 0.0, 0.0]
[machine.errors]
EAX = 100.0
[[part]]
shape = "block"
at = [0.0, -120.0, 0.0]
)"},
                      {"#500"});
  EXPECT_NEAR(z[0], 3.0 + 100.0 * kUmPerM * 120.0, 1e-9);
}

// Z pitches by 100 um/m about Y: a ball 50 mm along X sinks by 0.005 mm beside the stylus that it
// hangs on, and touches so much earlier.
TEST(TouchesOfRealMachines, FurtherBallsAndProbesLeanWithTheirAxis) {
  const auto touched_by = [](const std::string& further, const std::string& beside) {
    return read({"lean.nc", "O1\nG90G54G31Z-5.F100\n#500=#5063\nM30\n", R"([control]
profile = "fanuc-30i"
[probe]
length = 120.0
stem_diameter = 2.0
)" + further + R"(
[start]
Z = 20.0
[machine.errors]
EBZ = 100.0
[[part]]
shape = "block"
length = 20.0
width = 20.0
at = [)" + beside + ", 0.0, -120.0]\n"},
                {"#500"})
        .front();
  };
  EXPECT_NEAR(touched_by("[[probe.ball]]\nat = [50.0, 0.0, 0.0]\narm_diameter = 0.0", "50.0"),
              3.0 + 100.0 * kUmPerM * 50.0, 1e-9);
  EXPECT_NEAR(touched_by("[probe.second]\nat = [200.0, 0.0, 0.0]", "200.0"),
              3.0 + 100.0 * kUmPerM * 200.0, 1e-9);
}

// Probe 1 touches 0.4 mm before probe 2, and its signal comes 0.1 s late, at 10 mm/s: 1 mm.
TEST(TouchesOfRealMachines, AMoveForTwoProbesEndsAtTheLaterSignalNotAtTheLaterTouch) {
  const auto r = read({"both.mpf",
                       "MEASA[Z]=(1,1,2) G1 G90 Z95 F600\nSTOPRE\n"
                       "R1=$AA_MM1[Z] R2=$AA_MM2[Z] R3=$AA_IM[Z]\nM30\n",
                       R"([control]
profile = "sinumerik-828d"
[probe]
length = 100.0
stem_diameter = 2.0
trigger_delay_s = 0.1
[probe.second]
at = [200.0, 0.0, 0.0]
trigger_delay_s = 0.0
[start]
Z = 130.0
[machine]
stopping = "ideal"
[[part]]
name = "a"
shape = "block"
at = [0.0, 0.0, 0.5]
[[part]]
name = "b"
shape = "block"
at = [200.0, 0.0, 0.1]
)"},
                      {"R1", "R2", "R3"});
  EXPECT_NEAR(r[0], 102.5, 1e-9);
  EXPECT_NEAR(r[1], 103.1, 1e-9);
  EXPECT_NEAR(r[2], 102.5, 1e-9);
}

// A ball mill of radius 4 swings about a line 150 mm above the gauge point: its centre goes round
// at a radius of 346 mm, to 4 + 10 mm before the middle of a cube of 20 mm.
TEST(TouchesOfRealMachines, ASwingingToolTouchesAsItIsTurnedThere) {
  const auto b = read({"swing.nc", "O1\nT5M6\nG91G31B-40.F600\n#500=#5065\nM30\n",
                       R"([control]
profile = "fanuc-30i"
[probe]
tool = 99
[machine]
tool_side = "XYZB"
stopping = "ideal"
[machine.axes.B]
centre = [0.0, 0.0, 150.0]
[[tool]]
number = 5
kind = "ball_mill"
length = 200.0
diameter = 8.0
[[tool_probe]]
size = 20.0
at = [103.5514, 0.0, -179.2103]
deflection_limit = 9.0
)"},
                      {"#500"});
  const double right = -std::asin((103.5514 - 14.0) / 346.0) * 180.0 / std::numbers::pi;
  EXPECT_NEAR(b[0], right, 1e-7) << "deg; 1e-6 are 6 nm at the ball";
}

/// Tool 1, of one tooth, beside a cube.
const std::string kOneTooth = R"([start]
X = 224.5
Z = 80.0
[machine]
stopping = "ideal"
[[tool]]
number = 1
length = 100.0
diameter = 16.0
[[tool.teeth]]
angle_deg = 0.0
[[tool_probe]]
size = 25.0
at = [200.0, 0.0, 0.0]
)";

// One tooth of radius 8 turns at 1000 rev/min while the axis comes from 24.5 mm away at 5 mm/s: the
// first root of x(t) + 8 cos(wt) = 12.5 along a trapezoid, by steps and halving.
double first_tooth_by_steps(double acceleration) {
  constexpr double kStart = 24.5;
  constexpr double kSpeed = 5.0;
  const double rate = 1000.0 / 60.0 * 2.0 * std::numbers::pi;
  const double ramp_s = kSpeed / acceleration;
  const auto place = [&](double t) {
    return kStart - (t < ramp_s ? 0.5 * acceleration * t * t : kSpeed * (t - 0.5 * ramp_s));
  };
  const auto gap = [&](double t) { return place(t) + 8.0 * std::cos(rate * t) - 12.5; };
  constexpr double kStep = 1e-6;
  double t = 0.0;
  while (gap(t + kStep) > 0.0) {
    t += kStep;
  }
  double low = t;
  double high = t + kStep;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (gap(middle) > 0.0 ? low : high) = middle;
  }
  return 200.0 + place(low);
}

TEST(TouchesOfRealMachines, ATurningToothHasTurnedOnWhileTheAxisGathersSpeed) {
  for (const double acceleration : {2000.0, 200.0}) {
    const auto x = read({"tooth.nc", "O1\nT1M6\nM3S1000\nG91G31X-15.F300\n#500=#5061\nM30\n",
                         R"([control]
profile = "fanuc-30i"
[probe]
tool = 99
)" + kOneTooth + "[machine.axes.X]\nacceleration = " +
                             std::to_string(acceleration) + "\n"},
                        {"#500"});
    EXPECT_NEAR(x[0], first_tooth_by_steps(acceleration), 1e-6) << acceleration;
  }
}

// A cutting speed turns the spindle as fast as S of the same tool does, whatever the block's order.
TEST(TouchesOfRealMachines, ASpindleTurnsByItsCuttingSpeed) {
  std::vector<double> places;
  for (const char* const speed : {"M3 S=1000", "M3 SVC=50.26548245743669",
                                  "SVC=50.26548245743669 M3", "M3 S=500 OVRA[S1]=200"}) {
    const auto x = read({"speed.mpf",
                         "T1 D1 M6\n" + std::string(speed) +
                             "\nG91 MEAS=2 G1 X-15 F300\nSTOPRE\nR1=$AA_MM[X]\nM30\n",
                         R"([control]
profile = "sinumerik-828d"
[probe]
tool = 99
[tools.1]
length = 0.0
radius = 8.0
)" + kOneTooth},
                        {"R1"});
    places.push_back(x[0]);
    EXPECT_NEAR(x[0], places.front(), 1e-9) << speed;
  }
  EXPECT_NEAR(places.front(), first_tooth_by_steps(2000.0), 1e-6);
}

}  // namespace
}  // namespace g31::touches_of_real_machines_test

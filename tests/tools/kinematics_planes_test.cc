// CYCLE9960 and CYCLE996 with a probe that lies along Y or X (G18, G19) on a head that stands
// turned in its basic position, and in programs that count in inches.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/five_axis_run.h"
#include "tests/support/kinematics_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::kinematics_planes_test {
namespace {

constexpr double kInch = 25.4;

/// A fork head whose pivot is 0.05 mm lower than believed; its basic position has the spindle along
/// an axis of the machine.
struct TurnedHead {
  const char* name;
  MisbelievedMachine machine;
  std::string data;    ///< NC text: the carrier there, what the machine counts for G55
  std::string home;    ///< the axes there, then over the ball
  std::string along;   ///< the axis of the probe
  std::string series;  ///< of CYCLE9960
  std::string plane;
  std::array<Point, 4> vectors;
};

MisbelievedMachine head(const machine::AxisChainSetup& chain, std::size_t axis) {
  MisbelievedMachine m{"", chain, chain, "", "", {}};
  m.truth.rotary.at(axis).p_M_centre += Point(0, 0, 0.05);
  return m;
}

/// C A: with A at -90 the spindle looks along Y.  What A carries, (0, -8, 220.05), is turned about
/// X by -90: (0, 220.05, 8).  The tip at XYZ = 0 is at (0, -348, 212), the control takes (0, -120,
/// 0).
TurnedHead along_y() {
  const Point i2(0, 13, 0);
  const Point i3(0, 220.05, 8);
  return {"G18",
          head(machine::worked::k4(), 0),
          "$TC_CARR25[1]=-90\n$TC_CARR15[1]=0 $TC_CARR16[1]=220 $TC_CARR17[1]=8\n"
          "$TC_CARR1[1]=0 $TC_CARR2[1]=-233 $TC_CARR3[1]=-8\n"
          "$P_UIFR[2]=CTRANS(X,150,Y,-40+228,Z,-400-212)\n",
          "G0 C0 A-90\nX0 Z0 Y={0}\nY={1}\n",
          "Y",
          "0,120,240,4,-60,0,-60,30,4,0",
          "2",
          {-i2 - i3, i2, i3, Point::Zero()}};
}

/// C B: with B at 90 the spindle looks along X.  What B carries, (-8, 5, 220.05), is turned about Y
/// by 90: (220.05, 5, 8).
TurnedHead along_x() {
  machine::AxisChainSetup chain = machine::worked::chain("", "XYZCB");
  chain.rotary[2].p_M_centre = {0, 5, 0};
  chain.rotary[1] = {{-8, 0, 220}, {0, 1, 0}};
  const Point i2(8, 0, 0);
  const Point i3(220.05, 5, 8);
  return {"G19",
          head(chain, 1),
          "$TC_CARR25[1]=90\n$TC_CARR15[1]=220 $TC_CARR16[1]=5 $TC_CARR17[1]=8\n"
          "$TC_CARR1[1]=-228 $TC_CARR2[1]=-5 $TC_CARR3[1]=-8\n"
          "$P_UIFR[2]=CTRANS(X,150+228,Y,-40,Z,-400-212)\n",
          "G0 C0 B90\nY0 Z0 X={0}\nX={1}\n",
          "X",
          "0,120,240,4,60,0,60,-30,4,0",
          "3",
          {-i2 - i3, i2, i3, Point::Zero()}};
}

std::vector<ExpectedValue> carrier_of(const std::array<Point, 4>& vectors, double unit = 1.0) {
  std::vector<ExpectedValue> expected;
  const std::vector<std::string> names = carrier_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    expected.push_back({names[i], vectors.at(i / 3)[static_cast<int>(i % 3)] / unit});
  }
  return expected;
}

std::string approach(const TurnedHead& turned) {
  return "T1 M6\n$SCS_MEA_KIN_MIN_ANG_TRIANGLE=10\n" + turned.data + turned.name + " G55 D1\n" +
         fmt::format(fmt::runtime(turned.home), 50, 15.5);
}

TEST(KinematicsPlanes, AHeadIsFoundWithTheProbeAlongYOrX) {
  for (const TurnedHead& turned : {along_y(), along_x()}) {
    for (const int variant : {11400, 11200}) {
      SCOPED_TRACE(fmt::format("{} {}", turned.name, variant));
      const std::vector<ExpectedValue> expected = carrier_of(turned.vectors);
      expect_values(run_on_sheets(approach(turned) +
                                      fmt::format("CYCLE9960({},\"\",1,25,{},1,3,5,1,{},0,0)\n",
                                                  variant, turned.series, turned.plane),
                                  kinematics_sheets(turned.machine), names_of(expected)),
                    expected, 1e-6);
    }
  }
}

/// Each position is approached along the probe, as $P_TOOLO has it.
TEST(KinematicsPlanes, SingleStepsFindItToo) {
  const TurnedHead turned = along_y();
  std::string program = approach(turned) + "TRAORI\n";
  const std::pair<int, int> kPlaces[] = {{120, -60}, {180, -60}, {240, -60},
                                         {0, -90},   {0, -60},   {0, 0}};
  int variant = 10401;
  for (const auto& [c, a] : kPlaces) {
    program += fmt::format(
        "G0 X0 Z0 Y300\nC{} A{}\nR1=$P_TOOLO[1] R2=$P_TOOLO[2] R3=$P_TOOLO[3]\n"
        "X=R1*100 Y=R2*100 Z=R3*100\nX=R1*15.6 Y=R2*15.6 Z=R3*15.6\n"
        "CYCLE996({},1,1,25,0,,,,,,,,3,5,1,,2,0)\nX=R1*100 Y=R2*100 Z=R3*100\nX0 Z0 Y300\n",
        c, a, variant);
    variant += variant == 10403 ? 9998 : 1;
  }
  const std::vector<ExpectedValue> expected = carrier_of(turned.vectors);
  expect_values(run_on_sheets(program + "CYCLE996(1000,1,1,25,,,,,,,,,,,,,2,0)",
                              kinematics_sheets(turned.machine), names_of(expected)),
                expected, 1e-6);
}

// Inches: what the program gives and gets, the fixed value of axis 2 along Z among it.

std::string in_inches(const MisbelievedMachine& machine, const std::string& code) {
  return "T1 M6\n" + code + " G54 D1\n$SCS_MEA_KIN_MIN_ANG_TRIANGLE=10\n" +
         "G0 X0 Y0 Z=50/25.4\nZ=15.5/25.4\n"
         "$SCS_MEA_KIN_MODE[0]=4 $SCS_MEA_KIN_MODE[1]=3 $SCS_MEA_KIN_VALUE[1]=R1\n" +
         fmt::format("CYCLE9960(11400,\"\",1,25/25.4,{},3/25.4,3/25.4,5/25.4,1,1,1,0)\n",
                     machine.series);
}

/// The tilting table: I3 ends 2 mm above I2 along the tilted C, as believed: straight up.
std::array<Point, 4> with_fixed(const MisbelievedMachine& machine) {
  const Point i3 = machine.vectors[2] + Point(0, 0, 2);
  return {Point::Zero(), machine.vectors[1], i3, -machine.vectors[1] - i3};
}

TEST(KinematicsInInches, G700CountsDataInInchesToo) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  const std::array<Point, 4> vectors = with_fixed(machine);
  std::vector<ExpectedValue> expected = carrier_of(vectors, kInch);
  for (int k = 0; k < 3; ++k) {
    expected.push_back({fmt::format("_OVR[{}]", 4 + k), vectors[1][k] / kInch});
    expected.push_back({fmt::format("_OVR[{}]", 15 + k), vectors[2][k] / kInch});
  }
  // Directions have no unit; A of the table against X.
  expected.push_back({"_OVR[7]", -1.0});
  const MeasuringRun run = run_on_sheets("R1=2/25.4\n" + in_inches(machine, "G700"),
                                         kinematics_sheets(machine), names_of(expected));
  expect_values(run, expected, 1e-6 / kInch);
}

TEST(KinematicsInInches, G70LeavesDataInMillimetres) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  const std::array<Point, 4> vectors = with_fixed(machine);
  std::vector<ExpectedValue> expected = carrier_of(vectors);
  for (int k = 0; k < 3; ++k) {
    expected.push_back({fmt::format("_OVR[{}]", 4 + k), vectors[1][k] / kInch});
  }
  const MeasuringRun run = run_on_sheets("R1=2\n" + in_inches(machine, "G70"),
                                         kinematics_sheets(machine), names_of(expected));
  expect_values(run, expected, 1e-6);
}

/// C off by (0.03, -0.02): at 180 degrees the ball is off by twice that.
TEST(KinematicsInInches, DeviationsAreThoseOfTheProgram) {
  MisbelievedMachine machine = misbelieved_machines().front();
  machine.truth = machine.believed;
  machine.truth.rotary[2].p_M_centre += Point(0.03, -0.02, 0);
  const MeasuringRun run =
      run_on_sheets("R1=0\n" + in_inches(machine, "G700"), kinematics_sheets(machine),
                    {"_OVR[160]", "_OVR[161]", "_OVR[164]"});
  expect_values(
      run, {{"_OVR[160]", -0.06 / kInch}, {"_OVR[161]", 0.04 / kInch}, {"_OVR[164]", 180.0}}, 1e-7);
}

}  // namespace
}  // namespace g31::testing::kinematics_planes_test

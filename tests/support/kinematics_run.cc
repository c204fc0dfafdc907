#include "tests/support/kinematics_run.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "tests/support/five_axis_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing {
namespace {

using machine::AxisChainSetup;
using machine::RotaryLine;

const Point kWorkOffset(150, -40, -400);
const Point kBall = kWorkOffset + Point(0.1, -0.2, 0.05);
const Point kOff(0.03, -0.02, 0.015);
constexpr double kTilt = 20.0 / 3600.0 * std::numbers::pi / 180.0;
constexpr std::size_t kA = 0;
constexpr std::size_t kB = 1;
constexpr std::size_t kC = 2;

/// Of the table's axis C: off and tilted towards X.
void misplace(RotaryLine& line) {
  line.p_M_centre += kOff;
  line.axis_M = Point(kTilt, 0, 1);
}

/// Where the circle of the ball about the true line of C has its middle, brought along Z to a
/// height.
Point middle_of(const RotaryLine& line, double z) {
  const Point n = line.axis_M.normalized();
  const Point middle = line.p_M_centre + n * n.dot(kBall - line.p_M_centre);
  return {middle.x(), middle.y(), z};
}

constexpr const char* kTableSeries = "0,-60,60,4,0,0,0,270,4,0";

/// A table that tilts about A, and C on it.
MisbelievedMachine tilting_table() {
  MisbelievedMachine m{"tilting table",       machine::worked::k1(),
                       machine::worked::k1(), "$SCS_MEA_KIN_MODE[0]=4 $SCS_MEA_KIN_MODE[1]=6",
                       kTableSeries,          {}};
  m.truth.rotary[kA].p_M_centre += kOff;
  misplace(m.truth.rotary[kC]);
  const Point i2(5, 19.98, -449.985);  // X as believed
  const Point i3 = middle_of(m.truth.rotary[kC], i2.z()) - i2;
  m.vectors = {Point::Zero(), i2, i3, -i2 - i3};
  return m;
}

/// The same with an axis at 45 degrees in place of A.
MisbelievedMachine leaning_table() {
  MisbelievedMachine m{"table at 45 degrees", machine::worked::k6(),
                       machine::worked::k6(), "$SCS_MEA_KIN_MODE[0]=6 $SCS_MEA_KIN_MODE[1]=6",
                       kTableSeries,          {}};
  m.truth.rotary[kB].p_M_centre += kOff;
  misplace(m.truth.rotary[kC]);
  // Believed is the common perpendicular's foot (30, 15, -345); its Z stays.
  const Point i2(30.03, -60.02 + 74.985, -345);
  const Point i3 = middle_of(m.truth.rotary[kC], -345) - i2;
  m.vectors = {Point::Zero(), i2, i3, -i2 - i3};
  return m;
}

MisbelievedMachine head_and_table(bool leans) {
  const AxisChainSetup chain = leans ? machine::worked::k3() : machine::worked::k2();
  MisbelievedMachine m{leans ? "head at 45 degrees and table" : "head and table",
                       chain,
                       chain,
                       "$SCS_MEA_KIN_MODE[1]=6",
                       kTableSeries,
                       {}};
  m.truth.rotary[kB].p_M_centre += Point(0, 0, 0.05);
  misplace(m.truth.rotary[kC]);
  // Of the pivot's 0.05 only what is square to the axis shows.
  const Point i2 = leans ? Point(0, 25 - 0.025, 160 + 0.025) : Point(10, 0, 180.05);
  const Point i3 = middle_of(m.truth.rotary[kC], leans ? -400 : -500);
  m.vectors = {-i2, i2, i3, -i3};
  return m;
}

MisbelievedMachine fork_head() {
  MisbelievedMachine m{"fork head", machine::worked::k4(),        machine::worked::k4(),
                       "",          "0,120,240,4,30,0,30,90,4,0", {}};
  m.truth.rotary[kA].p_M_centre += Point(0, 0, 0.05);
  const Point i2(0, 13, 0);
  const Point i3(0, -8, 220.05);
  m.vectors = {-i2 - i3, i2, i3, Point::Zero()};
  return m;
}

MisbelievedMachine leaning_head() {
  MisbelievedMachine m{"head at 45 degrees",           machine::worked::k5(),
                       machine::worked::k5(),          "",
                       "0,-180,180,6,60,0,-60,60,5,0", {}};
  m.truth.rotary[kB].p_M_centre += Point(0, 0, 0.05);
  const Point i2(0, 0.025, 0);
  const Point i3(0, 5 - 0.025, 145 + 0.025);
  m.vectors = {-i2 - i3, i2, i3, Point::Zero()};
  return m;
}

}  // namespace

std::vector<MisbelievedMachine> misbelieved_machines() {
  return {tilting_table(),      leaning_table(), head_and_table(false),
          head_and_table(true), fork_head(),     leaning_head()};
}

std::vector<std::string> kinematics_sheets(const MisbelievedMachine& machine) {
  return {five_axis_sheet(machine.truth, kWorkOffset), believed_sheet(machine.believed),
          "[[part]]\nname = \"ball\"\nshape = \"sphere\"\non = \"G54\"\nat = [0.1, -0.2, 0.05]\n"
          "diameter = 25.0\n"};
}

std::string over_the_ball(const std::string& body) {
  return "T1 M6\nG54 D1\n$SCS_MEA_KIN_MIN_ANG_TRIANGLE=10\nG0 X0 Y0 Z50\nZ15.5\n" + body;
}

std::string head_step(int variant, double c, double a) {
  return fmt::format(
      "TRAORI\nG0 X0 Y0 Z300\nC{0} A{1}\nR1=SIN({0})*SIN({1}) R2=-COS({0})*SIN({1}) R3=COS({1})\n"
      "X=R1*100 Y=R2*100 Z=R3*100\nX=R1*15.6 Y=R2*15.6 Z=R3*15.6\n"
      "CYCLE996({2},1,1,25,0,,,,,,,,3,5,1,,1,0)\nX=R1*100 Y=R2*100 Z=R3*100\nX0 Y0 Z300\n"
      "TRAFOOF\n",
      c, a, variant);
}

std::vector<std::string> carrier_names() {
  std::vector<std::string> names;
  for (const int n : {1, 2, 3, 4, 5, 6, 15, 16, 17, 18, 19, 20}) {
    names.push_back(fmt::format("$TC_CARR{}[1]", n));
  }
  return names;
}

}  // namespace g31::testing

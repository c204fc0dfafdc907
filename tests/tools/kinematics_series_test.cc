// The rotary axes of a machine are found where they are, however the other axis stood in the series
// and whichever component is fixed: also where their directions are not those that are entered.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/measuring_run.h"

namespace g31::testing::kinematics_series_test {
namespace {

constexpr const char* kProbe = R"([control]
profile = "sinumerik-828d"
[machine.axes.X]
travel = [-900.0, 900.0]
[machine.axes.Y]
travel = [-900.0, 900.0]
[machine.axes.Z]
travel = [-900.0, 900.0]
[tools.1]
length = 120.0
radius = 3.0
type = 710.0
name = "PROBE"
[probe]
ball_diameter = 6.0
length = 117.0
[[part]]
name = "ball"
shape = "sphere"
on = "G54"
diameter = 25.0
)";

/// A ball beside both axes, and rotary axis 1 or 2 out of the direction that is entered.
struct Machine {
  const char* name;
  const char* sheet;
  const char* series;  ///< of CYCLE9960: {} is where the other axis stands
  std::vector<int> places;
  int fixed;  ///< the rotary axis whose component is fixed, from 0
  std::vector<int> modes;
  std::vector<ExpectedValue> expected;
};

/// The table's C runs along Z through the origin, whatever tilts A.
const Machine kTables = {"two tables",
                         R"([machine]
table_side = "CA"
tool_side = "XYZ"
[machine.axes.A]
travel = [-120.0, 30.0]
centre = [0.0, 0.0, -450.0]
direction = [1.0, 0.0001, 0.0]
[machine.axes.C]
travel = [-36000.0, 36000.0]
centre = [0.0, 0.0, 0.0]
[believed.axes.A]
direction = [1.0, 0.0, 0.0]
[work_offsets.G54]
X = 150.0
Y = 80.0
Z = -420.0
)",  "0,-90,0,4,0,0,0,270,4,{}",
                         {0, -30, -90}, 0,
                         {0, 4},        {{"_OVR[4]+_OVR[15]", 0.0}, {"_OVR[5]+_OVR[16]", 0.0}}};

const Machine kMixed = {"a head under 45 degrees, a table",
                        R"([machine]
table_side = "C"
tool_side = "XYZB"
[machine.axes.B]
travel = [-180.0, 180.0]
centre = [0.0, 25.0, 160.0]
direction = [0.0002, 1.0, 1.0]
[machine.axes.C]
travel = [-36000.0, 36000.0]
centre = [0.0, 0.0, -400.0]
[believed.axes.B]
direction = [0.0, 1.0, 1.0]
[work_offsets.G54]
X = 150.0
Y = 80.0
Z = -380.0
)",
                        "0,-90,0,4,0,0,0,270,4,{}",
                        {0, -45, -90},
                        0,
                        {0, 5},
                        {{"_OVR[15]", 0.0}, {"_OVR[16]", 0.0}}};

/// I1 leads from C to where the machine counts.
const Machine kHead = {"two axes in the head",
                       R"([machine]
table_side = ""
tool_side = "XYZCA"
[machine.axes.C]
travel = [-36000.0, 36000.0]
centre = [3.0, 2.0, 160.0]
[machine.axes.A]
travel = [-120.0, 120.0]
centre = [40.0, 25.0, 160.0]
direction = [1.0, 0.0002, 0.0]
[believed.axes.A]
direction = [1.0, 0.0, 0.0]
centre = [0.0, 25.1, 160.0]
[work_offsets.G54]
X = 150.0
Y = 80.0
Z = -380.0
)",
                       "0,0,270,4,{},0,-60,60,4,0",
                       {0, -45, -60},
                       1,
                       {0, 1, 4},
                       {{"_OVR[1]", -3.0}, {"_OVR[2]", -2.0}}};

TEST(KinematicsSeries, AxesAreFoundWhereTheyAreHoweverTheOtherOneStood) {
  for (const Machine* const machine : {&kTables, &kMixed, &kHead}) {
    for (const int place : testing::some_of(machine->places)) {
      for (const int mode : machine->modes) {
        SCOPED_TRACE(fmt::format("{}, other axis at {}, mode {}", machine->name, place, mode));
        std::string program = fmt::format(
            "T1 M6\nG54 D1\n$SCS_MEA_KIN_MODE[0]=6 $SCS_MEA_KIN_MODE[1]=6\n"
            "$SCS_MEA_KIN_MODE[{}]={}\nG0 X0 Y0 "
            "Z50\nZ15.5\nCYCLE9960(10400,\"\",1,25,{},1,3,5,1,1,0,0)\n",
            machine->fixed, mode, fmt::format(fmt::runtime(machine->series), place));
        std::vector<std::string> names;
        for (std::size_t i = 0; i < machine->expected.size(); ++i) {
          names.push_back(fmt::format("R{}", 10 + i));
          program += fmt::format("{}={}\n", names.back(), machine->expected[i].name);
        }
        const MeasuringRun run =
            run_on_sheets(program + "G0 Z50\nM30\n", {kProbe, kCalibrated, machine->sheet}, names);
        ASSERT_EQ(run.output.exit_code, 0) << run.output.errors;
        for (std::size_t i = 0; i < names.size(); ++i) {
          EXPECT_NEAR(run.at(names[i]), machine->expected[i].value, 1e-9)
              << machine->expected[i].name;
        }
      }
    }
  }
}

}  // namespace
}  // namespace g31::testing::kinematics_series_test

// TRAORI by machine data 24100 and on: the same as by the tool carriers of the six machines, and
// what is wrong with the data.

#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/kinematics/kinematic_vectors.h"
#include "tests/support/effort.h"
#include "tests/support/five_axis_run.h"
#include "tests/support/kinematics_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::transformation_data_test {
namespace {

using namespace machine::worked;  // NOLINT(google-build-using-namespace)

std::string vector_text(const char* name, int n, const Point& p) {
  std::string text;
  for (int k = 0; k < 3; ++k) {
    text += fmt::format("$MC_TRAFO5_{}_{}[{}]={:.15f} ", name, n, k, p[k]);
  }
  return text + "\n";
}

/// The machine data of transformation n as the machine has them.
std::string data_text(const machine::AxisChainSetup& chain, int n) {
  const machine::KinematicVectors v = machine::vectors_of(chain).value();
  const int type = v.type == machine::KinematicType::Tool   ? 24
                   : v.type == machine::KinematicType::Part ? 40
                                                            : 56;
  std::string text = fmt::format(
      "$MC_TRAFO_TYPE_{0}={1} $MC_TRAFO_AXES_IN_{0}[3]={2} $MC_TRAFO_AXES_IN_{0}[4]={3}"
      "\n",
      n, type, v.axes[0] + 1, v.axes[1] + 1);
  text += vector_text("PART_OFFSET", n, type == 24 ? v.i1 : v.i4);
  text += vector_text("BASE_TOOL", n, type == 24 ? v.i3 : v.i2);
  text += vector_text("JOINT_OFFSET", n, type == 24 ? v.i2 : type == 56 ? v.i1 : Point::Zero());
  text += vector_text("JOINT_OFFSET_PART", n, type == 24 ? Point::Zero() : v.i3);
  text += vector_text("AXIS1", n, v.v1) + vector_text("AXIS2", n, v.v2);
  return text;
}

struct Machine {
  machine::AxisChainSetup chain;
  const char* turned;  ///< words of the rotary axes
};

std::vector<Machine> machines() {
  return {{k1(), "A35 C-70"}, {k2(), "B35 C-70"},   {k3(), "B90 C30"},
          {k4(), "C30 A-40"}, {k5(), "C-135 B180"}, {k6(), "B60 C25"}};
}

const std::vector<std::string> kNames = {"R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9"};

/// @param spoilt  NC text between the data and TRAORI
MeasuringRun held(const Machine& machine, const std::string& data, const std::string& on) {
  return run_on_sheets(
      "T1 M6\nG54 D1\n" + data + "R9=0\n" + on + "\nG0 X30 Y-20 Z10\n" + machine.turned +
          "\nR1=$AA_IM[X] R2=$AA_IM[Y] R3=$AA_IM[Z] R4=$AA_IW[X] R5=$AA_IW[Y] R6=$AA_IW[Z]\n"
          "R7=$P_TRAFO R8=$P_TRAFO_PARSET\nX31 A3=0.1 B3=-0.2 C3=1\nR9=$AA_IM[X]",
      {five_axis_sheet(machine.chain, Point(100, -50, -400))}, kNames);
}

TEST(TransformationData, MoveAsTheToolCarrierDoes) {
  for (const Machine& machine : some_of(machines())) {
    SCOPED_TRACE(machine.turned);
    const MeasuringRun by_carrier = held(machine, "", "TRAORI");
    ASSERT_EQ(by_carrier.alarm(), 0) << by_carrier.output.errors;
    EXPECT_EQ(by_carrier.at("R8"), 1.0);
    for (const int n : {1, 2}) {
      // The carrier says nothing: the data alone do.
      const MeasuringRun run = held(machine, "$TC_CARR1[0]=0\n" + data_text(machine.chain, n),
                                    fmt::format("TRAORI({})", n));
      ASSERT_EQ(run.alarm(), 0) << run.output.errors;
      for (const char* const name : {"R1", "R2", "R3", "R4", "R5", "R6", "R7", "R9"}) {
        EXPECT_NEAR(run.at(name), by_carrier.at(name), 1e-9) << name;
      }
      EXPECT_EQ(run.at("R8"), 2000.0 + n);
    }
  }
}

/// What they believe wrongly the tip is off by, and a sign, an offset and a direction count.
TEST(TransformationData, AreBelieved) {
  const Machine machine{k4(), "C30 A-40"};
  const std::string data = "$TC_CARR1[0]=0\n" + data_text(machine.chain, 1);
  const MeasuringRun right = held(machine, data, "TRAORI");
  const MeasuringRun longer = held(machine,
                                   data +
                                       "$MC_TRAFO5_BASE_TOOL_1[2]=220.05\n"
                                       "$MC_TRAFO5_PART_OFFSET_1[2]=-220.05\n",
                                   "TRAORI");
  // 0.05 along the tool less 0.05 along Z: (-sin 30 sin 40, cos 30 sin 40, cos 40 - 1).
  EXPECT_NEAR(longer.at("R1") - right.at("R1"), 0.05 * -0.321393805, 1e-9);
  EXPECT_NEAR(longer.at("R2") - right.at("R2"), 0.05 * 0.556670399, 1e-9);
  EXPECT_NEAR(longer.at("R3") - right.at("R3"), 0.05 * -0.233955557, 1e-9);
  const MeasuringRun turned =
      held({k4(), "C-30 A-40"}, data + "$MC_TRAFO5_ROT_SIGN_IS_PLUS_1[0]=0\n", "TRAORI");
  EXPECT_NEAR(turned.at("R1"), right.at("R1"), 1e-9);
  const MeasuringRun shifted =
      held({k4(), "C40 A-40"}, data + "$MC_TRAFO5_ROT_AX_OFFSET_1[0]=10\n", "TRAORI");
  EXPECT_NEAR(shifted.at("R2"), right.at("R2"), 1e-9);
  const MeasuringRun called = held({k4(), "C40 A-40"}, data, "TRAORI(,,,,10,0)");
  EXPECT_NEAR(called.at("R2"), right.at("R2"), 1e-9);
}

TEST(TransformationData, TheSwivelCycleFollowsTheTipByThem) {
  const std::string program =
      "G0 X10 Y20 Z30\nCYCLE800(0,\"\",10,57,0,0,0,20,0,0,0,0,0,1)\nR1=$AA_IM[X] R2=$AA_IM[Y] "
      "R3=$AA_IM[Z] R4=$P_TRAFO";
  const auto run = [&](const std::string& data) {
    return run_on_sheets("T1 M6\nG54 D1\n" + data + program,
                         {five_axis_sheet(k1(), Point(40, -25, -380))}, {"R1", "R2", "R3", "R4"});
  };
  const MeasuringRun by_carrier = run("");
  const MeasuringRun by_data = run(data_text(k1(), 1));
  const MeasuringRun by_second = run("$MC_TRAFO_TYPE_1=0\n" + data_text(k1(), 2));
  ASSERT_EQ(by_carrier.alarm(), 0) << by_carrier.output.errors;
  for (const char* const name : {"R1", "R2", "R3", "R4"}) {
    EXPECT_NEAR(by_data.at(name), by_carrier.at(name), 1e-9) << name;
    EXPECT_NEAR(by_second.at(name), by_carrier.at(name), 1e-9) << name;
  }
}

struct Wrong {
  const char* name;
  std::string text;  ///< behind the data
  int alarm;
  const char* said;
};

TEST(TransformationData, WhatIsWrongWithThemIsSaid) {
  const Wrong rows[] = {
      {"no direction", "$MC_TRAFO5_AXIS1_1[2]=0\nTRAORI", 4342, "error 1"},
      {"no second direction", "$MC_TRAFO5_AXIS2_1[0]=0\nTRAORI", 4342, "error 2"},
      {"no orientation", "$MC_TRAFO5_BASE_ORIENT_1[2]=0\nTRAORI", 4342, "error 3"},
      {"parallel", "$MC_TRAFO5_AXIS2_1[0]=0 $MC_TRAFO5_AXIS2_1[2]=1\nTRAORI", 4342, "error 4"},
      {"one axis of two kinds", "$MC_TRAFO_TYPE_1=56 $MC_TRAFO_AXES_IN_1[4]=0\nTRAORI", 4342,
       "error 5"},
      {"an axis that is straight", "$MC_TRAFO_AXES_IN_1[4]=1\nTRAORI", 4342, ""},
      {"a type that is not there", "$MC_TRAFO_TYPE_1=256\nTRAORI", 14100, "256"},
      {"changed while it is active", "TRAORI\n$MC_TRAFO5_BASE_TOOL_1[2]=221\nNEWCONF", 4343, ""},
      {"another type while it is active", "TRAORI\n$MC_TRAFO_TYPE_1=72\nNEWCONF", 4343, ""},
      {"changed and put back",
       "TRAORI\n$MC_TRAFO5_BASE_TOOL_1[2]=221\n"
       "$MC_TRAFO5_BASE_TOOL_1[2]=220\nNEWCONF",
       0, ""},
      {"changed while it is off", "TRAORI\nTRAFOOF\n$MC_TRAFO5_BASE_TOOL_1[2]=221\nNEWCONF", 0, ""},
  };
  for (const Wrong& row : rows) {
    SCOPED_TRACE(row.name);
    const MeasuringRun run = run_on_sheets(
        "T1 M6\nG54 D1\n" + data_text(k4(), 1) + row.text + "\nR1=5",
        {five_axis_sheet(k4(), Point(300, 100, -500))}, {"R1", "$AA_IM[A]", "$AA_IM[C]"});
    EXPECT_EQ(run.alarm(), row.alarm) << run.output.errors;
    EXPECT_NE(run.output.errors.find(row.said), std::string::npos) << run.output.errors;
    EXPECT_EQ(run.at("R1"), row.alarm == 0 ? 5.0 : 0.0);
    EXPECT_EQ(run.at("$AA_IM[A]"), 0.0);
    EXPECT_EQ(run.at("$AA_IM[C]"), 0.0);
  }
}

}  // namespace
}  // namespace g31::testing::transformation_data_test

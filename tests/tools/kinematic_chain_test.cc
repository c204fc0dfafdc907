// What a machine's builder writes of rotary axes as a kinematic chain: carriers and transformations
// on it, and what CYCLE9960 and CYCLE996 correct there.

#include <cstddef>
#include <regex>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/kinematics/kinematic_vectors.h"
#include "tests/support/effort.h"
#include "tests/support/five_axis_run.h"
#include "tests/support/kinematic_chain_text.h"
#include "tests/support/kinematics_run.h"
#include "tests/support/worked_machines.h"

namespace g31::testing::kinematic_chain_test {
namespace {

std::vector<std::string> carrier_data(int number) {
  std::vector<std::string> names;
  for (int n = 1; n <= 20; ++n) {
    names.push_back(fmt::format("$TC_CARR{}[{}]", n, number));
  }
  return names;
}

/// Carrier 1 is made of the sheet by other code.
TEST(KinematicChain, SaysWhatTheSheetsCarrierDoes) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    SCOPED_TRACE(machine.name);
    std::vector<std::string> names = carrier_data(1);
    for (const int number : {2, 1001}) {
      const std::vector<std::string> more = carrier_data(number);
      names.insert(names.end(), more.begin(), more.end());
    }
    const MeasuringRun run =
        run_on_sheets(chain_text(machine.believed), kinematics_sheets(machine), names);
    EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
    for (std::size_t i = 0; i < 20; ++i) {
      EXPECT_NEAR(run.at(names[20 + i]), run.at(names[i]), 1e-12) << names[20 + i];
      EXPECT_NEAR(run.at(names[40 + i]), run.at(names[i]), 1e-12) << names[40 + i];
    }
  }
}

TEST(KinematicChain, ATransformationOnItMovesAsOneByACarrier) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    SCOPED_TRACE(machine.name);
    const auto places = [&](const std::string& on) {
      std::string program =
          chain_text(machine.believed) + "T1 M6\nG54 D1\n" + on + "\nG0 X5 Y-7 Z80\n";
      for (int i = 1; i <= 3; ++i) {
        program += fmt::format("AX[$TC_CARR21[1]]={} AX[$TC_CARR22[1]]={}\n", 20 * i, -15 * i);
        program += fmt::format("R{}=$AA_IM[X] R{}=$AA_IM[Y] R{}=$AA_IM[Z]\n", i, 10 + i, 20 + i);
      }
      return run_on_sheets(program + "R30=$P_TRAFO_PARSET", kinematics_sheets(machine),
                           {"R1", "R2", "R3", "R11", "R12", "R13", "R21", "R22", "R23", "R30"});
    };
    const MeasuringRun expected = places("TRAORI");
    const MeasuringRun run = places("TRAFOON(\"CHAIN\")");
    EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
    EXPECT_EQ(expected.output.exit_code, 0) << expected.output.errors;
    for (const char* const name : {"R1", "R2", "R3", "R11", "R12", "R13", "R21", "R22", "R23"}) {
      EXPECT_NEAR(run.at(name), expected.at(name), 1e-9) << name;
    }
    EXPECT_EQ(run.at("R30"), 1001.0);
  }
}

std::string measured(const MisbelievedMachine& machine, const char* name, int variant = 11400) {
  return fmt::format("CYCLE9960({},\"{}\",1,25,{},1,3,5,1,1,0,0)\n", variant, name, machine.series);
}

/// The vectors that the chain comes to, and by how much the cycle says that they have changed.
std::vector<ExpectedValue> vectors_of(const MisbelievedMachine& machine, int number,
                                      const machine::KinematicVectors& before) {
  std::vector<ExpectedValue> expected;
  const Point& i2 = machine.vectors[1];
  const Point& i3 = machine.vectors[2];
  for (int k = 0; k < 3; ++k) {
    expected.push_back({fmt::format("$TC_CARR{}[{}]", 4 + k, number), i2[k]});
    expected.push_back({fmt::format("$TC_CARR{}[{}]", 15 + k, number), i3[k]});
    expected.push_back({fmt::format("R{}", 21 + k), i2[k] - before.i2[k]});
    expected.push_back({fmt::format("R{}", 24 + k), i3[k] - before.i3[k]});
    expected.push_back({fmt::format("_OVR[{}]", 21 + k), 0.0});
    expected.push_back({fmt::format("_OVR[{}]", 24 + k), 0.0});
  }
  return expected;
}

const std::string kKept =
    "R21=_OVR[21] R22=_OVR[22] R23=_OVR[23] R24=_OVR[24] R25=_OVR[25] R26=_OVR[26]\n";

/// What a sheet says of the machine is a chain, too: as the carrier, and corrected like one that a
/// builder has written.
TEST(KinematicChain, IsFilledFromTheSheet) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    SCOPED_TRACE(machine.name);
    std::string program = "T1 M6\nG54 D1\n";
    std::vector<std::string> names;
    int r = 0;
    for (int n = 1; n <= 25; ++n) {
      if (n == 13 || n == 14 || n == 21 || n == 22 || n == 23) {
        continue;
      }
      program += fmt::format("R{0}=$TC_CARR{1}[1020]-$TC_CARR{1}[1]\n", ++r, n);
      names.push_back(fmt::format("R{}", r));
    }
    const MeasuringRun same = run_on_sheets(program, kinematics_sheets(machine), names);
    EXPECT_EQ(same.alarm(), 0) << same.output.errors;
    for (const std::string& name : names) {
      EXPECT_NEAR(same.at(name), 0.0, 1e-12) << name;
    }
    const std::string call = measured(machine, "SHEET");
    std::vector<ExpectedValue> expected =
        vectors_of(machine, 1020, machine::vectors_of(machine.believed).value());
    const MeasuringRun run =
        run_on_sheets(over_the_ball(machine.settings + "\n" + call + kKept + call),
                      kinematics_sheets(machine), names_of(expected));
    expect_values(run, expected, 1e-6);
  }
}

TEST(KinematicChain, AFilledOneMovesAsTraori) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    SCOPED_TRACE(machine.name);
    const auto run = [&](const std::string& on) {
      return run_on_sheets("T1 M6\nG54 D1\n" + on +
                               "\nG0 X30 Y-20 Z10\nA3=0.2 B3=-0.1 C3=1\nR1=$AA_IM[X] "
                               "R2=$AA_IM[Y] R3=$AA_IM[Z]",
                           kinematics_sheets(machine), {"R1", "R2", "R3"});
    };
    const MeasuringRun by_carrier = run("TRAORI");
    const MeasuringRun by_chain = run("TRAFOON(\"SHEET\")");
    EXPECT_EQ(by_chain.alarm(), 0) << by_chain.output.errors;
    for (const char* const name : {"R1", "R2", "R3"}) {
      EXPECT_NEAR(by_chain.at(name), by_carrier.at(name), 1e-9);
    }
  }
}

/// Measured, then measured again: nothing is left.
TEST(KinematicChain, ItsElementsTakeWhatIsMeasured) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    for (const auto& [name, number] : {std::pair("CHAIN", 1001), std::pair("CARRIED", 2)}) {
      SCOPED_TRACE(machine.name + " " + name);
      const std::string call = measured(machine, name);
      const std::vector<ExpectedValue> expected =
          vectors_of(machine, number, machine::vectors_of(machine.believed).value());
      const MeasuringRun run =
          run_on_sheets(chain_text(machine.believed) +
                            over_the_ball(machine.settings + "\n" + call + kKept + call),
                        kinematics_sheets(machine), names_of(expected));
      expect_values(run, expected, 1e-6);
    }
  }
}

TEST(KinematicChain, SingleStepsCorrectItToo) {
  const MisbelievedMachine machine = misbelieved_machines().at(4);
  std::string steps;
  for (const auto& [variant, c, a] :
       {std::tuple(10401, 120, 30), std::tuple(10402, 180, 30), std::tuple(10403, 240, 30),
        std::tuple(20401, 0, 0), std::tuple(20402, 0, 30), std::tuple(20403, 0, 90)}) {
    std::string step = head_step(variant, c, a);
    steps += step.replace(step.find(",1,1,25,"), 8, ",2,1,25,");
  }
  std::vector<ExpectedValue> expected;
  for (int k = 0; k < 3; ++k) {
    expected.push_back({fmt::format("$TC_CARR{}[2]", 4 + k), machine.vectors[1][k]});
    expected.push_back({fmt::format("$TC_CARR{}[2]", 15 + k), machine.vectors[2][k]});
  }
  // Along the head's way the elements run against the vectors.
  expected.push_back({"$NK_OFF_DIR[9,2]", -0.05});
  expected.push_back({"$NK_OFF_DIR[6,2]", 0.0});
  const MeasuringRun run =
      run_on_sheets(chain_text(machine.believed) + over_the_ball(steps + "CYCLE996(1000,2,1)"),
                    kinematics_sheets(machine), names_of(expected));
  expect_values(run, expected, 1e-6);
}

const char* const kResults = R"(Difference of vector before: X [mm]     Y [mm]      Z [mm]
CORR1                       0.00000     0.00000     0.00000
CORR2                       0.00000     0.00000     0.00000
Results:
Difference of vector:       X [mm]      Y [mm]      Z [mm]
CORR1                       0.00000     0.00000     0.00000
CORR2                       0.03000    -0.02000     0.00000
)";

TEST(KinematicChain, TheLogNamesItsElements) {
  MisbelievedMachine machine = misbelieved_machines().front();
  machine.truth = machine.believed;
  machine.truth.rotary[2].p_M_centre += Point(0.03, -0.02, 0);
  const MeasuringRun run =
      run_on_sheets(chain_text(machine.believed) +
                        over_the_ball(machine.settings + "\nCYCLE150(10,1001,\"LOG.TXT\")\n" +
                                      measured(machine, "CHAIN", 10400)),
                    kinematics_sheets(machine), {});
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  const std::string log = run.output.document.at("files").value("LOG.TXT", "missing");
  EXPECT_TRUE(log.ends_with(kResults)) << log;
  EXPECT_NE(log.find("Name / number :CHAIN / 1001"), std::string::npos) << log;
}

struct Fault {
  const char* name;
  std::string before;
  std::string program;
  int alarm;
};

/// The alarm comes, no element has changed.
void expect_refused(const Fault& fault) {
  SCOPED_TRACE(fault.name);
  const MisbelievedMachine machine = misbelieved_machines().front();
  const std::vector<std::string> names = {"$NK_OFF_DIR[5,0]", "$NK_OFF_DIR[8,0]",
                                          "$NK_OFF_DIR[5,1]", "$NK_OFF_DIR[8,1]"};
  const MeasuringRun run = run_on_sheets(chain_text(machine.believed) + fault.before + "\n" +
                                             over_the_ball(machine.settings + "\n" + fault.program),
                                         kinematics_sheets(machine), names);
  EXPECT_EQ(run.alarm(), fault.alarm) << run.output.errors;
  for (const std::string& name : names) {
    EXPECT_EQ(run.at(name), 0.0) << name;
  }
}

TEST(KinematicChain, WhatIsWrongIsSaid) {
  const std::string call = measured(misbelieved_machines().front(), "CHAIN");
  const Fault kFaults[] = {
      {"a name that is not there", "", "TRAFOON(\"OTHER\")", 14100},
      {"an element that is not there", "$NT_P_CHAIN_LAST_ELEM[1]=\"P8\"", "TRAFOON(\"CHAIN\")",
       4342},
      {"no beginning", "$TC_CARR_KIN_PART_START[2]=\"X\"", "TCARR=2", 4342},
      {"a chain that bites its tail", "$NK_NEXT[10]=\"P0\" $NK_PARALLEL[1]=\"\"",
       "TRAFOON(\"CHAIN\")", 4342},
      {"an axis that is not there", "$NK_AXIS[6]=\"Q1\"", "TRAFOON(\"CHAIN\")", 4342},
      {"an axis that is straight", "$NK_AXIS[6]=\"X1\"", "TRAFOON(\"CHAIN\")", 4342},
      {"no direction", "$NK_OFF_DIR[6,0]=0 $NK_OFF_DIR[6,1]=0 $NK_OFF_DIR[6,2]=0",
       "TRAFOON(\"CHAIN\")", 4342},
      {"a slide on a rotary axis", "$NK_TYPE[7]=\"AXIS_LIN\" $NK_OFF_DIR[7,0]=1",
       "TRAFOON(\"CHAIN\")", 4342},
      {"no rotary axis", "$NT_P_CHAIN_LAST_ELEM[1]=\"P0\"", "TRAFOON(\"CHAIN\")", 4342},
      {"a type that is not simulated", "$NK_TYPE[5]=\"SWITCH\"", "TRAFOON(\"CHAIN\")", 4342},
      {"a transformation that is not simulated", "$NT_TRAFO_TYPE[1]=\"TRACYL\"",
       "TRAFOON(\"CHAIN\")", 4342},
      {"a fourth component", "$NK_OFF_DIR[5,3]=1", "", 17030},
      {"a vector that the chain says", "$TC_CARR4[2]=1", "", 17070},
      {"an axis that the chain says", "$TC_CARR21[2]=B", "", 17070},
      {"closed at an element of the other side", "$NT_CLOSE_CHAIN_P[1]=\"X\"", "TRAFOON(\"CHAIN\")",
       4342},
      {"no correction element", "$NT_CORR_ELEM_P[1,1]=\"\"", call, 61430},
      {"a correction element that is an axis", "$NT_CORR_ELEM_P[1,1]=\"ROT2\"", call, 61430},
      {"a correction element at another place", "$NT_CORR_ELEM_P[1,1]=\"CORR1\"", call, 61430},
      {"heads that are adapted", "", measured(misbelieved_machines().front(), "CHAIN", 11402),
       61307},
  };
  for (const Fault& fault : some_of(kFaults)) {
    expect_refused(fault);
  }
}

/// A head whose chain is open: what it is off the reference goes before its first axis.
TEST(KinematicChain, AHeadIsAdaptedToTheReference) {
  const MisbelievedMachine machine = misbelieved_machines().at(4);
  const std::string open = "$NT_CNTRL[1]=128 $NT_CORR_ELEM_T[1,2]=\"T1\"\n";
  std::vector<ExpectedValue> expected;
  for (int k = 0; k < 3; ++k) {
    expected.push_back({fmt::format("R{}", 1 + k), machine.vectors[0][k]});
    expected.push_back({fmt::format("R{}", 4 + k), machine.vectors[1][k]});
    expected.push_back({fmt::format("R{}", 7 + k), machine.vectors[2][k]});
  }
  // As with a tool carrier: Z of the axes stays as entered by the reference head.
  expected[6].value -= 0.4;
  expected[7].value += 0.4;
  const std::string kept =
      "R1=$TC_CARR1[1001] R2=$TC_CARR2[1001] R3=$TC_CARR3[1001] R4=$TC_CARR4[1001] "
      "R5=$TC_CARR5[1001] R6=$TC_CARR6[1001] R7=$TC_CARR15[1001] R8=$TC_CARR16[1001] "
      "R9=$TC_CARR17[1001]\n";
  const std::string wrong =
      "$NK_OFF_DIR[4,2]=219 $NK_OFF_DIR[7,2]=-0.4 $NK_OFF_DIR[10,2]=-219.8\nG0 X0 Y0 Z15.5\n";
  const MeasuringRun run =
      run_on_sheets(chain_text(machine.believed) + open +
                        over_the_ball(measured(machine, "CHAIN", 11401) + wrong +
                                      measured(machine, "CHAIN", 11402) + kept),
                    kinematics_sheets(machine), names_of(expected));
  EXPECT_EQ(run.alarm(), 0) << run.output.errors;
  expect_values(run, expected, 1e-6);
}

/// The table's chain ends elsewhere than at its beginning: open it has another I4, closed behind an
/// element of it the axes behind that move.
TEST(KinematicChain, ASideIsClosedWhereItsDataSay) {
  const std::string text =
      chain_text(machine::worked::k1()) + "$NK_OFF_DIR[10,0]=$NK_OFF_DIR[10,0]+7\n";
  const auto i_of = [&](const std::string& data) {
    return run_on_sheets(text + data, {five_axis_sheet(machine::worked::k1(), Point::Zero())},
                         {"$TC_CARR4[1001]", "$TC_CARR15[1001]", "$TC_CARR18[1001]"});
  };
  const auto expect = [&](const std::string& data, double i2, double i3, double i4) {
    SCOPED_TRACE(data);
    expect_values(i_of(data),
                  {{"$TC_CARR4[1001]", i2}, {"$TC_CARR15[1001]", i3}, {"$TC_CARR18[1001]", i4}},
                  1e-12);
  };
  expect("$NT_CNTRL[1]=384", 5, 0, -5);
  expect("$NT_CNTRL[1]=0", 5, 0, 2);
  expect("$NT_CLOSE_CHAIN_P[1]=\"P0\"", -2, 0, 2);
  expect("$NT_CLOSE_CHAIN_P[1]=\"ROT1\"", 5, -7, 2);
}

}  // namespace
}  // namespace g31::testing::kinematic_chain_test

// CYCLE9960 and CYCLE996 on machines whose control believes what is nearly true.

#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/kinematics_run.h"

namespace g31::testing::kinematics_cycle_test {
namespace {

std::string measure(const MisbelievedMachine& machine, int variant) {
  return fmt::format("CYCLE9960({},\"\",1,25,{},1,3,5,1,1,0,0)\n", variant, machine.series);
}

std::vector<std::string> results() {
  std::vector<std::string> names = carrier_names();
  for (const int n : {1, 2, 3, 4, 5, 6, 15, 16, 17, 18, 19, 20}) {
    names.push_back(fmt::format("_OVR[{}]", n));
  }
  return names;
}

/// Carrier 1 and, where they were measured, the results have these vectors.
void expect_vectors(const MeasuringRun& run, const std::array<Point, 4>& vectors,
                    bool of_results = true) {
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  const std::vector<std::string> names = results();
  for (std::size_t i = 0; i < (of_results ? 24U : 12U); ++i) {
    const double expected = vectors.at(i % 12 / 3)[static_cast<int>(i % 3)];
    EXPECT_NEAR(run.at(names[i]), expected, 1e-6) << names[i];
  }
}

TEST(Kinematics, AreFoundWhereTheMachineTrulyHasThem) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    for (const int variant : {11400, 11200}) {
      SCOPED_TRACE(fmt::format("{} {}", machine.name, variant));
      expect_vectors(
          run_on_sheets(over_the_ball(machine.settings + "\n" + measure(machine, variant)),
                        kinematics_sheets(machine), results()),
          machine.vectors);
    }
  }
}

TEST(Kinematics, AreTheSameWhenTheyAreMeasuredAgain) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    SCOPED_TRACE(machine.name);
    const std::string call = measure(machine, 11400);
    expect_vectors(run_on_sheets(over_the_ball(machine.settings + "\n" + call + call),
                                 kinematics_sheets(machine), results()),
                   machine.vectors);
  }
}

// The cycle turns axes in machine positions, whatever a work offset says of them.
TEST(Kinematics, AreTheSameWithRotaryValuesOfAWorkOffset) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  expect_vectors(run_on_sheets("$P_UIFR[1,A,TR]=0.2 $P_UIFR[1,C,TR]=30\n" +
                                   over_the_ball(machine.settings + "\n" + measure(machine, 11400)),
                               kinematics_sheets(machine), results()),
                 machine.vectors);
}

TEST(Kinematics, StayAsTheyAreEnteredWhereOnlyMeasured) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    SCOPED_TRACE(machine.name);
    const std::vector<std::string> sheets = kinematics_sheets(machine);
    const MeasuringRun before = run_on_sheets("T1 M6", sheets, results());
    const MeasuringRun run = run_on_sheets(
        over_the_ball(machine.settings + "\n" + measure(machine, 10400)), sheets, results());
    EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
    for (const std::string& name : carrier_names()) {
      EXPECT_EQ(run.at(name), before.at(name)) << name;
    }
  }
}

TEST(Kinematics, CorrectOnlyTakesWhatWasMeasured) {
  for (const MisbelievedMachine& machine : some_of(misbelieved_machines())) {
    SCOPED_TRACE(machine.name);
    expect_vectors(run_on_sheets(over_the_ball(measure(machine, 10400) + machine.settings +
                                               "\nCYCLE9960(12400,\"\",1)"),
                                 kinematics_sheets(machine), results()),
                   machine.vectors);
  }
}

/// With the transformation that the cycle finds, it leaves: the probe is where it was, turned back.
TEST(Kinematics, LeaveTheProbeAndTheTransformationAsTheyWere) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  const MeasuringRun run = run_on_sheets(
      over_the_ball("TRAORI\n" + measure(machine, 10400) +
                    "R1=$P_TRAFO R2=$AA_IM[A] R3=$AA_IM[C] R4=$AA_IW[X] R5=$AA_IW[Y] "
                    "R6=$AA_IW[Z] R7=$P_UIFRNUM R8=$P_TOOL R9=$P_TC"),
      kinematics_sheets(machine), {"R1", "R2", "R3", "R4", "R5", "R6", "R7", "R8", "R9"});
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  const double kExpected[] = {40, 0, 0, 0.1, -0.2, 15.5, 1, 1, 0};
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(run.at(fmt::format("R{}", i + 1)), kExpected[i], 1e-6) << i + 1;
  }
}

/// The probe that comes is late and its ball beside the spindle: calibrated on the ball itself, it
/// finds the same.
TEST(Kinematics, TheProbeMayBeCalibratedOnTheBallBefore) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  std::vector<std::string> sheets = kinematics_sheets(machine);
  sheets.emplace_back("[probe]\neccentricity = [0.02, -0.03]\n");
  const auto call = [&](int mode) {
    return over_the_ball(
        machine.settings + "\n" +
        fmt::format("CYCLE9960(11400,\"\",1,25,{},1,3,5,1,1,{},0)", machine.series, mode));
  };
  expect_vectors(run_on_sheets(call(10), sheets, results()), machine.vectors);
}

/// The reference measurement, then the deviations by which the believed table is wrong: a ball at C
/// = 180 is off by twice what the axis is.
TEST(Kinematics, DeviationsAreThoseOfTheBelievedTable) {
  MisbelievedMachine machine = misbelieved_machines().front();
  machine.truth = machine.believed;
  machine.truth.rotary[2].p_M_centre += Point(0.03, -0.02, 0);
  const MeasuringRun run =
      run_on_sheets(over_the_ball(measure(machine, 10400)), kinematics_sheets(machine),
                    {"_OVR[120]", "_OVR[121]", "_OVR[130]", "_OVR[135]", "_OVR[138]", "_OVR[160]",
                     "_OVR[161]", "_OVR[162]", "_OVR[163]", "_OVR[164]"});
  expect_values(run,
                {{"_OVR[120]", 4.0},
                 {"_OVR[121]", 3.0},
                 {"_OVR[130]", 0.0},
                 {"_OVR[135]", 0.0},
                 {"_OVR[138]", -60.0},
                 {"_OVR[160]", -0.06},
                 {"_OVR[161]", 0.04},
                 {"_OVR[162]", 0.0},
                 {"_OVR[163]", 0.0},
                 {"_OVR[164]", 180.0}},
                1e-6);
}

std::string steps(int way) {
  return head_step(10001 + way, 120, 30) + head_step(10002 + way, 180, 30) +
         head_step(10003 + way, 240, 30) + head_step(20001 + way, 0, 0) +
         head_step(20002 + way, 0, 30) + head_step(20003 + way, 0, 90);
}

/// A shaft below the ball lies across where the table has tilted by 90 degrees, along Y of the
/// probe.
TEST(Kinematics, AShaftIsAvoidedWhereItIsKnown) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  std::vector<std::string> sheets = kinematics_sheets(machine);
  sheets.back() +=
      "[[part]]\nname = \"shaft\"\nshape = \"cylinder\"\non = \"G54\"\n"
      "at = [0.1, -0.2, -6.0]\ndiameter = 8.0\nheight = 60.0\n";
  const auto call = [&](int way, int mode) {
    return over_the_ball(
        machine.settings + "\n$SCS_MEA_KIN_BALL_VEC[2]=-1\n" +
        fmt::format("CYCLE9960(11{}00,\"\",1,25,0,-90,90,4,0,0,0,270,4,0,1,3,5,1,1,{},0)", way,
                    mode));
  };
  for (const int way : {2, 4}) {
    SCOPED_TRACE(way);
    // Touched on the way: a collision on the circle, alarm 61302 on lines.
    EXPECT_EQ(run_on_sheets(call(way, 0), sheets, {}).alarm(), way == 4 ? 61302 : 0);
    EXPECT_NE(run_on_sheets(call(way, 0), sheets, {}).output.exit_code, 0);
    expect_vectors(run_on_sheets(call(way, 100), sheets, results()), machine.vectors);
  }
}

/// A table that only turns: I2 to the axis, I4 back, there is no axis 2.
TEST(Kinematics, OneRotaryAxisIsEnough) {
  MisbelievedMachine machine = misbelieved_machines().front();
  for (machine::AxisChainSetup* const chain : {&machine.believed, &machine.truth}) {
    chain->table_side = "C";
    chain->tool_side = "XYZ";
    chain->rotary[2] = {Point(5, -3, -20), Point(0, 0, 1)};
  }
  machine.truth.rotary[2].p_M_centre += Point(0.03, -0.02, 0);
  const Point i2(5.03, -3.02, -20);
  const MeasuringRun run =
      run_on_sheets(over_the_ball("$SCS_MEA_KIN_MODE[0]=6\n"
                                  "CYCLE9960(11400,\"\",1,25,0,0,270,4,0,0,0,0,0,0,1,3,5,1,1,0,0)"),
                    kinematics_sheets(machine), results());
  expect_vectors(run, {Point::Zero(), i2, Point::Zero(), -i2});
  EXPECT_EQ(run_on_sheets(over_the_ball("CYCLE9960(51400,\"\",1,25,0,0,270,4,0,0,0,0,0,0,1,3,5)"),
                          kinematics_sheets(machine), {})
                .alarm(),
            61307);
}

/// A swivelled plane of a table stays what it is, the probe over the ball in it.
TEST(Kinematics, LeaveASwivelledPlaneAsItWas) {
  MisbelievedMachine machine = misbelieved_machines().front();
  machine.truth = machine.believed;
  const std::string plane =
      "G0 Z80\nCYCLE800(0,\"\",0,57,0,0,0,20,0,0,0,0,0,1)\nG0 X0.1 Y-0.2 Z80\nZ16\n";
  const MeasuringRun run = run_on_sheets(
      over_the_ball(plane + machine.settings + "\n" + measure(machine, 11400) +
                    "R1=$P_TC R2=$P_PARTFRAME[X,RT] R3=$P_WPFRAME[X,RT] R4=$P_ACTFRAME[X,RT] "
                    "R5=$AA_IW[Z]"),
      kinematics_sheets(machine), {"R1", "R2", "R3", "R4", "R5"});
  expect_values(run, {{"R1", 1.0}, {"R2", -20.0}, {"R3", 20.0}, {"R4", 0.0}, {"R5", 16.0}}, 1e-6);
}

/// The reference position is where the axes stand; work coordinates may be turned.
TEST(Kinematics, MayBeginAnywhere) {
  const std::vector<MisbelievedMachine> machines = misbelieved_machines();
  const MisbelievedMachine& table = machines.front();
  expect_vectors(run_on_sheets(over_the_ball(table.settings +
                                             "\nZ100\nTRAORI\nC30\nX0.1 Y-0.2\n"
                                             "Z15.5\n" +
                                             measure(table, 11400)),
                               kinematics_sheets(table), results()),
                 table.vectors);
  expect_vectors(run_on_sheets(over_the_ball(table.settings +
                                             "\n$P_UIFR[1,Z,RT]=25\n"
                                             "$P_UIFR[1,X,FI]=0.05\nG54\n" +
                                             measure(table, 11200)),
                               kinematics_sheets(table), results()),
                 table.vectors);
  const MisbelievedMachine& head = machines.at(4);
  expect_vectors(run_on_sheets(over_the_ball("Z100\nCYCLE800(0,\"\",0,57,0,0,0,20,0,0,0,0,0,1)\n"
                                             "G0 X0 Y0 Z80\nZ15.5\n" +
                                             measure(head, 11400)),
                               kinematics_sheets(head), results()),
                 head.vectors);
}

/// Fine offsets of the data record belong to its vectors where SD42974 has them count, and stay.
TEST(Kinematics, FineOffsetsStayAndCount) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  std::array<Point, 4> vectors = machine.vectors;
  vectors[1].z() -= 0.02;
  vectors[2].y() += 0.01;
  const MeasuringRun run = run_on_sheets(
      over_the_ball("$SC_TOCARR_FINE_CORRECTION=TRUE\n$TC_CARR46[1]=0.02 $TC_CARR56[1]=-0.01\n" +
                    machine.settings + "\n" + measure(machine, 11400)),
      kinematics_sheets(machine), results());
  expect_vectors(run, vectors, false);
  EXPECT_NEAR(run.at("_OVR[6]"), machine.vectors[1].z(), 1e-6);
}

/// A modulo axis goes the shorter way; axes with teeth stand on them.
TEST(Kinematics, ModuloAxesAndAxesWithTeeth) {
  const MisbelievedMachine machine = misbelieved_machines().front();
  std::vector<std::string> names = results();
  names.insert(names.end(), {"_OVR[120]", "_OVR[121]", "_OVR[138]", "_OVR[159]", "_OVR[164]"});
  const MeasuringRun run = run_on_sheets(
      over_the_ball(machine.settings +
                    "\n$MA_ROT_IS_MODULO[C]=TRUE\n$TC_CARR26[1]=1 $TC_CARR28[1]=7\n"
                    "CYCLE9960(11400,\"\",1,25,0,-60,60,4,0,0,270,0,4,0,1,3,5,1,1,0,0)"),
      kinematics_sheets(machine), names);
  expect_vectors(run, machine.vectors);
  EXPECT_EQ(run.at("_OVR[121]"), 3.0);
  // -60 is nearest to 1 - 9 * 7.
  EXPECT_EQ(run.at("_OVR[138]"), -62.0);
  EXPECT_EQ(run.at("_OVR[159]"), 270.0);
  EXPECT_EQ(run.at("_OVR[164]"), 300.0);
}

TEST(Kinematics, SingleStepsComeToTheSameVectors) {
  const MisbelievedMachine machine = misbelieved_machines().at(4);
  for (const int way : {0, 100, 200, 300, 400}) {
    SCOPED_TRACE(way);
    expect_vectors(run_on_sheets(over_the_ball(steps(way) + "CYCLE996(1000,1,1)"),
                                 kinematics_sheets(machine), results()),
                   machine.vectors);
  }
}

TEST(Kinematics, SingleStepsMayNormaliseAndLeaveTheChainOpen) {
  const MisbelievedMachine machine = misbelieved_machines().at(4);
  // X of axis 2 becomes 0.7: its vector moves along the axis, and that of axis 1 makes up for it; Z
  // of axis 1 becomes 2.  Open: I1 is nothing.
  std::array<Point, 4> vectors = machine.vectors;
  vectors = {Point::Zero(), Point(-0.7, 13, 2), Point(0.7, -8, 220.05), Point::Zero()};
  expect_vectors(
      run_on_sheets(over_the_ball(steps(400) + "CYCLE996(1331000,1,1,,,,,2,0.7,,,,,,,,,10)"),
                    kinematics_sheets(machine), results()),
      vectors);
  // Only reckoned.
  const std::array<Point, 4> believed = {Point(0, -5, -220), Point(0, 13, 0), Point(0, -8, 220),
                                         Point::Zero()};
  expect_vectors(run_on_sheets(over_the_ball(steps(400) + "CYCLE996(0,1,1)"),
                               kinematics_sheets(machine), results()),
                 believed, false);
}

/// An axis that is turned by hand stands where S_SETV0 says: as told by its encoder the same, a
/// degree off another machine.
TEST(Kinematics, SingleStepsTakeThePositionsOfAxesTurnedByHand) {
  const MisbelievedMachine machine = misbelieved_machines().at(4);
  const auto by_hand = [&](double off) {
    std::string text = "$TC_CARR37[1]=110\n";
    for (const auto& [variant, c, a] :
         {std::tuple(10401, 120, 30), std::tuple(10402, 180, 30), std::tuple(10403, 240, 30),
          std::tuple(20401, 0, 0), std::tuple(20402, 0, 30), std::tuple(20403, 0, 90)}) {
      std::string step = head_step(variant, c, a);
      const std::string without = ",1,1,25,0,,";
      const std::size_t at = step.find(without);
      EXPECT_NE(at, std::string::npos) << step;
      text += step.replace(at, without.size(), fmt::format(",1,1,25,0,{},{}", c + off, a));
    }
    return run_on_sheets(over_the_ball(text + "CYCLE996(1000,1,1)"), kinematics_sheets(machine),
                         results());
  };
  expect_vectors(by_hand(0.0), machine.vectors);
  // The head is found turned by that degree: of I2 = (0, 13) and I3 = (0, -8), whose part along
  // axis 2 goes to I2.
  EXPECT_NEAR(std::abs(by_hand(1.0).at("$TC_CARR4[1]")), (13.0 - 8.0) * 0.0174524, 1e-4);
}

TEST(Kinematics, ReferenceHeadAndHeadsThatAreAdaptedToIt) {
  const MisbelievedMachine machine = misbelieved_machines().at(4);
  std::vector<std::string> names = results();
  for (const char* const name :
       {"$P_UIFR[1,X,TR]", "$P_UIFR[1,Y,TR]", "$P_UIFR[1,Z,TR]", "$P_UIFR[1,Z,FI]"}) {
    names.emplace_back(name);
  }
  // Z stays as entered; the origin goes to the ball.
  std::array<Point, 4> vectors = {Point(0, -5, -220), Point(0, 13, 0), Point(0, -8, 220),
                                  Point::Zero()};
  const std::string reference = measure(machine, 11401);
  const MeasuringRun first = run_on_sheets(over_the_ball("$P_UIFR[1,Z,FI]=0.01\nG54\n" + reference),
                                           kinematics_sheets(machine), names);
  expect_vectors(first, vectors);
  EXPECT_NEAR(first.at("$P_UIFR[1,X,TR]"), 150.1, 1e-6);
  EXPECT_NEAR(first.at("$P_UIFR[1,Y,TR]"), -40.2, 1e-6);
  EXPECT_NEAR(first.at("$P_UIFR[1,Z,TR]"), -399.95, 1e-6);
  EXPECT_EQ(first.at("$P_UIFR[1,Z,FI]"), 0.0);
  // A head of the same machine whose data are wrong in all components.
  vectors = machine.vectors;
  vectors[0].z() -= 0.4;
  vectors[1].z() += 0.4;
  expect_vectors(
      run_on_sheets(over_the_ball(reference +
                                  "$TC_CARR3[1]=-219 $TC_CARR6[1]=0.4 $TC_CARR17[1]=219.8\n"
                                  "G0 X0 Y0 Z15.5\n" +
                                  measure(machine, 11402)),
                    kinematics_sheets(machine), results()),
      vectors);
}

}  // namespace
}  // namespace g31::testing::kinematics_cycle_test

// A lathe: the probe in its turret, which lengths of tools count where, X in diameter, the part on
// the spindle.

#include <gtest/gtest.h>

#include "tests/support/turning_run.h"

namespace g31::testing::turret_probe_test {
namespace {

const std::string kShaft = part("shaft", 0.0, 0.0, 200.0, "diameter = 50.0\nheight = 100.0");

TEST(TurretProbe, ItsBallIsWhereTheSheetSays) {
  // X 25 + 3 of the ball's centre, 20 more to the tool reference point; Z 190 and 150.
  const MeasuringRun run = expect_turned(
      "G0 X100 Z190\nSPOS=77\nMEAS=1 G1 X26 F100\nSTOPRE\nR1=$AC_MEA[1] R2=$AA_MM[X] R3=$AA_MW[X] "
      "R4=$AA_MM[Z]",
      {kProbeToMinusZ, kShaft, "[machine_data]\n\"$MA_SPIND_ASSIGN_TO_MACHAX[C]\" = 0\n"},
      {{"R1", 1.0}, {"R2", 48.0}, {"R3", 28.0}, {"R4", 340.0}});
  const auto& touch = run.output.document.at("touches").at(0);
  EXPECT_NEAR(touch.at("contact").at(0).get<double>(), 25.0, 1e-6);
  EXPECT_NEAR(touch.at("contact").at(2).get<double>(), 190.0, 1e-6);
}

TEST(TurretProbe, ItsStemLiesAlongTheLargestOfItsPlaces) {
  // To -Z the stem stands beside the shaft, 27 from its axis; to -X it goes off outwards.  Behind
  // the collar the one along Z meets it, the other does not.
  const std::string collared =
      kShaft + part("ring", 0.0, 0.0, 200.0, "bore = 50.0\nouter_diameter = 70.0\nheight = 10.0");
  const std::string body = "G0 X100\nZ150\nG1 X30 F1000";
  EXPECT_EQ(run_turning(body, {kProbeToMinusX, collared}, {}).output.exit_code, 0);
  const MeasuringRun hit = run_turning(body, {kProbeToMinusZ, collared}, {});
  EXPECT_EQ(hit.output.exit_code, 4);
  EXPECT_NE(hit.output.errors.find("stem touches ring"), std::string::npos) << hit.output.errors;
}

TEST(Lathe, BeginsInG18AndCountsAsMachineDataSay) {
  struct Case {
    const char* name;
    const char* data;
    double plane, diameter;
  };
  const Case kRows[] = {
      {"without Y", "", 2, 1},
      {"codes of machine data",
       "[machine_data]\n\"$MC_GCODE_RESET_VALUES[5]\" = 3\n\"$MC_GCODE_RESET_VALUES[28]\" = 2\n", 3,
       2},
      {"with Y", "[machine]\ntool_side = \"ZXY\"\n", 1, 1},
      {"with Y, technology turning",
       "[machine]\ntool_side = \"ZXY\"\n[machine_data]\n\"$MCS_TECHNOLOGY\" = 1\n", 2, 1},
      {"a number that is none", "[machine_data]\n\"$MC_GCODE_RESET_VALUES[28]\" = 9\n", 2, 1},
  };
  for (const Case& row : kRows) {
    SCOPED_TRACE(row.name);
    expect_turned("R1=$P_GG[6] R2=$P_GG[29]", {kProbeToMinusX, row.data},
                  {{"R1", row.plane}, {"R2", row.diameter}});
  }
}

TEST(Lathe, DiametersAreOfWorkCoordinatesOnly) {
  // Machine X of the reference point: radius + 90 of the tool.
  expect_turned(
      "T2 D1 M6\nDIAMON G0 X80 Z250\nR1=$AA_IM[X] R2=$AA_IW[X] R3=$P_EP[X]\nG91 X10\nR4=$AA_IM[X]\n"
      "G90 DIAM90 X80\nR5=$AA_IM[X]\nG91 X10\nR6=$AA_IM[X] R7=$AA_IW[X]\nG90 DIAMOF X40\n"
      "R8=$AA_IM[X] R9=$AA_IW[X] R10=$AA_IM[Z]",
      {kProbeToMinusX},
      {{"R1", 130.0},
       {"R2", 80.0},
       {"R3", 80.0},
       {"R4", 135.0},
       {"R5", 130.0},
       {"R6", 140.0},
       {"R7", 100.0},
       {"R8", 130.0},
       {"R9", 40.0},
       {"R10", 270.0}});
}

TEST(Lathe, LengthsCountInTheAxesOfTheirKindOfTool) {
  struct Case {
    const char* name;
    const char* data;
    const char* program;
    double x, z;
  };
  const Case kRows[] = {
      {"turning tool, G18", "", "T2 D1 M6\nG18", 90.0, 20.0},
      {"turning tool, G17", "", "T2 D1 M6\nG17", 20.0, 0.0},
      {"turning tool, G19", "", "T2 D1 M6\nG19", 0.0, 90.0},
      {"drill, G18", "", "T3 D1 M6\nG18", 0.0, 0.0},
      {"drill, G17", "", "T3 D1 M6\nG17", 0.0, 150.0},
      {"all as turning tools", "[machine_data]\n\"$SC_TOOL_LENGTH_TYPE\" = 2\n", "T3 D1 M6\nG18",
       150.0, 0.0},
      {"all as mills", "[machine_data]\n\"$SC_TOOL_LENGTH_TYPE\" = 1\n", "T2 D1 M6\nG18", 20.0,
       0.0},
      {"as in G18", "[machine_data]\n\"$SC_TOOL_LENGTH_CONST\" = 18\n", "T2 D1 M6\nG17", 90.0,
       20.0},
      {"as in G18, axes changed", "[machine_data]\n\"$SC_TOOL_LENGTH_CONST\" = -18\n",
       "T2 D1 M6\nG17", 20.0, 90.0},
      {"mills as in G17, turning tools as in G18",
       "[machine_data]\n\"$SC_TOOL_LENGTH_CONST\" = 17\n\"$SC_TOOL_LENGTH_CONST_T\" = 18\n",
       "T2 D1 M6\nG19", 90.0, 20.0},
      {"wear is a diameter", "[machine_data]\n\"$MC_TOOL_PARAMETER_DEF_MASK\" = 1\n",
       "$TC_DP12[2,1]=0.5 $TC_DP13[2,1]=0.25\nT2 D1 M6", 90.25, 20.25},
      {"length is a diameter", "[machine_data]\n\"$MC_TOOL_PARAMETER_DEF_MASK\" = 2\n",
       "$TC_DP12[2,1]=0.5 $TC_DP13[2,1]=0.25\nT2 D1 M6", 45.5, 20.25},
  };
  for (const Case& row : kRows) {
    SCOPED_TRACE(row.name);
    expect_turned(std::string(row.program) + "\nG0 X150 Z250\nR1=$AA_IM[X]-150 R2=$AA_IM[Z]-250",
                  {kProbeToMinusX, row.data}, {{"R1", row.x}, {"R2", row.z}});
  }
}

TEST(Lathe, TheSpindleTurnsThePartAndNotTheProbe) {
  // The shaft runs out: its axis is 0.02 from the spindle's towards -X at 0 degrees.
  const std::string eccentric =
      part("shaft", -0.02, 0.0, 200.0, "diameter = 50.02\nheight = 100.0");
  expect_turned(
      "G0 X100 Z190\nSPOS=0\nMEAS=1 G1 X26 F100\nSTOPRE\nR1=2*($AA_MW[X]-3)\nG0 X40\nSPOS=180\n"
      "MEAS=1 G1 X26\nSTOPRE\nR2=2*($AA_MW[X]-3) R3=$AA_IM[C]\nG0 X40\nM19\nR4=$AA_IM[C]",
      {kProbeToMinusX, eccentric}, {{"R1", 49.98}, {"R2", 50.06}, {"R3", 180.0}, {"R4", 0.0}});
}

}  // namespace
}  // namespace g31::testing::turret_probe_test

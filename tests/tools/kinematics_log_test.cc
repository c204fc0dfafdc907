// What CYCLE9960 shows and logs, and its files of interpolation points.  The expected text is
// written by hand.

#include <regex>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/kinematics_run.h"

namespace g31::testing::kinematics_log_test {
namespace {

/// The tilting table, C off by (0.03, -0.02): at C the ball is off by that, turned back by C, less
/// itself.
MisbelievedMachine table() {
  MisbelievedMachine machine = misbelieved_machines().front();
  machine.truth = machine.believed;
  machine.truth.rotary[2].p_M_centre += Point(0.03, -0.02, 0);
  return machine;
}

const char* const kSettings = "$SCS_MEA_KIN_MODE[0]=4 $SCS_MEA_KIN_MODE[1]=6\n";

std::string call(int variant) {
  return "CYCLE9960(" + std::to_string(variant) +
         ",\"\",1,25,0,-60,60,4,0,0,0,270,4,0,1,3,5,1,1,0,0)\n";
}

const char* const kResults = R"(1 :
Time:hh:mm:ss
Results measure:Kinematic measure complete /CYCLE9960
Variant      :S_MVAR=11400
Measuring plane:G17
Name / number :TABLE_AC / 1
Rotary axis 1 :A start:-60.000 final:60.000 no.:4
Position of rotary axis 2 :0.000
Rotary axis 2 :C start:0.000 final:270.000 no.:4
Position of rotary axis 1 :0.000
---------------------------------------------------------------
Difference of measure:      X [mm]      Y [mm]      Z [mm]
max Value                   0.00000     0.05000     0.00000
min Value                  -0.06000    -0.01000     0.00000
A[deg]       C[deg]        X [mm]      Y [mm]      Z [mm]
-60.0000     0.0000         0.00000     0.00000     0.00000
-20.0000     0.0000         0.00000     0.00000     0.00000
20.0000      0.0000         0.00000     0.00000     0.00000
60.0000      0.0000         0.00000     0.00000     0.00000
0.0000       0.0000         0.00000     0.00000     0.00000
0.0000       90.0000       -0.01000     0.05000     0.00000
0.0000       180.0000      -0.06000     0.04000     0.00000
0.0000       270.0000      -0.05000    -0.01000     0.00000
vectors before:             X [mm]      Y [mm]      Z [mm]
I2                          5.00000    20.00000  -450.00000
I3                          0.00000   -23.00000     0.00000
I4                         -5.00000     3.00000   450.00000
Results:
vectors:                    X [mm]      Y [mm]      Z [mm]
I2                          5.00000    20.00000  -450.00000
I3                          0.03000   -23.02000     0.00000
I4                         -5.03000     3.02000   450.00000
)";

TEST(KinematicsLog, SaysWhatWasMeasuredAndTheVectors) {
  const MeasuringRun run = run_on_sheets(
      over_the_ball(std::string(kSettings) +
                    "$TC_CARR34[1]=\"TABLE_AC\"\nCYCLE150(10,1001,\"LOG.TXT\")\n" + call(11400)),
      kinematics_sheets(table()), {});
  EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
  const std::string log =
      std::regex_replace(run.output.document.at("files").value("LOG.TXT", "missing"),
                         std::regex("[0-9]{2}:[0-9]{2}:[0-9]{2}"), "hh:mm:ss");
  EXPECT_TRUE(log.ends_with(kResults)) << log;
}

const char* const kByData = R"(TRAORI(1):                  X [mm]      Y [mm]      Z [mm]
TRAFO5_PART_OFFSET_1        0.00000    -5.00000  -220.05000
TRAFO5_BASE_TOOL_1          0.00000    -8.00000   220.05000
TRAFO5_JOINT_OFFSET_1       0.00000    13.00000     0.00000
)";

/// Where machine data say of TRAORI(1) what the machine is, the log has the vectors under their
/// names, too.
TEST(KinematicsLog, NamesTheMachineDataOfTheTransformation) {
  const MisbelievedMachine machine = misbelieved_machines().at(4);
  std::string steps;
  for (const auto& [variant, c, a] :
       {std::tuple(10401, 120, 30), std::tuple(10402, 180, 30), std::tuple(10403, 240, 30),
        std::tuple(20401, 0, 0), std::tuple(20402, 0, 30), std::tuple(20403, 0, 90)}) {
    steps += head_step(variant, c, a);
  }
  const auto log_of = [&](const std::string& type) {
    const MeasuringRun run = run_on_sheets(
        over_the_ball("CYCLE150(10,1001,\"LOG.TXT\")\n" + steps + type + "CYCLE996(10000000,1,1)"),
        kinematics_sheets(machine), {});
    EXPECT_EQ(run.output.exit_code, 0) << run.output.errors;
    return run.output.document.at("files").value("LOG.TXT", std::string("missing"));
  };
  const std::string log = log_of("$MC_TRAFO_TYPE_1=24\n");
  EXPECT_TRUE(log.ends_with(kByData)) << log;
  EXPECT_EQ(log_of("").find("TRAORI(1)"), std::string::npos);
  EXPECT_EQ(log_of("$MC_TRAFO_TYPE_1=40\n").find("TRAORI(1)"), std::string::npos);
}

/// The last file that a name is part of.
std::string file_of(const MeasuringRun& run, const std::string& name) {
  std::string found = "missing";
  for (const auto& [path, text] : run.output.document.at("files").items()) {
    if (path.find(name) != std::string::npos) {
      found = text.get<std::string>();
    }
  }
  return found;
}

/// With interpolation points the series goes evenly from end to end; home is made before.
const char* const kGrid = R"(; probe 117.0000; axis 1, axis 2, X, Y, Z
; 0.0000 0.0000 0.000000 0.000000 0.000000
; 0.0000 90.0000 -0.010000 0.050000 0.000000
; 0.0000 180.0000 -0.060000 0.040000 0.000000
; 0.0000 270.0000 -0.050000 -0.010000 0.000000
M17
)";

std::string points(int variant) {
  return "CYCLE9960(" + std::to_string(variant) +
         ",\"HEAD\",1,25,0,0,0,0,0,0,0,270,4,0,1,3,5,1,1,0,0)\n";
}

std::string without_signs_of_nothing(const std::string& text) {
  return std::regex_replace(text, std::regex("-0\\.000000"), "0.000000");
}

TEST(KinematicsLog, InterpolationPointsGoIntoFilesAndOldOnesAreKept) {
  const std::string named = "$TC_CARR34[1]=\"HEAD\"\n";
  const MeasuringRun run = run_on_sheets(
      over_the_ball(named + points(50403) + points(50403) + points(51403) + points(51403) +
                    "R1=ISFILE(\"/_N_CMA_DIR/_N_E996HEAD_MEA1_SPF\")\n"
                    "R2=ISFILE(\"/_N_CMA_DIR/_N_E996HEAD_MEA2_SPF\")\n"
                    "R3=ISFILE(\"/_N_CMA_DIR/_N_E996HEAD_1_SPF\")\n"
                    "R4=ISFILE(\"/_N_CMA_DIR/_N_E996HEAD_OLD1_1_SPF\")\n"
                    "R5=ISFILE(\"/_N_CMA_DIR/_N_E996HEAD_OLD2_1_SPF\")\n"
                    "R6=ISFILE(\"/_N_CMA_DIR/_N_E996HEAD_MEA3_SPF\")\n"),
      kinematics_sheets(table()), {"R1", "R2", "R3", "R4", "R5", "R6", "$TC_CARR15[1]"});
  expect_values(run,
                {{"R1", 1.0},
                 {"R2", 1.0},
                 {"R3", 1.0},
                 {"R4", 1.0},
                 {"R5", 0.0},
                 {"R6", 0.0},
                 {"$TC_CARR15[1]", 0.0}},
                1e-9);
  for (const char* const name : {"E996HEAD_MEA1", "E996HEAD_1", "E996HEAD_OLD1"}) {
    EXPECT_EQ(without_signs_of_nothing(file_of(run, name)), kGrid) << name;
  }
}

TEST(KinematicsLog, InterpolationPointsMayLieInTheUsersFolder) {
  const MeasuringRun run = run_on_sheets(
      over_the_ball("$TC_CARR34[1]=\"HEAD\" $MC_E996_FILE_LOCATION=2\n" + points(50403) +
                    "R1=ISFILE(\"/_N_CUS_DIR/_N_E996HEAD_MEA1_SPF\")"),
      kinematics_sheets(table()), {"R1"});
  expect_values(run, {{"R1", 1.0}}, 1e-9);
}

}  // namespace
}  // namespace g31::testing::kinematics_log_test

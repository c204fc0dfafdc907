// G60: FANUC operator's manual B-63534EN, single direction positioning; M700V programming manual,
// unidirectional positioning; Haas mill operator's manual 96-8000, G60.

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::fanuc::single_direction_test {
namespace {

using testing::ControlRun;
using Lines = std::vector<std::string>;

runtime::ControlSetup overruns() {
  runtime::ControlSetup setup;
  setup.parameters = {{"5440.X", -2.0}, {"5440.Y", 3.0}, {"8209.X", -2.0}, {"8209.Y", 3.0}};
  return setup;
}

Lines moves(const char* control, const char* program,
            const runtime::ControlSetup& setup = overruns()) {
  ControlRun run(control, program, setup);
  EXPECT_EQ(run.alarm(), 0) << program;
  return run.machine().log();
}

TEST(SingleDirection, GoesPastTheEndAndOnToIt) {
  const Lines both{"move 12.000 7.000 0.000 rapid", "move 10.000 10.000 0.000 rapid"};
  EXPECT_EQ(moves("fanuc-16i", "G60X10.Y10."), both);
  EXPECT_EQ(moves("meldas", "G60X10.Y10."), both);
  EXPECT_EQ(moves("fanuc-16i", "G60X-10."),
            (Lines{"move -8.000 0.000 0.000 rapid", "move -10.000 0.000 0.000 rapid"}));
  EXPECT_EQ(moves("fanuc-16i", "G60Z5."), (Lines{"move 0.000 0.000 5.000 rapid"}))
      << "no way in the parameter";
  EXPECT_EQ(moves("fanuc-16i", "G0X10.\nG60X10.Y10."),
            (Lines{"move 10.000 0.000 0.000 rapid", "move 10.000 7.000 0.000 rapid",
                   "move 10.000 10.000 0.000 rapid"}))
      << "X does not move";
}

TEST(SingleDirection, IsOfItsBlockUnlessAParameterMakesItModal) {
  EXPECT_EQ(moves("fanuc-16i", "G1X5.F100\nG60X10.\nX20."),
            (Lines{"move 5.000 0.000 0.000 F100", "move 12.000 0.000 0.000 rapid",
                   "move 10.000 0.000 0.000 rapid", "move 20.000 0.000 0.000 F100"}));
  runtime::ControlSetup modal = overruns();
  modal.parameters["5431.0"] = 1.0;
  modal.parameters["1271.0"] = 1.0;
  for (const char* const control : {"fanuc-16i", "meldas"}) {
    EXPECT_EQ(moves(control, "G60X10.\nX20.\nG0X30.", modal),
              (Lines{"move 12.000 0.000 0.000 rapid", "move 10.000 0.000 0.000 rapid",
                     "move 22.000 0.000 0.000 rapid", "move 20.000 0.000 0.000 rapid",
                     "move 30.000 0.000 0.000 rapid"}));
  }
  ControlRun shown("fanuc-16i", "G60X10.\n#100=#4001", modal);
  EXPECT_EQ(shown.value("#100"), 60.0);
}

TEST(SingleDirection, IsThatOfTheMachineUnderMirrorImage) {
  EXPECT_EQ(moves("fanuc-16i", "G51.1X0\nG60X10."),
            (Lines{"move -8.000 0.000 0.000 rapid", "move -10.000 0.000 0.000 rapid"}));
}

TEST(SingleDirection, InACycleIsOfThePlaceAlone) {
  runtime::ControlSetup modal = overruns();
  modal.parameters["5431.0"] = 1.0;
  modal.parameters["5440.Z"] = 1.0;
  EXPECT_EQ(moves("fanuc-16i", "G60\nG81X10.Z-5.R1.F100", modal),
            (Lines{"move 12.000 0.000 0.000 rapid", "move 10.000 0.000 0.000 rapid",
                   "move 10.000 0.000 1.000 rapid", "move 10.000 0.000 -5.000 F100",
                   "move 10.000 0.000 0.000 rapid"}));
}

TEST(SingleDirection, OfAHaasGoesDownBySetting35) {
  runtime::ControlSetup setup;
  setup.variables["#20035"] = 0.5;
  EXPECT_EQ(moves("haas", "G60X10.", setup),
            (Lines{"move 10.500 0.000 0.000 rapid", "move 10.000 0.000 0.000 rapid"}));
  EXPECT_EQ(moves("haas", "G60X10.", {}), (Lines{"move 10.000 0.000 0.000 rapid"}));
}

}  // namespace
}  // namespace g31::fanuc::single_direction_test

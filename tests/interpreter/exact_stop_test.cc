// How blocks end: G64 passes on, G61 and G09 stop exactly, #3004 bit 2 forbids both; rapids stop.
// And who plans the speed of what passes on.

#include <string>

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::fanuc::exact_stop_test {
namespace {

TEST(ExactStop, IsModalOrOfOneBlockAndNeverForBitTwoOf3004) {
  struct Case {
    const char* name;
    const char* program;
    const char* ends;  ///< a letter a move: S stops, P passes on
  };
  const Case kCases[] = {
      {"power on is G64", "G1X1.F100\nX2.\nG2X4.R1.", "PPP"},
      {"rapids stop, feed before and after or not", "G0X1.\nG1X2.F100\nG0X3.", "SPS"},
      {"G61 until G64", "G61G1X1.F100\nX2.\nG3X4.R1.\nG64X5.", "SSSP"},
      {"G62 and G63 end G61", "G61G1X1.F100\nG62X2.\nG61X3.\nG63X4.", "SPSP"},
      {"G09 in its own block", "G1X1.F100\nG9X2.\nX3.\nG09G2X5.R1.\nX6.R1.", "PSPSP"},
      {"#3004 bit 2 and back", "#3004=4\nG61G1X1.F100\nG9X2.\n#3004=3\nX3.", "PPS"},
      {"in cutter compensation, where blocks wait",
       "G41D1G1X10.F100\nG9Y10.\nX20.\nG61Y20.\nG40X30.", "PSPSS"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    runtime::ControlSetup setup;
    setup.tools[1].radius_mm = 1.0;
    testing::ControlRun run("fanuc-16i", c.program, setup);
    EXPECT_EQ(run.alarm(), 0);
    std::string ends;
    for (const machine::BlockEnd end : run.machine().ends()) {
      ends += end == machine::BlockEnd::ExactStop ? 'S' : 'P';
    }
    EXPECT_EQ(ends, c.ends);
  }
}

TEST(ExactStop, WithNciNobodyWaitsForTheAxes) {
  for (const bool nci : {false, true}) {
    runtime::ControlSetup setup;
    setup.parameters = {{"1601.5", nci ? 1.0 : 0.0}};
    testing::ControlRun run("fanuc-30i", "G0X1.\nG61G1X2.F100\nG64X3.\nG28X4.", setup);
    EXPECT_EQ(run.alarm(), 0);
    const auto stop = nci ? machine::BlockEnd::CommandStop : machine::BlockEnd::ExactStop;
    ASSERT_EQ(run.machine().ends().size(), 5U);
    for (const std::size_t i : {0U, 1U, 3U, 4U}) {
      EXPECT_EQ(run.machine().ends()[i], stop) << i;
    }
    EXPECT_EQ(run.machine().ends()[2], machine::BlockEnd::PassOn);
  }
}

/// A letter a move: O contour control off, L look-ahead, F with feed-forward.
std::string controls_of(const testing::RecordingMachine& machine) {
  std::string letters;
  for (const machine::ContourControl control : machine.contour_controls()) {
    letters += "OLF"[static_cast<std::size_t>(control)];
  }
  return letters;
}

TEST(ContourControl, IsSwitchedByQAndPAndAHaasPlansAheadInAnyCase) {
  struct Case {
    const char* profile;
    const char* program;
    const char* controls;
  };
  const Case kCases[] = {
      {"fanuc-16i", "G1X1.F100\nG5.1Q1\nX2.\nG2X4.R1.\nG5.1Q0\nX5.", "OFFO"},
      {"fanuc-30i", "G8P1\nG1X1.F100\nG8P0\nX2.", "FO"},
      {"fanuc-30i", "G5.1Q1\nG8P1\nG1X1.F100\nG8P0\nX2.\nG5.1Q0\nX3.", "FFO"},
      {"meldas", "G1X1.F100\nG8P1\nX2.", "OF"},
      {"haas", "G1X1.F100\nG3X2.R1.", "LL"},
      {"fanuc-16i", "G41D1G1X10.F100\nX20.\nG5.1Q1\nY20.\nG40X30.", "OOFF"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.program);
    runtime::ControlSetup setup;
    setup.tools[1].radius_mm = 1.0;
    testing::ControlRun run(c.profile, c.program, setup);
    EXPECT_EQ(run.alarm(), 0);
    EXPECT_EQ(controls_of(run.machine()), c.controls);
  }
}

}  // namespace
}  // namespace g31::fanuc::exact_stop_test

// G70, G71 and G72: Haas mill operator's manual 96-8000.

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::fanuc::hole_pattern_test {
namespace {

using testing::ControlRun;
using Lines = std::vector<std::string>;

Lines moves(const std::string& program) {
  ControlRun run("haas", program);
  EXPECT_EQ(run.alarm(), 0) << program;
  return run.machine().log();
}

/// Where holes are drilled to.
Lines bottoms(const std::string& program) {
  Lines found;
  for (const std::string& line : moves(program)) {
    if (line.ends_with(" F100")) {
      found.push_back(line.substr(5, line.size() - 10));
    }
  }
  return found;
}

TEST(HolePattern, CyclesDrillAtEachPlace) {
  EXPECT_EQ(moves("G81G99Z-5.R1.F100.L0\nG70I10.J90.L2"),
            (Lines{"move 0.000 10.000 0.000 rapid", "move 0.000 10.000 1.000 rapid",
                   "move 0.000 10.000 -5.000 F100", "move 0.000 10.000 1.000 rapid",
                   "move 0.000 -10.000 1.000 rapid", "move 0.000 -10.000 1.000 rapid",
                   "move 0.000 -10.000 -5.000 F100", "move 0.000 -10.000 1.000 rapid"}));
}

TEST(HolePattern, LieOnCirclesArcsAndLines) {
  const std::string cycle = "G81Z-5.R1.F100.L0\n";
  EXPECT_EQ(bottoms(cycle + "G70I10.J0L4"),
            (Lines{"10.000 0.000 -5.000", "0.000 10.000 -5.000", "-10.000 0.000 -5.000",
                   "0.000 -10.000 -5.000"}));
  EXPECT_EQ(bottoms(cycle + "G70X50.Y20.I10.L2"),
            (Lines{"60.000 20.000 -5.000", "40.000 20.000 -5.000"}))
      << "about the centre of the block";
  EXPECT_EQ(bottoms(cycle + "G71I10.J90.K-90.L2"),
            (Lines{"0.000 10.000 -5.000", "10.000 0.000 -5.000"}));
  EXPECT_EQ(bottoms(cycle + "G71I10.K30.L4").at(1), "8.660 5.000 -5.000");
  EXPECT_EQ(bottoms(cycle + "G72I5.J90.L3"),
            (Lines{"0.000 0.000 -5.000", "0.000 5.000 -5.000", "0.000 10.000 -5.000"}));
  EXPECT_EQ(bottoms("G81G70Z-5.R1.F100.I10.L2"),
            (Lines{"10.000 0.000 -5.000", "-10.000 0.000 -5.000"}))
      << "in the block of the cycle";
}

TEST(HolePattern, LeavesTheCycleAsItWas) {
  EXPECT_EQ(bottoms("G83Z-4.R0Q2.F100.L0\nG70I10.L1\nX30."),
            (Lines{"10.000 0.000 -2.000", "10.000 0.000 -4.000", "30.000 0.000 -2.000",
                   "30.000 0.000 -4.000"}))
      << "I of G70 is no peck";
}

TEST(HolePattern, NeedsACycleAndItsWords) {
  const std::string cycle = "G81Z-5.R1.F100.L0\n";
  EXPECT_EQ(ControlRun("haas", "G70I10.L4").alarm(), 10);
  EXPECT_EQ(ControlRun("haas", cycle + "G80\nG70I10.L4").alarm(), 10);
  EXPECT_EQ(ControlRun("haas", cycle + "G70I10.").alarm(), 9);
  EXPECT_EQ(ControlRun("haas", cycle + "G70I10.L0").alarm(), 9);
  EXPECT_EQ(ControlRun("haas", cycle + "G70L4").alarm(), 9);
  EXPECT_EQ(ControlRun("haas", cycle + "G72I10.L1.5").alarm(), 7);
}

}  // namespace
}  // namespace g31::fanuc::hole_pattern_test

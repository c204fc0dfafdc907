// G70, G71 and G72: Haas mill operator's manual 96-8000.  G34, G35 and G36: M700V programming
// manual, special fixed cycles.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "tests/support/control_run.h"

namespace g31::fanuc::hole_pattern_test {
namespace {

using testing::ControlRun;
using Lines = std::vector<std::string>;

Lines moves(const std::string& program, const std::string& control = "haas") {
  ControlRun run(control, program);
  EXPECT_EQ(run.alarm(), 0) << program;
  return run.machine().log();
}

/// Where holes are drilled to.
Lines bottoms(const std::string& program, const std::string& control = "haas") {
  Lines found;
  for (const std::string& line : moves(program, control)) {
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
  EXPECT_EQ(ControlRun("haas", cycle + "G71I10.L4").alarm(), 9);
  EXPECT_EQ(ControlRun("haas", cycle + "G72I10.L1.5").alarm(), 7);
}

TEST(HolePattern, OfMeldas) {
  const std::string cycle = "G81Z-5.R1.F100.L0\n";
  const auto meldas = [&](const std::string& block) { return bottoms(cycle + block, "meldas"); };
  EXPECT_EQ(meldas("G34X50.Y20.I10.J90.K2"),
            (Lines{"50.000 30.000 -5.000", "50.000 10.000 -5.000"}));
  EXPECT_EQ(meldas("G34I10.K4"), (Lines{"10.000 0.000 -5.000", "0.000 10.000 -5.000",
                                        "-10.000 0.000 -5.000", "0.000 -10.000 -5.000"}));
  EXPECT_EQ(meldas("G34I10.K-4").at(1), "0.000 -10.000 -5.000") << "clockwise";
  EXPECT_EQ(meldas("G35X10.I5.J-90.K3"),
            (Lines{"10.000 0.000 -5.000", "10.000 -5.000 -5.000", "10.000 -10.000 -5.000"}));
  EXPECT_EQ(meldas("G36I10.P30.K3").at(1), "8.660 5.000 -5.000");
  EXPECT_EQ(meldas("G36I10.P90.K2\nX30.").at(2), "30.000 10.000 -5.000")
      << "the next hole is counted from the last";
  EXPECT_EQ(moves("G82Z-5.R1.P500F100.L0\nG36I10.P90.K1", "meldas").at(3), "dwell 0.5")
      << "P of the pattern is no dwell";
  EXPECT_EQ(ControlRun("meldas", cycle + "G34I10.K0").alarm(), 221);
  EXPECT_EQ(ControlRun("meldas", cycle + "G35I10.K-2").alarm(), 221);
  EXPECT_EQ(ControlRun("meldas", cycle + "G34I10.").alarm(), 221);
  EXPECT_EQ(ControlRun("meldas", cycle + "G36I10.K2").alarm(), 222);
  EXPECT_EQ(meldas("G35I5.K2.").size(), 2U) << "a point behind how many is none";
  EXPECT_EQ(ControlRun("meldas", "G34I10.K4").alarm(), 34);
  EXPECT_EQ(ControlRun("fanuc-16i", cycle + "G34I10.K4").alarm(), 10);
}

/// G34.1 is the circle of a Mazak, G34 is none, and G37.1 is no measuring.
TEST(HolePattern, AMazakHasGridsAndItsOwnCircle) {
  const std::string cycle = "G81Z-5.R1.F100.L0\n";
  EXPECT_EQ(bottoms(cycle + "G37.1X10.Y10.I5.P3J7.K2", "mazatrol-iso"),
            (Lines{"10.000 10.000 -5.000", "15.000 10.000 -5.000", "20.000 10.000 -5.000",
                   "20.000 17.000 -5.000", "15.000 17.000 -5.000", "10.000 17.000 -5.000"}));
  EXPECT_EQ(bottoms(cycle + "G37.1I-5.P2K1", "mazatrol-iso"),
            (Lines{"0.000 0.000 -5.000", "-5.000 0.000 -5.000"}));
  EXPECT_EQ(bottoms(cycle + "G34.1I10.J0K-4", "mazatrol-iso").at(1), "0.000 -10.000 -5.000");
  EXPECT_EQ(ControlRun("mazatrol-iso", cycle + "G37.1I5.P3J7.").alarm(), 221);
  EXPECT_EQ(ControlRun("mazatrol-iso", cycle + "G37.1P3K2").alarm(), 32);
  EXPECT_NE(ControlRun("mazatrol-iso", cycle + "G34I10.K4").alarm(), 0);
  EXPECT_NE(ControlRun("meldas", cycle + "G34.1I10.K4").alarm(), 0);
}

TEST(HolePattern, EveryCodeHasItsWords) {
  for (const GCode& code : g_codes()) {
    if (code.action == GAction::HolePattern) {
      const bool is_grid = code.number == GNumber{37, 1};
      const std::string control = code.set == CodeSet::Haas    ? "haas"
                                  : code.set == CodeSet::Mazak ? "mazatrol-iso"
                                                               : "meldas";
      const std::string block =
          fmt::format("{}I10.{}K3L3", to_text(code.number), is_grid ? "J5.P1" : "P20.");
      EXPECT_EQ(bottoms("G81Z-5.R1.F100.L0\n" + block, control).size(), 3) << block;
    }
  }
}

}  // namespace
}  // namespace g31::fanuc::hole_pattern_test

// G33: FANUC operator's manual B-63534EN, thread cutting; M700V programming manual, constant lead
// thread cutting.

#include <gtest/gtest.h>

#include "tests/support/last_moves.h"

namespace g31::fanuc::thread_test {
namespace {

using testing::ControlRun;
using testing::expect_last_moves;
using testing::LastMove;

TEST(Thread, GoesTheLeadInATurn) {
  constexpr LastMove kCases[] = {
      {"500 turns of 1.5 mm", "S500\nG33Z-10.F1.5", "move 0.000 0.000 -10.000 F750"},
      {"along the axis that moves farthest: 750 by the root of 1.25", "S500\nG33X5.Z-10.F1.5",
       "move 5.000 0.000 -10.000 F838.525"},
      {"until another code", "S500\nG33Z-10.F1.5\nZ-20.", "move 0.000 0.000 -20.000 F750"},
      {"F150 is 1.5", "S500\nG33Z-10.F150", "move 0.000 0.000 -10.000 F750"},
      {"100 turns of .05 inch", "G20S100\nG33Z-1.F.05", "move 0.000 0.000 -25.400 F127"},
      {"whatever F means else", "G95S500\nG33Z-10.F1.5", "move 0.000 0.000 -10.000 F750"},
      {"Q changes nothing", "S500\nG33Z-10.F1.5Q90000", "move 0.000 0.000 -10.000 F750"},
      {"at constant surface speed, 318.31 turns", "G0X50.\nG96S100\nG33Z-10.F2.",
       "move 50.000 0.000 -10.000 F636.62"},
  };
  expect_last_moves(kCases);
  ControlRun modal("fanuc-16i", "S500\nG33Z-10.F1.5\n#100=#4001");
  EXPECT_EQ(modal.value("#100"), 33.0);
}

TEST(Thread, IsNotOverridden) {
  runtime::ControlSetup setup;
  setup.feed_switches.override_percent = 50.0;
  constexpr LastMove kCases[] = {{"100 %", "S500\nG33Z-10.F1.5", "move 0.000 0.000 -10.000 F750"},
                                 {"a line is", "G1Z-10.F750", "move 0.000 0.000 -10.000 F375"}};
  expect_last_moves(kCases, setup);
}

TEST(Thread, NeedsALeadAndASpeed) {
  EXPECT_EQ(ControlRun("fanuc-16i", "G33Z-10.F1.5").alarm(), 14);
  EXPECT_EQ(ControlRun("fanuc-16i", "S500\nG33Z-10.").alarm(), 14);
  EXPECT_EQ(ControlRun("fanuc-16i", "S500\nG33Z-10.F500.").alarm(), 0);
  EXPECT_EQ(ControlRun("fanuc-16i", "S500\nG33Z-10.F500.01").alarm(), 14);
  EXPECT_EQ(ControlRun("fanuc-16i", "G20S500\nG33Z-1.F10.").alarm(), 14);
  EXPECT_EQ(ControlRun("meldas", "G33Z-10.F1.5").alarm(), 93);
  EXPECT_EQ(ControlRun("meldas", "S500\nG93G33Z-10.F1.5").alarm(), 125);
  EXPECT_EQ(ControlRun("haas", "S500\nG33Z-10.F1.5").alarm(), 10) << "a Haas mill has none";
}

}  // namespace
}  // namespace g31::fanuc::thread_test

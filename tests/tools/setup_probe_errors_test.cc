#include <gtest/gtest.h>

#include "tests/tools/setup_error_text.h"

namespace g31::setup::setup_probe_errors_test {
namespace {

const ErrorCase kOfAProbeThatIsATool[] = {
    {"a digital input that no control has", "[probe]\nready_input = 99\n",
     R"(sheet1.toml:2:15: error: probe.ready_input is 99, it should be 1 to 64 for $A_IN, 1000 to 1015 for #1000 to #1015, or 11016 to 11255 for those of a Haas [SET105]
    2 | ready_input = 99
      |               ^
)"},
    {"a probe that is no tool", "[probe]\ntool = 0\n",
     R"(sheet1.toml:2:8: error: probe.tool is 0, it should be 1 to 99999999 [SET105]
    2 | tool = 0
      |        ^
)"},
    {"a code that is no M code", "[probe]\non = \"G80\"\n",
     R"(sheet1.toml:2:6: error: probe.on is "G80", it should be an M code like "M80", or an output "#1100" to "#1115" or "$A_OUT[1]" to "$A_OUT[64]" [SET105]
    2 | on = "G80"
      |      ^
)"},
    {"a tool by its name", "[probe]\ntool = \"PROBE\"\n",
     R"(sheet1.toml:2:8: error: probe.tool is a string, it should be a whole number [SET104]
    2 | tool = "PROBE"
      |        ^
      = for example: tool = 1
)"},
    {"a code without its letter", "[probe]\non = 80\n",
     R"(sheet1.toml:2:6: error: probe.on is a whole number, it should be a string [SET104]
    2 | on = 80
      |      ^
      = for example: on = "M80"
)"},
    {"an output that is none", "[probe]\non = \"#1116\"\n",
     R"(sheet1.toml:2:6: error: probe.on is "#1116", it should be an M code like "M80", or an output "#1100" to "#1115" or "$A_OUT[1]" to "$A_OUT[64]" [SET105]
    2 | on = "#1116"
      |      ^
)"},
    {"an input without its number", "[[input]]\nvalue = 1\n",
     R"(sheet1.toml:1:1: error: an input needs number [SET121]
    1 | [[input]]
      | ^
      = for example: number = 1003
)"},
    {"an input with two beginnings",
     "[[input]]\nnumber = 1003\nfrom_s = 1.0\nfrom_code = \"M21\"\n",
     R"(sheet1.toml:4:13: error: an input takes its value from one thing, not from from_s and from_code [SET116]
    4 | from_code = "M21"
      |             ^
      = write two [[input]], each with one of them
)"},
    {"an input that the probe sets", "[probe]\nready_input = 1004\n[[input]]\nnumber = 1004\n",
     R"(sheet1.toml:4:10: error: input.number is 1004, an input that probe.ready_input already sets [SET115]
    4 | number = 1004
      |          ^
      = each takes an input of its own
)"},
    {"a code that is too long", "[probe]\noff = \"M123456789\"\n",
     R"(sheet1.toml:2:7: error: probe.off is "M123456789", it should be an M code like "M80", or an output "#1100" to "#1115" or "$A_OUT[1]" to "$A_OUT[64]" [SET105]
    2 | off = "M123456789"
      |       ^
)"},
    {"a slip of the pen", "[probe]\nready_imput = 4\n",
     R"(sheet1.toml:2:1: error: unknown key ready_imput in [probe], did you mean ready_input? [SET103]
    2 | ready_imput = 4
      | ^
)"},
    {"two things on one input", "[probe]\nready_input = 1004\nsignal_input = 1004\n",
     R"(sheet1.toml:3:16: error: probe.signal_input is 1004, an input that probe.ready_input already sets [SET115]
    3 | signal_input = 1004
      |                ^
      = each takes an input of its own
)"},
    {"the battery on the input of the signal",
     "[probe]\nsignal_input = 1005\nlow_battery_input = 1005\n",
     R"(sheet1.toml:3:21: error: probe.low_battery_input is 1005, an input that probe.signal_input already sets [SET115]
    3 | low_battery_input = 1005
      |                     ^
      = each takes an input of its own
)"},
};

TEST_F(SetupErrorText, OfAProbeThatIsATool) {
  for (const ErrorCase& c : kOfAProbeThatIsATool) {
    expect_text(c);
  }
}

TEST_F(SetupErrorText, OfLoopsThatSwing) {
  expect_text(
      {"a position loop too fast for its velocity loop",
       "[machine.axes.X]\nservo_gain = 100.0\nvelocity_gain = 10.0\n",
       R"(sheet1.toml:1:15: error: the loops of axis X do not come to rest: they swing ever farther [SET119]
    1 | [machine.axes.X]
      |               ^
      = servo_gain makes 1666.67 1/s of the position loop: a velocity_gain of several times that, and at most 10000
)"});
}

TEST_F(SetupErrorText, OfACyclicErrorThatTurnsBack) {
  expect_text(
      {"a cyclic error of two millimetres on a screw of ten",
       "[machine.axes.X]\ncyclic_error = 2.0\n",
       R"(sheet1.toml:1:15: error: the cyclic error of axis X would turn the axis back while its encoder goes on [SET158]
    1 | [machine.axes.X]
      |               ^
      = with this cyclic_pitch, cyclic_error has to be below 1.59155
)"});
}

const ErrorCase kOfWhatTheControlBelieves[] = {
    {"a belief about an axis that carries nothing", "[believed.axes.C]\ncentre = [0.0, 0.0, 1.0]\n",
     R"(sheet1.toml:1:16: error: axis C carries neither part nor tool, so the control can believe nothing of it [SET114]
    1 | [believed.axes.C]
      |                ^
      = table_side and tool_side of [machine] name its rotary axes
)"},
    {"a belief about a linear axis", "[believed.axes.X]\n",
     R"(sheet1.toml:1:16: error: unknown key X in [believed.axes], which takes A, B and C [SET103]
    1 | [believed.axes.X]
      |                ^
)"},
    {"a belief about an axis that the control knows but nothing stands on",
     "[machine.axes.C]\n[believed.axes.C]\n",
     R"(sheet1.toml:2:16: error: axis C carries neither part nor tool, so the control can believe nothing of it [SET114]
    2 | [believed.axes.C]
      |                ^
      = table_side and tool_side of [machine] name its rotary axes
)"},
    {"a key of another spelling",
     "[machine]\ntable_side = \"C\"\n[believed.axes.C]\ncenter = [0.0, 0.0, 1.0]\n",
     R"(sheet1.toml:4:1: error: unknown key center in [believed.axes.C], did you mean centre? [SET103]
    4 | center = [0.0, 0.0, 1.0]
      | ^
)"},
    {"what no transformation goes by",
     "[machine]\ntable_side = \"C\"\n[believed.axes.C]\ntravel = [10.0, -10.0]\n",
     R"(sheet1.toml:4:1: error: unknown key travel in [believed.axes.C], which takes centre, direction [SET103]
    4 | travel = [10.0, -10.0]
      | ^
)"},
    {"a centre with two numbers",
     "[machine]\ntable_side = \"C\"\n[believed.axes.C]\ncentre = [0.0, 1.0]\n",
     R"(sheet1.toml:4:10: error: believed.axes.C.centre is an array of 2, it should be an array of three numbers [SET104]
    4 | centre = [0.0, 1.0]
      |          ^
      = for example: centre = [0.0, 0.0, -400.0]
)"},
    {"a factor that makes all places one", "[work_offsets.G54]\nscale = [0, 1, 1]\n",
     R"(sheet1.toml:2:9: error: work_offsets.G54.scale is [0, 1, 1], it should be three numbers, none of them 0 [SET105]
    2 | scale = [0, 1, 1]
      |         ^
)"},
    {"a direction that is none",
     "[machine]\ntable_side = \"C\"\n[believed.axes.C]\ndirection = [0.0, 0.0, 0.0]\n",
     R"(sheet1.toml:4:13: error: believed.axes.C.direction is [0, 0, 0], it should be three numbers, not all 0 [SET105]
    4 | direction = [0.0, 0.0, 0.0]
      |             ^
)"},
    {"a slip in the section", "[believed.axis.C]\n",
     R"(sheet1.toml:1:11: error: unknown key axis in [believed], did you mean axes? [SET103]
    1 | [believed.axis.C]
      |           ^
)"},
};

TEST_F(SetupErrorText, OfWhatTheControlBelieves) {
  for (const ErrorCase& c : kOfWhatTheControlBelieves) {
    expect_text(c);
  }
}

}  // namespace
}  // namespace g31::setup::setup_probe_errors_test

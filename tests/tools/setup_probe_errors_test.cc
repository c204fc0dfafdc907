#include <gtest/gtest.h>

#include "tests/tools/setup_error_text.h"

namespace g31::setup {
namespace {

const ErrorCase kOfAProbeThatIsATool[] = {
    {"a digital input that no control has", "[probe]\nready_input = 99\n",
     R"(sheet1.toml:2:15: error: probe.ready_input is 99, it should be 1 to 64 for $A_IN, or 1000 to 1015 for #1000 to #1015 [SET105]
    2 | ready_input = 99
      |               ^
)"},
    {"a probe that is no tool", "[probe]\ntool = 0\n",
     R"(sheet1.toml:2:8: error: probe.tool is 0, it should be 1 to 99999999 [SET105]
    2 | tool = 0
      |        ^
)"},
    {"a code that is no M code", "[probe]\non = \"G80\"\n",
     R"(sheet1.toml:2:6: error: probe.on is "G80", it should be M and a number of one to eight digits [SET105]
    2 | on = "G80"
      |      ^
)"},
};

TEST_F(SetupErrorText, OfAProbeThatIsATool) {
  for (const ErrorCase& c : kOfAProbeThatIsATool) {
    expect_text(c);
  }
}

const ErrorCase kOfWhatTheControlBelieves[] = {
    {"a belief about an axis that carries nothing", "[believed.axes.C]\ncentre = [0.0, 0.0, 1.0]\n",
     R"(sheet1.toml:1:16: error: axis C carries neither part nor tool, so there is nothing to believe of it [SET114]
    1 | [believed.axes.C]
      |                ^
      = table_side and tool_side of [machine] name its rotary axes
)"},
    {"a belief about a linear axis", "[believed.axes.X]\n",
     R"(sheet1.toml:1:16: error: unknown key X in [believed.axes], which takes A, B and C [SET103]
    1 | [believed.axes.X]
      |                ^
)"},
};

TEST_F(SetupErrorText, OfWhatTheControlBelieves) {
  for (const ErrorCase& c : kOfWhatTheControlBelieves) {
    expect_text(c);
  }
}

}  // namespace
}  // namespace g31::setup

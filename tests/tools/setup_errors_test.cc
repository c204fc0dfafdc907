#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "tests/tools/setup_error_text.h"
#include "tools/setup/check_value.h"
#include "tools/setup/keys.h"

namespace g31::setup::setup_errors_test {
namespace {

const ErrorCase kNameTheKeyThatWasProbablyMeant[] = {
    {"an unknown section", "contrl = 1\n",
     R"(sheet1.toml:1:1: error: unknown key contrl in the sheet, did you mean control? [SET103]
    1 | contrl = 1
      | ^
)"},
    {"an unknown section far from all", "zebra = 2\n",
     R"(sheet1.toml:1:1: error: unknown key zebra in the sheet, which takes control, parameters, macro_calls, variables, machine_data, gud, start, work_offsets, tools, machine, believed, probe, part, sensor, tool, tool_probe, input, skip_signal, characteristic, expect [SET103]
    1 | zebra = 2
      | ^
)"},
    {"a section that is a number", "probe = 5\n",
     R"(sheet1.toml:1:9: error: probe is a whole number, it should be a table [SET104]
    1 | probe = 5
      |         ^
      = for example: [probe]
)"},
    {"[part] instead of [[part]]", "[part]\nshape = \"ring\"\n",
     R"(sheet1.toml:1:1: error: part is a table, it should be an array of tables [SET104]
    1 | [part]
      | ^
      = for example: [[part]]
)"},
    {"a list of numbers instead of tables", "skip_signal = [1]\n",
     R"(sheet1.toml:1:16: error: skip_signal is a whole number, it should be a table [SET104]
    1 | skip_signal = [1]
      |                ^
      = for example: [[skip_signal]]
)"},
    {"a named section without tables", "tools = 1\n",
     R"(sheet1.toml:1:9: error: tools is a whole number, it should be a table [SET104]
    1 | tools = 1
      |         ^
      = for example: [tools.99]
)"},
    {"a named table that is a number", "[tools]\n7 = 120.0\n",
     R"(sheet1.toml:2:5: error: tools.7 is a number with a decimal point, it should be a table [SET104]
    2 | 7 = 120.0
      |     ^
      = for example: [tools.99]
)"},
    {"a misspelt key", "[probe]\nbal_diameter = 6.0\n",
     R"(sheet1.toml:2:1: error: unknown key bal_diameter in [probe], did you mean ball_diameter? [SET103]
    2 | bal_diameter = 6.0
      | ^
)"},
    {"an unknown key far from all", "[control]\nwombat = 1\n",
     R"(sheet1.toml:2:1: error: unknown key wombat in [control], which takes profile, increment, offset_memory, axes, block_skip, lookahead, feed_override, dry_run, rapids, variables_file, files, keys [SET103]
    2 | wombat = 1
      | ^
)"},
    {"an error of an axis that is none", "[machine.errors]\nEXW = 1\n",
     R"(sheet1.toml:2:1: error: unknown key EXW in [machine.errors], did you mean EXX? [SET103]
    2 | EXW = 1
      | ^
)"},
    {"an unknown key in a named table", "[tools.99]\nlenght = 3\n",
     R"(sheet1.toml:2:1: error: unknown key lenght in [tools.99], did you mean length? [SET103]
    2 | lenght = 3
      | ^
)"},
    {"an axis that is none", "[work_offsets.G59]\nQ = 1\n",
     R"(sheet1.toml:2:1: error: unknown key Q in [work_offsets.G59], which takes X, Y, Z, A, B and C, rotate_deg, fine, scale, mirror [SET103]
    2 | Q = 1
      | ^
)"},
    {"a lower-case axis", "[start]\nx = 1\n",
     R"(sheet1.toml:2:1: error: unknown key x in [start], which takes X, Y, Z, A, B and C [SET103]
    2 | x = 1
      | ^
)"},
    {"a work offset that is none", "[work_offsets.G60]\n",
     R"(sheet1.toml:1:15: error: unknown key G60 in [work_offsets], which takes G54 to G59, EXT, "G54.1 Pn", "G154 Pn" and G505 to G599 [SET103]
    1 | [work_offsets.G60]
      |               ^
)"},
    {"a misspelt work offset", "[work_offsets.EXTT]\n",
     R"(sheet1.toml:1:15: error: unknown key EXTT in [work_offsets], did you mean EXT? [SET103]
    1 | [work_offsets.EXTT]
      |               ^
)"},
    {"a tool below zero", "[tools.-1]\n",
     R"(sheet1.toml:1:8: error: unknown key -1 in [tools], which takes whole numbers 0 to 99999999 [SET103]
    1 | [tools.-1]
      |        ^
)"},
    {"a machine axis that is none", "[machine.axes.D]\n",
     R"(sheet1.toml:1:15: error: unknown key D in [machine.axes], which takes X, Y, Z, A, B, C, U, V and W [SET103]
    1 | [machine.axes.D]
      |               ^
)"},
    {"a misspelt [machine.axes]", "[machine.axis.X]\n",
     R"(sheet1.toml:1:10: error: unknown key axis in [machine], did you mean axes? [SET103]
    1 | [machine.axis.X]
      |          ^
)"},
    {"a parameter bit without quotes", "[parameters]\n6001.1 = 1\n",
     R"(sheet1.toml:2:1: error: parameters.6001 is a table, it should be a number, true or false [SET104]
    2 | 6001.1 = 1
      | ^
      = for example: "6001.1" = 1
)"},
    {"a parameter bit above 7", "[parameters]\n\"6001.8\" = 1\n",
     R"(sheet1.toml:2:1: error: unknown key "6001.8" in [parameters], which takes NUMBER, NUMBER.BIT or NUMBER.AXIS [SET103]
    2 | "6001.8" = 1
      | ^
)"},
    {"a parameter bit that is 2", "[parameters]\n\"6001.2\" = 2\n",
     R"(sheet1.toml:2:12: error: parameters."6001.2" is 2, it should be 0 or 1 [SET105]
    2 | "6001.2" = 2
      |            ^
)"},
    {"a code that calls nothing", "[macro_calls]\nT1 = 5\n",
     R"(sheet1.toml:2:1: error: unknown key T1 in [macro_calls], which takes G and a number or M and a number [SET103]
    2 | T1 = 5
      | ^
)"},
    {"a name that is no variable", "[variables]\n\"5 0\" = 1\n",
     R"(sheet1.toml:2:1: error: unknown key "5 0" in [variables], which takes names of variables like #500, R1 or _OVR[0] [SET103]
    2 | "5 0" = 1
      | ^
)"},
};

TEST(SetupValues, EveryNumberWithAUnitHasBounds) {
  const setup::Node huge{1, 1, 1e300};
  std::size_t bounded = 0;
  for (const setup::KeyRow& row : setup::key_rows()) {
    if (row.type == setup::ValueType::Number && !row.unit.empty()) {
      EXPECT_FALSE(setup::checked_value(huge, row.type, row.limit, row.unit)) << row.name;
      ++bounded;
    }
  }
  EXPECT_GT(bounded, 40U);
}

TEST_F(SetupErrorText, NameTheKeyThatWasProbablyMeant) {
  for (const ErrorCase& c : kNameTheKeyThatWasProbablyMeant) {
    expect_text(c);
  }
}

const ErrorCase kSayWhatAValueIsAndWhatItShouldBe[] = {
    {"a string for a name", "[control]\nprofile = 7\n",
     R"(sheet1.toml:2:11: error: control.profile is a whole number, it should be a string [SET104]
    2 | profile = 7
      |           ^
      = for example: profile = "fanuc-16i"
)"},
    {"a number for a variable", "[variables]\n\"#500\" = \"abc\"\n",
     R"(sheet1.toml:2:10: error: variables."#500" is a string, it should be a number, or "" for vacant [SET104]
    2 | "#500" = "abc"
      |          ^
      = for example: "#515" = 6.0
)"},
    {"a number for a parameter", "[parameters]\n\"3410\" = \"x\"\n",
     R"(sheet1.toml:2:10: error: parameters.3410 is a string, it should be a number, true or false [SET104]
    2 | "3410" = "x"
      |          ^
      = for example: "6001.1" = 1
)"},
    {"a whole number for a program", "[macro_calls]\nG65 = 1.5\n",
     R"(sheet1.toml:2:7: error: macro_calls.G65 is a number with a decimal point, it should be a whole number [SET104]
    2 | G65 = 1.5
      |       ^
      = for example: G100 = 9010
)"},
    {"a date for a number", "[machine.axes.X]\nhome = 1979-05-27\n",
     R"(sheet1.toml:2:8: error: machine.axes.X.home is a date or time, it should be a number [SET104]
    2 | home = 1979-05-27
      |        ^
      = for example: home = 0.0
)"},
    {"whole numbers for the switches", "[control]\nblock_skip = [1.5]\n",
     R"(sheet1.toml:2:14: error: control.block_skip is an array that holds a number with a decimal point, it should be an array of whole numbers [SET104]
    2 | block_skip = [1.5]
      |              ^
      = for example: block_skip = [1]
)"},
    {"a switch that is no list", "[control]\nblock_skip = 1\n",
     R"(sheet1.toml:2:14: error: control.block_skip is a whole number, it should be an array of whole numbers [SET104]
    2 | block_skip = 1
      |              ^
      = for example: block_skip = [1]
)"},
    {"two numbers, not one", "[machine.axes.Y]\ntravel = [5]\n",
     R"(sheet1.toml:2:10: error: machine.axes.Y.travel is an array of 1, it should be an array of two numbers [SET104]
    2 | travel = [5]
      |          ^
      = for example: travel = [0.0, 900.0]
)"},
    {"two numbers, not a flag", "[machine.axes.Y]\ntravel = [true, 1]\n",
     R"(sheet1.toml:2:10: error: machine.axes.Y.travel is an array that holds a true-or-false value, it should be an array of two numbers [SET104]
    2 | travel = [true, 1]
      |          ^
      = for example: travel = [0.0, 900.0]
)"},
    {"three numbers, not two", "[[part]]\nshape = \"ring\"\nat = [1, 2]\n",
     R"(sheet1.toml:3:6: error: part.at is an array of 2, it should be an array of three numbers [SET104]
    3 | at = [1, 2]
      |      ^
      = for example: at = [250.0, -180.0, -300.0]
)"},
    {"a switch out of range", "[control]\nblock_skip = [0, 12]\n",
     R"(sheet1.toml:2:14: error: control.block_skip is [0, 12], it should be a list of numbers 1 to 9 [SET105]
    2 | block_skip = [0, 12]
      |              ^
)"},
    {"an increment system that is none", "[control]\nincrement = \"IS-D\"\n",
     R"(sheet1.toml:2:13: error: control.increment is "IS-D", it should be "IS-A", "IS-B" or "IS-C" [SET105]
    2 | increment = "IS-D"
      |             ^
)"},
    {"a program number of 0", "[macro_calls]\nG100 = 0\n",
     R"(sheet1.toml:2:8: error: macro_calls.G100 is 0, it should be 1 to 99999999 [SET105]
    2 | G100 = 0
      |        ^
)"},
    {"travel that does not rise", "[machine.axes.X]\ntravel = [5, 5]\n",
     R"(sheet1.toml:2:10: error: machine.axes.X.travel is [5, 5], it should be two numbers, the first below the second [SET105]
    2 | travel = [5, 5]
      |          ^
)"},
    {"a rapid traverse of 0", "[machine.axes.X]\nrapid = 0\n",
     R"(sheet1.toml:2:9: error: machine.axes.X.rapid is 0, it should be greater than 0 [SET105]
    2 | rapid = 0
      |         ^
)"},
    {"an acceleration below 0", "[machine.axes.X]\nacceleration = -2.5\n",
     R"(sheet1.toml:2:16: error: machine.axes.X.acceleration is -2.5, it should be greater than 0 [SET105]
    2 | acceleration = -2.5
      |                ^
)"},
    {"a way of stopping that is none", "[machine]\nstopping = \"slow\"\n",
     R"(sheet1.toml:2:12: error: machine.stopping is "slow", it should be "braking" or "ideal" [SET105]
    2 | stopping = "slow"
      |            ^
)"},
    {"a correction of an angle", "[machine.compensation]\nEAX = [[0.0, 0.0]]\n",
     R"(sheet1.toml:2:1: error: unknown key EAX in [machine.compensation], did you mean EXX? [SET103]
    2 | EAX = [[0.0, 0.0]]
      | ^
)"},
    {"an error table that is a string", "[machine.errors]\nEXX = \"no\"\n",
     R"(sheet1.toml:2:7: error: machine.errors.EXX is a string, it should be a number or an array of [place, error] [SET104]
    2 | EXX = "no"
      |       ^
      = for example: EXX = [[0.0, 0.0], [560.0, 0.004]]
)"},
    {"an error table without places", "[machine.errors]\nEXX = [[0.0, 1.0, 2.0]]\n",
     R"(sheet1.toml:2:7: error: machine.errors.EXX is an array that holds an array of 3, it should be a number or an array of [place, error] [SET104]
    2 | EXX = [[0.0, 1.0, 2.0]]
      |       ^
      = for example: EXX = [[0.0, 0.0], [560.0, 0.004]]
)"},
    {"places that do not rise", "[machine.errors]\nEXX = [[5.0, 0.0], [5.0, 1.0]]\n",
     R"(sheet1.toml:2:7: error: machine.errors.EXX is [5, 0, 5, 1], it should be pairs with rising places [SET105]
    2 | EXX = [[5.0, 0.0], [5.0, 1.0]]
      |       ^
)"},
    {"a side with a letter that is no axis", "[machine]\ntable_side = \"CU\"\n",
     R"(sheet1.toml:2:14: error: machine.table_side is "CU", it should be letters of X, Y, Z, A, B and C, none twice [SET105]
    2 | table_side = "CU"
      |              ^
)"},
    {"a direction that points nowhere", "[machine.axes.C]\ndirection = [0, 0, 0.0]\n",
     R"(sheet1.toml:2:13: error: machine.axes.C.direction is [0, 0, 0], it should be three numbers, not all 0 [SET105]
    2 | direction = [0, 0, 0.0]
      |             ^
)"},
    {"a probe as long as the way to the next galaxy", "[probe]\nlength = 1e60\n",
     R"(sheet1.toml:2:10: error: probe.length is 1e+60, it should be 1000000 mm at most [SET105]
    2 | length = 1e60
      |          ^
)"},
    {"a ball that vanishes", "[probe]\nball_diameter = 1e-300\n",
     R"(sheet1.toml:2:17: error: probe.ball_diameter is 1e-300, it should be 1e-09 mm at least [SET105]
    2 | ball_diameter = 1e-300
      |                 ^
)"},
    {"a ball of no size", "[probe]\nball_diameter = 0.0\n",
     R"(sheet1.toml:2:17: error: probe.ball_diameter is 0, it should be greater than 0 [SET105]
    2 | ball_diameter = 0.0
      |                 ^
)"},
    {"a probe of a type that is none", "[probe]\ntype = \"2D\"\n",
     R"(sheet1.toml:2:8: error: probe.type is "2D", it should be "3D" or "mono" [SET105]
    2 | type = "2D"
      |        ^
)"},
    {"seats that are none", "[probe]\nseats = \"leather\"\n",
     R"(sheet1.toml:2:9: error: probe.seats is "leather", it should be "even" or "tripod" [SET105]
    2 | seats = "leather"
      |         ^
)"},
    {"a state that is none", "[probe]\nstate = \"tired\"\n",
     R"(sheet1.toml:2:9: error: probe.state is "tired", it should be "ready", "dead", "low_battery" or "double_trigger" [SET105]
    2 | state = "tired"
      |         ^
)"},
    {"an input that is none", "[probe]\nlow_battery_input = 1016\n",
     R"(sheet1.toml:2:21: error: probe.low_battery_input is 1016, it should be 1 to 64 for $A_IN, 1000 to 1015 for #1000 to #1015, or 11016 to 11255 for those of a Haas [SET105]
    2 | low_battery_input = 1016
      |                     ^
)"},
    {"an input that no control has", "[probe]\ninput = 9\n",
     R"(sheet1.toml:2:9: error: probe.input is 9, it should be 1 to 8 [SET105]
    2 | input = 9
      |         ^
)"},
    {"a stem without stiffness", "[probe]\nstem_stiffness = 0\n",
     R"(sheet1.toml:2:18: error: probe.stem_stiffness is 0, it should be greater than 0 [SET105]
    2 | stem_stiffness = 0
      |                  ^
)"},
    {"a further ball of no size", "[probe]\n[[probe.ball]]\ndiameter = 0\n",
     R"(sheet1.toml:3:12: error: probe.ball.diameter is 0, it should be greater than 0 [SET105]
    3 | diameter = 0
      |            ^
)"},
    {"an arm thinner than nothing", "[probe]\n[[probe.ball]]\narm_diameter = -1\n",
     R"(sheet1.toml:3:16: error: probe.ball.arm_diameter is -1, it should be 0 or more [SET105]
    3 | arm_diameter = -1
      |                ^
)"},
    {"a length that is not finite", "[probe]\nlength = inf\n",
     R"(sheet1.toml:2:10: error: probe.length is inf, it should be a finite number [SET105]
    2 | length = inf
      |          ^
)"},
    {"a delay before the touch", "[probe]\ntrigger_delay_s = -0.1\n",
     R"(sheet1.toml:2:19: error: probe.trigger_delay_s is -0.1, it should be 0 or more [SET105]
    2 | trigger_delay_s = -0.1
      |                   ^
)"},
    {"a repeatability below 0", "[probe]\nrepeatability_mm = -1\n",
     R"(sheet1.toml:2:20: error: probe.repeatability_mm is -1, it should be 0 or more [SET105]
    2 | repeatability_mm = -1
      |                    ^
)"},
    {"a list that is not finite", "[probe]\neccentricity = [0, nan]\n",
     R"(sheet1.toml:2:16: error: probe.eccentricity is nan, it should be a finite number [SET105]
    2 | eccentricity = [0, nan]
      |                ^
)"},
    {"a whole number too large for a double", "[variables]\n\"#2\" = 9223372036854775807\n",
     R"(sheet1.toml:2:8: error: variables."#2" is 9223372036854775807, it should be 9007199254740992 at most in size [SET105]
    2 | "#2" = 9223372036854775807
      |        ^
)"},
    {"an axis of a signal that is none", "[[skip_signal]]\naxis = \"W\"\n",
     R"(sheet1.toml:2:8: error: skip_signal.axis is "W", it should be "X", "Y", "Z", "A", "B" or "C" [SET105]
    2 | axis = "W"
      |        ^
)"},
};

TEST_F(SetupErrorText, SayWhatAValueIsAndWhatItShouldBe) {
  for (const ErrorCase& c : kSayWhatAValueIsAndWhatItShouldBe) {
    expect_text(c);
  }
}

const ErrorCase kStandAtTheirPlace[] = {
    {"an empty path", "[control]\nvariables_file = \"\"\n",
     R"(sheet1.toml:2:18: error: control.variables_file is "", it should be a string that is not empty [SET105]
    2 | variables_file = ""
      |                  ^
)"},
    {"a part of nothing", "[[part]]\nname = \"air\"\n",
     R"(sheet1.toml:1:1: error: a part needs either file or shape; this one has none [SET106]
    1 | [[part]]
      | ^
      = for example: file = "ring.stl"
)"},
    {"a part of two things", "[[part]]\nfile = \"ring.stl\"\nshape = \"ring\"\n",
     R"(sheet1.toml:1:1: error: a part needs either file or shape; this one has both [SET106]
    1 | [[part]]
      | ^
      = for example: file = "ring.stl"
)"},
    {"a misspelt size of a shape", "[[part]]\nshape = \"ring\"\nboree = 5\n",
     R"(sheet1.toml:3:1: error: unknown key boree in [[part]], did you mean bore? [SET103]
    3 | boree = 5
      | ^
)"},
    {"a size below 0", "[[part]]\nshape = \"ring\"\nbore = -1\n",
     R"(sheet1.toml:3:8: error: part.bore is -1, it should be greater than 0 [SET105]
    3 | bore = -1
      |        ^
)"},
    {"a size of a file", "[[part]]\nfile = \"ring.stl\"\nbore = 3\n",
     R"(sheet1.toml:3:1: error: unknown key bore in [[part]], which takes name, file, step_sagitta, unit, scale, closed, fixture, mount, shape, on, at, rotate_deg, expansion, temperature, profile [SET103]
    3 | bore = 3
      | ^
)"},
    {"a mesh that is not there", "[[part]]\nfile = \"meshes/nix.stl\"\n",
     R"(sheet1.toml:2:8: error: there is no file meshes/nix.stl [SET107]
    2 | file = "meshes/nix.stl"
      |        ^
      = paths start at the folder of the sheet
)"},
    {"a machine file that is not there", "[machine]\nfile = \"nix.toml\"\n",
     R"(sheet1.toml:2:8: error: there is no file nix.toml [SET107]
    2 | file = "nix.toml"
      |        ^
      = paths start at the folder of the sheet
)"},
    {"a tool given in two spellings", "[tools.5]\nlength = 1\n[tools.05]\nlength = 2\n",
     R"(sheet1.toml:3:8: error: tools.5 is given twice in this sheet [SET108]
    3 | [tools.05]
      |        ^
)"},
    {"a variable given in two spellings", "[variables]\n\"#1\" = 1\n\"#01\" = 2\n",
     R"(sheet1.toml:3:1: error: variables."#01" is given twice in this sheet [SET108]
    3 | "#01" = 2
      | ^
)"},
    {"an axis on no side", "[machine]\ntable_side = \"C\"\n[machine.axes.B]\n",
     R"(sheet1.toml:3:15: error: axis B is in neither table_side nor tool_side [SET112]
    3 | [machine.axes.B]
      |               ^
)"},
    {"an axis on both sides", "[machine]\ntable_side = \"CX\"\n",
     R"(sheet1.toml:2:14: error: axis X appears twice in table_side and tool_side [SET113]
    2 | table_side = "CX"
      |              ^
)"},
    {"a signal without axis", "[[skip_signal]]\nat = 3\n",
     R"(sheet1.toml:1:1: error: a skip signal with at needs its axis [SET109]
    1 | [[skip_signal]]
      | ^
      = for example: axis = "X"
)"},
    {"not TOML: an open array", "x = [1\n[a]\n",
     R"(sheet1.toml:2:1: error: this is not TOML: Error while parsing array: expected comma or closing ']', saw '[' [SET102]
    2 | [a]
      | ^
)"},
    {"not TOML: a key twice", "[probe]\nlength = 1\nlength = 2\n",
     R"(sheet1.toml:3:10: error: this is not TOML: Error while parsing key-value pair: cannot redefine existing integer 'length' [SET102]
    3 | length = 2
      |          ^
)"},
    {"not TOML: a key of too many parts",
     "[a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a]\n",
     R"(sheet1.toml:1:67: error: this is not TOML: a key of more than 32 parts [SET102]
    1 | [a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a.a]
      |                                                                   ^
)"},
    {"bytes that are not UTF-8", "[control]\nprofile = \"\xff\x01\"\n",
     R"(sheet1.toml:2:11: error: this is not TOML: Encountered invalid utf-8 sequence [SET102]
    2 | profile = "??"
      |           ^
)"},
    {"characters of several bytes before the place", "\"\xc3\xa4\" = { \"\xc3\xb6\" = 1, b = \n",
     R"(sheet1.toml:1:22: error: this is not TOML: Error while parsing key-value pair: expected value, saw '\n' [SET102]
    1 | "ä" = { "ö" = 1, b = 
      |                      ^
)"},
    {"a line break in a name", "\"a\\nb\" = 1\n",
     R"(sheet1.toml:1:1: error: unknown key "a?b" in the sheet, which takes control, parameters, macro_calls, variables, machine_data, gud, start, work_offsets, tools, machine, believed, probe, part, sensor, tool, tool_probe, input, skip_signal, characteristic, expect [SET103]
    1 | "a\nb" = 1
      | ^
)"},
    {"a carriage return at the end of the line", "zebr = 1\r\n",
     R"(sheet1.toml:1:1: error: unknown key zebr in the sheet, which takes control, parameters, macro_calls, variables, machine_data, gud, start, work_offsets, tools, machine, believed, probe, part, sensor, tool, tool_probe, input, skip_signal, characteristic, expect [SET103]
    1 | zebr = 1
      | ^
)"},
    {"errors of a sheet in the order of its lines",
     "[probe]\nlength = \"long\"\nball_diameter = -1\n[control]\nprofil = \"\"\nincrement = "
     "\"\"\n",
     R"(sheet1.toml:2:10: error: probe.length is a string, it should be a number [SET104]
    2 | length = "long"
      |          ^
      = for example: length = 120.0
sheet1.toml:3:17: error: probe.ball_diameter is -1, it should be greater than 0 [SET105]
    3 | ball_diameter = -1
      |                 ^
sheet1.toml:5:1: error: unknown key profil in [control], did you mean profile? [SET103]
    5 | profil = ""
      | ^
sheet1.toml:6:13: error: control.increment is "", it should be "IS-A", "IS-B" or "IS-C" [SET105]
    6 | increment = ""
      |             ^
)"},
};

TEST_F(SetupErrorText, StandAtTheirPlace) {
  for (const ErrorCase& c : kStandAtTheirPlace) {
    expect_text(c);
  }
}

TEST_F(SetupErrorText, AnUnknownShapeIsTheOnlyErrorOfItsPart) {
  std::string shapes;
  for (const parts::Shape& shape : parts::shapes()) {
    shapes += (shapes.empty() ? "\"" : " or \"") + std::string(shape.name) + "\"";
  }
  EXPECT_EQ(errors_of(read({"[[part]]\nshape = \"blob\"\ndiameter = 5\n"})),
            "sheet1.toml:2:9: error: part.shape is \"blob\", it should be " + shapes +
                " [SET105]\n    2 | shape = \"blob\"\n      |         ^\n");
}

TEST_F(SetupErrorText, OfAFileThatCannotBeReadStandAlone) {
  struct Unreadable {
    std::string path;
    std::string text;
  };
  const Unreadable kCases[] = {
      {path_of("nix.toml"), "nix.toml: error: cannot read the file: no such file [SET101]\n"},
      {path_of("."), ".: error: cannot read the file: it is a folder [SET101]\n"},
      {write("big.toml", std::string(kLargestSheetBytes + 1, '\n')),
       "big.toml: error: cannot read the file: it is larger than 16 MiB [SET101]\n"},
  };
  for (const Unreadable& c : kCases) {
    SCOPED_TRACE(c.path);
    const std::vector<std::string> paths = {c.path};
    EXPECT_EQ(errors_of(read_job(paths)), c.text);
  }
}

TEST_F(SetupErrorText, OfAllSheetsAndTheMachineFileComeInTheOrderOfReading) {
  static_cast<void>(write("v55.toml", "nam = \"V55\"\nfile = \"ring.stl\"\n"));
  EXPECT_EQ(errors_of(read({"[[part]]\nfile = \"nix.stl\"\n[machine]\nfile = \"v55.toml\"\n",
                            "[machine", "[probe]\nlength = nan\n"})),
            R"(sheet1.toml:2:8: error: there is no file nix.stl [SET107]
    2 | file = "nix.stl"
      |        ^
      = paths start at the folder of the sheet
sheet2.toml:1:9: error: this is not TOML: Error while parsing table header: encountered end-of-file [SET102]
    1 | [machine
      |         ^
sheet3.toml:2:10: error: probe.length is nan, it should be a finite number [SET105]
    2 | length = nan
      |          ^
v55.toml:1:1: error: unknown key nam in the machine file, did you mean name? [SET103]
    1 | nam = "V55"
      | ^
v55.toml:2:8: error: a machine file cannot name another machine file [SET110]
    2 | file = "ring.stl"
      |        ^
)");
}

TEST_F(SetupErrorText, OfAMachineFileThatIsAWholeSheetNameWhatDoesNotBelongThere) {
  static_cast<void>(write("v55.toml", "[machine]\nname = \"V55\"\n[probe]\n"));
  EXPECT_EQ(
      errors_of(read({"[machine]\nfile = \"v55.toml\"\n"})),
      R"(v55.toml:3:2: error: unknown key probe in the machine file, which takes [machine] [SET103]
    3 | [probe]
      |  ^
)");
}

TEST_F(SetupErrorText, CutLongLinesAroundTheCaret) {
  const std::string sheet = "control = {profile = \"" + std::string(300, 'p') + "\", zebra = 1" +
                            std::string(300, ' ') + "}\n";
  EXPECT_EQ(errors_of(read({sheet})),
            "sheet1.toml:1:326: error: unknown key zebra in [control], which takes profile, "
            "increment, offset_memory, axes, block_skip, lookahead, feed_override, dry_run, "
            "rapids, variables_file, files, keys [SET103]\n    1 | " +
                std::string(57, 'p') + "\", zebra = 1" + std::string(51, ' ') + "\n      | " +
                std::string(60, ' ') + "^\n");
}

TEST_F(SetupErrorText, CutLongDetails) {
  const std::string key(1000, 'k');
  const std::string text = errors_of(read({key + " = 1\n"}));
  EXPECT_NE(text.find("unknown key " + std::string(400, 'k') + "... in the sheet"),
            std::string::npos);
}

TEST_F(SetupErrorText, HaveCodesOfTheirOwn) {
  const std::vector<std::string> codes = {
#define SETUP_ERROR(name, code, text, about) code,
#include "tools/setup/setup_errors.def"
#undef SETUP_ERROR
  };
  EXPECT_EQ(std::set<std::string>(codes.begin(), codes.end()).size(), codes.size());
}

}  // namespace
}  // namespace g31::setup::setup_errors_test

// Whole programs in which something touches that must not.

#include <algorithm>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::collision_run_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

/// A block of 60 x 40 x 20 with its top at Z 0, and a probe whose wide body begins 50 mm above the
/// ball.
constexpr const char* kSheet = R"([start]
X = -100.0
Z = 400.0
[work_offsets.G54]
[tools.1]
length = 120.0
[machine]
stopping = "ideal"
[[part]]
name = "block"
shape = "block"
[probe]
ball_diameter = 6.0
length = 120.0
stem_length = 50.0
[[probe.body]]
name = "transmitter"
length = 70.0
diameter = 40.0
)";

RunOutput run_with(const std::string& sheet_end, const std::string& blocks) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("hit.nc", "O1\nG90 G54 G43 H1 G00 Z20.\n" + blocks + "M30\n")};
  options.setups = {folder.write("sheet.toml", kSheet), folder.write("more.toml", sheet_end)};
  options.moves = true;
  return run_program(options);
}

struct Case {
  const char* what;
  std::string sheet_end;
  std::string blocks;   ///< from line 3 on
  std::string message;  ///< of the collision; "" for none
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.what;
}

class Collisions : public ::testing::TestWithParam<Case> {};

TEST_P(Collisions, EndTheRunWithPlaceAndBodies) {
  const Case& c = GetParam();
  SCOPED_TRACE(c.what);
  const RunOutput output = run_with(c.sheet_end, c.blocks);
  if (c.message.empty()) {
    EXPECT_NE(output.exit_code, 4) << output.errors;
    return;
  }
  EXPECT_EQ(output.exit_code, 4) << output.errors;
  EXPECT_EQ(output.document.at("status"), "collision");
  EXPECT_NE(output.errors.find(c.message), std::string::npos) << output.errors;
}

const Case kCases[] = {
    {"the body touches beside the block, deeper than the stem is long", "",
     "G00 X-100. Z-55.\nG01 X-36. F1000\n",
     "hit.nc:4:1: error: transmitter touches block [PRB401]"},
    {"the body is still above the block", "", "G00 X-100. Z-45.\nG01 X-34. F1000\n", ""},
    {"a rapid through the block", "", "G00 X-100. Z-5.\nG00 X100.\n",
     "hit.nc:4:1: error: stylus ball touches block [PRB401]"},
    {"the stem on a rapid under the block", "", "G00 X-100. Z-40.\nG00 X-20.\n",
     "hit.nc:4:1: error: stem touches block [PRB401]"},
    {"a skip move whose body touches before the ball", "", "G00 X-100. Z-55.\nG31 X-20. F100\n",
     "hit.nc:4:1: error: transmitter touches block [PRB401]"},
    {"an arc of the body around the ball", "",
     "G00 X-100. Z-55.\nG02 X-50. Y50. I50. F1000\nG02 X-50. Y-50. J-50.\n",
     "error: transmitter touches block [PRB401]"},
    {"a probe pushed further than it gives way by a late signal",
     "[probe]\ntrigger_delay_s = 0.5\n", "G00 X-100. Z-5.\nG31 X-20. F1000\n",
     "hit.nc:4:1: error: stylus is pushed 3.000 mm into block, its deflection limit [PRB401]"},
    {"a probe with a lower limit breaks",
     "[probe]\ntrigger_delay_s = 0.1\ndeflection_limit = 1.5\n",
     "G00 X-100. Z-5.\nG31 X-20. F1000\n",
     "hit.nc:4:1: error: stylus is pushed 1.500 mm into block, its deflection limit [PRB401]"},
    {"a dead probe is pushed until it breaks", "[probe]\nstate = \"dead\"\n",
     "G00 X-100. Z-5.\nG31 X0. F100\n",
     "hit.nc:4:1: error: stylus is pushed 3.000 mm into block, its deflection limit [PRB401]"},
    {"the arm of a second ball sinks into the block",
     "[[probe.ball]]\nat = [160.0, 0.0, 4.0]\ndiameter = 4.0\n", "G00 X-70. Z10.\nG01 Z-3. F1000\n",
     "hit.nc:4:1: error: stylus arm touches block [PRB401]"},
    {"the arm of a second ball a little higher",
     "[[probe.ball]]\nat = [160.0, 0.0, 4.0]\ndiameter = 4.0\n",
     "G00 X-70. Z10.\nG01 Z-2.6 F1000\n", ""},
    {"a second ball without an arm beside the block",
     "[[probe.ball]]\nat = [160.0, 0.0, 4.0]\ndiameter = 4.0\narm_diameter = 0.0\n",
     "G00 X-70. Z10.\nG01 Z-5. F1000\n", ""},
    {"a touch and the way back", "[probe]\ntrigger_delay_s = 0.1\n",
     "G00 X-100. Z-5.\nG31 X-20. F1000\nG00 X-100.\nZ20.\n", ""},
};

INSTANTIATE_TEST_SUITE_P(Runs, Collisions, ::testing::ValuesIn(kCases));

/// A round pillar of diameter 8 beside the way, as high as the ball, and the probe at the origin.
constexpr const char* kPillar = R"([tools.1]
length = 0.0
[[part]]
name = "pillar"
shape = "cylinder"
diameter = 8.0
height = 40.0
at = [18.0, 18.0, 10.0]
[probe]
ball_diameter = 6.0
length = 0.0
)";

// Each axis goes 1000 t^2 as long as it accelerates, Y for 0.1 s and then as much slower: the ball
// is at (13.289, 12.823) when its centre is 7 mm from that of the pillar.
TEST(Rapids, OfEachAxisOnItsOwnMeetWhatAStraightLinePasses) {
  for (const auto& [control, is_met] : {std::pair("", true),
                                        {"[parameters]\n\"1401.1\" = 1\n", false},
                                        {"[control]\nrapids = \"straight\"\n", false}}) {
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write("hit.nc", "O1\nG0 X100. Y20.\nM30\n")};
    options.setups = {folder.write("sheet.toml", std::string(control) + kPillar)};
    const RunOutput output = run_program(options);
    EXPECT_EQ(output.exit_code, is_met ? 4 : 0) << control << output.errors;
    EXPECT_NEAR(output.document.at("machine_time_s").get<double>(), is_met ? 0.11528 : 0.466667,
                5e-6);
  }
}

TEST(ProtectedMoves, ThatASignalEndsAreReportedWhenAnotherSkipMoveFollows) {
  const RunOutput output = run_with("", "G00 X0.\nG31 Z-10. F500\nG91 G31 X10. F100\nM30\n");
  EXPECT_EQ(output.exit_code, 1) << output.errors;
  EXPECT_NE(output.errors.find("hit.nc:4:1: warning: a skip move was stopped by its signal, and "
                               "another skip move follows [PRB310]"),
            std::string::npos)
      << output.errors;
}

TEST(ProtectedMoves, WhoseResultIsReadOrThatARetreatFollowsAreMeasurements) {
  for (const char* between : {"#1=#5063\n", "G01 Z5.\n", "#1=#5043\n"}) {
    const RunOutput output = run_with("", std::string("G00 X0.\nG31 Z-10. F500\n") + between +
                                              "G31 Z-10. F50\n#2=#5063\nG00 Z20.\n");
    EXPECT_EQ(output.errors.find("PRB310"), std::string::npos) << output.errors;
  }
}

// Blocks of 1 mm at 50 mm/s, one a line from line 5 on; the ball touches at X-33 while the command
// is v / Kv = 1.667 mm further on, in the block to X-31.  What was read ahead did not take place.
TEST(Collision, OfALaggingAxisComesWithTheBlockThatWasCommandedThen) {
  std::string blocks = "G00 X-100. Z-10.\nG05.1 Q1\nG01 F3000 X-99.\n";
  for (int x = -98; x <= -20; ++x) {
    blocks += "X" + std::to_string(x) + ".\n";
  }
  const RunOutput output = run_with("[machine.axes.X]\nservo_gain = 1.8\n", blocks);
  EXPECT_EQ(output.exit_code, 4) << output.errors;
  EXPECT_NE(output.errors.find("hit.nc:73:1: error: stylus ball touches block [PRB401]"),
            std::string::npos)
      << output.errors;
  EXPECT_EQ(output.document.at("moves").size(), 2U + 72U - 4U);
}

// The block to X-31 is met late, when the program has gone on in another level: the calls are those
// behind that block.
TEST(Collision, ThatIsFoundLateHasTheCallsOfItsBlock) {
  const std::string to_wall = "X-33.\nX-32.\nX-31.\n";
  const std::string further = "X-30.\nX-29.\nX-28.\nX-27.\n";
  const std::string begin = "G00 X-100. Z-10.\nG05.1 Q1\nG01 F3000 X-34.\n";
  struct Level {
    std::string main, sub;
    const char* place;
    bool is_called;
  };
  const Level kLevels[] = {{"M98 P2\n" + further, to_wall, "hit.nc:15:1", true},
                           {to_wall + "M98 P2\n", further, "hit.nc:8:1", false}};
  for (const Level& c : kLevels) {
    const RunOutput output = run_with("[machine.axes.X]\nservo_gain = 1.8\n",
                                      begin + c.main + "M30\nO2\n" + c.sub + "M99\n");
    EXPECT_EQ(output.exit_code, 4) << output.errors;
    EXPECT_NE(output.errors.find(c.place), std::string::npos) << output.errors;
    EXPECT_EQ(output.errors.find("called from O0001") != std::string::npos, c.is_called)
        << output.errors;
  }
}

/// Of a SINUMERIK, its subprogram beside it; the tool's length is in its frame.
RunOutput run_on_sinumerik(const std::string& sheet_end, const std::string& blocks,
                           const std::string& sub) {
  TemporaryFolder folder;
  cli::RunOptions options;
  folder.write("SUB.SPF", sub + "RET\n");
  options.programs = {folder.write("HIT.MPF", "T1 M6 D1\nG90 G54 G0 Z20.\n" + blocks + "M30\n")};
  options.setups = {folder.write("sheet.toml", kSheet), folder.write("more.toml", sheet_end)};
  options.control = "sinumerik-828d";
  return run_program(options);
}

// The same on a SINUMERIK.  The ball touches at X-33: of axes that follow at once in the block that
// passes there, to X-32.4; of axes that lag while the command is 1.667 mm ahead in that to X-31,
// whichever level the program has got to by then.  With G642 each block waits for its corner, and
// goes to the machine when the next one is read: it may be of another level.  What DISPLOF hides is
// told by the block that called it.
struct LateCase {
  const char* what;
  std::string main;  ///< from line 6 on
  std::string sub;
  std::string at_once;  ///< what is said
  std::string late;
};

void check_late_case(const LateCase& c, const std::string& mode, bool lags) {
  SCOPED_TRACE(std::string(c.what) + " " + mode + (lags ? " lagging" : " at once"));
  const RunOutput output =
      run_on_sinumerik(lags ? "[machine.axes.X]\nservo_gain = 1.8\n" : "",
                       "G0 X-100. Z-10.\n" + mode + "\nG1 F3000 X-34.\n" + c.main, c.sub);
  EXPECT_EQ(output.exit_code, 4) << output.errors;
  std::string said;  // the places alone
  std::istringstream lines(output.errors);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t name = std::min(line.find("HIT.MPF:"), line.find("SUB.SPF:"));
    if (name != std::string::npos) {
      const std::size_t kind = line.find(": ", name);
      said += line.substr(name, 9) +
              (line.find("error: ", kind) == kind + 2     ? " error"
               : line.find("note: in ", kind) == kind + 2 ? " in"
                                                          : " called") +
              "\n";
    }
  }
  // At rest behind each block nothing is late.
  EXPECT_EQ(said, lags && mode != "G60" ? c.late : c.at_once) << output.errors;
}

TEST(Collision, ThatIsFoundLateHasTheCallsOfItsBlockOnASinumerikToo) {
  const std::string to_wall = "X-33.4\nX-32.4\nX-31.\n";
  const std::string further = "X-30.\nX-29.\nX-28.\nX-27.\n";
  const std::string called = "HIT.MPF:6 called\n";
  const LateCase kLateCases[] = {
      {"in the call", "SUB\n" + further, to_wall, "SUB.SPF:2 error\n" + called,
       "SUB.SPF:3 error\n" + called},
      {"before the call", to_wall + "SUB\n", further, "HIT.MPF:7 error\n", "HIT.MPF:8 error\n"},
      {"behind the call", "SUB\n" + to_wall + further, "X-33.5\n", "HIT.MPF:8 error\n",
       "HIT.MPF:9 error\n"},
      {"between two calls", "SUB\n" + to_wall + "SUB\n", "X=IC(0.1)\n", "HIT.MPF:8 error\n",
       "HIT.MPF:9 error\n"},
      {"in a repeated call", "SUB P9\n", "X=IC(0.7)\n", "SUB.SPF:1 error\n" + called,
       "SUB.SPF:1 error\n" + called},
      {"before a hidden call", to_wall + "SUB\n", "PROC SUB DISPLOF\n" + further,
       "HIT.MPF:7 error\n", "HIT.MPF:8 error\n"},
      {"in a hidden call", "SUB\n" + further, "PROC SUB DISPLOF\n" + to_wall,
       "HIT.MPF:6 error\nSUB.SPF:3 in\n", "HIT.MPF:6 error\nSUB.SPF:4 in\n"}};
  for (const char* const mode : {"G64", "G642", "G60"}) {
    for (const LateCase& c : kLateCases) {
      check_late_case(c, mode, false);
      check_late_case(c, mode, true);
    }
  }
}

// The command of the last block ends at X-32.5 when the ball, 1.667 mm behind it, is not yet at the
// face; it gets there when the program is over.
TEST(Collision, OfWhatStillLagsWhenTheProgramHasEnded) {
  for (const auto& [end, exit_code] : {std::pair("X-33.1", 0), {"X-32.5", 4}}) {
    const RunOutput output =
        run_with("[machine.axes.X]\nservo_gain = 1.8\n",
                 "G00 X-100. Z-10.\nG01 F3000 X-60.\n" + std::string(end) + "\n");
    EXPECT_EQ(output.exit_code, exit_code) << output.errors;
  }
}

}  // namespace
}  // namespace g31::collision_run_test

// Bodies of the machine, on the bed or on an axis: runs that meet them, runs that do not, what the
// sheet may say of them, and where pictures show them.

#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tools/disk/disk.h"
#include "tools/picture/pictured_part.h"
#include "tools/session/prepare.h"
#include "tools/session/world.h"

namespace g31::machine_bodies_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

/// A block to measure with its top at Z0, and a post of 40 x 40 x 100 beside it.
constexpr const char* kBench = R"([start]
X = -100.0
Z = 400.0
[work_offsets.G54]
[tools.1]
length = 120.0
[tools.2]
length = 100.0
[machine]
stopping = "ideal"
[probe]
ball_diameter = 6.0
length = 120.0
tool = 1
stem_length = 50.0
[[probe.body]]
name = "transmitter"
length = 70.0
diameter = 40.0
[[tool]]
number = 2
kind = "mill"
length = 100.0
diameter = 16.0
[[tool.body]]
name = "chuck"
length = 60.0
diameter = 50.0
[[part]]
name = "block"
shape = "block"
[[part]]
name = "post"
shape = "block"
length = 40.0
width = 40.0
height = 100.0
at = [100.0, 0.0, 50.0]
)";

struct Bodies {
  std::string machine;  ///< further keys
  std::string mount;
};

RunOutput run_on(const Bodies& bodies, const std::string& blocks) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("hit.nc", "O1\nG90 G54\n" + blocks + "M30\n")};
  options.setups = {
      folder.write("sheet.toml", kBench + std::string("mount = \"") + bodies.mount + "\"\n"),
      folder.write("machine.toml", "[machine]\n" + bodies.machine)};
  return run_program(options);
}

struct Case {
  const char* what;
  Bodies bodies;
  std::string blocks;   ///< from line 3 on
  std::string message;  ///< of the collision; "" for none
  int axis = 0;         ///< whose place where it stopped is known
  double at = 0.0;      ///< of the machine
};

constexpr const char* kOnSlides = "table_side = \"XY\"\ntool_side = \"Z\"\n";
constexpr const char* kOnTurning = "table_side = \"CA\"\ntool_side = \"XYZ\"\n";

const Case kCases[] = {
    {"as a fixture: from the side",
     {"", "table"},
     "G43 H1 Z20.\nG1 X90. F1000\n",
     "hit.nc:4:1: error: stylus ball touches post [PRB401]",
     0,
     77.0},
    {"on the bed of a machine that moves the tool alone, the same",
     {"", "bed"},
     "G43 H1 Z20.\nG1 X90. F1000\n",
     "hit.nc:4:1: error: stylus ball touches post [PRB401]",
     0,
     77.0},
    {"with X, which the tool follows: never from the side of X",
     {"", "X"},
     "G43 H1 Z20.\nG1 X300. F1000\n",
     "",
     0,
     0.0},
    // The slide of Y rides on that of X; the tool stays at X0 Y0 of it.
    {"with Y, beside the tool: never",
     {"", "Y"},
     "Y500.\nG43 H1 Z20.\nG1 X90. F1000\n",
     "",
     0,
     0.0},
    {"with Z, which carries the tool", {"", "Z"}, "X100.\nG43 H1 Z20.\n", "", 0, 0.0},
    {"on the bed under a table that slides: the tool stays at X0 of the bed",
     {kOnSlides, "bed"},
     "G43 H1 Z20.\nG1 X300. F1000\n",
     "",
     0,
     0.0},
    {"the stem on a skip move",
     {"", "bed"},
     "Y30.\nG43 H1 Z5.\nX90.\nG31 Y0 F100\n",
     "hit.nc:6:1: error: stylus ball touches post [PRB401]",
     1,
     23.0},
    // The transmitter of radius 20 begins 50 above the ball, the post is 50 high.
    {"a body of the probe",
     {"", "bed"},
     "X62. Y-100.\nG43 H1 Z-5.\nG1 Y0 F1000\n",
     "hit.nc:5:1: error: transmitter touches post [PRB401]",
     1,
     -28.717797887081347},
    {"a body of the probe passes beside",
     {"", "bed"},
     "X59.9 Y-100.\nG43 H1 Z-5.\nG1 Y100. F1000\n",
     "",
     0,
     0.0},
    {"a tool of radius 8",
     {"", "bed"},
     "M6 T2\nG43 H2 Z20.\nG1 X90. F1000\n",
     "hit.nc:5:1: error: tool T2 touches post [PRB401]",
     0,
     72.0},
    {"its chuck of radius 25",
     {"", "bed"},
     "M6 T2\nZ100.\nG1 X90. F1000\n",
     "hit.nc:5:1: error: chuck touches post [PRB401]",
     0,
     55.0},
    {"on the bed while a table turns",
     {kOnTurning, "bed"},
     "C30.\nG43 H1 Z20.\nG1 X90. F1000\n",
     "hit.nc:5:1: error: stylus ball touches post [PRB401]",
     0,
     77.0},
    {"with A, while C turns the part alone",
     {kOnTurning, "A"},
     "C30.\nG43 H1 Z20.\nG1 X90. F1000\n",
     "hit.nc:5:1: error: stylus ball touches post [PRB401]",
     0,
     77.0},
    // The post is 40 wide along Y and reaches from -50 to 50 along Z: at A-90 the other way round.
    {"turned with A",
     {kOnTurning, "A"},
     "A-90. C30.\nY200.\nG43 H1 Z0\nX100.\nG1 Y0 F1000\n",
     "hit.nc:7:1: error: stylus ball touches post [PRB401]",
     1,
     53.0},
};

TEST(MachineBodies, AreMetWhereTheyAre) {
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.what);
    const RunOutput output = run_on(c.bodies, c.blocks);
    EXPECT_EQ(output.exit_code, c.message.empty() ? 0 : 4) << output.errors;
    if (!c.message.empty()) {
      EXPECT_NE(output.errors.find(c.message), std::string::npos) << output.errors;
      const auto& at = output.document.at("collision").at("at");
      EXPECT_NEAR(at.at(static_cast<std::size_t>(c.axis)).get<double>(), c.at, 3e-4);
    }
  }
}

/// Its ball is 50 mm before the first one along X, so the axes stand at 27 when it touches.
TEST(MachineBodies, AreMetByTheSecondProbeToo) {
  for (const char* const turned : {"C0.\n", "C30.\n"}) {
    SCOPED_TRACE(turned);
    const RunOutput output =
        run_on({std::string(kOnTurning) + "[probe]\ninput = 1\n[probe.second]\nat = [50.0, 0.0, "
                                          "0.0]\ninput = 2\n",
                "bed"},
               turned + std::string("G43 H1 Z20.\nG1 X90. F1000\n"));
    EXPECT_EQ(output.exit_code, 4) << output.errors;
    const auto& collision = output.document.at("collision");
    EXPECT_EQ(collision.at("what"), "second probe: stylus ball touches post");
    EXPECT_NEAR(collision.at("at").at(0).get<double>(), 100.0 - 20.0 - 3.0 - 50.0, 3e-4);
  }
}

/// On the bed under a table with C and A: in the frame of the part, A90 brings Y where Z was.
TEST(MachineBodies, AreShownWhereTheAxesHaveBroughtThem) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("still.nc", "O1\nM30\n")};
  options.setups = {folder.write("sheet.toml", kBench + std::string("mount = \"bed\"\n")),
                    folder.write("machine.toml", "[machine]\n" + std::string(kOnTurning))};
  disk::Disk disk;
  const auto prepared = session::prepare(options, disk);
  ASSERT_TRUE(prepared.ok());
  const setup::Job& job = prepared.value().job;
  const auto world = session::build_world(job, 0);
  ASSERT_TRUE(world.ok());
  AxisPositions q_M = AxisPositions::Zero();
  for (const double angle : {0.0, 90.0}) {
    SCOPED_TRACE(angle);
    q_M[3] = angle;
    const auto shown = picture::parts_of(world.value(), job, q_M);
    ASSERT_EQ(shown.size(), 2U);
    EXPECT_TRUE(shown[1].is_fixture);
    Point low = Point::Constant(1e9);
    Point high = Point::Constant(-1e9);
    for (const Point& p : shown[1].mesh_M->vertices) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    const bool is_turned = angle > 0.0;
    EXPECT_LT((low - (is_turned ? Point(80, -50, -20) : Point(80, -20, -50))).norm(), 1e-9);
    EXPECT_LT((high - (is_turned ? Point(120, 50, 20) : Point(120, 20, 50))).norm(), 1e-9);
  }
}

TEST(MachineBodies, OfAMountThatIsNotThereAreRefusedWithTheirPlace) {
  struct Wrong {
    Bodies bodies;
    const char* message;
  };
  const Wrong kWrong[] = {
      {{"", "B"}, "mount = \"B\""},
      {{"", "bett"}, "mount = \"bett\""},
      {{kOnTurning, "B"}, "part.mount is B, and the axes of the machine are XYZAC [SET156]"},
      {{"", "XY"}, "part.mount is XY, and the axes of the machine are XYZ [SET156]"},
      {{"", "bed\"\nfixture = false\non = \"G54"},
       "part.fixture is false, it should be true of what is on \"bed\" [SET105]"},
  };
  for (const Wrong& wrong : kWrong) {
    const RunOutput output = run_on(wrong.bodies, "");
    EXPECT_EQ(output.exit_code, 2) << output.errors;
    EXPECT_NE(output.errors.find(wrong.message), std::string::npos) << output.errors;
    EXPECT_NE(output.errors.find("sheet.toml:"), std::string::npos) << output.errors;
  }
}

}  // namespace
}  // namespace g31::machine_bodies_test

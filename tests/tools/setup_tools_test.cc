#include <gtest/gtest.h>

#include "tests/tools/setup_error_text.h"
#include "tools/setup/sheet_stack.h"
#include "tools/setup/varied_key.h"

namespace g31::setup::setup_tools_test {
namespace {

constexpr const char* kMill = "[[tool]]\nnumber = 5\nlength = 100.0\ndiameter = 16.0\n";

class SetupTools : public SetupErrorText {
 protected:
  SetupTools() { static_cast<void>(write("base.toml", "")); }

  [[nodiscard]] Job job(const std::vector<std::string>& sheets) const {
    const auto result = read(sheets);
    EXPECT_EQ(errors_of(result), "");
    return result ? result.value() : Job{};
  }
};

TEST_F(SetupTools, ToolsArriveWithTeethAndBodies) {
  const std::vector<probe::ToolSetup> tools = job({kEveryKey}).tools;
  ASSERT_EQ(tools.size(), 4U);
  EXPECT_EQ(tools[0].number, 7);
  EXPECT_EQ(tools[0].kind, probe::ToolKind::Probe);
  const probe::ToolSetup& mill = tools[1];
  EXPECT_EQ(mill.kind, probe::ToolKind::BullMill);
  EXPECT_EQ(mill.length_mm, 100.0);
  EXPECT_EQ(mill.diameter_mm, 16.0);
  EXPECT_EQ(mill.corner_radius_mm, 1.5);
  EXPECT_EQ(mill.cutting_length_mm, 30.0);
  EXPECT_EQ(mill.core_diameter_mm, 10.0);
  ASSERT_EQ(mill.teeth.size(), 2U);
  EXPECT_EQ(mill.teeth[0].angle_deg, 90.0);
  EXPECT_EQ(mill.teeth[0].radius_mm, 8.0);
  EXPECT_EQ(mill.teeth[0].length_mm, 100.0);
  EXPECT_EQ(mill.teeth[1].radius_mm, 7.99);
  EXPECT_EQ(mill.teeth[1].length_mm, 99.98);
  ASSERT_EQ(mill.bodies.size(), 2U);
  EXPECT_EQ(mill.bodies[0].name, "chuck");
  EXPECT_EQ(mill.bodies[0].z_bottom, 41.0) << "100 - 40 - 20, and its edge";
  EXPECT_EQ(mill.bodies[0].z_top, 79.0);
  EXPECT_EQ(mill.bodies[0].radius_bottom, 15.0);
  EXPECT_EQ(mill.bodies[0].radius_top, 24.0);
  EXPECT_EQ(mill.bodies[0].rounding, 1.0);
  EXPECT_EQ(mill.bodies[1].name, "holder");
  EXPECT_EQ(mill.bodies[1].z_bottom, 80.0);
  EXPECT_EQ(mill.bodies[1].z_top, 100.0) << "the gauge line";
  EXPECT_EQ(tools[2].kind, probe::ToolKind::Drill);
  EXPECT_EQ(tools[2].tip_angle_deg, 140.0);
  EXPECT_TRUE(tools[2].teeth.empty() && tools[2].bodies.empty());
  EXPECT_EQ(tools[3].insert.lengths_mm, (std::array<double, 3>{50.0, 80.0, -0.5}));
  EXPECT_EQ(tools[3].insert.tip_radius_mm, 0.4);
  EXPECT_EQ(tools[3].insert.edge_position, 2);
  EXPECT_EQ(tools[3].insert.angle_deg, 80.0);
  EXPECT_EQ(tools[3].insert.orientation_deg, 135.0);
  EXPECT_EQ(tools[3].insert.edge_length_mm, 12.0);
}

TEST_F(SetupTools, ToolProbesArrive) {
  const std::vector<probe::ToolProbeSetup> probes = job({kEveryKey}).tool_probes;
  ASSERT_EQ(probes.size(), 3U);
  const probe::ToolProbeSetup& disc = probes[0];
  EXPECT_EQ(disc.name, "setter");
  EXPECT_EQ(disc.shape, probe::ToolProbeShape::Disc);
  EXPECT_EQ(disc.size_mm, (std::array<double, 3>{20.0, 6.0, 0.0}));
  EXPECT_EQ(disc.p_M_at, Point(200.0, -30.0, -400.0));
  EXPECT_EQ(disc.rotate_deg, Point(0.0, 0.0, 45.0));
  EXPECT_EQ(disc.side, probe::ToolProbeSide::Table);
  EXPECT_EQ(disc.input, 3);
  EXPECT_EQ(disc.delay_s, 0.002);
  EXPECT_EQ(disc.repeatability_mm, 0.0005);
  EXPECT_EQ(disc.pre_travel_mm, 0.01);
  EXPECT_EQ(disc.deflection_limit_mm, 2.0);
  EXPECT_EQ(probes[1].name, "tool probe");
  EXPECT_EQ(probes[1].shape, probe::ToolProbeShape::Cube);
  EXPECT_EQ(probes[1].size_mm, (std::array<double, 3>{25.0, 25.0, 25.0}));
  EXPECT_EQ(probes[1].input, 2);
  EXPECT_EQ(probes[2].shape, probe::ToolProbeShape::Laser);
  EXPECT_EQ(probes[2].filter_s, 0.01);
}

TEST_F(SetupTools, SizesFollowTheShape) {
  struct Case {
    const char* sheet;
    std::array<double, 3> sizes;
  };
  for (const Case& c :
       {Case{"size = 10", {10.0, 10.0, 10.0}}, Case{"size = [10, 12.5, 3.0]", {10.0, 12.5, 3.0}},
        Case{"shape = \"laser\"\nsize = [150.0, 0.03]", {150.0, 0.03, 0.0}}}) {
    SCOPED_TRACE(c.sheet);
    const Job read = job({std::string("[[tool_probe]]\n") + c.sheet + "\n"});
    ASSERT_EQ(read.tool_probes.size(), 1U);
    EXPECT_EQ(read.tool_probes[0].size_mm, c.sizes);
    EXPECT_FALSE(read.probe) << "tools are measured without a touch probe";
  }
}

TEST_F(SetupTools, AMillWithACornerIsABullMill) {
  EXPECT_EQ(job({kMill}).tools.at(0).kind, probe::ToolKind::Mill);
  EXPECT_EQ(job({std::string(kMill) + "corner_radius = 2.0\n"}).tools.at(0).kind,
            probe::ToolKind::BullMill);
}

TEST_F(SetupTools, TheToolOfKindProbeIsTheProbe) {
  const Job read = job({"[probe]\n[[tool]]\nnumber = 3\nkind = \"probe\"\n"});
  EXPECT_EQ(read.probe->switching.tool, 3);
}

TEST_F(SetupTools, ALaterListOfToolsReplacesTeethAndBodiesToo) {
  const std::string first = std::string(kMill) + "[[tool.body]]\n[[tool.teeth]]\n";
  const Job read = job({first, "[[tool]]\nnumber = 8\nlength = 90.0\ndiameter = 10.0\n"});
  ASSERT_EQ(read.tools.size(), 1U);
  EXPECT_EQ(read.tools[0].number, 8);
  EXPECT_TRUE(read.tools[0].bodies.empty() && read.tools[0].teeth.empty());
}

TEST_F(SetupTools, StudiesVaryThem) {
  const std::string path = write("vary.toml", std::string(kMill) + "[[tool_probe]]\n");
  const auto stack = SheetStack::read(std::vector<std::string>{path}, "");
  ASSERT_TRUE(stack.ok());
  const auto override_of = [](const char* key, double value) {
    return Override{find_varied_key(key).value(), value, {}};
  };
  const std::vector<Override> overrides = {override_of("tool.5.length", 99.5),
                                           override_of("tool_probe.tool probe.at.Y", 7.0)};
  const auto varied = stack.value().job(overrides);
  ASSERT_TRUE(varied.ok());
  EXPECT_EQ(varied.value().tools.at(0).length_mm, 99.5);
  EXPECT_EQ(varied.value().tool_probes.at(0).p_M_at, Point(0.0, 7.0, 0.0));
  EXPECT_NE(find_varied_key("tool.body.length").error().find("of lists only"), std::string::npos);
}

const ErrorCase kOfTools[] = {
    {"no number", "[[tool]]\nlength = 1.0\ndiameter = 1.0\n",
     R"(sheet1.toml:1:1: error: a tool needs number [SET121]
    1 | [[tool]]
      | ^
      = for example: number = 5
)"},
    {"a mill without its diameter", "[[tool]]\nnumber = 5\nlength = 100.0\n",
     R"(sheet1.toml:1:1: error: a tool of kind mill needs diameter [SET121]
    1 | [[tool]]
      | ^
      = for example: diameter = 16.0
)"},
    {"a turning tool without its lengths", "[[tool]]\nnumber = 5\nkind = \"turning\"\n",
     R"(sheet1.toml:1:1: error: a tool of kind turning needs lengths [SET121]
    1 | [[tool]]
      | ^
      = for example: lengths = [50.0, 80.0, 0.0]
)"},
    {"a kind that is none", "[[tool]]\nnumber = 5\nkind = \"saw\"\n",
     R"(sheet1.toml:3:8: error: tool.kind is "saw", it should be "mill", "ball_mill", "bull_mill", "drill", "turning", "calibration" or "probe" [SET105]
    3 | kind = "saw"
      |        ^
)"},
    {"a number twice",
     "[[tool]]\nnumber = 5\nlength = 9.0\ndiameter = 1.0\n"
     "[[tool]]\nnumber = 5\nlength = 9.0\ndiameter = 1.0\n",
     R"(sheet1.toml:6:10: error: [[tool]] with number 5 is given twice in this sheet [SET108]
    6 | number = 5
      |          ^
)"},
    {"a key of another kind",
     "[[tool]]\nnumber = 5\nlength = 9.0\ndiameter = 1.0\ntip_radius = 0.4\n",
     R"(sheet1.toml:5:14: error: tool.tip_radius is not for a tool of kind mill [SET128]
    5 | tip_radius = 0.4
      |              ^
      = leave it out
)"},
    {"teeth of what does not turn",
     "[[tool]]\nnumber = 5\nkind = \"turning\"\nlengths = [1.0, 2.0, 3.0]\nteeth = [{ }]\n",
     R"(sheet1.toml:5:10: error: tool.teeth is not for a tool of kind turning [SET128]
    5 | teeth = [{ }]
      |          ^
      = leave it out
)"},
    {"a corner rounder than the mill",
     "[[tool]]\nnumber = 5\nlength = 9.0\ndiameter = 8.0\ncorner_radius = 4.5\n",
     R"(sheet1.toml:5:17: error: tool.corner_radius is 4.5, it should be half the diameter at most, 4 mm [SET105]
    5 | corner_radius = 4.5
      |                 ^
)"},
    {"a holder longer than its tool",
     "[[tool]]\nnumber = 5\nlength = 50.0\ndiameter = 8.0\n[[tool.body]]\n",
     R"(sheet1.toml:5:1: error: the height of the bodies of tool 5 is 50, it should be less than the length of the tool, 50 mm [SET105]
    5 | [[tool.body]]
      | ^
      = they end at the gauge line
)"},
    {"two tools that are the probe", "[probe]\ntool = 1\n[[tool]]\nnumber = 2\nkind = \"probe\"\n",
     R"(sheet1.toml:4:10: error: tool.number is 2, it should be 1, the tool that is the probe [SET105]
    4 | number = 2
      |          ^
      = one tool is the probe: probe.tool and the [[tool]] of kind probe have one number
)"},
    {"a probe that the sheet has not", "[[tool]]\nnumber = 2\nkind = \"probe\"\n",
     R"(sheet1.toml:2:10: error: a tool of kind probe needs [probe] [SET121]
    2 | number = 2
      |          ^
      = write a [probe], or leave this [[tool]] out
)"},
    {"an edge position that is none",
     "[[tool]]\nnumber = 5\nkind = \"turning\"\nlengths = [1, 2, 3]\nedge_position = 10\n",
     R"(sheet1.toml:5:17: error: tool.edge_position is 10, it should be 1 to 9 [SET105]
    5 | edge_position = 10
      |                 ^
)"},
    {"a tooth longer than its tool",
     "[[tool]]\nnumber = 5\nlength = 50.0\ndiameter = 8.0\nteeth = [{ }, { length = 50.1 }]\n",
     R"(sheet1.toml:5:26: error: tool 5 has length = 50, but its longest tooth is 50.1 mm [SET150]
    5 | teeth = [{ }, { length = 50.1 }]
      |                          ^
      = give the tool what its teeth reach, or correct the tooth
)"},
    {"teeth that are all narrower than their tool",
     "[[tool]]\nnumber = 5\nlength = 50.0\ndiameter = 8.0\n"
     "teeth = [{ radius = 3.9 }, { radius = 3.8 }]\n",
     R"(sheet1.toml:4:12: error: tool 5 has diameter = 8, but its widest tooth has a radius of 3.9 mm [SET150]
    4 | diameter = 8.0
      |            ^
      = give the tool what its teeth reach, or correct the tooth
)"},
    {"edges as high as the tool",
     "[[tool]]\nnumber = 5\nlength = 50.0\ndiameter = 8.0\ncutting_length = 50.0\n",
     R"(sheet1.toml:5:18: error: tool.cutting_length is 50, it should be less than the length of the tool, 50 mm [SET105]
    5 | cutting_length = 50.0
      |                  ^
)"},
    {"a core as thick as the tool",
     "[[tool]]\nnumber = 5\nlength = 50.0\ndiameter = 8.0\ncore_diameter = 8.0\n",
     R"(sheet1.toml:5:17: error: tool.core_diameter is 8, it should be less than that of all teeth, 8 mm [SET105]
    5 | core_diameter = 8.0
      |                 ^
)"},
    {"a tip without an angle",
     "[[tool]]\nnumber = 5\nkind = \"drill\"\nlength = 9\ndiameter = 2\ntip_angle_deg = 0\n",
     R"(sheet1.toml:6:17: error: tool.tip_angle_deg is 0, it should be above 0 and 180 at most [SET105]
    6 | tip_angle_deg = 0
      |                 ^
)"},
};

TEST_F(SetupTools, WhatIsWrongWithATool) {
  for (const ErrorCase& c : kOfTools) {
    expect_text(c);
  }
}

TEST_F(SetupTools, AHundredTeethAreTheMost) {
  std::string teeth = "{ }";
  for (int i = 1; i < 100; ++i) {
    teeth += ", { }";
  }
  EXPECT_EQ(job({std::string(kMill) + "teeth = [" + teeth + "]\n"}).tools.at(0).teeth.size(), 100U);
  const auto refused = errors_of(read({std::string(kMill) + "teeth = [" + teeth + ", { }]\n"}));
  EXPECT_NE(refused.find("tool 5 has 101 teeth, more than 100 [SET129]"), std::string::npos)
      << refused;
}

const ErrorCase kOfToolProbes[] = {
    {"a shape that is none", "[[tool_probe]]\nshape = \"ball\"\n",
     R"(sheet1.toml:2:9: error: tool_probe.shape is "ball", it should be "cube", "disc" or "laser" [SET105]
    2 | shape = "ball"
      |         ^
)"},
    {"a disc without sizes", "[[tool_probe]]\nshape = \"disc\"\n",
     R"(sheet1.toml:1:1: error: a tool probe of this shape needs size [SET121]
    1 | [[tool_probe]]
      | ^
      = size is [diameter, thickness] of the disc
)"},
    {"a cube of two sizes", "[[tool_probe]]\nsize = [10.0, 20.0]\n",
     R"(sheet1.toml:2:8: error: tool_probe.size is [10, 20], it should be the edge of the cube or [x, y, z] [SET105]
    2 | size = [10.0, 20.0]
      |        ^
)"},
    {"a beam of one size", "[[tool_probe]]\nshape = \"laser\"\nsize = 10.0\n",
     R"(sheet1.toml:3:8: error: tool_probe.size is [10], it should be [length, diameter] of the beam [SET105]
    3 | size = 10.0
      |        ^
)"},
    {"a size that is none", "[[tool_probe]]\nsize = [10.0, 0.0, 20.0]\n",
     R"(sheet1.toml:2:8: error: tool_probe.size is [10, 0, 20], it should be greater than 0 [SET105]
    2 | size = [10.0, 0.0, 20.0]
      |        ^
)"},
    {"a disc as large as a shop", "[[tool_probe]]\nshape = \"disc\"\nsize = [1000000.0, 11.0]\n",
     R"(sheet1.toml:3:8: error: tool_probe.size is [1000000, 11], it should be 1000 mm of a disc across at most [SET105]
    3 | size = [1000000.0, 11.0]
      |        ^
)"},
    {"a side that is none", "[[tool_probe]]\nside = \"wall\"\n",
     R"(sheet1.toml:2:8: error: tool_probe.side is "wall", it should be "bed" or "table" [SET105]
    2 | side = "wall"
      |        ^
)"},
    {"a signal behind the breaking of the plate",
     "[[tool_probe]]\npre_travel_mm = 2.0\ndeflection_limit = 2.0\n",
     R"(sheet1.toml:2:17: error: tool_probe.pre_travel_mm is 2, it should be less than deflection_limit, 2 mm [SET105]
    2 | pre_travel_mm = 2.0
      |                 ^
)"},
    {"a beam that gives way",
     "[[tool_probe]]\nshape = \"laser\"\nsize = [50.0, 1.0]\npre_travel_mm = 0.1\n",
     R"(sheet1.toml:4:17: error: tool_probe.pre_travel_mm is not for a laser [SET151]
    4 | pre_travel_mm = 0.1
      |                 ^
      = leave it out
)"},
    {"a plate that sorts drips out", "[[tool_probe]]\nfilter_s = 0.01\n",
     R"(sheet1.toml:2:12: error: tool_probe.filter_s is not for a cube [SET151]
    2 | filter_s = 0.01
      |            ^
      = leave it out
)"},
    {"a name twice", "[[tool_probe]]\n[[tool_probe]]\n",
     R"(sheet1.toml:2:1: error: the tool probe "tool probe" is given twice in this sheet [SET108]
    2 | [[tool_probe]]
      | ^
      = give each a name of its own
)"},
    {"a slip of the pen", "[[tool_probe]]\ndelay = 0.1\n",
     R"(sheet1.toml:2:1: error: unknown key delay in [[tool_probe]], did you mean delay_s? [SET103]
    2 | delay = 0.1
      | ^
)"},
};

TEST_F(SetupTools, WhatIsWrongWithAToolProbe) {
  for (const ErrorCase& c : kOfToolProbes) {
    expect_text(c);
  }
}

}  // namespace
}  // namespace g31::setup::setup_tools_test

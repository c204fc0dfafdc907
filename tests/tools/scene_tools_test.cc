// Tools and what measures them, as scenes show them.

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "machine/units/point.h"
#include "tools/picture/stylus_shape.h"
#include "tools/picture/tip.h"
#include "tools/session/tool_sets.h"

namespace g31::scene_tools_test {
namespace {

struct Box {
  Point low = Point::Constant(1e9);
  Point high = Point::Constant(-1e9);
};

Box box_of(const parts::Mesh& mesh) {
  Box box;
  for (const Point& p : mesh.vertices) {
    box.low = box.low.cwiseMin(p);
    box.high = box.high.cwiseMax(p);
  }
  return box;
}

Box box_of(const std::vector<picture::StylusPiece>& pieces) {
  Box box;
  for (const picture::StylusPiece& piece : pieces) {
    const Box one = box_of(piece.mesh_S);
    box.low = box.low.cwiseMin(one.low);
    box.high = box.high.cwiseMax(one.high);
  }
  return box;
}

TEST(SceneTools, ABeamIsACylinderAboutTheMiddleOfItsLine) {
  probe::ToolProbeSetup laser;
  laser.name = "laser";
  laser.shape = probe::ToolProbeShape::Laser;
  laser.size_mm = {100.0, 2.0, 0.0};
  laser.p_M_at = {10.0, 20.0, -300.0};
  laser.rotate_deg = {0.0, 0.0, 90.0};
  const auto beams = session::beams_of({laser, {}});
  ASSERT_EQ(beams.size(), 1U) << "a cube is no beam";
  EXPECT_EQ(beams[0].name, "laser");
  const Box box = box_of(beams[0].mesh_M);
  // Turned by 90 degrees it lies along Y; facets stand off a cylinder by 50 nm.
  EXPECT_LT((box.low - Point(9.0, -30.0, -301.0)).cwiseAbs().maxCoeff(), 2e-3);
  EXPECT_LT((box.high - Point(11.0, 70.0, -299.0)).cwiseAbs().maxCoeff(), 2e-3);
}

Box drawn(const probe::ToolSetup& tool) {
  setup::Job job;
  job.tools = {tool};
  return box_of(picture::stylus_shape(job, tool.number));
}

TEST(SceneTools, AMillIsAsWideAndLongAsItIs) {
  probe::ToolSetup tool;
  tool.number = 3;
  tool.kind = probe::ToolKind::BallMill;
  tool.length_mm = 80.0;
  tool.diameter_mm = 20.0;
  const Box box = drawn(tool);
  EXPECT_NEAR(box.low.z(), 0.0, 1e-9) << "from its lowest point";
  EXPECT_NEAR(box.high.z(), 80.0, 1e-9);
  EXPECT_NEAR(box.high.x(), 10.0, 1e-9);
}

TEST(SceneTools, TeethAreDrawnAsTheWidestTakesUp) {
  probe::ToolSetup tool;
  tool.number = 3;
  tool.kind = probe::ToolKind::Mill;
  tool.length_mm = 60.0;
  tool.diameter_mm = 20.0;
  tool.teeth = {{0.0, 10.0, 60.0}, {180.0, 10.05, 60.0}};
  EXPECT_NEAR(drawn(tool).high.x(), 10.05, 1e-9);
}

TEST(SceneTools, AnInsertIsTheBallOfItsTipRadius) {
  probe::ToolSetup tool;
  tool.number = 5;
  tool.kind = probe::ToolKind::Turning;
  tool.insert = {{50.0, 90.0, 0.0}, 0.8, 3};
  // Its middle is a tip radius inwards from the tip: edge position 3 cuts towards -X and -Z.
  EXPECT_LT((picture::tip_of(tool) - Point(-49.2, 0.0, -89.2)).norm(), 1e-12);
  const Box box = drawn(tool);
  EXPECT_LT((box.low - Point(-0.8, -0.8, -0.8)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((box.high - Point(0.8, 0.8, 0.8)).cwiseAbs().maxCoeff(), 1e-9);
}

/// Its middle is 45 degrees from +Z to +X, as edge position 3 has it: its edges go along +Z and +X.
TEST(SceneTools, AnInsertHasItsEdges) {
  probe::ToolSetup tool;
  tool.number = 5;
  tool.kind = probe::ToolKind::Turning;
  tool.insert = {{50.0, 90.0, 0.0}, 0.8, 3};
  tool.insert.angle_deg = 90.0;
  tool.insert.edge_length_mm = 12.0;
  const Box box = drawn(tool);
  EXPECT_LT((box.low - Point(-0.8, -0.8, -0.8)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((box.high - Point(12.0, 0.8, 12.0)).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace g31::scene_tools_test

// Chips on the plate of a tool probe: which parts are some, and what they hand on.

#include "probe/sensor/chips.h"

#include <memory>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "parts/artefacts/artefact.h"
#include "parts/geometry/placement.h"
#include "probe/sensor/tool_probe.h"

namespace g31::probe::chips_test {
namespace {

ToolProbeSetup plate(ToolProbeShape shape = ToolProbeShape::Cube) {
  ToolProbeSetup setup;
  setup.shape = shape;
  setup.size_mm =
      shape == ToolProbeShape::Disc ? std::array{20.0, 6.0, 0.0} : std::array{20.0, 20.0, 20.0};
  setup.p_M_at = {200.0, 0.0, 0.0};
  return setup;
}

/// A block with the middle of its upper face there.
ProbedPart block(const Point& p_M_at, double length, double width, double height,
                 const Point& rotate_deg = Point::Zero()) {
  parts::PartSetup setup;
  setup.shape = "block";
  setup.sizes = {{"length", length}, {"width", width}, {"height", height}};
  const auto mesh = parts::make_artefact(setup);
  EXPECT_TRUE(mesh.ok());
  return {"chip", parts::placed_mesh(mesh.value(), {p_M_at, rotate_deg})};
}

TEST(Chips, LieOnThePlateWithAnyPieceOfTheirSurface) {
  const ToolProbeSetup cube = plate();
  EXPECT_TRUE(is_chip(block({203, 0, 0.75}, 2, 3, 0.75), cube)) << "all corners on it";
  EXPECT_TRUE(is_chip(block({200, 0, 0.75}, 60, 3, 0.75), cube)) << "all corners beside it";
  EXPECT_TRUE(is_chip(block({200, 0, 0.5}, 60, 60, 0.5), cube)) << "larger than the plate";
  EXPECT_TRUE(is_chip(block({211, 0, -5}, 2, 3, 3), cube)) << "at its side";
  EXPECT_FALSE(is_chip(block({211.1, 0, -5}, 2, 3, 3), cube)) << "0.1 mm beside it";
  EXPECT_FALSE(is_chip(block({200, 0, 0.9}, 60, 3, 0.8), cube)) << "0.1 mm above it";
  EXPECT_FALSE(is_chip(block({200, 0, -20}, 500, 500, 30), cube)) << "what it stands on";
  EXPECT_FALSE(is_chip(block({217, 17, 0.75}, 10, 10, 0.75, {0, 0, 45}), cube))
      << "past the corner";
  ProbedPart clamp = block({203, 0, 0.75}, 2, 3, 0.75);
  clamp.role = Role::Rigid;
  EXPECT_FALSE(is_chip(clamp, cube));
}

TEST(Chips, LieOnADiscWithinItsCircle) {
  const ToolProbeSetup disc = plate(ToolProbeShape::Disc);
  EXPECT_TRUE(is_chip(block({200, 0, 0.5}, 60, 60, 0.5), disc));
  EXPECT_TRUE(is_chip(block({200, 10.5, 0.5}, 60, 1.02, 0.5), disc));
  EXPECT_FALSE(is_chip(block({200, 10.7, 0.5}, 60, 1.0, 0.5), disc));
  EXPECT_FALSE(is_chip(block({209, 9, 0.5}, 1, 1, 0.5), disc)) << "within its square alone";
}

/// A mill of 10 mm and 100 mm over a plate that a long chip of 0.75 mm lies across.
class UnderAMill {
 public:
  explicit UnderAMill(double pre_travel_mm)
      : probe_(with(pre_travel_mm), rack(), 1, 0,
               {{CollisionMesh(block({200, 0, 0.75}, 60, 3, 0.75).mesh_M)}, std::nullopt}),
        machine_(machine::MachineSetup(), &probe_) {
    EXPECT_TRUE(machine_.move(to(200, 0, 150)).ok());
    machine_.change_tool({{5, 0.0, 0.0}, 1});
  }

  static machine::LinearMove to(double x, double y, double z) {
    machine::LinearMove move;
    move.q_M_end.head<3>() = Point(x, y, z);
    move.traverse = machine::Traverse::Feed;
    move.feed_mm_min = 100.0;
    return move;
  }
  double latched_z() {
    machine::SkipMove skip(to(200, 0, 95));
    skip.input = 2;
    const auto outcome = machine_.move_until_skip(skip);
    const auto* const touched =
        outcome.ok() ? std::get_if<machine::Touched>(&outcome.value()) : nullptr;
    return touched != nullptr ? touched->q_M_latched[2] : 0.0;
  }
  bool is_on() { return machine_.skip_signal(2); }
  bool rises() { return machine_.move(to(200, 0, 101)).ok(); }

 private:
  static ToolProbeSetup with(double pre_travel_mm) {
    ToolProbeSetup setup = plate();
    setup.pre_travel_mm = pre_travel_mm;
    return setup;
  }
  static std::shared_ptr<const ToolRack> rack() {
    ToolSetup mill;
    mill.number = 5;
    mill.length_mm = 100.0;
    mill.diameter_mm = 10.0;
    return std::make_shared<const ToolRack>(std::vector{mill}, std::nullopt,
                                            UnnamedTools::Believed);
  }

  ToolProbe probe_;
  machine::MachiningCentre machine_;
};

TEST(Chips, AreFeltGoingAndStanding) {
  for (const double pre_travel : {0.0, 0.02}) {
    UnderAMill bench(pre_travel);
    EXPECT_FALSE(bench.is_on());
    EXPECT_NEAR(bench.latched_z(), 100.75 - pre_travel, 1e-5);
    EXPECT_TRUE(bench.is_on()) << "the tool stands on the chip";
    EXPECT_TRUE(bench.rises());
    EXPECT_FALSE(bench.is_on());
  }
}

}  // namespace
}  // namespace g31::probe::chips_test

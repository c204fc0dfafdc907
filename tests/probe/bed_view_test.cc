// What stands on the bed while a table turns: the touch probe meets it where it is, not where the
// table would have brought it.

#include "probe/sensor/bed_view.h"

#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::bed_view_test {
namespace {

machine::MachineSetup with_table() {
  machine::MachineSetup setup;
  setup.chain.table_side = "C";
  setup.chain.tool_side = "XYZ";
  setup.axes[5].present = true;
  return setup;
}

/// A cube of 20 mm from X100 Y-10 Z-10 on; the ball of 6 mm hangs 120 mm below the gauge line.
std::unique_ptr<machine::Surroundings> plate_on_bed() {
  parts::Mesh mesh = testing::box_mesh({20, 20, 20});
  for (Point& p : mesh.vertices) {
    p += Point(100, -10, -10);
  }
  std::vector<ProbedPart> plates = {{"setter", mesh, Role::SensingTarget, Mount::Bed}};
  return std::make_unique<TouchProbe>(ProbeSetup(), plates, 1);
}

class Bench {
 public:
  Bench()
      : bed_(plate_on_bed(), machine::AxisChain(with_table().chain, Point::Zero())),
        machine_(with_table(), &bed_) {}

  /// "": it gets there.
  std::string go(double x, double y, double z, double c) {
    machine::LinearMove move;
    move.q_M_end.head<3>() = Point(x, y, z);
    move.q_M_end[5] = c;
    const auto outcome = machine_.move(move);
    stopped_ = outcome.ok() ? outcome.value() : outcome.error().q_M_at;
    return outcome.ok() ? "" : outcome.error().what;
  }
  [[nodiscard]] const AxisPositions& stopped() const { return stopped_; }

 private:
  BedObstacles bed_;
  machine::MachiningCentre machine_;
  AxisPositions stopped_ = AxisPositions::Zero();
};

TEST(BedView, TheProbeMeetsThePlateWhereverTheTableStands) {
  for (const double c : {0.0, 90.0, -37.5, 180.0}) {
    SCOPED_TRACE(c);
    Bench bench;
    ASSERT_EQ(bench.go(0, 0, 200, c), "");
    ASSERT_EQ(bench.go(0, 0, 120, c), "");
    EXPECT_EQ(bench.go(150, 0, 120, c), "stylus ball touches setter");
    EXPECT_NEAR(bench.stopped()[0], 97.0, 1e-6) << "the plate's side less the ball's radius";
  }
}

TEST(BedView, WhereTheTableWouldHaveBroughtThePlateIsNothing) {
  Bench bench;
  ASSERT_EQ(bench.go(0, 0, 200, 90), "");
  ASSERT_EQ(bench.go(0, 0, 120, 90), "");
  for (const auto& [x, y] : {std::pair(0, 150), std::pair(0, -150), std::pair(-150, 0)}) {
    EXPECT_EQ(bench.go(x, y, 120, 90), "");
    EXPECT_EQ(bench.go(0, 0, 120, 90), "");
  }
}

TEST(BedView, ATableThatTurnsAloneMovesNoTool) {
  Bench bench;
  ASSERT_EQ(bench.go(0, 0, 200, 0), "");
  ASSERT_EQ(bench.go(96, 0, 120, 0), "");
  EXPECT_EQ(bench.go(96, 0, 120, 720), "") << "1 mm beside the plate all the time";
}

}  // namespace
}  // namespace g31::probe::bed_view_test

// What stands on the bed while a table turns, and what axes carry: the touch probe meets it where
// it is, not where the table would have brought it.

#include "probe/sensor/carrier_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/effort.h"

namespace g31::probe::carrier_view_test {
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
      : bed_(plate_on_bed(),
             {{machine::AxisChain(with_table().chain, Point::Zero()), std::nullopt}}),
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
  CarriedObstacles bed_;
  machine::MachiningCentre machine_;
  AxisPositions stopped_ = AxisPositions::Zero();
};

TEST(CarrierView, TheProbeMeetsThePlateWhereverTheTableStands) {
  for (const double c : {0.0, 90.0, -37.5, 180.0}) {
    SCOPED_TRACE(c);
    Bench bench;
    ASSERT_EQ(bench.go(0, 0, 200, c), "");
    ASSERT_EQ(bench.go(0, 0, 120, c), "");
    EXPECT_EQ(bench.go(150, 0, 120, c), "stylus ball touches setter");
    EXPECT_NEAR(bench.stopped()[0], 97.0, 1e-6) << "the plate's side less the ball's radius";
  }
}

TEST(CarrierView, WhereTheTableWouldHaveBroughtThePlateIsNothing) {
  Bench bench;
  ASSERT_EQ(bench.go(0, 0, 200, 90), "");
  ASSERT_EQ(bench.go(0, 0, 120, 90), "");
  for (const auto& [x, y] : {std::pair(0, 150), std::pair(0, -150), std::pair(-150, 0)}) {
    EXPECT_EQ(bench.go(x, y, 120, 90), "");
    EXPECT_EQ(bench.go(0, 0, 120, 90), "");
  }
}

TEST(CarrierView, ATableThatTurnsAloneMovesNoTool) {
  Bench bench;
  ASSERT_EQ(bench.go(0, 0, 200, 0), "");
  ASSERT_EQ(bench.go(96, 0, 120, 0), "");
  EXPECT_EQ(bench.go(96, 0, 120, 720), "") << "1 mm beside the plate all the time";
}

/// A machine, a box of 40 mm on one of its links, and the ball of 6 mm; where all of it is by plain
/// matrices.
class LinkBench {
 public:
  LinkBench(const std::string& table, const std::string& tool, std::size_t link,
            const Point& p_M_box)
      : axes_(table + tool), link_(link), p_M_box_(p_M_box) {
    machine::MachineSetup setup;
    setup.q_M_start[2] = 300.0;
    setup.p_T_tip = Point(0, 0, -120);
    setup.chain.table_side = table;
    setup.chain.tool_side = tool;
    for (const char axis : axes_) {
      setup.axes.at(static_cast<std::size_t>(axis_index(axis))).present = true;
    }
    setup.chain.rotary[0].p_M_centre = Point(0, 10, -40);
    setup.chain.rotary[1].p_M_centre = Point(20, 0, -30);
    setup.chain.rotary[2].p_M_centre = Point(-15, 25, 0);
    lines_ = setup.chain.rotary;
    parts::Mesh mesh = testing::box_mesh({40, 40, 40});
    for (Point& p : mesh.vertices) {
      p += p_M_box;
    }
    const std::vector<ProbedPart> bodies = {{"column", mesh, Role::Rigid, Mount::Link, link}};
    obstacles_ = std::make_unique<CarriedObstacles>(
        std::make_unique<TouchProbe>(ProbeSetup(), bodies, 1),
        CarriedObstacles::Place{{machine::AxisChain(setup.chain, Point::Zero()), link}, 400.0});
    machine_ = std::make_unique<machine::MachiningCentre>(setup, obstacles_.get());
  }

  /// The ball's centre as the link sees it.
  [[nodiscard]] Point ball(const AxisPositions& q) const {
    // From the link to the tool, or back to it: whatever axes lie between.
    Eigen::Isometry3d link_from_tool = Eigen::Isometry3d::Identity();
    for (std::size_t i = link_; i < axes_.size(); ++i) {
      link_from_tool = link_from_tool * joint(axes_[i], q);
    }
    return link_from_tool * Point(0, 0, -120);
  }

  /// How far the ball's surface is from the box, mm; < 0 inside.
  [[nodiscard]] double distance(const AxisPositions& q) const {
    const Point p = ball(q) - p_M_box_;
    return (p - p.cwiseMax(0.0).cwiseMin(40.0)).norm() - 3.0;
  }

  /// Goes there in a straight line of the axes.  @returns where it was stopped by the box
  std::optional<AxisPositions> go(const AxisPositions& q) {
    machine::LinearMove move;
    move.q_M_end = q;
    const auto outcome = machine_->move(move);
    if (outcome.ok()) {
      return std::nullopt;
    }
    EXPECT_EQ(outcome.error().what, "stylus ball touches column");
    return outcome.error().q_M_at;
  }

 private:
  [[nodiscard]] Eigen::Isometry3d joint(char axis, const AxisPositions& q) const {
    const int index = axis_index(axis);
    Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
    if (index < 3) {
      motion.translation()[index] = q[index];
    } else {
      const machine::RotaryLine& line = lines_.at(static_cast<std::size_t>(index - 3));
      motion.translate(line.p_M_centre);
      motion.rotate(Eigen::AngleAxisd(q[index] * std::numbers::pi / 180.0, line.axis_M));
      motion.translate(-line.p_M_centre);
    }
    return motion;
  }

  std::string axes_;
  std::size_t link_;
  Point p_M_box_;
  std::array<machine::RotaryLine, 3> lines_;
  std::unique_ptr<CarriedObstacles> obstacles_;
  std::unique_ptr<machine::MachiningCentre> machine_;
};

struct LinkCase {
  const char* table;
  const char* tool;
  std::size_t link;
};

constexpr std::array kLinks = {
    LinkCase{"", "XYZ", 1},   LinkCase{"", "XYZ", 2},    LinkCase{"XY", "Z", 2},
    LinkCase{"XY", "Z", 1},   LinkCase{"CA", "XYZ", 2},  LinkCase{"CA", "XYZ", 1},
    LinkCase{"CA", "XYZ", 3}, LinkCase{"CAX", "YZ", 3},  LinkCase{"CAX", "YZ", 2},
    LinkCase{"", "XYZCB", 4}, LinkCase{"CB", "XYZA", 2}, LinkCase{"C", "XZ", 1},
};

/// Two thousand places of the way, and half of the last step that a sampled way may hide.
constexpr int kLinkSamples = 2000;
/// Twice what a straight piece may leave the way by.
constexpr double kLinkErrorMm = 4e-4;

AxisPositions position_by_chance(const std::string& axes, std::mt19937& random) {
  AxisPositions q = AxisPositions::Zero();
  for (const char axis : axes) {
    const int index = axis_index(axis);
    const double most = index < 3 ? 120.0 : 100.0;
    q[index] = std::uniform_real_distribution(-most, most)(random) + (index == 2 ? 120.0 : 0.0);
  }
  return q;
}

/// A way by chance and a box about its middle, more or less.  @returns whether it was stopped
bool try_way(const LinkCase& one, std::mt19937& random) {
  const std::string axes = std::string(one.table) + one.tool;
  const AxisPositions from = position_by_chance(axes, random);
  const AxisPositions to = position_by_chance(axes, random);
  Point p_box = LinkBench(one.table, one.tool, one.link, Point::Zero()).ball(0.5 * (from + to));
  for (int i = 0; i < 3; ++i) {
    p_box[i] += std::uniform_real_distribution(-50.0, 10.0)(random);
  }
  LinkBench bench(one.table, one.tool, one.link, p_box);
  if (bench.distance(from) < 1.0 || bench.go(from)) {
    return false;  // not to be tried from there
  }
  const auto stopped = bench.go(to);
  const AxisPositions end = stopped.value_or(to);
  double least = 1e9;
  for (int i = 0; i <= kLinkSamples; ++i) {
    least = std::min(least, bench.distance(from + i * (end - from) / kLinkSamples));
  }
  EXPECT_GT(least, -kLinkErrorMm) << "nothing is gone through before";
  if (stopped) {
    EXPECT_LT(std::abs(bench.distance(*stopped)), kLinkErrorMm) << "there it touches";
  }
  return stopped.has_value();
}

TEST(CarrierView, WaysByChanceEndWhereTheBallTouchesWhateverCarriesTheBody) {
  std::mt19937 random(18);
  for (const LinkCase& one : kLinks) {
    SCOPED_TRACE(fmt::format("{} | {}, link {}", one.table, one.tool, one.link));
    const int ways = std::max(testing::of_many(40), 10);  // of fewer, none may end early
    int stopped = 0;
    for (int i = 0; i < ways; ++i) {
      stopped += try_way(one, random) ? 1 : 0;
    }
    EXPECT_GE(stopped, ways / 8);
    EXPECT_LT(stopped, ways);
  }
}

TEST(CarrierView, ABodyOnTheLastSlideIsNeverMet) {
  LinkBench bench("", "XYZ", 3, Point(-20, -20, 100));
  EXPECT_FALSE(bench.go((AxisPositions() << 300, -200, 100, 0, 0, 0).finished()));
}

TEST(CarrierView, TouchesOfABlockInClosedForm) {
  // On the bed, while the table goes along X: the tool comes from above only.
  LinkBench on_bed("XY", "Z", 2, Point(-20, -20, 0));
  EXPECT_FALSE(on_bed.go((AxisPositions() << 0, 0, 300, 0, 0, 0).finished()));
  EXPECT_FALSE(on_bed.go((AxisPositions() << 500, 90, 300, 0, 0, 0).finished()));
  const auto above = on_bed.go((AxisPositions() << 500, 90, 100, 0, 0, 0).finished());
  ASSERT_TRUE(above);
  EXPECT_NEAR((*above)[2], 120.0 + 40.0 + 3.0, 1e-9);
  // With X: only Y and Z come nearer.
  LinkBench on_x("", "XYZ", 1, Point(-20, 50, 0));
  EXPECT_FALSE(on_x.go((AxisPositions() << 333, 0, 140, 0, 0, 0).finished()));
  const auto beside = on_x.go((AxisPositions() << 200, 80, 140, 0, 0, 0).finished());
  ASSERT_TRUE(beside);
  EXPECT_NEAR((*beside)[1], 50.0 - 3.0, 1e-9);
  EXPECT_NEAR((*beside)[0], 333.0 - 133.0 * 47.0 / 80.0, 1e-9);
  // With A of a table that carries C: turned by 90 degrees about X0 (Y10 Z-40), as a table turns.
  LinkBench on_a("CA", "XYZ", 1, Point(-20, 0, -200));
  EXPECT_FALSE(on_a.go((AxisPositions() << 0, 300, 300, 90, 0, 77).finished()));
  // The box reaches from -10 to 30 along Y of the axis and from -160 to -120 along Z of it; the
  // table at A90 turns by -90 degrees: its Z becomes Y, its -Y becomes Z.
  EXPECT_FALSE(on_a.go((AxisPositions() << 0, -130, 300, 90, 0, 77).finished()));
  const auto turned = on_a.go((AxisPositions() << 0, -130, 0, 90, 0, 77).finished());
  ASSERT_TRUE(turned);
  EXPECT_NEAR((*turned)[2], 120.0 - 40.0 + 10.0 + 3.0, 2e-4);
}

}  // namespace
}  // namespace g31::probe::carrier_view_test

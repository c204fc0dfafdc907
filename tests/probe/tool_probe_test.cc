// A tool probe in the machine: what is latched when tools of a known shape touch it.

#include "probe/sensor/tool_probe.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "machine/sim/machining_centre.h"
#include "tests/support/effort.h"

namespace g31::probe::tool_probe_test {
namespace {

using machine::Rotation;
using machine::Touched;

constexpr int kInput = 2;

ToolSetup tool(ToolKind kind, double length, double diameter) {
  ToolSetup setup;
  setup.number = 5;
  setup.kind = kind;
  setup.length_mm = length;
  setup.diameter_mm = diameter;
  return setup;
}

/// A machine with one tool probe and one tool, which is in the spindle.
class Bench {
 public:
  Bench(const ToolSetup& held, const ToolProbeSetup& setup)
      : probe_(setup,
               std::make_shared<const ToolRack>(std::vector<ToolSetup>{held}, std::nullopt,
                                                UnnamedTools::Believed),
               1, 0),
        machine_(machine::MachineSetup(), &probe_) {
    EXPECT_TRUE(go(0, 0, 250));
    machine_.change_tool({{held.number, 0.0, 0.0}, 1});
  }

  machine::MachiningCentre& machine() { return machine_; }

  bool go(double x, double y, double z) {
    machine::LinearMove move;
    move.q_M_end.head<3>() = Point(x, y, z);
    return machine_.move(move).ok();
  }

  /// What is latched on the way; nullopt: nothing.
  std::optional<Point> touch(const Point& end, double feed_mm_min) {
    machine::LinearMove move;
    move.q_M_end.head<3>() = end;
    move.traverse = machine::Traverse::Feed;
    move.feed_mm_min = feed_mm_min;
    machine::SkipMove skip(move);
    skip.input = kInput;
    const auto outcome = machine_.move_until_skip(skip);
    if (!outcome.ok()) {
      fault_ = outcome.error().what;
      return std::nullopt;
    }
    const auto* const touched = std::get_if<Touched>(&outcome.value());
    return touched != nullptr ? std::optional(linear_axes(touched->q_M_latched)) : std::nullopt;
  }

  [[nodiscard]] const std::string& fault() const { return fault_; }

 private:
  ToolProbe probe_;
  machine::MachiningCentre machine_;
  std::string fault_;
};

ToolProbeSetup cube(double size = 25.0) {
  ToolProbeSetup setup;
  setup.name = "setter";
  setup.size_mm = {size, size, size};
  setup.p_M_at = {200.0, 0.0, 0.0};
  return setup;
}

ToolProbeSetup disc(double diameter, double thickness) {
  ToolProbeSetup setup = cube();
  setup.shape = ToolProbeShape::Disc;
  setup.size_mm = {diameter, thickness, 0.0};
  return setup;
}

ToolProbeSetup laser(double diameter) {
  ToolProbeSetup setup = cube();
  setup.shape = ToolProbeShape::Laser;
  setup.size_mm = {300.0, diameter, 0.0};
  return setup;
}

TEST(ToolProbe, LengthsAndRadiiAreThoseOfTheTool) {
  Bench bench(tool(ToolKind::Mill, 103.4, 16.2), cube());
  ASSERT_TRUE(bench.go(200, 0, 110));
  const auto above = bench.touch({200, 0, 90}, 100);
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->z(), 103.4, 1e-12);
  ASSERT_TRUE(bench.go(200, 0, 120) && bench.go(240, 0, 120) && bench.go(240, 0, 98));
  const auto side = bench.touch({200, 0, 98}, 100);
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->x(), 200 + 12.5 + 8.1, 1e-12);
}

TEST(ToolProbe, ADiscIsRoundForTools) {
  Bench bench(tool(ToolKind::Mill, 100, 10), disc(20, 5));
  ASSERT_TRUE(bench.go(240, 6, 98));
  const auto side = bench.touch({200, 6, 98}, 100);
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->x(), 200 + std::sqrt(15.0 * 15.0 - 36.0), 1e-8);
}

TEST(ToolProbe, TheEndsOfToolsAreWhatTheirKindSays) {
  const double gone = 3.0;  // sideways, from the middle of a plate of 2 mm
  const auto height = [&](const ToolSetup& held) {
    Bench bench(held, disc(2, 5));
    EXPECT_TRUE(bench.go(200 + gone, 0, 130));
    const auto z = bench.touch({200 + gone, 0, 80}, 100);
    return z ? z->z() : 0.0;
  };
  EXPECT_NEAR(height(tool(ToolKind::Mill, 100, 16)), 100, 1e-9);
  // The plate's rim is 2 mm from the axis.
  EXPECT_NEAR(height(tool(ToolKind::BallMill, 100, 16)), 100 - (8 - std::sqrt(64 - 4.0)), 1e-8);
  EXPECT_NEAR(height(tool(ToolKind::Drill, 100, 16)),
              100 - 2 / std::tan(59 * std::numbers::pi / 180), 1e-8);
  ToolSetup bull = tool(ToolKind::BullMill, 100, 6);
  bull.corner_radius_mm = 2.0;
  EXPECT_NEAR(height(bull), 100 - (2 - std::sqrt(4 - 1.0)), 1e-8);
}

TEST(ToolProbe, AStandingToolTouchesWithTheToothThatFacesThePlate) {
  ToolSetup mill = tool(ToolKind::Mill, 100, 20);
  mill.teeth = {{0.0, 10.0, 100.0}, {120.0, 9.9, 100.0}, {240.0, 9.8, 100.0}};
  Bench bench(mill, cube());
  ASSERT_TRUE(bench.go(160, 0, 98));
  for (const auto& [angle, radius] : {std::pair(0.0, 10.0), {-120.0, 9.9}, {120.0, 9.8}}) {
    bench.machine().turn_spindle({Rotation::Stopped, 0.0, angle, 1});
    const auto side = bench.touch({190, 0, 98}, 100);
    ASSERT_TRUE(side);
    EXPECT_NEAR(side->x(), 187.5 - radius, 1e-9) << angle;
    ASSERT_TRUE(bench.go(160, 0, 98));
  }
}

/// How far an axis has come that gathers speed from standstill.
double gone_after(double t, double speed_mm_s) {
  const double acceleration = machine::AxisSetup().acceleration_per_s2;
  const double ramp_s = speed_mm_s / acceleration;
  return t < ramp_s ? 0.5 * acceleration * t * t : speed_mm_s * (t - 0.5 * ramp_s);
}

/// Brute force: the teeth turn and advance in steps of a microsecond.
double first_tooth_by_steps(const ToolSetup& mill, double rate_deg_s, double angle_deg,
                            double speed_mm_s, double gap_mm) {
  double outline = 0.0;
  for (const Tooth& tooth : mill.teeth) {
    outline = std::max(outline, tooth.radius_mm);
  }
  constexpr double kStep_s = 1e-6;
  for (double t = (gap_mm - outline) / speed_mm_s;; t += kStep_s) {
    for (const Tooth& tooth : mill.teeth) {
      const double angle = (angle_deg + tooth.angle_deg + rate_deg_s * t) * std::numbers::pi / 180;
      const double gone = gone_after(t, speed_mm_s);
      if (gone + tooth.radius_mm * std::cos(angle) >= gap_mm) {
        return gone;
      }
    }
  }
}

TEST(ToolProbe, ATurningToolTouchesWhenAToothComes) {
  for (int i = 0; i < testing::of_many(40); ++i) {
    const auto draw = [&](std::uint32_t what) {
      return uniform({3, what}, static_cast<std::uint64_t>(i));
    };
    ToolSetup mill = tool(ToolKind::Mill, 100, 20);
    const int count = i % 4 == 3 ? 60 : 1 + static_cast<int>(draw(1) * 6);
    for (int k = 0; k < count; ++k) {
      mill.teeth.push_back(
          {k * 360.0 / count, 10.0 - 0.02 * draw(10 + static_cast<std::uint32_t>(k)), 100.0});
    }
    const double rev_min = 100 + 2900 * draw(2);
    const double feed = 20 + 300 * draw(3);
    Bench bench(mill, cube());
    ASSERT_TRUE(bench.go(170, 0, 98));
    const bool clockwise = draw(4) < 0.5;
    bench.machine().turn_spindle(
        {clockwise ? Rotation::Clockwise : Rotation::Counterclockwise, rev_min, std::nullopt, 1});
    const auto side = bench.touch({195, 0, 98}, feed);
    ASSERT_TRUE(side);
    const double rate = (clockwise ? -6.0 : 6.0) * rev_min;
    const double gone = first_tooth_by_steps(mill, rate, 0.0, feed / 60, 17.5);
    EXPECT_NEAR(side->x(), 170 + gone, 2e-5)
        << i;  // what a step of the brute force is worth, and more
    // Never before the longest tooth could touch, and no later than the next time that it comes.
    EXPECT_LE(side->x(), 187.5 - 9.98 + feed / rev_min);
  }
}

TEST(ToolProbe, TheLongestToothIsFeltFromAboveWhenItComesOverThePlate) {
  ToolSetup mill = tool(ToolKind::Mill, 100, 40);
  mill.teeth = {{0.0, 20.0, 98.0}, {180.0, 20.0, 100.0}};
  Bench bench(mill, cube(10.0));
  ASSERT_TRUE(bench.go(220, 0, 110));  // the plate is on the side of -X
  const auto standing = bench.touch({220, 0, 95}, 100);
  ASSERT_TRUE(standing);
  EXPECT_NEAR(standing->z(), 100.0, 1e-9);
  ASSERT_TRUE(bench.go(220, 0, 110));
  bench.machine().turn_spindle({Rotation::Stopped, 0.0, 180.0, 1});
  const auto turned = bench.touch({220, 0, 95}, 100);
  ASSERT_TRUE(turned);
  EXPECT_NEAR(turned->z(), 98.0, 1e-9);
  ASSERT_TRUE(bench.go(220, 0, 110));
  bench.machine().turn_spindle({Rotation::Clockwise, 500.0, std::nullopt, 1});
  const auto turning = bench.touch({220, 0, 95}, 50);
  ASSERT_TRUE(turning);
  EXPECT_LE(turning->z(), 100.0);
  EXPECT_GE(turning->z(), 100.0 - 50.0 / 500.0);
}

TEST(ToolProbe, ABeamIsBrokenAndFreeAgain) {
  Bench bench(tool(ToolKind::Mill, 100, 10), laser(0.5));
  ASSERT_TRUE(bench.go(200, -20, 98));
  const auto broken = bench.touch({200, 20, 98}, 100);
  ASSERT_TRUE(broken);
  EXPECT_NEAR(broken->y(), -5.25, 1e-8);
  ASSERT_TRUE(bench.go(200, 0, 98));  // no obstacle
  machine::LinearMove move;
  move.q_M_end.head<3>() = Point(200, 20, 98);
  move.traverse = machine::Traverse::Feed;
  move.feed_mm_min = 100;
  machine::SkipMove skip(move);
  skip.input = kInput;
  skip.edge = machine::SignalEdge::Falling;
  const auto free = bench.machine().move_until_skip(skip);
  ASSERT_TRUE(free.ok());
  const auto* const touched = std::get_if<Touched>(&free.value());
  ASSERT_NE(touched, nullptr);
  EXPECT_NEAR(touched->q_M_latched[1], 5.25, 1e-7);
}

TEST(ToolProbe, AHolderBreaksABeamAsTheToolDoes) {
  ToolSetup mill = tool(ToolKind::Mill, 100, 10);
  ProbeSection chuck;  // 50 mm high, 40 mm thick, from 50 mm above the lowest point on
  chuck.z_bottom = 50.0;
  chuck.z_top = 100.0;
  chuck.radius_bottom = chuck.radius_top = 20.0;
  mill.bodies = {chuck};
  Bench bench(mill, laser(0.5));
  ASSERT_TRUE(bench.go(200, -60, 40));
  const auto broken = bench.touch({200, 60, 40}, 100);
  ASSERT_TRUE(broken);
  EXPECT_NEAR(broken->y(), -20.25, 1e-8) << "the chuck's radius and the beam's";
  EXPECT_TRUE(bench.machine().skip_signal(kInput));
  ASSERT_TRUE(bench.go(200, -60, 40) && bench.go(200, -60, 60));
  const auto shank = bench.touch({200, 60, 60}, 100);
  ASSERT_TRUE(shank);
  EXPECT_NEAR(shank->y(), -5.25, 1e-8) << "the beam is below the chuck";
}

TEST(ToolProbe, APlateGivesWayAndBreaks) {
  ToolProbeSetup setup = cube();
  setup.pre_travel_mm = 0.01;
  setup.deflection_limit_mm = 2.0;
  Bench bench(tool(ToolKind::Mill, 100, 10), setup);
  ASSERT_TRUE(bench.go(200, 0, 101));
  const auto above = bench.touch({200, 0, 95}, 100);
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->z(), 99.99, 1e-12);
  ASSERT_TRUE(bench.go(200, 0, 101));
  EXPECT_FALSE(bench.go(200, 0, 99));  // a rapid into it
}

TEST(ToolProbe, AnotherInputHearsNothingAndTheToolIsPushedIn) {
  Bench bench(tool(ToolKind::Mill, 100, 10), cube());
  ASSERT_TRUE(bench.go(200, 0, 101));
  machine::LinearMove move;
  move.q_M_end.head<3>() = Point(200, 0, 90);
  move.traverse = machine::Traverse::Feed;
  move.feed_mm_min = 100;
  machine::SkipMove skip(move);
  skip.input = 1;
  const auto outcome = bench.machine().move_until_skip(skip);
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error().what, "tool T5 is pushed 5.000 mm into setter, its deflection limit");
  EXPECT_NEAR(outcome.error().q_M_at[2], 95.0, 1e-9);
}

TEST(ToolProbe, ACornerIsPassedByAsRoundToolsPassIt) {
  Bench bench(tool(ToolKind::Mill, 100, 16), cube());
  // 7 mm beside both faces of the corner: 9.9 mm from it.
  ASSERT_TRUE(bench.go(260, 60, 97) && bench.go(219.5, 19.5, 97));
  EXPECT_FALSE(bench.machine().skip_signal(kInput));
  ASSERT_TRUE(bench.go(219.5, 30, 97) && bench.go(219.5, 19.5, 97));
  const auto corner = bench.touch({200, 0, 97}, 100);
  ASSERT_TRUE(corner);
  EXPECT_NEAR(corner->x(), 212.5 + 8 / std::sqrt(2.0), 1e-8);
  EXPECT_TRUE(bench.machine().skip_signal(kInput));
  EXPECT_TRUE(bench.go(260, 60, 97));
}

/// Brute force from above: the teeth turn and go down in small steps; of each edge many points.
double first_depth_by_steps(const ToolSetup& mill, double rate_deg_s, double speed_mm_s,
                            double start_mm, const Point& p_axis, double half) {
  std::vector<std::vector<Blade::Radial>> edges;
  for (const Tooth& tooth : mill.teeth) {
    auto& edge = edges.emplace_back();
    const Blade blade = blade_of(tooth, mill);
    const Blade::Radial lowest = blade.rounded_centre - Blade::Radial(0, blade.rounded_radius);
    for (int k = 0; k <= 600; ++k) {
      const double share = k / 600.0;
      const double out = share * std::numbers::pi / 2;
      edge.emplace_back(blade.rounded_centre +
                        blade.rounded_radius * Blade::Radial(std::sin(out), -std::cos(out)));
      edge.emplace_back(share * blade.corners[0] + (1 - share) * lowest);
    }
  }
  constexpr double kStep_s = 2e-5;
  for (double t = 0.0; speed_mm_s * t < 5.0; t += kStep_s) {
    const double z = start_mm - gone_after(t, speed_mm_s);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const double angle = (mill.teeth[i].angle_deg + rate_deg_s * t) * std::numbers::pi / 180;
      for (const Blade::Radial& point : edges[i]) {
        if (z + point.y() <= 0.0 && std::abs(p_axis.x() + point.x() * std::cos(angle)) <= half &&
            std::abs(p_axis.y() + point.x() * std::sin(angle)) <= half) {
          return z;
        }
      }
    }
  }
  return -1.0;
}

TEST(ToolProbe, ATurningToolOfAnyKindTouchesFromAbove) {
  struct Case {
    ToolKind kind;
    double diameter;
    double corner;
    Point p_axis;
    double plate;
  };
  const Case cases[] = {
      {ToolKind::BallMill, 16, 0, {0, 0, 0}, 10}, {ToolKind::Drill, 12, 0, {1, 0, 0}, 10},
      {ToolKind::BullMill, 16, 2, {1, 2, 0}, 20}, {ToolKind::Mill, 63, 0, {0, 0, 0}, 25},
      {ToolKind::Mill, 20, 0, {9, 0, 0}, 10},     {ToolKind::BullMill, 20, 3, {8, 1, 0}, 10},
  };
  for (const Case& one : cases) {
    ToolSetup mill = tool(one.kind, 100, one.diameter);
    mill.corner_radius_mm = one.corner;
    mill.teeth = {{0.0, one.diameter / 2, 100.0}, {170.0, one.diameter / 2, 99.995}};
    Bench bench(mill, cube(one.plate));
    const Point above = Point(200, 0, 0) + one.p_axis;
    ASSERT_TRUE(bench.go(above.x(), above.y(), 100.3));
    bench.machine().turn_spindle({Rotation::Counterclockwise, 300.0, std::nullopt, 1});
    const auto touched = bench.touch({above.x(), above.y(), 97}, 60);
    ASSERT_TRUE(touched) << bench.fault();
    const double wanted =
        first_depth_by_steps(mill, 300.0 * 6.0, 1.0, 100.3, one.p_axis, one.plate / 2);
    EXPECT_NEAR(touched->z(), wanted, 2e-3) << static_cast<int>(one.kind) << ' ' << one.diameter;
  }
}

TEST(ToolProbe, ADrillWithTeethTurnsOnItsTip) {
  ToolSetup drill = tool(ToolKind::Drill, 100, 16);
  drill.teeth = {{0.0, 8.0, 100.0}, {180.0, 8.0, 100.0}};
  Bench bench(drill, cube());
  bench.machine().turn_spindle({Rotation::Clockwise, 1000.0, std::nullopt, 1});
  ASSERT_TRUE(bench.go(200, 0, 110));
  const auto tip = bench.touch({200, 0, 95}, 100);
  ASSERT_TRUE(tip) << bench.fault();
  EXPECT_NEAR(tip->z(), 100.0, 1e-9);
}

/// Two teeth, which stand across what they are to touch: their core of 10 mm touches in their
/// place.
TEST(ToolProbe, BetweenTheTeethIsTheCore) {
  ToolSetup mill = tool(ToolKind::Mill, 100, 16);
  mill.teeth = {{90.0, 8.0, 100.0}, {270.0, 8.0, 100.0}};
  mill.core_diameter_mm = 10.0;
  Bench beside(mill, cube());
  ASSERT_TRUE(beside.go(250, 0, 110) && beside.go(250, 0, 90));
  const auto side = beside.touch({200, 0, 90}, 100);
  ASSERT_TRUE(side) << beside.fault();
  EXPECT_NEAR(side->x(), 212.5 + 5.0, 1e-9);
  // Its teeth 3 mm beside the plate, it reaches over it; it ends above their lower edges.
  Bench above(mill, cube());
  ASSERT_TRUE(above.go(215.5, 0, 110));
  const auto top = above.touch({215.5, 0, 95}, 100);
  ASSERT_TRUE(top) << above.fault();
  EXPECT_NEAR(top->z(), 100.0 - 8.0 * std::tan(2.0 * std::numbers::pi / 180.0), 1e-9);
  mill.core_diameter_mm = 0.0;
  Bench without(mill, cube());
  ASSERT_TRUE(without.go(215.5, 0, 110));
  EXPECT_FALSE(without.touch({215.5, 0, 95}, 100));
}

TEST(ToolProbe, ATouchMayBeginLessDeepThanTheSignalNeeds) {
  ToolProbeSetup setup = cube();
  setup.pre_travel_mm = 0.01;
  Bench bench(tool(ToolKind::Mill, 100, 10), setup);
  ASSERT_TRUE(bench.go(200, 0, 101));
  ASSERT_TRUE(bench.touch({200, 0, 95}, 100));
  ASSERT_TRUE(bench.go(200, 0, 99.995));
  EXPECT_FALSE(bench.machine().skip_signal(kInput));
  const auto again = bench.touch({200, 0, 95}, 100);
  ASSERT_TRUE(again) << bench.fault();
  EXPECT_NEAR(again->z(), 99.99, 1e-9);
}

TEST(ToolProbe, WhatGoesThroughThePlateUnheardBreaksIt) {
  ToolProbeSetup setup = cube(10.0);
  setup.input = 3;
  Bench across(tool(ToolKind::Mill, 100, 6), setup);
  ASSERT_TRUE(across.go(160, 0, 97));
  EXPECT_FALSE(across.touch({240, 0, 97}, 100));
  EXPECT_NE(across.fault().find("5.000 mm into setter"), std::string::npos) << across.fault();
  Bench down(tool(ToolKind::BallMill, 100, 16), setup);
  ASSERT_TRUE(down.go(200, 0, 101));
  EXPECT_FALSE(down.touch({200, 0, 80}, 100));
  EXPECT_NE(down.fault().find("5.000 mm into setter"), std::string::npos) << down.fault();
}

TEST(ToolProbe, WhatIsBelowThePlateTouchesItOnlyFromBelow) {
  ToolSetup insert = tool(ToolKind::Turning, 0, 0);
  insert.insert = {{0.0, 0.0, 0.0}, 0.4, 1};  // cuts towards +X and +Z
  Bench bench(insert, cube());
  ASSERT_TRUE(bench.go(100, 0, -50) && bench.go(200, 0, -50));
  EXPECT_FALSE(bench.machine().skip_signal(kInput));
  const auto below = bench.touch({200, 0, -10}, 100);
  ASSERT_TRUE(below);
  EXPECT_NEAR(below->z(), -25.0, 1e-9);
  EXPECT_TRUE(bench.machine().skip_signal(kInput));
  EXPECT_TRUE(bench.go(200, 0, -50));
}

TEST(ToolProbe, AnInsertTouchesWithItsRadiusAsItsEdgePositionSays) {
  ToolSetup insert = tool(ToolKind::Turning, 0, 0);
  insert.insert = {{50.0, 80.0, 0.0}, 0.4, 3};
  Bench bench(insert, cube());
  // The theoretical tip is at X - 50, Z - 80; position 3 cuts towards -X and -Z.
  ASSERT_TRUE(bench.go(250, 0, 100));
  const auto along_z = bench.touch({250, 0, 70}, 100);
  ASSERT_TRUE(along_z);
  EXPECT_NEAR(along_z->z(), 80.0, 1e-9);
  ASSERT_TRUE(bench.go(250, 0, 100) && bench.go(280, 0, 100) && bench.go(280, 0, 70));
  const auto along_x = bench.touch({250, 0, 70}, 100);
  ASSERT_TRUE(along_x);
  EXPECT_NEAR(along_x->x(), 212.5 + 50.0, 1e-9);
}

/// The tip is 5 mm below the top when an edge that leans over by 30 degrees meets the corner there.
TEST(ToolProbe, AnInsertTouchesWithItsEdges) {
  const double r = 0.4;
  ToolSetup insert = tool(ToolKind::Turning, 0, 0);
  insert.insert = {{50.0, 80.0, 0.0}, r, 3};
  insert.insert.angle_deg = 60.0;
  const auto touched_at_x = [&]() {
    Bench bench(insert, cube());
    EXPECT_TRUE(bench.go(300, 0, 100) && bench.go(300, 0, 75));
    const auto there = bench.touch({250, 0, 75}, 100);
    return there ? there->x() : 0.0;
  };
  const double tip = 212.5 + 50.0;
  EXPECT_NEAR(touched_at_x(), tip, 1e-9) << "the edges lie behind the tip";
  insert.insert.orientation_deg = 0.0;
  const double lean = std::numbers::pi / 6;
  const double over = r * std::cos(lean) + std::tan(lean) * (5.0 - r + r * std::sin(lean)) - r;
  EXPECT_NEAR(touched_at_x(), tip + over, 1e-7);
  insert.insert.edge_length_mm = 3.0;  // ends below the corner: its end meets the side
  EXPECT_NEAR(touched_at_x(), tip + r * std::cos(lean) + 3.0 * std::sin(lean) - r, 1e-7);
}

TEST(ToolProbe, ASideMillTouchesWithItsRearSide) {
  ToolSetup side = tool(ToolKind::Mill, 100, 40);
  side.cutting_length_mm = 6.0;
  for (const bool has_teeth : {false, true}) {
    SCOPED_TRACE(has_teeth);
    if (has_teeth) {
      side.teeth = {{0.0, 20.0, 100.0}, {180.0, 20.0, 100.0}};
    }
    Bench bench(side, cube());
    // Its axis 15 mm beside the plate, its edges 5 mm below it.
    ASSERT_TRUE(bench.go(300, 0, 100) && bench.go(300, 0, 64) && bench.go(227.5, 0, 64));
    const auto below = bench.touch({227.5, 0, 80}, 100);
    ASSERT_TRUE(below);
    EXPECT_NEAR(below->z(), -25.0 + 94.0, 1e-9);
  }
}

}  // namespace
}  // namespace g31::probe::tool_probe_test

// A ball that meets a second surface while the first one deflects it.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::pressed_surfaces_test {
namespace {

using testing::at;

/// A ball of 3 mm radius, its centre at the linear axes.
ProbeSetup ball_at_the_axes() {
  ProbeSetup setup;
  setup.length_mm = 0.0;
  return setup;
}

ProbeSetup mono_probe() {
  ProbeSetup setup = ball_at_the_axes();
  setup.at_switch.type = ProbeType::Mono;  // towards +X
  return setup;
}

/// Of several boxes in one mesh.
parts::Mesh together(const std::vector<parts::Mesh>& meshes) {
  parts::Mesh all;
  for (const parts::Mesh& mesh : meshes) {
    const auto count = static_cast<std::uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& triangle : mesh.triangles) {
      all.triangles.push_back({triangle[0] + count, triangle[1] + count, triangle[2] + count});
    }
  }
  return all;
}

/// From the origin the ball meets a side at Y 0.5 and a wall at X 15.
const parts::Mesh kSide = testing::moved_by(testing::box_mesh({100, 20, 20}), {-50, 3.5, -10});
const parts::Mesh kWall = testing::moved_by(testing::box_mesh({10, 100, 20}), {18, -50, -10});

std::vector<std::vector<ProbedPart>> corners() {
  return {{{"side", kSide}, {"wall", kWall}}, {{"wall", together({kSide, kWall})}}};
}

/// The ball comes to the side after half of this way, to the wall after three quarters.
const machine::Sweep kIntoTheCorner{at({0, 0, 0}), at({20, 1, 0})};

/// X of the signal; nullopt without one.
std::optional<double> signal_x(TouchProbe& probe, const std::vector<machine::Waypoint>& way) {
  const auto trigger = testing::touch_along(probe, way);
  if (!trigger) {
    return std::nullopt;
  }
  const Point from = linear_axes(way.front().q_M);
  const Point to = linear_axes(way.back().q_M);
  EXPECT_FALSE(trigger->on_at_start);
  return from.x() + trigger->fraction * (to.x() - from.x());
}

/// A straight way in so many pieces.
std::vector<machine::Waypoint> in_pieces(const machine::Sweep& sweep, int count) {
  std::vector<machine::Waypoint> way;
  for (int i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    way.push_back({share, sweep.q_M_from + share * (sweep.q_M_to - sweep.q_M_from)});
  }
  return way;
}

TEST(PressedSurfaces, TheEarliestSignalCountsInOnePieceAndInMany) {
  struct Case {
    const char* name;
    double pre_travel;
    double x;
    const char* touched;
  };
  // A twentieth of the way goes into the side, all of it along X into the wall.
  const Case kCases[] = {
      {"the side signals at once", 0.0, 10.0, "side"},
      {"before the wall is met", 0.2, 10.0 + 0.2 * 20.0, "side"},
      {"just before the wall signals", 0.26, 10.0 + 0.26 * 20.0, "side"},
      {"the wall is earlier", 0.27, 15.0 + 0.27, "wall"},
      {"and earlier still", 0.4, 15.4, "wall"},
      {"without the wall nearly at the end", 0.48, 15.48, "wall"},
      {"without the wall behind the end", 0.7, 15.7, "wall"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    ProbeSetup setup = ball_at_the_axes();
    setup.at_switch.pre_travel_mm = c.pre_travel;
    for (const std::vector<ProbedPart>& parts : corners()) {
      TouchProbe probe(setup, parts, 0);
      for (const int pieces : {1, 7, 40, 333}) {
        SCOPED_TRACE(pieces);
        const auto x = signal_x(probe, in_pieces(kIntoTheCorner, pieces));
        ASSERT_TRUE(x.has_value());
        EXPECT_NEAR(*x, c.x, 1e-9);
      }
      const auto trigger = testing::touch_on(probe, kIntoTheCorner);
      const bool is_wall = std::string(c.touched) == "wall";
      EXPECT_EQ(trigger->contact->part, parts.size() == 1 ? "wall" : c.touched);
      EXPECT_NEAR((trigger->contact->n_M + (is_wall ? Point::UnitX() : Point::UnitY())).norm(), 0.0,
                  1e-14);
      // The ball slides along the side: there it meets the wall.
      const Point touched = is_wall ? Point(18, 0.5, 0) : Point(10, 3.5, 0);
      EXPECT_NEAR((trigger->contact->p_M_point - touched).norm(), 0.0, 1e-9);
    }
  }
}

TEST(PressedSurfaces, ASideThatCannotSwitchAMonoProbeDoesNotHideTheWall) {
  for (const std::vector<ProbedPart>& parts : corners()) {
    TouchProbe probe(mono_probe(), parts, 0);
    for (const int pieces : {1, 7, 40, 333}) {
      SCOPED_TRACE(pieces);
      const auto x = signal_x(probe, in_pieces(kIntoTheCorner, pieces));
      ASSERT_TRUE(x.has_value());
      EXPECT_NEAR(*x, 15.0, 1e-9);
    }
    // From a start that is pressed into the side, on along it, and away from it.
    for (const double y : {0.7, 0.0}) {
      const auto x = signal_x(probe, in_pieces({at({5, 0.7, 0}), at({17, y, 0})}, 1));
      ASSERT_TRUE(x.has_value());
      EXPECT_NEAR(*x, 15.0, 1e-9);
    }
    EXPECT_FALSE(testing::touch_on(probe, {at({5, 0.7, 0}), at({14.9, 0.9, 0})}).has_value());
    // In both of them from the start.
    EXPECT_TRUE(testing::touch_on(probe, {at({15.1, 0.7, 0}), at({17, 0.7, 0})})->on_at_start);
    EXPECT_TRUE(testing::touch_on(probe, {at({15.1, 0.7, 0}), at({10, 0.7, 0})})->on_at_start);
  }
}

TEST(PressedSurfaces, ASlantedWallIsReachedByTheDeflectionAlongItsOwnNormal) {
  // The wall leans by 30 degrees over the side or away from it; the way goes along the side's
  // slope of 1 : 20.
  for (const double lean : {30.0, -30.0}) {
    SCOPED_TRACE(lean);
    const double angle = lean * std::numbers::pi / 180.0;
    const Point n(-std::cos(angle), std::sin(angle), 0.0);
    parts::Mesh wall = testing::moved_by(testing::box_mesh({10, 200, 20}), {3, -100, -10});
    const Eigen::AngleAxisd turn(-angle, Point::UnitZ());
    for (Point& vertex : wall.vertices) {
      vertex = turn * vertex + Point(15, 0, 0);
    }
    ProbeSetup setup = ball_at_the_axes();
    setup.at_switch.pre_travel_mm = 0.4;
    TouchProbe probe(setup, {{"side", kSide}, {"wall", wall}}, 0);
    // (C - (15, 0, 0)) n = -0.4 for C = (x, x / 20).
    const double x = (0.4 + 15.0 * std::cos(angle)) / (std::cos(angle) - std::sin(angle) / 20.0);
    for (const int pieces : {1, 40}) {
      EXPECT_NEAR(signal_x(probe, in_pieces(kIntoTheCorner, pieces)).value(), x, 1e-9);
    }
    EXPECT_NEAR((testing::touch_on(probe, kIntoTheCorner)->contact->n_M - n).norm(), 0.0, 1e-12);
  }
}

TEST(PressedSurfaces, AWallBehindTheSurfaceThatIsTouchedIsNeverMet) {
  // A pin stands in the block, 0.1 mm under its side.
  const parts::Mesh pin = testing::moved_by(testing::box_mesh({1, 1, 20}), {12, 3.6, -10});
  ProbeSetup setup = ball_at_the_axes();
  setup.at_switch.pre_travel_mm = 0.48;
  TouchProbe probe(setup, {{"pin", pin}, {"side", kSide}}, 0);
  const auto trigger = testing::touch_on(probe, kIntoTheCorner);
  ASSERT_TRUE(trigger.has_value());
  EXPECT_NEAR(20.0 * trigger->fraction, 10.0 + 0.48 * 20.0, 1e-9);
  EXPECT_EQ(trigger->contact->part, "side");
}

TEST(PressedSurfaces, WhereTheSideEndsTheBallIsFreeAgain) {
  // The side ends at X 13.  Behind it the ball goes on at Y 1 and meets the edge of the wall there.
  const parts::Mesh side = testing::moved_by(testing::box_mesh({63, 20, 20}), {-50, 3.5, -10});
  const parts::Mesh wall = testing::moved_by(testing::box_mesh({10, 10, 20}), {28, 2.5, -10});
  TouchProbe probe(mono_probe(), {{"side", side}, {"wall", wall}}, 0);
  const auto edge = testing::touch_on(probe, {at({0, 1, 0}), at({30, 1, 0})});
  ASSERT_TRUE(edge.has_value());
  EXPECT_NEAR(30.0 * edge->fraction, 28.0 - std::sqrt(9.0 - 1.5 * 1.5), 1e-9);
}

TEST(PressedSurfaces, TheWallBreaksAStylusThatTheSideOnlyDeflects) {
  ProbeSetup setup = ball_at_the_axes();
  setup.deflection_limit_mm = 2.0;
  for (const std::vector<ProbedPart>& parts : corners()) {
    TouchProbe probe(setup, parts, 0);
    const auto broken = testing::damage_on(probe, kIntoTheCorner);
    ASSERT_TRUE(broken.has_value());
    EXPECT_EQ(broken->what, "stylus is pushed 2.000 mm into wall, its deflection limit");
    EXPECT_NEAR(20.0 * broken->fraction, 17.0, 1e-9);
    // In pieces that begin in contact, too.
    const auto way = in_pieces(kIntoTheCorner, 40);
    const auto then = probe.first_obstacle(machine::Way(way), machine::Travel::Skip);
    ASSERT_TRUE(then.has_value());
    EXPECT_NEAR(20.0 * then->fraction, 17.0, 1e-9);
    EXPECT_FALSE(testing::damage_on(probe, {at({0, 0, 0}), at({16.9, 0.845, 0})}).has_value());
  }
}

TEST(PressedSurfaces, FacetsOfABoreAreOneSurface) {
  parts::PartSetup ring;
  ring.name = "ring";
  ring.shape = "ring";
  const parts::Mesh mesh = parts::make_artefact(ring).value();
  ProbeSetup setup = ball_at_the_axes();
  setup.at_switch.pre_travel_mm = 0.05;
  TouchProbe probe(setup, {{"ring", mesh}}, 0);
  constexpr double kFree = 39.996 / 2 - 3.0;
  for (int i = 0; i < 60; ++i) {
    // Beside the axis: the wall is met at a slant, and the deflection is that of the first facet.
    const double off = 0.25 * i;
    const double touch = std::sqrt(kFree * kFree - off * off);
    const auto trigger = testing::touch_on(probe, {at({0, off, -10}), at({20, off, -10})});
    ASSERT_TRUE(trigger.has_value());
    EXPECT_NEAR(20.0 * trigger->fraction, touch + 0.05 * kFree / touch, 1e-3) << off;
  }
}

TEST(PressedSurfaces, EachBallOfAStarLooksForItsOwnSignal) {
  ProbeSetup setup = mono_probe();
  setup.further_balls.push_back({Point(0, 0, 40), 6.0});
  // The lower ball is pressed into the side alone, the upper one meets the wall.
  const parts::Mesh high = testing::moved_by(kWall, {0, 0, 40});
  TouchProbe probe(setup, {{"side", kSide}, {"wall", high}}, 0);
  const auto trigger = testing::touch_on(probe, kIntoTheCorner);
  ASSERT_TRUE(trigger.has_value());
  EXPECT_NEAR(20.0 * trigger->fraction, 15.0, 1e-9);
  EXPECT_EQ(trigger->contact->part, "wall");
}

}  // namespace
}  // namespace g31::probe::pressed_surfaces_test

// How far a ball is pressed in at a slant, against the distance of its centre in closed form:
// signals with pre-travel and the deflection limit over edges, on spheres, in a bore.

#include <cmath>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "parts/geometry/placement.h"
#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::touch_pressing_test {
namespace {

using testing::at;
using testing::between;

constexpr double kBall = 3.0;
constexpr double kSameDepth = 1.1e-6;  // as the probe has it of planes

/// A ball of 3 mm radius, its centre at the linear axes.
ProbeSetup ball_at_the_axes(double pre_travel_mm) {
  ProbeSetup setup;
  setup.length_mm = 0.0;
  setup.at_switch.pre_travel_mm = pre_travel_mm;
  return setup;
}

ProbedPart block() {
  return {"block", testing::box_mesh({10, 10, 10})};
}

/// 25 mm, a true sphere at the origin.
ProbedPart sphere() {
  parts::PartSetup setup;
  setup.name = "sphere";
  setup.shape = "sphere";
  setup.sizes = {{"diameter", 25.0}, {"sagitta", 0.05}};
  ProbedPart part{"sphere", parts::make_artefact(setup).value()};
  part.sphere_M = parts::exact_sphere(setup);
  return part;
}

/// Of 40 mm, its axis Z through the origin, its top at Z0.
ProbedPart bore() {
  parts::PartSetup setup;
  setup.name = "ring";
  setup.shape = "ring";
  setup.sizes = {{"bore", 40.0}, {"outer_diameter", 200.0}, {"sagitta", 1e-4}};
  return {"ring", parts::make_artefact(setup).value()};
}

/// X where it first gives the signal on a way along X; nullopt: nowhere.
std::optional<double> signal_at(TouchProbe& probe, const Point& from, double to_x) {
  const auto trigger = testing::touch_on(probe, {at(from), at({to_x, from.y(), from.z()})});
  return trigger ? std::optional(from.x() + trigger->fraction * (to_x - from.x())) : std::nullopt;
}

/// The same of the deflection limit.
std::optional<double> broken_at(TouchProbe& probe, const Point& from, double to_x) {
  const auto broken = testing::damage_on(probe, {at(from), at({to_x, from.y(), from.z()})});
  return broken ? std::optional(from.x() + broken->fraction * (to_x - from.x())) : std::nullopt;
}

/// Along X over the upper edge of the block, so many mm below where the ball would rest on its top.
TEST(TouchPressing, OverAnEdgeTheSignalComesWhereTheBallIsDeepEnough) {
  std::mt19937_64 random(31);
  for (int i = 0; i < 200; ++i) {
    const double pre_travel = between(random, 0.005, 0.1);
    const double below = between(random, 0.2 * pre_travel, 2.9);
    TouchProbe probe(ball_at_the_axes(pre_travel), {block()}, 0);
    const double height = kBall - below;
    const auto signal = signal_at(probe, {-20.0, 5.0, 10.0 + height}, 30.0);
    if (below < pre_travel) {
      EXPECT_FALSE(signal) << below << " of " << pre_travel << ": nowhere that deep";
      continue;
    }
    const double reach = kBall - pre_travel;
    ASSERT_TRUE(signal) << below << " of " << pre_travel;
    const double expected = -std::sqrt(reach * reach - height * height);
    EXPECT_NEAR(*signal, expected, kSameDepth * reach / -expected) << below << " of " << pre_travel;
    machine::Waypoint there{0.0, at({*signal + 1e-6, 5.0, 10.0 + height})};
    EXPECT_TRUE(probe.signals_at(there, {}));
  }
}

TEST(TouchPressing, PastASphereTheSignalComesWhereTheBallIsDeepEnough) {
  std::mt19937_64 random(32);
  for (int i = 0; i < 200; ++i) {
    const double pre_travel = between(random, 0.005, 0.1);
    const double off = between(random, 14.5, 15.5);
    TouchProbe probe(ball_at_the_axes(pre_travel), {sphere()}, 0);
    const auto signal = signal_at(probe, {-40.0, off, 0.0}, 40.0);
    const double reach = 12.5 + kBall - pre_travel;
    ASSERT_EQ(signal.has_value(), off < reach) << off << " " << pre_travel;
    if (signal) {
      const double expected = -std::sqrt(reach * reach - off * off);
      EXPECT_NEAR(*signal, expected, kSameDepth * reach / -expected) << off << " " << pre_travel;
    }
  }
}

TEST(TouchPressing, ABallOnAChordOfABoreBreaksWhereItIsTooDeep) {
  for (const double off : {5.0, 12.0, 16.0, 16.95}) {
    TouchProbe probe(ball_at_the_axes(0.0), {bore()}, 0);
    const auto broken = broken_at(probe, {0.0, off, -5.0}, 30.0);
    ASSERT_TRUE(broken) << off;
    EXPECT_NEAR(*broken, std::sqrt(400.0 - off * off), 2e-4) << off;
    ProbeSetup careful = ball_at_the_axes(0.0);
    careful.deflection_limit_mm = 1.0;
    TouchProbe soft(careful, {bore()}, 0);
    const auto earlier = broken_at(soft, {0.0, off, -5.0}, 30.0);
    ASSERT_TRUE(earlier) << off;
    EXPECT_NEAR(*earlier, std::sqrt(18.0 * 18.0 - off * off), 2e-4) << off;
  }
}

TEST(TouchPressing, ABallThatSkimsOverBreaksNothing) {
  for (const double below : {0.01, 0.02, 0.5, 2.9}) {
    TouchProbe over_block(ball_at_the_axes(0.0), {block()}, 0);
    EXPECT_FALSE(broken_at(over_block, {-60.0, 5.0, 13.0 - below}, 60.0)) << below;
    TouchProbe past_sphere(ball_at_the_axes(0.0), {sphere()}, 0);
    EXPECT_FALSE(broken_at(past_sphere, {-40.0, 15.5 - below, 0.0}, 40.0)) << below;
  }
  TouchProbe through(ball_at_the_axes(0.0), {sphere()}, 0);
  const auto broken = broken_at(through, {-40.0, 12.0, 0.0}, 40.0);
  ASSERT_TRUE(broken) << "its centre comes into the sphere";
  EXPECT_NEAR(*broken, -std::sqrt(12.5 * 12.5 - 144.0), 1e-6);
}

TEST(TouchPressing, OnPlanesTheTangentPlaneIsTheSurface) {
  std::mt19937_64 random(33);
  for (int i = 0; i < 200; ++i) {
    const double pre_travel = between(random, 0.005, 0.1);
    const double rise = between(random, 0.01, 2.0);
    TouchProbe probe(ball_at_the_axes(pre_travel), {{"block", testing::box_mesh({100, 100, 10})}},
                     0);
    const Point from(20.0, 50.0, 10.0 + kBall + 0.5 * rise);
    const Point to(80.0, 50.0, 10.0 + kBall - rise);
    const auto trigger = testing::touch_on(probe, {at(from), at(to)});
    ASSERT_EQ(trigger.has_value(), rise >= pre_travel);
    if (trigger) {
      EXPECT_NEAR(1.5 * rise * trigger->fraction, 0.5 * rise + pre_travel, 1e-12);
    }
  }
}

/// Boxes from corner to corner, as one part.
ProbedPart boxes(const std::vector<std::pair<Point, Point>>& corners) {
  ProbedPart part{"boxes", {}};
  for (const auto& [low, high] : corners) {
    const auto first = static_cast<std::uint32_t>(part.mesh_M.vertices.size());
    const parts::Mesh box = testing::box_mesh(high - low);
    for (const Point& vertex : box.vertices) {
      part.mesh_M.vertices.push_back(vertex + low);
    }
    for (const auto& triangle : box.triangles) {
      part.mesh_M.triangles.push_back(
          {triangle[0] + first, triangle[1] + first, triangle[2] + first});
    }
  }
  return part;
}

/// Walls along Y, their faces at -width / 2 and width / 2, from Z -20 to 0.
ProbedPart slot(double width) {
  return boxes({{{-20.0 - 0.5 * width, -50.0, -20.0}, {-0.5 * width, 50.0, 0.0}},
                {{0.5 * width, -50.0, -20.0}, {20.0 + 0.5 * width, 50.0, 0.0}}});
}

/// A move from one wall of a slot to the other, as behind a touch that was retracted too little.
TEST(TouchPressing, FromOneWallOfASlotToTheOtherNothingBreaks) {
  for (const double in_it : {0.001, 0.005, 0.04}) {
    TouchProbe probe(ball_at_the_axes(0.05), {slot(8.0)}, 0);
    const Point from(-1.0 - in_it, 0.0, -10.0);
    EXPECT_FALSE(broken_at(probe, from, 1.5)) << in_it;
    const auto signal = signal_at(probe, from, 1.5);
    ASSERT_TRUE(signal) << in_it;
    EXPECT_NEAR(*signal, 1.05, 1e-9) << in_it;
  }
  TouchProbe tight(ball_at_the_axes(0.05), {slot(5.98)}, 0);
  EXPECT_FALSE(testing::damage_on(tight, {at({0.0, -30.0, -10.0}), at({0.0, 30.0, -10.0})}));
}

/// Two edges hold the ball: it is deflected along the slot's depth alone, and a slot narrower than
/// the ball lets nothing through.
TEST(TouchPressing, ABallWedgedInANarrowSlotGivesASignal) {
  constexpr double kWidth = 5.94;
  TouchProbe probe(ball_at_the_axes(0.05), {slot(kWidth)}, 0);
  const auto trigger = testing::touch_on(probe, {at({0.0, 0.0, 5.0}), at({0.0, 0.0, -5.0})});
  ASSERT_TRUE(trigger);
  const double touches_at = std::sqrt(kBall * kBall - 0.25 * kWidth * kWidth);
  EXPECT_NEAR(5.0 - 10.0 * trigger->fraction, touches_at - 0.05 / (touches_at / kBall), 1e-6);
}

TEST(TouchPressing, TheContactIsOfTheSurfaceThatGivesTheSignal) {
  // A floor, on which the ball slides 0.01 mm deep, and a boss on it.
  TouchProbe probe(ball_at_the_axes(0.05),
                   {boxes({{{-40, -40, -10}, {40, 40, 0}}, {{20, -8, 0}, {30, 5, 6}}})}, 0);
  const auto trigger = testing::touch_on(probe, {at({-30.0, 7.9, 2.99}), at({39.0, 7.9, 2.99})});
  ASSERT_TRUE(trigger);
  ASSERT_TRUE(trigger->contact);
  EXPECT_GT(trigger->contact->p_M_point.x(), 19.9);
  EXPECT_GT(trigger->contact->n_M.y(), 0.9) << "of the side of the boss";
}

/// The same in many pieces, as curves are asked.
TEST(TouchPressing, PiecesOfAWaySayTheSameAsTheWhole) {
  for (const double below : {0.002, 0.02, 0.049, 0.06, 0.5, 2.0}) {
    TouchProbe probe(ball_at_the_axes(0.05), {block()}, 0);
    constexpr int kPieces = 37;
    std::vector<machine::Waypoint> way;
    for (int i = 0; i <= kPieces; ++i) {
      const double share = static_cast<double>(i) / kPieces;
      way.push_back({share, at({-20.0 + 50.0 * share, 5.0, 13.0 - below})});
    }
    const auto trigger = testing::touch_along(probe, way);
    ASSERT_EQ(trigger.has_value(), below >= 0.05) << below;
    if (trigger) {
      const double height = kBall - below;
      const double reach = kBall - 0.05;
      const double expected = -std::sqrt(reach * reach - height * height);
      EXPECT_NEAR(-20.0 + 50.0 * trigger->fraction, expected, kSameDepth * reach / -expected);
    }
  }
}

}  // namespace
}  // namespace g31::probe::touch_pressing_test

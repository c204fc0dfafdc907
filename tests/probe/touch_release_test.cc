// Where the signal of a touch probe goes off again, and whether it is on where the probe stands.

#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::touch_release_test {
namespace {

using testing::at;

using Way = std::vector<machine::Waypoint>;

/// A ball of 3 mm radius, its centre at the linear axes.
ProbeSetup ball_at_the_axes() {
  ProbeSetup setup;
  setup.length_mm = 0.0;
  return setup;
}

TEST(TouchRelease, OfAStylusAcrossNeedsTheDeflectionOfItsRise) {
  ProbeSetup setup = ball_at_the_axes();
  setup.in_turret = true;
  setup.turn_of_stylus = Eigen::Quaterniond::FromTwoVectors(Point::UnitZ(), Point::UnitX());
  setup.at_switch.seats = Seats::Tripod;
  setup.at_switch.pre_travel_mm = 0.01;
  setup.at_switch.trigger_force_n = 0.5;
  setup.at_switch.stem_stiffness_n_mm = 10.0;
  // The stem lies along X, and so the top face of the block is touched sideways.
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  const auto rise = testing::touch_on(probe, {at({5, 5, 23}), at({5, 5, 12})});
  ASSERT_TRUE(rise.has_value());
  // Against a weak direction: 0.5 N bend a stem of 10 N/mm by 0.05.
  constexpr double kDeflection = 0.01 + 0.5 / 10.0;
  EXPECT_NEAR(23.0 - 11.0 * rise->fraction, 13.0 - kDeflection, 1e-12);
  const auto fall =
      testing::release_along(probe, Way{{0.0, at({5, 5, 12})}, {1.0, at({5, 5, 23})}});
  ASSERT_TRUE(fall.has_value());
  EXPECT_NEAR(12.0 + 11.0 * fall->fraction, 13.0 - kDeflection, 1e-8);
}

TEST(TouchRelease, AMonoProbeAcrossIsSilentFromTheSideFromWhichItNeverRises) {
  ProbeSetup setup = ball_at_the_axes();
  setup.in_turret = true;
  setup.turn_of_stylus = Eigen::Quaterniond::FromTwoVectors(Point::UnitZ(), Point::UnitX());
  setup.at_switch.type = ProbeType::Mono;
  setup.at_switch.mono_direction_deg = 90.0;
  TouchProbe probe(setup, {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  EXPECT_FALSE(testing::touch_on(probe, {at({5, 5, 23}), at({5, 5, 12})}).has_value());
  EXPECT_FALSE(probe.signals_at({0.0, at({5, 5, 12})}, {1}));
  // Along the stem it is as if from above.
  EXPECT_TRUE(testing::touch_on(probe, {at({23, 5, 5}), at({12, 5, 5})}).has_value());
  EXPECT_TRUE(probe.signals_at({0.0, at({12, 5, 5})}, {1}));
}

/// A mono probe that turns its switch towards +X.
ProbeSetup mono_probe() {
  ProbeSetup setup = ball_at_the_axes();
  setup.at_switch.type = ProbeType::Mono;
  return setup;
}

TEST(TouchRelease, ABallExactlyInTouchIsDeflectedFromThatSide) {
  // Right over a face, an edge and a corner of the block: 3 mm from each.
  const Point kPlaces[] = {{5.3, 5.4, 13.0}, {-1.8, 5.0, 12.4}, {-1.0, -2.0, 12.0}};
  const Point kNormals[] = {{0, 0, 1}, {-0.6, 0, 0.8}, {-1.0 / 3, -2.0 / 3, 2.0 / 3}};
  TouchProbe probe(ball_at_the_axes(), {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(probe.signals_at({0.0, at(kPlaces[i])}, {1}));
    EXPECT_FALSE(probe.signals_at({0.0, at(kPlaces[i] + 1e-8 * kNormals[i])}, {1}));
    const auto fall = testing::release_along(
        probe, Way{{0.0, at(kPlaces[i])}, {1.0, at(kPlaces[i] + 10.0 * kNormals[i])}});
    ASSERT_TRUE(fall.has_value());
    EXPECT_FALSE(fall->on_at_start);
    EXPECT_NEAR(fall->fraction, 0.0, 1e-9);
    ASSERT_TRUE(fall->contact.has_value());
    EXPECT_NEAR((fall->contact->n_M - kNormals[i]).norm(), 0.0, 1e-14);
    EXPECT_NEAR((fall->contact->p_M_point - (kPlaces[i] - 3.0 * kNormals[i])).norm(), 0.0, 1e-14);
  }
}

TEST(TouchRelease, AMonoProbeExactlyInTouchSignalsFromItsSides) {
  TouchProbe probe(mono_probe(), {{"block", testing::box_mesh({10, 10, 10})}}, 0);
  EXPECT_TRUE(probe.signals_at({0.0, at({5.3, 5.4, 13.0})}, {1}));
  EXPECT_TRUE(probe.signals_at({0.0, at({-3.0, 5.4, 5.0})}, {1}));
  EXPECT_FALSE(probe.signals_at({0.0, at({13.0, 5.4, 5.0})}, {1}));
  EXPECT_FALSE(probe.signals_at({0.0, at({5.3, -3.0, 5.0})}, {1}));
}

/// Two walls, the way to +X and the way to +Y: the centre may go up to X 0 and Y 0.
std::vector<ProbedPart> corner() {
  return {{"side", testing::moved_by(testing::box_mesh({60, 10, 20}), {-50, 3, -10})},
          {"wall", testing::moved_by(testing::box_mesh({10, 60, 20}), {3, -50, -10})}};
}

TEST(TouchRelease, InACornerEachWallCountsByItsOwnDeflection) {
  TouchProbe probe(mono_probe(), corner(), 0);
  EXPECT_FALSE(probe.signals_at({0.0, at({-1e-8, 0.3, 0.0})}, {1})) << "only the side is touched";
  EXPECT_TRUE(probe.signals_at({0.0, at({0.0, 0.3, 0.0})}, {1}));
  const auto fall =
      testing::release_along(probe, Way{{0.0, at({0.1, 0.3, 0})}, {1.0, at({-0.9, 0.3, 0})}});
  ASSERT_TRUE(fall.has_value());
  EXPECT_NEAR(fall->fraction, 0.1, 1e-8);
  EXPECT_EQ(fall->contact->part, "wall");
}

/// A slot along Y: the centre may go from X -7 to X 7.  In one mesh, and as two parts.
std::vector<std::vector<ProbedPart>> slots() {
  const parts::Mesh right = testing::moved_by(testing::box_mesh({10, 60, 20}), {10, -30, -10});
  parts::Mesh both = testing::moved_by(right, {-30, 0, 0});
  const std::vector<ProbedPart> two = {{"left", both}, {"right", right}};
  const auto count = static_cast<std::uint32_t>(both.vertices.size());
  both.vertices.insert(both.vertices.end(), right.vertices.begin(), right.vertices.end());
  for (const auto& triangle : right.triangles) {
    both.triangles.push_back({triangle[0] + count, triangle[1] + count, triangle[2] + count});
  }
  return {two, {{"slot", both}}};
}

TEST(TouchRelease, IsFoundOnAStraightWayThatEndsInAnotherWall) {
  ProbeSetup setup = ball_at_the_axes();
  setup.at_switch.pre_travel_mm = 0.25;
  for (const std::vector<ProbedPart>& parts : slots()) {
    TouchProbe probe(setup, parts, 0);
    // From X 8, on from X 7.25: head-on, and at a slant.
    for (const double y : {0.0, 20.0}) {
      const auto fall =
          testing::release_along(probe, Way{{0.0, at({8, 0, 0})}, {1.0, at({-7.5, y, 0})}});
      ASSERT_TRUE(fall.has_value());
      EXPECT_NEAR(8.0 - 15.5 * fall->fraction, 7.25, 1e-8);
      EXPECT_EQ(fall->contact->part, parts.back().name);
      EXPECT_EQ(fall->contact->n_M, -Point::UnitX());
    }
  }
}

TEST(TouchRelease, IsFoundWhereTheBallSlidesOffAnEdgeAndOnToAnotherBlock) {
  // Along the tops of two blocks, 1 mm deep: the ball is on the edge at X 10 until it is 3 mm from
  // it, sqrt(9 - 4) further; at 30 - sqrt(5) it comes on to the other one.
  TouchProbe probe(ball_at_the_axes(),
                   {{"block", testing::box_mesh({10, 10, 10})},
                    {"another", testing::moved_by(testing::box_mesh({10, 10, 10}), {30, 0, 0})}},
                   0);
  const auto fall =
      testing::release_along(probe, Way{{0.0, at({5, 5, 12})}, {1.0, at({35, 5, 12})}});
  ASSERT_TRUE(fall.has_value());
  EXPECT_NEAR(5.0 + 30.0 * fall->fraction, 10.0 + std::sqrt(5.0), 1e-8);
  EXPECT_EQ(fall->contact->part, "block");
}

}  // namespace
}  // namespace g31::probe::touch_release_test

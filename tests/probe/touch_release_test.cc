// Where the signal of a touch probe goes off again, and whether it is on where the probe stands.

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::touch_release_test {
namespace {

AxisPositions at(const Point& p) {
  AxisPositions q = AxisPositions::Zero();
  q.head<3>() = p;
  return q;
}

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
  EXPECT_FALSE(probe.signals_at({0.0, at({5, 5, 12})}, 1));
  // Along the stem it is as if from above.
  EXPECT_TRUE(testing::touch_on(probe, {at({23, 5, 5}), at({12, 5, 5})}).has_value());
  EXPECT_TRUE(probe.signals_at({0.0, at({12, 5, 5})}, 1));
}

}  // namespace
}  // namespace g31::probe::touch_release_test

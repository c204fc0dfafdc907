// Stem and body of a probe on arcs: what a chord with a fixed margin would find too early.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "probe/sensor/touch_probe.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/asked.h"

namespace g31::probe::whole_probe_test {
namespace {

using testing::at;

/// A thin stem and a body of 20 mm radius that begins 50 mm above a small ball.
ProbeSetup probe_with_body() {
  ProbeSetup setup;
  setup.ball_diameter_mm = 4.0;
  setup.length_mm = 120.0;
  ProbeSection stem;
  stem.name = "stem";
  stem.z_top = 50.0;
  stem.radius_bottom = 1.2;
  stem.radius_top = 1.2;
  setup.stem = {stem};
  ProbeSection body;
  body.name = "probe body";
  body.z_bottom = 50.0;
  body.z_top = 120.0;
  body.radius_bottom = 20.0;
  body.radius_top = 20.0;
  setup.bodies = {body};
  return setup;
}

/// Three quarters of a circle of this radius about the origin, from -Y on, the ball at z.
machine::CurvedWay circle(const ProbeSetup& setup, double radius, double z) {
  const double turn = 1.5 * std::numbers::pi;
  return {[=, length = setup.length_mm](double fraction) {
            const double angle = turn * fraction - 0.5 * std::numbers::pi;
            return at(Point(radius * std::cos(angle), radius * std::sin(angle), z + length));
          },
          radius * turn * turn, 200};
}

TEST(WholeProbe, FollowsAnArcIntoAPost) {
  const ProbeSetup setup = probe_with_body();
  // A post of 4 x 4 mm at (60, 0), 30 mm over the body's lower end when the ball is at z = 0.
  TouchProbe probe(setup, {{"post", testing::moved_by(testing::box_mesh({4, 4, 80}), {60, -2, 0})}},
                   0);
  // At 80 mm the body passes behind the post by 80 - 20 - 64 mm: it meets the corner (64, -2).
  const auto corner = [](double radius) {
    // Where the circle is 20 mm from the corner: by the law of cosines.
    const double far = std::hypot(64.0, 2.0);
    const double between = std::acos((radius * radius + far * far - 400.0) / (2.0 * radius * far));
    const double angle = std::atan2(-2.0, 64.0) - between;
    return (angle + 0.5 * std::numbers::pi) / (1.5 * std::numbers::pi);
  };
  const auto met = testing::collision_on(probe, circle(setup, 80.0, 0.0));
  ASSERT_TRUE(met);
  EXPECT_EQ(met->what, "probe body touches post");
  EXPECT_NEAR(met->fraction * 80.0 * 1.5 * std::numbers::pi,
              corner(80.0) * 80.0 * 1.5 * std::numbers::pi, 3e-6);
}

TEST(WholeProbe, PassesAnArcWithoutTouchingByAHair) {
  const ProbeSetup setup = probe_with_body();
  TouchProbe probe(setup, {{"post", testing::moved_by(testing::box_mesh({4, 4, 80}), {60, -2, 0})}},
                   0);
  // Inside the circle of 40 mm the body ends at x = 60, where the post's face begins.
  EXPECT_FALSE(testing::collision_on(probe, circle(setup, 39.9999, 0.0)));
  EXPECT_TRUE(testing::collision_on(probe, circle(setup, 40.0001, 0.0)));
  // Above the post the body does not matter.
  EXPECT_FALSE(testing::collision_on(probe, circle(setup, 80.0, 31.0)));
}

}  // namespace
}  // namespace g31::probe::whole_probe_test

// Ways that a transformation leads, against its closed form.

#include "machine/sim/led_path.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "machine/sim/servo_motion.h"
#include "tests/support/turntable.h"

namespace g31::machine::led_path_test {
namespace {

using testing::Turntable;

AxisPositions at(double x, double y, double z, double c) {
  return (AxisPositions() << x, y, z, 0, 0, c).finished();
}

struct Led {
  AxisPositions q_B_from;
  AxisPositions q_B_to;

  [[nodiscard]] AxisPositions exactly_at(double fraction) const {
    const AxisPositions q_B = q_B_from + fraction * (q_B_to - q_B_from);
    return Turntable::turned(q_B, -q_B[5]);
  }
  [[nodiscard]] LinearMove move() const {
    LinearMove move;
    move.q_M_end = exactly_at(1.0);
    move.traverse = Traverse::Feed;
    move.feed_mm_min = 3000.0;
    move.transform = std::make_shared<Turntable>();
    return move;
  }
  [[nodiscard]] LedPath path() const { return *led_path(exactly_at(0.0), move()); }
};

const Led kHalfTurn = {at(300, -20, 10, -90), at(250, 40, 25, 90)};
const Led kHeld = {at(300, 0, 0, -180), at(300, 0, 0, 180)};
const Led kShort = {at(300, -20, 10, 30), at(300.5, -20.2, 10.1, 30.4)};
const Led kShortButBent = {at(300, -20, 10, 30), at(300.5, -20.2, 10.1, 31.9)};

TEST(LedPath, IsStraightInBaseCoordinates) {
  for (const Led& led : {kHalfTurn, kHeld, kShort, kShortButBent}) {
    const LedPath path = led.path();
    EXPECT_EQ(path.from(), led.exactly_at(0.0));
    EXPECT_EQ(path.to(), led.exactly_at(1.0));
    for (int i = 0; i <= 1000; ++i) {
      const double fraction = i / 1000.0;
      EXPECT_LT((path.at(fraction) - led.exactly_at(fraction)).cwiseAbs().maxCoeff(), kLedErrorMm)
          << fraction;
    }
  }
}

/// An arc is exact however many pieces its speeds are looked at in, which are as many as it and the
/// rotary axes turn.
TEST(LedPath, ArcsAreExactInAsManyPiecesAsTheyTurn) {
  const auto on_arc = [](double deg, double c) {
    const double angle = deg * std::numbers::pi / 180.0;
    return at(250.0 + 50.0 * std::cos(angle), 10.0 + 50.0 * std::sin(angle), 7.0, c);
  };
  for (const double sweep : {0.2, 14.0, 15.0, 31.0, 90.0, 200.0, 360.0}) {
    for (const double turned : {0.0, 1.0, 41.0}) {
      SCOPED_TRACE(::testing::Message() << sweep << " " << turned);
      const auto exactly = [&](double fraction) {
        const double c = 20.0 + fraction * turned;
        return Turntable::turned(on_arc(fraction * sweep, c), -c);
      };
      ArcMove arc;
      arc.q_M_end = exactly(1.0);
      arc.centre_first = 250.0;
      arc.centre_second = 10.0;
      arc.turn = Turn::Counterclockwise;
      arc.feed_mm_min = 1000.0;
      arc.transform = std::make_shared<Turntable>();
      const LedPath path = *led_path(exactly(0.0), arc);
      const int wanted =
          std::max(1 + static_cast<int>(turned / 2.0), static_cast<int>(std::ceil(sweep / 15.0)));
      EXPECT_EQ(path.piece_count(), wanted);
      double worst = 0.0;
      for (int i = 0; i <= 1000; ++i) {
        worst = std::max(worst, (path.at(i / 1000.0) - exactly(i / 1000.0)).cwiseAbs().maxCoeff());
      }
      EXPECT_LT(worst, 1e-9);
    }
  }
}

TEST(LedPath, CountsTheFeedOfTheWayInBaseCoordinates) {
  EXPECT_NEAR(kHalfTurn.path().length(), std::sqrt(50.0 * 50 + 60 * 60 + 15 * 15), 1e-9);
  EXPECT_NEAR(kHeld.path().length(), 360.0, 1e-9);  // the tip stands: degrees
}

TEST(LedPath, SlopesAreThoseOfTheWay) {
  for (const Led& led : {kHalfTurn, kHeld, kShort}) {
    for (const double fraction : {0.0, 0.3, 1.0}) {
      constexpr double kStep = 1e-5;
      const double before = std::max(0.0, fraction - kStep);
      const double behind = std::min(1.0, fraction + kStep);
      const AxisPositions slope =
          (led.exactly_at(behind) - led.exactly_at(before)) / (behind - before);
      EXPECT_LT((led.path().slope_at(fraction) - slope).norm(), 1e-3 * slope.norm());
    }
  }
}

TEST(LedPath, IsOneOnlyWhereARotaryAxisTurns) {
  const Led straight = {at(300, -20, 10, 30), at(250, 40, 25, 30)};
  EXPECT_FALSE(led_path(straight.exactly_at(0.0), straight.move()));
  LinearMove unled = kHalfTurn.move();
  unled.transform = nullptr;
  EXPECT_FALSE(led_path(kHalfTurn.exactly_at(0.0), unled));
}

TEST(LedPath, IsCommandedAsExactly) {
  for (const Led& led : {kHalfTurn, kHeld, kShort}) {
    const LedPath path = led.path();
    const MotionProfile profile(path.length(), 50.0, 400.0, 3000.0);
    const ServoMotion motion(path, profile.phases(), {}, {});
    for (int i = 0; i <= 2000; ++i) {
      const double time_s = profile.duration_s() * i / 2000.0;
      const double fraction = profile.distance_at(time_s) / path.length();
      const AxisPositions off = motion.commanded_at(time_s) - led.exactly_at(fraction);
      EXPECT_LT(off.cwiseAbs().maxCoeff(), 3.0 * kLedErrorMm) << time_s;
    }
  }
}

TEST(LedPath, NoAxisGoesFasterThanItCan) {
  MachineSetup setup;
  for (AxisSetup& axis : setup.axes) {
    axis.present = true;
    axis.rapid_per_min = 6000.0;
  }
  const AxisDynamics dynamics(setup);
  const PathLimits limits = dynamics.limits(kHeld.path(), kHeld.move());
  // 300 mm from the centre 100 mm/s are 19.1 deg/s; F3000 asks for 50.
  const double turning = 100.0 / 300.0 * 180.0 / std::numbers::pi;
  EXPECT_LT(limits.speed, 1.01 * turning);
  EXPECT_GT(limits.speed, 0.9 * turning);
}

TEST(LedPath, TravelLimitsHoldOnTheWholeWay) {
  MachineSetup setup;
  for (AxisSetup& axis : setup.axes) {
    axis.present = true;
  }
  setup.axes[0].travel_max = 299.0;  // both ends of half a turn are at X0
  const Led led = {at(300, 0, 0, -90), at(300, 0, 0, 90)};
  setup.q_M_start = led.exactly_at(0.0);
  MachiningCentre machine(setup, nullptr);
  const auto reached = machine.move(led.move());
  ASSERT_FALSE(reached);
  EXPECT_EQ(reached.error().kind, FaultKind::SoftLimit);
  EXPECT_EQ(machine.position(), setup.q_M_start);
}

TEST(LedPath, AnArcIsOneInBaseCoordinates) {
  ArcMove arc;
  arc.q_M_end = Turntable::turned(at(0, 50, 0, 40), -40);
  arc.centre_first = arc.centre_second = 0.0;
  arc.turn = Turn::Counterclockwise;
  arc.feed_mm_min = 1000.0;
  arc.transform = std::make_shared<Turntable>();
  const LedPath path = *led_path(at(50, 0, 0, 0), arc);
  for (const double fraction : {0.25, 0.5, 0.75}) {
    const double angle = fraction * std::numbers::pi / 2;
    const AxisPositions q_B = at(50 * std::cos(angle), 50 * std::sin(angle), 0, 40 * fraction);
    EXPECT_LT((path.at(fraction) - Turntable::turned(q_B, -40 * fraction)).norm(), 1e-9);
  }
}

}  // namespace
}  // namespace g31::machine::led_path_test

// Phases that are next to nothing, as rounding leaves them: the axes follow as without them.

#include <cmath>
#include <memory>
#include <variant>

#include <gtest/gtest.h>

#include "machine/sim/servo_motion.h"
#include "tests/support/turntable.h"

namespace g31::machine::short_phases_test {
namespace {

using testing::Turntable;

constexpr double kSpeed = 50.0;  // mm/s

AxisPositions at(double x, double y, double c) {
  return (AxisPositions() << x, y, 0, 0, 0, c).finished();
}

/// A quarter about a place far from the origin, where places round more.
CommandedPath quarter() {
  ArcMove arc;
  arc.q_M_end = at(700, 310, 0);
  arc.centre_first = 700.0;
  arc.centre_second = 300.0;
  arc.turn = Turn::Counterclockwise;
  arc.feed_mm_min = 60.0 * kSpeed;
  return ArcPath(at(710, 300, 0), arc);
}

/// From X300 Y-20 of a table that turns by 90 degrees meanwhile.
CommandedPath led_way() {
  const Turntable table;
  LinearMove move;
  move.q_M_end = *table.axes_at(at(250, 40, 60));
  move.traverse = Traverse::Feed;
  move.feed_mm_min = 60.0 * kSpeed;
  move.transform = std::make_shared<Turntable>();
  return *led_path(*table.axes_at(at(300, -20, -30)), move);
}

double length_of(const CommandedPath& path) {
  return std::visit([](const auto& way) { return way.length(); }, path);
}

MotionPhases steady(double first_s, double between_s, double last_s) {
  MotionPhases phases(MotionState{0.0, kSpeed, 0.0});
  phases.append(first_s, 0.0);
  phases.append(between_s, 0.0);
  phases.append(last_s, 0.0);
  return phases;
}

class ShortPhases : public ::testing::TestWithParam<CommandedPath> {};

TEST_P(ShortPhases, LeaveTheAxesWhereTheyWouldBe) {
  ServoLoops loops;
  loops.time_constants_s = at(0.06, 0.06, 0.06);
  const double all_s = length_of(GetParam()) / kSpeed;
  const ServoMotion plain(GetParam(), steady(0.0, 0.0, all_s), {}, loops);
  for (int power = -300; power <= -2; power += power < -20 ? 20 : 1) {
    SCOPED_TRACE(power);
    const double cut_s = std::pow(10.0, power);
    const double first_s = 0.4 * all_s;
    const ServoMotion cut(GetParam(), steady(first_s, cut_s, all_s - cut_s - first_s), {}, loops);
    for (int i = 0; i <= 60; ++i) {
      const double time_s = all_s * i / 50.0;  // the lag that dies away, too
      const AxisPositions off = cut.encoder_at(time_s) - plain.encoder_at(time_s);
      ASSERT_LT(off.cwiseAbs().maxCoeff(), 1e-9) << time_s;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OnCurves, ShortPhases, ::testing::Values(quarter(), led_way()));

}  // namespace
}  // namespace g31::machine::short_phases_test

#include "probe/tooling/spindle.h"

#include "machine/base/random.h"

namespace g31::probe {
namespace {

/// The random stream of the angle at which a spindle comes to rest.
constexpr std::uint32_t kRestStream = 2;

/// Clockwise is seen from the spindle, down to the tool.
double rate_of(const machine::SpindleTurn& turn) {
  constexpr double kPerMinuteToDegreesPerSecond = kFullTurnDeg / 60.0;
  const double rate = turn.speed_rev_min * kPerMinuteToDegreesPerSecond;
  switch (turn.rotation) {
    case machine::Rotation::Clockwise:
      return -rate;
    case machine::Rotation::Counterclockwise:
      return rate;
    case machine::Rotation::Stopped:
      break;
  }
  return 0.0;
}

}  // namespace

void Spindle::take(const machine::SpindleTurn& turn, double now_s) {
  if (turn.spindle != kToolSpindle) {
    return;
  }
  const bool comes_to_rest = turns_ && turn.rotation == machine::Rotation::Stopped;
  turns_ = turn.rotation != machine::Rotation::Stopped;
  angle_deg_ = angle_deg(now_s);
  since_s_ = now_s;
  rate_deg_s_ = rate_of(turn);
  if (turn.angle_deg) {
    angle_deg_ = *turn.angle_deg;
    is_angle_known_ = true;
  } else if (comes_to_rest) {
    angle_deg_ = kFullTurnDeg * uniform({seed_, kRestStream}, rests_++);
    is_angle_known_ = false;
  }
}

}  // namespace g31::probe

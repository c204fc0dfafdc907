#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "machine/base/random.h"
#include "probe/metrology/circle_evaluation.h"

namespace g31::testing {

/// A machine whose circle is computed, with the errors that the evaluation is to find.
struct CircleMachine {
  metrology::CircleErrors errors;
  std::array<double, 2> amplitude = {};  ///< of cyclic errors, of the pitches in errors, mm
  std::array<double, 2> phase = {};      ///< of them where the axis stands at 0, rad
  std::array<double, 2> bow = {};  ///< straightness: how far the axis' way bows aside at +-R, mm
  double noise = 0.0;              ///< standard deviation of a reading, mm
  double feed_mm_s = 2000.0 / 60.0;
  double start = 0.0;  ///< angle of the first point, rad
  std::uint64_t seed = 1;
};

/// The record of a circle counter-clockwise and one clockwise, as a scale on the table sees them.
///
/// Written from the physics and not from the model: each axis follows its command by its own lag,
/// the play is a state that is taken up step by step, and the geometry is added to the axes.  Play
/// lies behind the screw, whose cyclic error counts where the screw stands: as sheets have it, that
/// is the table's place where it came from below.
struct CircleRecord {
  std::vector<double> t;
  std::vector<double> x;
  std::vector<double> y;

  [[nodiscard]] metrology::PlaneSamples samples() const { return {t, x, y}; }
};

/// What remains behind when an axis turns round, half on either side.
class TestPlay {
 public:
  explicit TestPlay(double width) : half_(0.5 * width) {}
  double follow(double q) {
    if (!is_known_) {
      table_ = q;
      is_known_ = true;
    }
    table_ = std::clamp(table_, q - half_, q + half_);
    return table_;
  }

 private:
  double half_;
  double table_ = 0.0;
  bool is_known_ = false;
};

/// The cyclic error of an axis whose screw stands there.
inline double cyclic_of(const CircleMachine& machine, std::size_t axis, double at) {
  const auto& pitch = machine.errors.pitches.at(axis);
  return pitch ? machine.amplitude.at(axis) *
                     std::sin(2.0 * std::numbers::pi * at / *pitch + machine.phase.at(axis))
               : 0.0;
}

inline CircleRecord recorded_circle(const CircleMachine& machine, std::size_t per_turn = 2000) {
  CircleRecord record;
  const metrology::CircleErrors& e = machine.errors;
  const double omega = machine.feed_mm_s / e.radius;
  const double turn_s = 2.0 * std::numbers::pi / omega;
  TestPlay play_x(e.backlash[0]);
  TestPlay play_y(e.backlash[1]);
  const Stream stream{machine.seed, 7};
  std::uint64_t draw = 0;
  for (const int direction : {1, -1}) {
    for (std::size_t i = 0; i <= per_turn; ++i) {
      const double time = turn_s * static_cast<double>(i) / static_cast<double>(per_turn);
      // Of the mismatch, half is the lag of X and half the lead of Y.
      const double angle_x = machine.start + direction * omega * (time - 0.5 * e.mismatch);
      const double angle_y = machine.start + direction * omega * (time + 0.5 * e.mismatch);
      const double screw_x = e.radius * std::cos(angle_x);
      const double screw_y = e.radius * std::sin(angle_y);
      const double qx = play_x.follow(screw_x);
      const double qy = play_y.follow(screw_y);
      const double across = qx / e.radius;
      const double along = qy / e.radius;
      const double y = qy * (1.0 + e.scale[1]) + machine.bow[0] * across * across +
                       cyclic_of(machine, 1, e.centre.y() - 0.5 * e.backlash[1] + screw_y);
      const double x = qx * (1.0 + e.scale[0]) + e.squareness * qy * (1.0 + e.scale[1]) +
                       machine.bow[1] * along * along +
                       cyclic_of(machine, 0, e.centre.x() - 0.5 * e.backlash[0] + screw_x);
      record.t.push_back(time + (direction > 0 ? 0.0 : turn_s + 0.5));
      record.x.push_back(e.centre.x() + x + machine.noise * standard_normal(stream, draw++));
      record.y.push_back(e.centre.y() + y + machine.noise * standard_normal(stream, draw++));
    }
  }
  return record;
}

}  // namespace g31::testing

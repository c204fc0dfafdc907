#pragma once

#include <cstdint>

#include "machine/port/machine_events.h"

namespace g31::probe {

inline constexpr double kFullTurnDeg = 360.0;
using machine::kToolSpindle;

/// How the spindle that holds tools stands or turns.
class Spindle {
 public:
  /// @param seed  of the angle at which it comes to rest where no program says one
  explicit Spindle(std::uint64_t seed) : seed_(seed) {}

  /// One that has turned and stops without an angle stands anywhere: the seed draws it, evenly.
  /// @param now_s  since the start of the program
  void take(const machine::SpindleTurn& turn, double now_s);

  [[nodiscard]] bool turns() const { return turns_; }
  /// It stands where a program put it, as at the start.
  [[nodiscard]] bool is_angle_known() const { return is_angle_known_; }

  /// Positive from +X towards +Y.  @param time_s  not before the last turn
  [[nodiscard]] double angle_deg(double time_s) const {
    return angle_deg_ + rate_deg_s_ * (time_s - since_s_);
  }
  /// 0: it stands, or nobody has said how fast it turns.
  [[nodiscard]] double rate_deg_s() const { return rate_deg_s_; }

 private:
  std::uint64_t seed_;
  std::uint64_t rests_ = 0;
  bool turns_ = false;
  bool is_angle_known_ = true;
  double angle_deg_ = 0.0;  // at
  double since_s_ = 0.0;
  double rate_deg_s_ = 0.0;
};

}  // namespace g31::probe

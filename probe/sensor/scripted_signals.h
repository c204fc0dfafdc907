#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "machine/port/surroundings.h"
#include "probe/sensor/probe_setup.h"

namespace g31::probe {

/// Skip signals from a list instead of a probe: for programs without parts, and for tests.
///
/// The n-th skip move takes the n-th signal of the list, whether it uses it or not; it rises when
/// the axis reaches its machine coordinate.  Ideal: no delay, no random shift, nothing to collide
/// with.
class ScriptedSignals final : public machine::Surroundings {
 public:
  /// @param signals  axis 0..5 each
  explicit ScriptedSignals(std::vector<SkipSignal> signals);

  /// No signal: the list is used up, the signal has no `at`, its axis does not move in this sweep
  /// or ends before `at`.  An axis that starts at `at` or beyond it in the direction of its motion:
  /// the signal is on at the start.
  std::optional<machine::SkipTrigger> first_trigger(const machine::Sweep& sweep) override;

  /// Always nullopt.
  std::optional<machine::Obstacle> first_collision(const machine::Sweep& sweep) override;

 private:
  std::vector<SkipSignal> signals_;
  std::size_t used_ = 0;
};

}  // namespace g31::probe

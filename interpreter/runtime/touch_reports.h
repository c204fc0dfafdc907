#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "interpreter/runtime/missed_touches.h"
#include "interpreter/runtime/touch_notes.h"

namespace g31::runtime {

/// What a run tells of its measuring moves: touches that were missed, and touches that count though
/// they are wrong by something.
///
/// Values are also looked at from outside the program, at a pause or for somebody who listens:
/// nothing of the run changes for that, so what such a look asks for is not heard.
class TouchReports {
 public:
  MissedTouches missed;

  [[nodiscard]] bool is_inspected() const { return is_inspected_; }

  /// The program looks where the axes are.
  void looks() {
    if (!is_inspected_) {
      missed.looks();
    }
  }
  /// The program looks at the signal of a sensor.
  void looks_at_signal(int input) {
    if (!is_inspected_) {
      missed.looks_at_signal(input);
    }
  }
  /// The program looks at an input that is wired to something else, for all that is known.
  void looks_at_input() {
    if (!is_inspected_) {
      missed.looks_at_input();
    }
  }
  /// The program asks whether the last move had its signal.
  void asks(int input) {
    if (!is_inspected_) {
      missed.asks(input);
    }
  }
  /// The program reads what the last move latched.
  /// @returns whether a move has latched anything yet
  bool result_read(std::vector<source::Diagnostic>& diagnostics) {
    if (is_inspected_) {
      return true;
    }
    missed.reads_result();
    notes_.read(diagnostics);
    return has_latched_;
  }
  /// @param state  of what touched
  void touched(const TouchEvent& event, const std::optional<machine::SensorState>& state) {
    has_latched_ = true;
    notes_.touched(event, state);
  }
  /// A move without a sensor latches its end.
  void latched() { has_latched_ = true; }

  bool operator==(const TouchReports&) const = default;

 private:
  friend class LookFromOutside;
  TouchNotes notes_;
  bool is_inspected_ = false;
  bool has_latched_ = false;
};

/// While it lives, values are looked at from outside the program: no report comes of it, no time
/// passes and nothing moves.
class LookFromOutside {
 public:
  explicit LookFromOutside(TouchReports& reports)
      : reports_(reports), was_before_(std::exchange(reports.is_inspected_, true)) {}
  ~LookFromOutside() { reports_.is_inspected_ = was_before_; }
  LookFromOutside(const LookFromOutside&) = delete;
  LookFromOutside& operator=(const LookFromOutside&) = delete;

 private:
  TouchReports& reports_;
  bool was_before_;
};

}  // namespace g31::runtime

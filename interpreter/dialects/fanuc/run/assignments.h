#pragma once

#include <cstdint>
#include <optional>

#include "interpreter/dialects/fanuc/run/call_stack.h"
#include "interpreter/dialects/fanuc/state/control.h"

namespace g31::fanuc {

/// Writes a variable for the block that runs, and tells who listens to writes.
std::optional<AlarmId> write_variable(Control& control, const CallStack& stack, std::int32_t number,
                                      Cell value);

/// Statements that give variables values and names.
class Assignments {
 public:
  /// Both must outlive it.
  Assignments(const CallStack& stack, Control& control) : stack_(stack), control_(control) {}

  MaybeFailure assign(const Step& step);
  /// SETVN: on controls without names in programs they only show on the screen (MB-104).
  MaybeFailure set_names(const Step& step);

 private:
  MaybeFailure assigned_system_variable(int number, double value);
  [[nodiscard]] const Frame& frame() const { return stack_.frame(); }

  const CallStack& stack_;
  Control& control_;
};

}  // namespace g31::fanuc

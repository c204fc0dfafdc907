#pragma once

#include <cstdint>

#include "interpreter/dialects/sinumerik/run/operands.h"
#include "interpreter/dialects/sinumerik/run/step_fault.h"

namespace g31::sinumerik {

/// Does the steps on numbers, arrays, texts and frames.  Those that return a truth say whether they
/// went well; fault() has the reason.
class StepMachine {
 public:
  /// Both must outlive the machine.
  StepMachine(CallStack& stack, Channel& channel)
      : operands_(stack, channel), stack_(stack), channel_(channel) {}

  Operands& operands() { return operands_; }
  StepFault& fault() { return fault_; }

  // run_numbers.cc

  /// Does steps on numbers, jumps and the beginnings of blocks up to a step of another kind, which
  /// it returns, or up to one that failed.
  const Op& number_steps();
  /// The step that comes next: now it is the present one.
  const Op& take_step();
  bool number_step(const Op& op);
  bool array_step(const Op& op);

  // run_texts.cc

  bool text_step(const Op& op);
  bool frame_step(const Op& op);

 private:
  // run_numbers.cc
  bool rare_number_step(const Op& op);
  bool mathematical_step(const Op& op);
  bool take(const Op& op, double value);
  bool take_truth(const Op& op, bool holds);
  [[nodiscard]] bool is_less(double a, double b) const;
  bool take_whole(const Op& op, Type type, AlarmId alarm);
  bool is_within_limits(const Op& op);
  bool index(const Op& op);
  bool store(const VariableView& into, std::size_t element, double value);

  // run_texts.cc
  bool set_character(const Op& op);
  bool store_text(const Op& op);
  bool fill(const Op& op);
  bool repeat_value(const Op& op);
  bool set_element(const VariableView& target, std::int32_t element, const Argument& value);

  double& number(Operand place) { return operands_.number(place); }
  std::string& text(Operand place) { return operands_.text(place); }
  Frame& frame(Operand place) { return operands_.frame(place); }
  VariableView variable(std::int32_t which) { return operands_.variable(which); }

  Operands operands_;
  StepFault fault_;
  CallStack& stack_;
  Channel& channel_;
};

}  // namespace g31::sinumerik

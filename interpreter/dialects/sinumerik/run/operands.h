#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/code/value_limits.h"
#include "interpreter/dialects/sinumerik/run/call_stack.h"
#include "interpreter/dialects/sinumerik/state/channel.h"
#include "interpreter/dialects/sinumerik/state/failure.h"
#include "interpreter/dialects/sinumerik/state/frame.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {

using Arguments = std::span<const Argument>;

/// A variable with its memory, from its first element on, which stays while its level runs.
struct VariableView : Reference {
  // One of them, by its type
  double* numbers = nullptr;
  std::string* texts = nullptr;
  Frame* frames = nullptr;
};

/// What the operands of steps stand for: constants and locals of the running level, globals of the
/// channel, and results within a block.
class Operands {
 public:
  /// Both must outlive the operands.
  Operands(CallStack& stack, Channel& channel);

  /// Another level, or another program of it, runs from now on.
  void use_level();

  double& number(Operand place) {
    return banks_[static_cast<std::size_t>(place.bank)][place.place];
  }
  /// An argument that holds a number or an axis.
  [[nodiscard]] double number(const Argument& argument) {
    G31_EXPECTS(is_held_as_number(argument.type));
    return number(argument.value);
  }
  std::string& text(Operand place);
  Frame& frame(Operand place);
  /// What a step with a list gives.
  [[nodiscard]] Arguments arguments_of(const Op& op) const;

  /// A variable of the running program, by its number there; one of a caller, if it is a VAR
  /// parameter.
  VariableView variable(std::int32_t which);
  /// A number of an array as the program counts it.
  [[nodiscard]] double loaded(const VariableView& from, std::size_t element) const;
  /// And the other way.  @returns why it is no number that may be kept
  std::optional<WrongValue> store(const VariableView& into, std::size_t element, double value);
  /// A result goes to the variable that an argument names, as an assignment would.
  MaybeFailure assign(const Argument& target, double value);

  [[nodiscard]] Level& level() const { return stack_.level(); }
  [[nodiscard]] const CompiledProgram& program() const { return *stack_.level().program; }
  [[nodiscard]] std::span<const double> temporaries() const { return number_temporaries_; }

 private:
  [[nodiscard]] Reference reference(const Variable& known) const;

  double* banks_[4] = {};
  std::vector<double> number_temporaries_;
  std::vector<std::string> text_temporaries_;
  std::vector<Frame> frame_temporaries_;
  CallStack& stack_;
  Channel& channel_;
};

}  // namespace g31::sinumerik

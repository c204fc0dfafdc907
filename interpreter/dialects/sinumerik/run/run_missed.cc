// What becomes of the result of a measuring move without a signal: a run that owes nothing does not
// come here.

#include <algorithm>
#include <span>
#include <vector>

#include "interpreter/dialects/sinumerik/run/runner.h"

namespace g31::sinumerik {
namespace {

runtime::MissedTouches::Holder holder_of(const double& cell) {
  return reinterpret_cast<runtime::MissedTouches::Holder>(&cell);
}

bool is_comparison(OpCode code) {
  return code == OpCode::Equal || code == OpCode::NotEqual || code == OpCode::Less ||
         code == OpCode::Greater || code == OpCode::LessEqual || code == OpCode::GreaterEqual;
}

}  // namespace

/// Says what a step reads and what becomes of it, before it is done.
void Runner::follow(const Op& op) {
  runtime::MissedTouches& missed = channel_.touches.missed;
  const auto reads = [&](Operand place) { missed.reads(holder_of(number(place))); };
  if (is_number_step(op.code)) {
    reads(op.a);
    reads(op.b);
    if (is_comparison(op.code)) {
      missed.compares();
    }
    missed.assigns(holder_of(number(op.result)));
    return;
  }
  if (op.code == OpCode::JumpIfNot) {
    reads(op.a);
    missed.compares();
  } else if (op.code == OpCode::Load) {
    missed.reads(holder_of(element(op)));
    missed.assigns(holder_of(number(op.result)));
  } else if (op.code == OpCode::Store) {
    reads(op.result);
    missed.assigns(holder_of(element(op)));
  } else if (op.code == OpCode::Word || op.code == OpCode::AxisWord) {
    reads(op.code == OpCode::Word ? op.a : op.b);
    missed.moves();
  } else if (op.code == OpCode::NumberToText) {
    reads(op.a);
    use_measured();
  } else if (op.code == OpCode::WriteSystem) {
    reads(arguments_of(op).back().value);
    use_measured();
  } else if (op.code == OpCode::Function) {
    follow_function(op);
  } else if (op.code == OpCode::Call) {
    missed.passes_on();
  }
}

/// The element of an array that Load and Store are about.
const double& Runner::element(const Op& op) {
  return variable(op.b.place).numbers[static_cast<std::size_t>(number(op.a))];
}

/// A frame out of measured numbers is as good as an offset.
void Runner::follow_function(const Op& op) {
  for (const Argument& argument : arguments_of(op)) {
    if (argument.form == Argument::Form::Value && is_held_as_number(argument.type)) {
      channel_.touches.missed.reads(holder_of(number(argument.value)));
    }
  }
  const Type result = info(static_cast<FunctionId>(op.detail)).result;
  if (result == Type::Frame) {
    use_measured();
  } else if (is_held_as_number(result)) {
    channel_.touches.missed.assigns(holder_of(number(op.result)));
  } else {
    channel_.touches.missed.passes_on();
  }
}

/// The variables that a call gives values of, by argument; 0: none that is followed.
std::vector<runtime::MissedTouches::Holder> Runner::holders_given(
    const CallSite& site, const std::vector<BoundValue>& values) {
  std::vector<runtime::MissedTouches::Holder> given;
  if (!channel_.touches.missed.any()) {
    return given;
  }
  given.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Argument& argument = level().program->arguments[site.first_argument + i];
    const BoundValue& value = values[i];
    if (value.form == Argument::Form::Element && value.reference.numbers != nullptr) {
      given[i] = holder_of(*value.reference.numbers);
    } else if (value.form == Argument::Form::Value && is_held_as_number(value.type)) {
      given[i] = holder_of(number(argument.value));
    }
  }
  return given;
}

/// The parameters of the level that has begun hold what the arguments were made of; those that are
/// taken by reference are the caller's own variables.
void Runner::follow_arguments(const std::vector<runtime::MissedTouches::Holder>& given) {
  runtime::MissedTouches& missed = channel_.touches.missed;
  const CompiledProgram& program = *level().program;
  for (std::size_t i = 0; i < std::min(given.size(), program.parameters.size()); ++i) {
    const Parameter& parameter = program.parameters[i];
    const Variable& variable = program.variables[static_cast<std::size_t>(parameter.variable)];
    if (given[i] != 0 && !parameter.by_reference && is_held_as_number(variable.type)) {
      missed.reads(given[i]);
      missed.assigns(holder_of(level().numbers[static_cast<std::size_t>(variable.place)]));
    }
  }
}

/// What a system variable shows is known once it has been read.
void Runner::follow_read(const Op& op) {
  if (channel_.touches.missed.any() && !channel_.is_inspected()) {
    channel_.touches.missed.assigns(holder_of(number(op.result)));
  }
}

void Runner::use_measured() {
  channel_.warnings.add_missed(channel_.diagnostics, channel_.touches.missed.uses());
}

/// The variables of a level, or the results within a block, are gone.
void Runner::forget(std::span<const double> cells) {
  if (channel_.touches.missed.any() && !cells.empty()) {
    channel_.touches.missed.forget(holder_of(cells.front()), holder_of(cells.back()));
  }
}

void Runner::end_missed() {
  forget(number_temporaries_);
  for (std::size_t i = 1; i < levels_.size(); ++i) {
    forget(levels_[i]->numbers);
  }
  channel_.warnings.add_missed(channel_.diagnostics, channel_.touches.missed.ends());
}

}  // namespace g31::sinumerik

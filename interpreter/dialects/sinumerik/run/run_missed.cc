// What becomes of the result of a measuring move without a signal: a run that owes nothing does not
// come here.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "interpreter/dialects/sinumerik/run/missed_results.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {
namespace {

/// Of a number that is the results within a block (bank 1), a global (2) or in a level (3 and on).
runtime::MissedTouches::Holder holder_in(std::uint64_t bank, std::size_t place) {
  constexpr int kBankShift = 32;
  return bank << kBankShift | place;
}

bool is_comparison(OpCode code) {
  return code == OpCode::Equal || code == OpCode::NotEqual || code == OpCode::Less ||
         code == OpCode::Greater || code == OpCode::LessEqual || code == OpCode::GreaterEqual;
}

}  // namespace

runtime::MissedTouches::Holder MissedResults::holder_of(const double& cell) const {
  std::uint64_t bank = 1;
  const auto in_bank =
      [&](std::span<const double> numbers) -> std::optional<runtime::MissedTouches::Holder> {
    const double* const first = numbers.data();
    const double* const last = first + numbers.size();
    const bool is_here = !std::less<>()(&cell, first) && std::less<>()(&cell, last);
    return is_here ? std::optional(holder_in(bank, static_cast<std::size_t>(&cell - first)))
                   : std::nullopt;
  };
  auto found = in_bank(operands_.temporaries());
  ++bank;
  found = found ? found : in_bank(channel_.numbers);
  for (std::size_t i = 0; !found && i < stack_.count(); ++i) {
    ++bank;
    found = in_bank(stack_.level(i).numbers);
  }
  return found.value_or(0);
}

void MissedResults::follow(const Op& op) {
  const auto reads = [&](Operand place) { missed_.reads(holder_of(operands_.number(place))); };
  if (is_comparison(op.code)) {
    const auto side = [&](Operand place) {
      reads(place);
      return runtime::MissedTouches::Side{operands_.number(place), missed_.set_aside()};
    };
    const auto left = side(op.a);
    missed_.compares(left, side(op.b));
    missed_.assigns(holder_of(operands_.number(op.result)));
    return;
  }
  if (is_number_step(op.code)) {
    reads(op.a);
    reads(op.b);
    missed_.assigns(holder_of(operands_.number(op.result)));
    return;
  }
  if (op.code == OpCode::JumpIfNot) {
    reads(op.a);
    missed_.decides();
  } else if (op.code == OpCode::Load) {
    missed_.reads(holder_of(element(op)));
    missed_.assigns(holder_of(operands_.number(op.result)));
  } else if (op.code == OpCode::Store) {
    reads(op.result);
    missed_.assigns(holder_of(element(op)));
  } else if (op.code == OpCode::Word || op.code == OpCode::AxisWord) {
    reads(op.code == OpCode::Word ? op.a : op.b);
    missed_.moves();
  } else if (op.code == OpCode::NumberToText) {
    reads(op.a);
    use_measured();
  } else if (op.code == OpCode::WriteSystem) {
    reads(operands_.arguments_of(op).back().value);
    use_measured();
  } else if (op.code == OpCode::Function) {
    follow_function(op);
  } else if (op.code == OpCode::Call) {
    missed_.passes_on();
  }
}

/// The element of an array that Load and Store are about.
const double& MissedResults::element(const Op& op) {
  return operands_.variable(op.b.place).numbers[static_cast<std::size_t>(operands_.number(op.a))];
}

/// A frame out of measured numbers is as good as an offset.
void MissedResults::follow_function(const Op& op) {
  for (const Argument& argument : operands_.arguments_of(op)) {
    if (argument.form == Argument::Form::Value && is_held_as_number(argument.type)) {
      missed_.reads(holder_of(operands_.number(argument.value)));
    }
  }
  const Type result = info(static_cast<FunctionId>(op.detail)).result;
  if (result == Type::Frame) {
    use_measured();
  } else if (is_held_as_number(result)) {
    missed_.assigns(holder_of(operands_.number(op.result)));
  } else {
    missed_.passes_on();
  }
}

std::vector<runtime::MissedTouches::Holder> MissedResults::holders_given(
    const CallSite& site, const std::vector<BoundValue>& values) {
  std::vector<runtime::MissedTouches::Holder> given;
  if (!missed_.any()) {
    return given;
  }
  given.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Argument& argument = operands_.level().program->arguments[site.first_argument + i];
    const BoundValue& value = values[i];
    if (value.form == Argument::Form::Element && is_held_as_number(value.type)) {
      const VariableView whole = operands_.variable(argument.variable);
      given[i] =
          holder_of(whole.numbers[static_cast<std::size_t>(operands_.number(argument.element))]);
    } else if (value.form == Argument::Form::Value && is_held_as_number(value.type)) {
      given[i] = holder_of(operands_.number(argument.value));
    }
  }
  return given;
}

void MissedResults::follow_arguments(const std::vector<runtime::MissedTouches::Holder>& given) {
  const CompiledProgram& program = *operands_.level().program;
  for (std::size_t i = 0; i < std::min(given.size(), program.parameters.size()); ++i) {
    const Parameter& parameter = program.parameters[i];
    const Variable& variable = program.variables[static_cast<std::size_t>(parameter.variable)];
    if (given[i] != 0 && !parameter.by_reference && is_held_as_number(variable.type)) {
      missed_.reads(given[i]);
      missed_.assigns(
          holder_of(operands_.level().numbers[static_cast<std::size_t>(variable.place)]));
    }
  }
}

void MissedResults::follow_read(const Op& op) {
  if (missed_.any() && !channel_.is_inspected()) {
    missed_.assigns(holder_of(operands_.number(op.result)));
  }
}

void MissedResults::use_measured() {
  channel_.warnings.add_missed(channel_.diagnostics, missed_.uses());
}

void MissedResults::forget(std::span<const double> cells) {
  if (missed_.any() && !cells.empty()) {
    missed_.forget(holder_of(cells.front()), holder_of(cells.back()));
  }
}

void MissedResults::end() {
  forget(operands_.temporaries());
  for (std::size_t i = 1; i < stack_.count(); ++i) {
    forget(stack_.level(i).numbers);
  }
  channel_.warnings.add_missed(channel_.diagnostics, missed_.ends());
}

}  // namespace g31::sinumerik

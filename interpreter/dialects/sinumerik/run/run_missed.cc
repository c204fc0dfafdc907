// What becomes of the result of a measuring move without a signal: a run that owes nothing does not
// come here.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/run/missed_results.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"

namespace g31::sinumerik {
namespace {

/// Of a number that is the results within a block (bank 1), a global (2) or in a level (3 and on).
runtime::MissedTouches::Holder holder_in(std::uint64_t bank, std::size_t place) {
  constexpr int kBankShift = 32;
  return bank << kBankShift | place;
}

constexpr std::size_t kMostArguments = 1000;

/// Where an argument waits that a modal call keeps.
runtime::MissedTouches::Holder of_modal_call(std::size_t argument) {
  return holder_in(0, argument + 1);
}

bool is_frame_code(std::uint16_t bits) {
  return g_codes()[unpacked(bits).row].group == Group::ProgrammableFrame;
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
    if (auto reading = missed_.set_aside()) {
      of_words_.push_back(std::move(reading));
    }
  } else if (op.code == OpCode::Block) {
    of_words_.clear();
  } else if (op.code == OpCode::Execute) {
    follow_block(op);
  } else if (op.code == OpCode::NumberToText) {
    reads(op.a);
    use_measured();
  } else if (op.code == OpCode::WriteSystem || op.code == OpCode::StoreComponent) {
    const Arguments list = operands_.arguments_of(op);
    read_arguments(op.code == OpCode::WriteSystem ? list.last(1) : list.first(1));
    use_measured();
  } else if (op.code == OpCode::Fill || op.code == OpCode::Repeat) {
    follow_array(op);
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

/// The axes go to the words of a block, unless they are a frame: what the program counts from is as
/// good as an offset.
void MissedResults::follow_block(const Op& op) {
  const CompiledProgram& program = operands_.program();
  const auto codes = program.nc_blocks[static_cast<std::size_t>(op.b.place)].codes_of(program);
  for (const auto& reading : of_words_) {
    missed_.reads(reading);
  }
  of_words_.clear();
  if (std::ranges::any_of(codes, is_frame_code)) {
    use_measured();
  } else {
    missed_.moves();
  }
}

void MissedResults::read_arguments(Arguments list) {
  for (const Argument& argument : list) {
    if (!is_held_as_number(argument.type)) {
      continue;
    }
    if (argument.form == Argument::Form::Whole) {
      for (const double& cell : cells_of(argument)) {
        missed_.reads(holder_of(cell));
      }
    } else if (argument.form != Argument::Form::Omitted) {
      missed_.reads(holder_of(operands_.number(argument.value)));
    }
  }
}

/// All elements of an array.
std::span<const double> MissedResults::cells_of(const Argument& whole) {
  const VariableView view = operands_.variable(whole.variable);
  return {view.numbers, static_cast<std::size_t>(view.shape.count())};
}

/// A frame out of measured numbers is as good as an offset.
void MissedResults::follow_function(const Op& op) {
  const auto id = static_cast<FunctionId>(op.detail);
  const Arguments list = operands_.arguments_of(op);
  if (id == FunctionId::CALCDAT) {
    read_arguments(list.first(list.size() - 1));
    const auto reading = missed_.set_aside();
    for (const double& cell : cells_of(list.back())) {
      missed_.reads(reading);
      missed_.assigns(holder_of(cell));
    }
    return;
  }
  read_arguments(list);
  const Type result = info(id).result;
  if (result == Type::Frame) {
    use_measured();
  } else if (is_held_as_number(result)) {
    missed_.assigns(holder_of(operands_.number(op.result)));
  } else {
    missed_.passes_on();
  }
}

/// SET(values): elements in turn; REP(value, times): the same in each.
void MissedResults::follow_array(const Op& op) {
  const VariableView view = operands_.variable(op.a.place);
  if (!is_held_as_number(view.type)) {
    missed_.passes_on();
    return;
  }
  const auto first = static_cast<std::size_t>(operands_.number(op.result));
  const auto count = static_cast<std::size_t>(view.shape.count());
  const std::span<const double> cells(view.numbers, count);
  const Arguments list = operands_.arguments_of(op);
  for (std::size_t i = first; i < count; ++i) {
    const std::size_t which = op.code == OpCode::Repeat ? 0 : i - first;
    if (which >= list.size()) {
      break;
    }
    read_arguments(list.subspan(which, 1));
    missed_.assigns(holder_of(cells[i]));
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

void MissedResults::keep_for_modal_call(const std::vector<runtime::MissedTouches::Holder>& given) {
  missed_.forget(of_modal_call(0), of_modal_call(kMostArguments));
  for (std::size_t i = 0; i < given.size(); ++i) {
    missed_.reads(given[i]);
    missed_.assigns(of_modal_call(i));
  }
}

void MissedResults::follow_modal_call(std::size_t count) {
  if (!missed_.any()) {
    return;
  }
  std::vector<runtime::MissedTouches::Holder> waiting;
  for (std::size_t i = 0; i < count; ++i) {
    waiting.push_back(of_modal_call(i));
  }
  follow_arguments(waiting);
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
  missed_.forget(of_modal_call(0), of_modal_call(kMostArguments));
  for (std::size_t i = 1; i < stack_.count(); ++i) {
    forget(stack_.level(i).numbers);
  }
  channel_.warnings.add_missed(channel_.diagnostics, missed_.ends());
}

void MissedResults::break_off() {
  channel_.warnings.add_missed(channel_.diagnostics, missed_.breaks_off());
}

}  // namespace g31::sinumerik

#include "interpreter/dialects/sinumerik/run/operands.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {

Operands::Operands(CallStack& stack, Channel& channel)
    : number_temporaries_(kTemporaryCount),
      text_temporaries_(kTemporaryCount),
      frame_temporaries_(kTemporaryCount),
      stack_(stack),
      channel_(channel) {}

void Operands::use_level() {
  // Constants are never written: no step has one as its result.
  banks_[0] = const_cast<double*>(program().constants.data());
  banks_[1] = level().numbers.data();
  banks_[2] = channel_.numbers.data();
  banks_[3] = number_temporaries_.data();
  if (program().reads_block_time && !channel_.clocks.block_began && !channel_.is_inspected()) {
    channel_.clocks.block_began = channel_.port.time_s();
  }
}

std::string& Operands::text(Operand place) {
  const auto at = static_cast<std::size_t>(place.place);
  switch (place.bank) {
    case Bank::Constants:
      // Never written: no step has a constant as its result.
      return const_cast<std::string&>(program().text_constants[at]);
    case Bank::Locals:
      return level().texts[at];
    case Bank::Globals:
      return channel_.texts[at];
    case Bank::Temporaries:
      break;
  }
  return text_temporaries_[at];
}

Frame& Operands::frame(Operand place) {
  const auto at = static_cast<std::size_t>(place.place);
  return place.bank == Bank::Locals    ? level().frames[at]
         : place.bank == Bank::Globals ? channel_.frames[at]
                                       : frame_temporaries_[at];
}

Arguments Operands::arguments_of(const Op& op) const {
  return Arguments(program().arguments).subspan(static_cast<std::size_t>(op.b.place), op.count);
}

Reference Operands::reference(const Variable& known) const {
  if (known.storage == Storage::Reference) {
    return level().references[static_cast<std::size_t>(known.place)];
  }
  Reference found;
  found.type = known.type;
  found.is_global = known.storage == Storage::Global;
  found.level = stack_.depth();
  found.place = known.place;
  if (known.storage == Storage::OfMain) {
    // The main program runs: no text before it sees its variables.
    const CompiledProgram& main = *stack_.level(0).own_place().first;
    const auto there = main.locals.find(known.name);
    G31_EXPECTS(there != main.locals.end());
    found.level = 0;
    found.place = main.variables[static_cast<std::size_t>(there->second)].place;
  }
  found.shape = known.shape;
  found.longest = known.longest;
  found.unit = known.unit;
  found.is_by_axis = known.is_by_axis;
  return found;
}

VariableView Operands::variable(std::int32_t which) {
  VariableView found = {reference(program().variables[static_cast<std::size_t>(which)])};
  const auto at = static_cast<std::size_t>(found.place) + found.first;
  Level& local = stack_.level(found.level);
  if (found.type == Type::String) {
    found.texts = (found.is_global ? channel_.texts : local.texts).data() + at;
  } else if (found.type == Type::Frame) {
    found.frames = (found.is_global ? channel_.frames : local.frames).data() + at;
  } else if (found.type != Type::None) {
    found.numbers = (found.is_global ? channel_.numbers : local.numbers).data() + at;
  }
  return found;
}

double Operands::loaded(const VariableView& from, std::size_t element) const {
  const double kept = from.numbers[element];
  return from.unit == DatumUnit::Plain
             ? kept
             : kept / channel_.kept_per_datum(from.unit, from.axis(element));
}

std::optional<WrongValue> Operands::store(const VariableView& into, std::size_t element,
                                          double value) {
  double kept = value;
  if (into.unit != DatumUnit::Plain) {
    kept *= channel_.kept_per_datum(into.unit, into.axis(element));
  }
  if (!std::isfinite(kept)) {
    return WrongValue{AlarmId::ArithmeticError, "too large"};
  }
  into.numbers[element] = kept;
  return std::nullopt;
}

MaybeFailure Operands::assign(const Argument& target, double value) {
  const Variable& into = program().variables[static_cast<std::size_t>(target.variable)];
  const VariableView found = variable(target.variable);
  const auto kept = kept_as(found.type, value);
  if (!kept) {
    return failure(AlarmId::BadConversion,
                   fmt::format("{}: no {}", into.name, name_of(found.type)));
  }
  auto wrong = beyond_limits(into, *kept);
  if (!wrong && found.numbers != nullptr) {
    wrong = store(found, static_cast<std::size_t>(number(target.element)), *kept);
  }
  return failure(std::move(wrong));
}

}  // namespace g31::sinumerik

#include "interpreter/dialects/sinumerik/code/block_part.h"

namespace g31::sinumerik {

Operand BlockPart::temporary(Type type) {
  const auto place = code_.temporary(type);
  if (!place) {
    fail(AlarmId::TooComplex, block());
  }
  return place.value_or(Operand{Bank::Temporaries, 0});
}

std::uint32_t BlockPart::keep_arguments(const std::vector<Argument>& list) {
  const auto first = static_cast<std::uint32_t>(program_.arguments.size());
  program_.arguments.insert(program_.arguments.end(), list.begin(), list.end());
  return first;
}

void BlockPart::set_target(std::int32_t jump, std::int32_t target) {
  if (jump >= 0) {
    Op& op = code_.step(jump);
    // Of a block that is wrong its alarm stays, behind its first step.
    const std::int32_t alarm = static_cast<std::int32_t>(code_.first_step()) + 1;
    (op.code == OpCode::Jump ? op.a : op.b).place = failed() ? alarm : target;
  }
}

Argument argument_of(const Expr& expr) {
  Argument argument;
  argument.form = expr.is_whole_array  ? Argument::Form::Whole
                  : expr.variable >= 0 ? Argument::Form::Element
                                       : Argument::Form::Value;
  argument.type = expr.type;
  argument.value = expr.value;
  argument.variable = expr.variable;
  argument.element = expr.element;
  argument.where = expr.where;
  return argument;
}

}  // namespace g31::sinumerik

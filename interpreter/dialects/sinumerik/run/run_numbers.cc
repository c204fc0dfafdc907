#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/step_machine.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

/// Whether a comparison takes two numbers as equal: what binary digits lose makes no difference.
bool are_equal(double a, double b) {
  constexpr double kRelative = 1e-12;
  return a == b || std::abs(a - b) <= kRelative * std::max(std::abs(a), std::abs(b));
}

std::int32_t bits(double number) {
  return static_cast<std::int32_t>(number);
}

}  // namespace

/// result = value, which must be a number.
bool StepMachine::take(const Op& op, double value) {
  if (!std::isfinite(value)) [[unlikely]] {
    return fault_.keep(no_number(number(op.b)));
  }
  number(op.result) = value;
  return true;
}

bool StepMachine::take_truth(const Op& op, bool holds) {
  number(op.result) = holds ? 1.0 : 0.0;
  return true;
}

bool StepMachine::is_less(double a, double b) const {
  return a < b && (!are_equal(a, b) || channel_.orders_exactly());
}

/// The hot loop: the level's step is looked up and left once.
const Op& StepMachine::number_steps() {
  Level& now = stack_.level();
  const Op* const ops = now.program->ops.data();
  const Op* op = ops + now.step;
  const bool in_part = !now.parts.empty();
  for (bool done = true;; ++op) {
    if (is_number_step(op->code)) {
      done = number_step(*op);
    } else if (op->code == OpCode::Block) {
      done = op->detail == 0 && !in_part && channel_.watch.counts_at_once();
    } else if (op->code == OpCode::JumpIfNot) {
      op = number(op->a) == 0.0 ? ops + op->b.place - 1 : op;
    } else if (op->code == OpCode::Jump) {
      op = ops + op->a.place - 1;
    } else {
      done = false;
    }
    if (!done) {
      const auto current = static_cast<std::int32_t>(op - ops);
      stack_.set_current(current);
      now.step = current + 1;
      return *op;
    }
  }
}

const Op& StepMachine::take_step() {
  Level& running = stack_.level();
  stack_.set_current(running.step++);
  return running.program->ops[static_cast<std::size_t>(stack_.current())];
}

bool StepMachine::number_step(const Op& op) {
  switch (static_cast<NumberStep>(op.code)) {
    case NumberStep::Move:
      number(op.result) = number(op.a);
      return true;
    case NumberStep::Add:
      return take(op, number(op.a) + number(op.b));
    case NumberStep::Subtract:
      return take(op, number(op.a) - number(op.b));
    case NumberStep::Multiply:
      return take(op, number(op.a) * number(op.b));
    case NumberStep::Divide:
      return take(op, number(op.a) / number(op.b));
    case NumberStep::Equal:
      return take_truth(op, are_equal(number(op.a), number(op.b)));
    case NumberStep::NotEqual:
      return take_truth(op, !are_equal(number(op.a), number(op.b)));
    case NumberStep::Less:
      return take_truth(op, is_less(number(op.a), number(op.b)));
    case NumberStep::Greater:
      return take_truth(op, is_less(number(op.b), number(op.a)));
    case NumberStep::LessEqual:
      return take_truth(op, number(op.a) <= number(op.b) || are_equal(number(op.a), number(op.b)));
    case NumberStep::GreaterEqual:
      return take_truth(op, number(op.a) >= number(op.b) || are_equal(number(op.a), number(op.b)));
    case NumberStep::CheckInt:
      return take_whole(op, Type::Int, AlarmId::ArithmeticError);
    case NumberStep::Math:
      return mathematical_step(op);
    case NumberStep::CheckLimits:
      return is_within_limits(op);
#define RARE_NUMBER_STEP(name) case NumberStep::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
      return rare_number_step(op);
  }
  contract_violated("is_number_step() lets only these through", __FILE__, __LINE__);
}

bool StepMachine::rare_number_step(const Op& op) {
  const double a = number(op.a);
  switch (static_cast<RareNumberStep>(op.code)) {
    case RareNumberStep::DivideWhole:
      return take(op, std::trunc(a / number(op.b)));
    case RareNumberStep::Modulo:
      return take(op, std::fmod(a, number(op.b)));
    case RareNumberStep::Negate:
      return take(op, -a);
    case RareNumberStep::Not:
      return take_truth(op, a == 0.0);
    case RareNumberStep::And:
      return take_truth(op, a != 0.0 && number(op.b) != 0.0);
    case RareNumberStep::Or:
      return take_truth(op, a != 0.0 || number(op.b) != 0.0);
    case RareNumberStep::Xor:
      return take_truth(op, (a != 0.0) != (number(op.b) != 0.0));
    case RareNumberStep::BitAnd:
      return take(op, bits(a) & bits(number(op.b)));
    case RareNumberStep::BitOr:
      return take(op, bits(a) | bits(number(op.b)));
    case RareNumberStep::BitXor:
      return take(op, bits(a) ^ bits(number(op.b)));
    case RareNumberStep::BitNot:
      return take(op, ~bits(a));
    case RareNumberStep::ToBool:
      return take_truth(op, a != 0.0);
    case RareNumberStep::ToChar:
      return take_whole(op, Type::Char, AlarmId::BadConversion);
    case RareNumberStep::ToInt:
      return take_whole(op, Type::Int, AlarmId::BadConversion);
  }
  contract_violated("number_step() lets only these through", __FILE__, __LINE__);
}

bool StepMachine::is_within_limits(const Op& op) {
  const Variable& into = stack_.level().program->variables[static_cast<std::size_t>(op.b.place)];
  const auto wrong = beyond_limits(into, number(op.a));
  return !wrong || fault_.keep(*wrong);
}

/// result = a as INT or CHAR, the types of whole numbers; or an alarm.
bool StepMachine::take_whole(const Op& op, Type type, AlarmId alarm) {
  const double a = number(op.a);
  const double whole = rounded(a);
  if (!fits(type, whole)) [[unlikely]] {
    return fault_.keep(not_of_type(type, a, alarm));
  }
  number(op.result) = whole;
  return true;
}

bool StepMachine::mathematical_step(const Op& op) {
  const auto id = static_cast<FunctionId>(op.detail);
  const double a = number(op.a);
  const auto value = mathematics(id, a, number(op.b));
  if (!value) {
    return fault_.keep(undefined_at(id, a));
  }
  number(op.result) = *value;
  return true;
}

bool StepMachine::store(const VariableView& into, std::size_t element, double value) {
  auto wrong = operands_.store(into, element, value);
  return !wrong || fault_.keep(*std::move(wrong));
}

/// result = result * size + a, when a is an index of that dimension.
bool StepMachine::index(const Op& op) {
  const Variable& known = stack_.level().program->variables[static_cast<std::size_t>(op.b.place)];
  const Shape shape =
      known.storage == Storage::Reference ? variable(op.b.place).shape : known.shape;
  const double place = rounded(number(op.a));
  const int size = shape.size[op.detail];
  if (!(place >= 0.0 && place < size)) {
    return fault_.keep(no_such_index(known, op.detail, place, size));
  }
  double& result = number(op.result);
  result = result * size + place;
  return true;
}

bool StepMachine::array_step(const Op& op) {
  switch (static_cast<ArrayStep>(op.code)) {
    case ArrayStep::Index:
      return index(op);
    case ArrayStep::Load:
      number(op.result) =
          operands_.loaded(variable(op.b.place), static_cast<std::size_t>(number(op.a)));
      return true;
    case ArrayStep::Store:
      return store(variable(op.b.place), static_cast<std::size_t>(number(op.a)), number(op.result));
    case ArrayStep::Fill:
      return fill(op);
    case ArrayStep::Repeat:
      return repeat_value(op);
  }
  contract_violated("other_step() lets only these through", __FILE__, __LINE__);
}

}  // namespace g31::sinumerik

#include "interpreter/dialects/fanuc/code/compile_expression.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/code/value_limits.h"
#include "interpreter/dialects/fanuc/vocabulary/functions.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using syntax::Expr;
using syntax::ExprKind;
using syntax::Index;
using syntax::kNone;
using syntax::Operator;

/// Numbers of so many digits are taken by every control; the run judges longer ones (MB-027).
constexpr int kDigitsOfEveryControl = 8;

bool is_comparison(const Expr& expr) {
  return expr.kind == ExprKind::Binary && is_comparison(operation_of(expr.op));
}

/// AND, OR, XOR, && or ||, which may join conditions.
bool is_junction(const Expr& expr) {
  const bool is_word =
      expr.kind == ExprKind::Binary &&
      (expr.op == Operator::And || expr.op == Operator::Or || expr.op == Operator::Xor);
  return is_word || expr.kind == ExprKind::Logic;
}

}  // namespace

std::int32_t literal_variable(const Expr& number) {
  return written_variable(number.number);
}

std::optional<ExpressionCompiler::Misuse> ExpressionCompiler::take_misuse() {
  return std::exchange(misuse_, std::nullopt);
}

void ExpressionCompiler::misused(AlarmId id, syntax::ShortSpan where, std::string message) {
  if (!misuse_) {
    misuse_ = Misuse{id, where, std::move(message)};
  }
}

Index ExpressionCompiler::finish(Index begin, Operand result, syntax::ShortSpan span) {
  Op end;
  end.code = OpCode::End;
  end.a = result;
  push(end, 0, span);
  temporaries_ = 0;
  return begin;
}

Index ExpressionCompiler::value(Index expr) {
  const auto begin = static_cast<Index>(out_.ops.size());
  return finish(begin, emit(expr), tree_.exprs[expr].span);
}

Index ExpressionCompiler::condition(Index expr) {
  const auto begin = static_cast<Index>(out_.ops.size());
  const syntax::ShortSpan span = tree_.exprs[expr].span;
  if (!is_condition(expr) && profile_.conditions_are_numbers) {
    return finish(begin, emit(expr), span);
  }
  if (!is_condition(expr)) {
    misused(AlarmId::StatementFormat, span,
            "a condition compares two values with EQ NE GT LT GE or LE");
    return begin;
  }
  return finish(begin, emit_condition(expr), span);
}

Index ExpressionCompiler::target_number(const Expr& variable) {
  const auto begin = static_cast<Index>(out_.ops.size());
  const Operand number = variable.kind == ExprKind::Name ? emit_name(variable) : emit(variable.a);
  return finish(begin, number, variable.span);
}

/// Appends an operation; its result is temporary `result`, which frees those behind it.
Operand ExpressionCompiler::push(Op op, std::size_t result, syntax::ShortSpan span) {
  G31_EXPECTS(result < kTemporaryCount);
  op.result = static_cast<std::uint8_t>(result);
  op.is_missing = !has_operation(op, profile_.functions);
  out_.ops.push_back(op);
  out_.op_spans.push_back(span);
  temporaries_ = result + 1;
  return {Bank::Temporaries, static_cast<std::int32_t>(result)};
}

Operand ExpressionCompiler::constant(double number) {
  out_.constants.emplace_back(number);
  return {Bank::Constants, static_cast<std::int32_t>(out_.constants.size() - 1)};
}

std::int32_t ExpressionCompiler::written_number(const Expr& number) {
  const bool has_decimals = number.number != std::floor(number.number);
  const auto is_in_brackets = [&] { return out_.file->text()[number.span.begin] == '['; };
  if (has_decimals && !may_have_part(number.number) && !is_in_brackets()) {
    misused(AlarmId::ExpressionFormat, number.span,
            "the number of a variable has no decimals: a product needs its *, as in #100*.5");
  }
  return literal_variable(number);
}

Operand ExpressionCompiler::emit_variable(const Expr& expr) {
  const Expr& number = tree_.exprs[expr.a];
  const std::size_t result = temporaries_;
  Op op;
  op.code = OpCode::Read;
  if (number.kind == ExprKind::Number) {
    const std::int32_t variable = written_number(number);
    if (variable == 0) {
      return {};
    }
    if (is_local(variable) || is_common(variable)) {
      return {is_local(variable) ? Bank::Locals : Bank::Commons, variable};
    }
    op.a = constant(variable);
  } else {
    op.a = emit(expr.a);
  }
  return push(op, result, expr.span);
}

/// The number of the variable that a name means; SETVN may give it while the program runs.
Operand ExpressionCompiler::emit_name(const Expr& expr) {
  const std::size_t result = temporaries_;
  Op op;
  op.code = OpCode::NumberOfName;
  if (expr.a != kNone) {
    op.a = emit(expr.a);
  }
  op.b = constant(static_cast<double>(out_.names.size()));
  out_.names.push_back(
      upper_case(out_.file->text().substr(expr.span.begin, expr.span.end - expr.span.begin)));
  return push(op, result, expr.span);
}

/// 1+2+3... is a tree as deep as it is long: its left side is walked in a loop, as no stack is as
/// deep as a hostile line is long.
Operand ExpressionCompiler::emit_chain(Index index) {
  std::vector<Index> chain;
  Index left = index;
  for (; tree_.exprs[left].kind == ExprKind::Binary; left = tree_.exprs[left].a) {
    chain.push_back(left);
  }
  const std::size_t result = temporaries_;
  Operand value = emit(left);
  std::ranges::reverse(chain);
  for (const Index place : chain) {
    const Expr& expr = tree_.exprs[place];
    if (is_comparison(expr) && !profile_.conditions_are_numbers) {
      misused(AlarmId::ExpressionFormat, expr.span,
              "a comparison is not a number; it may appear only in IF and WHILE");
    }
    Op op;
    op.code = operation_of(expr.op);
    op.a = value;
    op.b = emit(expr.b);
    value = push(op, result, expr.span);
  }
  return value;
}

bool ExpressionCompiler::is_condition(Index index) const {
  for (;;) {
    const Expr& expr = tree_.exprs[index];
    if (is_comparison(expr)) {
      return true;
    }
    if (!is_junction(expr) || !is_condition(expr.b)) {
      return false;
    }
    index = expr.a;
  }
}

/// Comparisons give 1 and 0, and so the bit operations join them.
Operand ExpressionCompiler::emit_condition(Index index) {
  std::vector<Index> chain;
  Index left = index;
  for (; is_junction(tree_.exprs[left]); left = tree_.exprs[left].a) {
    chain.push_back(left);
  }
  const std::size_t result = temporaries_;
  const auto compare = [&](Index place) {
    const Expr& expr = tree_.exprs[place];
    const std::size_t into = temporaries_;
    Op op;
    op.code = operation_of(expr.op);
    op.a = emit(expr.a);
    op.b = emit(expr.b);
    return push(op, into, expr.span);
  };
  Operand value = compare(left);
  std::ranges::reverse(chain);
  for (const Index place : chain) {
    const Expr& expr = tree_.exprs[place];
    if (expr.kind == ExprKind::Logic && !profile_.has_symbol_logic) {
      misused(AlarmId::ExpressionFormat, expr.span, "this control has no && and ||");
    }
    if (expr.kind == ExprKind::Binary) {
      Op check;
      check.code = OpCode::LogicSwitch;
      push(check, temporaries_, expr.span);
      --temporaries_;
    }
    Op op;
    op.code = operation_of(expr.op);
    op.a = value;
    op.b = is_junction(tree_.exprs[expr.b]) ? emit_condition(expr.b) : compare(expr.b);
    value = push(op, result, expr.span);
  }
  return value;
}

Operand ExpressionCompiler::emit_call(const Expr& expr) {
  const std::size_t result = temporaries_;
  Op op;
  op.function = expr.function;
  op.a = emit(expr.a);
  if (expr.c != kNone) {
    Op of_axis;
    of_axis.code = OpCode::AxisParameter;
    of_axis.a = op.a;
    of_axis.b = emit(expr.c);
    const Operand value = push(of_axis, temporaries_, expr.span);
    if (expr.b == kNone) {
      return value;
    }
  }
  const bool is_listed = expr.b != kNone && expr.op != Operator::Divide;
  if (is_listed && !profile_.has_series_30i_functions() &&
      info(static_cast<FunctionId>(expr.function)).arguments == Arguments::OneOrTwo) {
    misused(AlarmId::ExpressionFormat, expr.span, "this control takes ATAN[y]/[x], no comma");
  }
  op.code = expr.b != kNone ? OpCode::CallOfTwo : OpCode::Call;
  if (expr.b != kNone) {
    op.b = emit(expr.b);
  }
  return push(op, result, expr.span);
}

Operand ExpressionCompiler::emit(Index index) {
  const Expr& expr = tree_.exprs[index];
  const std::size_t result = temporaries_;
  Op op;
  switch (expr.kind) {
    case ExprKind::Number:
      if (expr.digits > kDigitsOfEveryControl) {
        op.code = OpCode::DigitLimit;
        op.function = expr.digits;
        push(op, result, expr.span);
        temporaries_ = result;
      }
      return constant(expr.number);
    case ExprKind::Variable:
      return emit_variable(expr);
    case ExprKind::Name:
      op.code = OpCode::Read;
      op.a = emit_name(expr);
      return push(op, result, expr.span);
    case ExprKind::Negate:
      op.code = OpCode::Negate;
      op.a = emit(expr.a);
      return push(op, result, expr.span);
    case ExprKind::Binary:
      return emit_chain(index);
    case ExprKind::Logic:
      misused(AlarmId::ExpressionFormat, expr.span,
              "&& and || join conditions of IF and WHILE only");
      return {};
    case ExprKind::Call:
      return emit_call(expr);
  }
  contract_violated("every kind of expression is emitted", __FILE__, __LINE__);
}

}  // namespace g31::fanuc

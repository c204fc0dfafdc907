#pragma once

#include <utility>

#include "interpreter/dialects/sinumerik/code/block_part.h"

namespace g31::sinumerik {

/// What operators make of their operands, and values of one type of those of another.
class Operations : private BlockPart {
 public:
  /// All outlive them.
  explicit Operations(const BlockWork& work) : BlockPart(work) {}

  Expr constant(Type type, double value, ShortSpan where);
  /// @param row  of operators.def
  Expr combine(int row, Expr left, Expr right);
  /// - NOT B_NOT
  Expr inverted(const Token& token, Expr operand);
  Expr compare(OpCode code, Expr left, Expr right, ShortSpan where);
  Expr concatenate(Expr left, Expr right, ShortSpan where);
  Expr arithmetic(OpCode code, Expr left, Expr right, ShortSpan where);
  /// Alarm 14051 where an INT that was worked out has left them.
  void keep_to_32_bits(const Expr& whole);

  /// A whole array is an argument and nothing else: its alarm where a value is wanted.
  void expect_value(const Expr& expr);
  Expr convert(Expr from, Type to, AlarmId mismatch = AlarmId::WrongType);
  Expr boolean(Expr from) { return convert(std::move(from), Type::Bool); }
  /// What << makes of an operand.
  Expr as_text(Expr from);

 private:
  void narrow(Expr& value, Type from);
};

}  // namespace g31::sinumerik

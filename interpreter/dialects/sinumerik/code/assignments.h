#pragma once

#include <cstdint>

#include "interpreter/dialects/sinumerik/code/expressions.h"

namespace g31::sinumerik {

/// Values for variables, their elements, characters and components, and for system variables.
class Assignments : private BlockPart {
 public:
  /// All outlive them.
  Assignments(const BlockWork& work, KnownVariables& variables, Expressions& expressions)
      : BlockPart(work),
        variables_(variables),
        expressions_(expressions),
        operations_(expressions.operations()),
        accesses_(expressions.accesses()) {}

  /// What stands behind a variable's name: an element, = and values.
  void assign_variable(std::int32_t variable, ShortSpan where);
  void assign_system(const SystemName& name, ShortSpan where);
  /// A variable that takes a value: as a whole, until an element is named.
  [[nodiscard]] Expr target_of(std::int32_t variable, ShortSpan where) const;
  /// What stands behind `=`: a value, or a list for an array from this element on.
  void assign_element(const Expr& target);
  void assign_list(const Expr& target);
  /// target = value, converted.
  void store(const Expr& target, Expr value);
  /// Goes on at the next assignment to system data in the block, or at its end.
  void pass_over(const Token& datum);

  [[nodiscard]] Expressions& expressions() { return expressions_; }

 private:
  [[nodiscard]] bool looks_like_list() const;
  void repeat_value(const Expr& target);
  void assign_component(const Expr& frame);
  void assign_character(const Expr& target);
  /// What an assignment is of.
  enum class Reach { Element, Array };
  void check_value(const Expr& target, Operand value, Reach reach);

  KnownVariables& variables_;
  Expressions& expressions_;
  Operations& operations_;
  Accesses& accesses_;
};

}  // namespace g31::sinumerik

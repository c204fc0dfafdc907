#pragma once

#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/accesses.h"
#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/code/known_variables.h"
#include "interpreter/dialects/sinumerik/code/operations.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {

/// Reads expressions and writes the steps that compute them.
class Expressions : private BlockPart {
 public:
  /// All outlive them.
  Expressions(const BlockWork& work, KnownVariables& variables, const Globals& globals,
              Purpose purpose)
      : BlockPart(work),
        variables_(variables),
        globals_(globals),
        purpose_(purpose),
        operations_(work),
        accesses_(work, operations_, *this) {}

  /// @param level  of operators.def: closer operators belong to it
  Expr expression(int level = 0);
  /// Without operators of two operands.
  Expr unary();
  Expr primary();
  /// An argument of a function or procedure.  @param kind  see functions.def
  void function_argument(char kind, std::vector<Argument>& list);

  [[nodiscard]] Operations& operations() { return operations_; }
  [[nodiscard]] Accesses& accesses() { return accesses_; }

 private:
  Expr text_literal(const Token& token);
  Expr name_in_expression();
  Expr letter_in_expression();
  Expr axis_of_data(const Token& name);
  Expr call_function(FunctionId id, ShortSpan where);
  Expr plain_mathematics(FunctionId id, ShortSpan where);

  KnownVariables& variables_;
  const Globals& globals_;
  Purpose purpose_;
  Operations operations_;
  Accesses accesses_;
  int depth_ = 0;  ///< of brackets and signs
};

/// Whether an argument is the variable that its parameter wants; see functions.def and
/// procedures.def.
bool is_taken_by(char kind, const Argument& argument);

}  // namespace g31::sinumerik

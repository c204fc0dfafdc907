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
  /// Those of a function, a procedure or RET, behind the opening bracket and with the closing one.
  /// @param parameters  see functions.def and procedures.def
  std::vector<Argument> arguments(std::string_view parameters, std::string_view name);

  [[nodiscard]] Operations& operations() { return operations_; }
  [[nodiscard]] Accesses& accesses() { return accesses_; }

 private:
  Expr text_literal(const Token& token);
  Expr name_in_expression();
  Expr letter_in_expression();
  Expr axis_of_data(const Token& name);
  Argument argument(char kind);
  Expr call_function(FunctionId id, ShortSpan where);
  Expr plain_mathematics(FunctionId id, ShortSpan where);

  KnownVariables& variables_;
  const Globals& globals_;
  Purpose purpose_;
  Operations operations_;
  Accesses accesses_;
  int depth_ = 0;  ///< of brackets and signs
};

/// Whether a list may end before a parameter.  @param kind  see functions.def and procedures.def
bool may_be_missing(char kind);

}  // namespace g31::sinumerik

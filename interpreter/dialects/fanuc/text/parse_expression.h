#pragma once

#include <optional>
#include <string>

#include "interpreter/dialects/fanuc/text/scanner.h"
#include "interpreter/dialects/fanuc/vocabulary/alarms.h"
#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

/// Reads expressions of Macro B (grammar MB-040) into a tree.
///
/// Precedence: functions; * / AND MOD; + - OR XOR; comparisons.  Equal precedence binds to the
/// left.
class ExpressionParser {
 public:
  ExpressionParser(Scanner& scanner, syntax::Tree& tree) : scanner_(scanner), tree_(tree) {}

  /// The expression that begins here; kNone after an error, which is then in error().
  syntax::Index expression();

  /// The expression that goes on behind its first operand: `+10` of `#1+10`; kNone after an error.
  syntax::Index continued(syntax::Index first);

  /// `[expression]`; kNone after an error.
  syntax::Index bracketed();

  /// `#digits`, `#[expression]`; kNone after an error.  The scanner stands on `#`.
  syntax::Index variable();

  /// Whether `[#NAME` begins here.
  bool at_name();

  /// `[#NAME]`, `[#NAME[index]]`; kNone after an error.  @pre at_name()
  syntax::Index named_variable();

  /// Adds a node.
  syntax::Index add(const syntax::Expr& expr);

  [[nodiscard]] const std::optional<syntax::SyntaxError>& error() const { return error_; }
  void forget_error() {
    error_.reset();
    depth_ = 0;
  }

  /// Notes an error at the cursor (the first one stays) and returns kNone.
  syntax::Index fail(AlarmId id, std::string message);
  syntax::Index fail_at(AlarmId id, syntax::ShortSpan where, std::string message);

 private:
  syntax::Index comparison_from(syntax::Index left);
  syntax::Index sum();
  syntax::Index sum_from(syntax::Index left);
  syntax::Index product();
  syntax::Index product_from(syntax::Index left);
  syntax::Index operand();
  syntax::Index primary();
  syntax::Index function();
  syntax::Index number();
  syntax::Index binary(syntax::Operator op, syntax::Index a, syntax::Index b);
  bool open_bracket();
  bool close_bracket(std::uint32_t opened_at);

  Scanner& scanner_;
  syntax::Tree& tree_;
  int depth_ = 0;
  std::optional<syntax::SyntaxError> error_;
};

}  // namespace g31::fanuc

#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"

namespace g31::fanuc {

/// Turns expression trees into the code of one program.
class ExpressionCompiler {
 public:
  /// What is wrong with an expression although it could be read.
  struct Misuse {
    AlarmId id;
    syntax::ShortSpan where;
    std::string message;
  };

  /// All of them must outlive the compiler.
  ExpressionCompiler(const syntax::Tree& tree, const Profile& profile, CompiledProgram& out)
      : tree_(tree), profile_(profile), out_(out) {}

  /// Appends the code of an expression.  @returns where it begins
  syntax::Index value(syntax::Index expr);

  /// Appends the code of what IF and WHILE ask for: a comparison, or several joined (MB-075).
  syntax::Index condition(syntax::Index expr);

  /// The number of a variable that is written as one (MB-040).
  std::int32_t written_number(const syntax::Expr& number);

  /// Appends the code of the number of the variable that an assignment sets: `#[expr]`, `[#NAME]`.
  syntax::Index target_number(const syntax::Expr& variable);

  /// The first misuse since the last call.
  std::optional<Misuse> take_misuse();

 private:
  syntax::Index finish(syntax::Index begin, Operand result, syntax::ShortSpan span);
  Operand emit(syntax::Index expr);
  Operand emit_chain(syntax::Index index);
  Operand emit_variable(const syntax::Expr& expr);
  Operand emit_name(const syntax::Expr& expr);
  Operand emit_call(const syntax::Expr& expr);
  Operand emit_condition(syntax::Index index);
  [[nodiscard]] bool is_condition(syntax::Index index) const;
  Operand constant(double number);
  Operand push(Op op, std::size_t result, syntax::ShortSpan span);
  void misused(AlarmId id, syntax::ShortSpan where, std::string message);

  const syntax::Tree& tree_;
  const Profile& profile_;
  CompiledProgram& out_;
  std::optional<Misuse> misuse_;
  std::size_t temporaries_ = 0;  ///< how many hold results that are still to be used
};

/// #12 and #[12.5]: the number of the variable, rounded as a computed one is (MB-099).
std::int32_t literal_variable(const syntax::Expr& number);

}  // namespace g31::fanuc

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"

namespace g31::study {

/// A result of a run: a variable of the control, or what is computed from several.
///
/// `#160 - #161`, `SQRT[#110*#110 + #125*#125]`, `(#164 + #179)/2`, `_OVR[4] - R10`: + - * / with
/// their usual ranks, round or square brackets, the functions of result_functions.def.  Behind the
/// name of a variable square brackets are its indices.
class Expression {
 public:
  /// Error: what is wrong, with its place in the text counted from 1.
  static Result<Expression, std::string> parse(std::string_view text);

  /// The variables it reads, each once.
  [[nodiscard]] const std::vector<std::string>& variables() const { return variables_; }

  /// Its value; nullopt when a variable is vacant or the result is no finite number.
  /// @param values  of variables(), in that order
  [[nodiscard]] std::optional<double> value(const std::vector<std::optional<double>>& values) const;

 private:
  friend class ExpressionParser;

  enum class Kind {
    Number,
    Variable,
    Add,
    Subtract,
    Multiply,
    Divide,
    Negate,
#define RESULT_FUNCTION(name, arguments, text) name,
#include "tools/study/result_functions.def"
#undef RESULT_FUNCTION
  };
  /// One step of a stack machine.
  struct Step {
    Kind kind = Kind::Number;
    double number = 0.0;       ///< of Number
    std::size_t variable = 0;  ///< of Variable: which one
  };

  static bool takes_one(Kind kind);
  static double of_one(Kind kind, double a);
  static double of_two(Kind kind, double a, double b);

  std::vector<Step> steps_;
  std::vector<std::string> variables_;
};

}  // namespace g31::study

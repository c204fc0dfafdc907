#pragma once

#include <array>
#include <optional>
#include <string>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/code/value_limits.h"
#include "interpreter/dialects/fanuc/state/variables.h"
#include "interpreter/dialects/fanuc/vocabulary/functions.h"
#include "interpreter/dialects/fanuc/vocabulary/parameters.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/runtime/missed_touches.h"

namespace g31::fanuc {

/// Parameters that change what an expression means.
struct EvaluationRules {
  double largest_result = 1e47;
  double smallest_result = 1e-29;
  int digit_limit = 12;                    ///< digits of a number (MB-027)
  bool signed_angles = false;              ///< 6004.0 NAT: ATAN -180..180
  bool has_signed_arc_sine = false;        ///< the same: ASIN -90..90
  bool clear_small_sines = false;          ///< 6004.1 MFZ: SIN COS TAN up to 1e-8 become 0
  bool joins_conditions = false;           ///< 6006.0 MLG: AND OR XOR between comparisons
  const Parameters* parameters = nullptr;  ///< what PRM reads
  const std::string* axes = nullptr;       ///< the letters of the controlled axes, as PRM counts
  LogicOperands logic_operands = LogicOperands::Round;
};

/// Why an expression has no value.
struct EvaluationFault {
  AlarmId id = AlarmId::ExpressionFormat;
  syntax::ShortSpan where;
  std::string detail;
};

/// Runs the code of expressions.
class Evaluator {
 public:
  /// @param missed  hears what expressions read while a skip move is unsettled
  Evaluator(const Variables& own, AllVariables& all, runtime::MissedTouches& missed,
            const EvaluationRules& rules)
      : variables_(own), all_variables_(all), missed_(missed), rules_(rules) {}

  /// The value of the expression whose code begins at `code`; vacant after a fault, which is then
  /// in fault().
  /// @param round_to  what ROUND rounds to: 1 in statements, the least increment in a word (MB-061)
  Cell evaluate(const CompiledProgram& program, syntax::Index code, double round_to = 1.0);

  /// The same for a statement that does something with the value.
  Cell value(const CompiledProgram& program, syntax::Index code, double round_to = 1.0);

  /// The truth of a condition; false after a fault.
  bool condition(const CompiledProgram& program, syntax::Index code);

  /// The fault of the last evaluation, taken out.
  std::optional<EvaluationFault> take_fault();
  [[nodiscard]] bool failed() const { return fault_.has_value(); }

  void set_rules(const EvaluationRules& rules) { rules_ = rules; }
  [[nodiscard]] double largest_result() const { return rules_.largest_result; }

 private:
  Cell rare_operation(const CompiledProgram& program, const Op& op, Cell a, Cell b,
                      double round_to);
  Cell arithmetic_of_vacant(OpCode code, Cell a, Cell b);
  [[nodiscard]] bool is_in_range(double result) const;
  Cell in_range(double result);
  Cell integer_operation(OpCode op, double a, double b);
  Cell function(const Op& op, double argument, double round_to);
  Cell trigonometric(FunctionId id, double argument);
  Cell rounding_function(FunctionId id, double argument, double round_to);
  Cell function_of_two(const Op& op, double a, double b);
  Cell read(std::int32_t number);
  template <typename Listener>
  Cell evaluate_heard(const CompiledProgram& program, syntax::Index code, double round_to,
                      Listener& listener);
  Cell number_of_name(const std::string& name, Cell index);
  Cell parameter(double number, std::optional<double> bit);
  Cell axis_parameter(double number, double axis);
  Cell at(const CompiledProgram& program, const Op& op);
  Cell fail(AlarmId id, std::string detail);
  Cell fail(WrongValue wrong);

  const Variables& variables_;
  AllVariables& all_variables_;
  runtime::MissedTouches& missed_;
  EvaluationRules rules_;
  std::array<Cell, kTemporaryCount> temporaries_;
  std::optional<EvaluationFault> fault_;
};

}  // namespace g31::fanuc

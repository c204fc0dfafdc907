#include "interpreter/analysis/mixed_comparisons.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string_view>

#include "interpreter/dialects/sinumerik/vocabulary/operators.h"

namespace g31::analysis {
namespace {

using sinumerik::Bank;
using sinumerik::Op;
using sinumerik::OpCode;
using sinumerik::Operand;
using sinumerik::OperatorKind;

/// What a temporary value came out of.
enum class Origin : std::uint8_t {
  Other,
  Logic,            ///< AND, OR, XOR
  LogicOfNumber,    ///< the same of a written number, which nobody means: 2 AND SWITCH
  Not,              ///< NOT
  ComparedToLogic,  ///< a comparison with a value of AND, OR or XOR on its right
};

bool is_of(OpCode code, OperatorKind kind) {
  const auto rows = sinumerik::operators();
  const auto row = std::ranges::find(rows, code, &sinumerik::OperatorInfo::code);
  return row != rows.end() && row->kind == kind;
}

bool is_logic(OpCode code) {
  return is_of(code, OperatorKind::Logic);
}

bool is_comparison(OpCode code) {
  return is_of(code, OperatorKind::Comparison);
}

bool is_no_truth(double number) {
  return number != 0.0 && number != 1.0;
}

class Origins {
 public:
  explicit Origins(const sinumerik::CompiledProgram& program) : program_(program) {}

  void forget() { of_temporaries_ = {}; }

  [[nodiscard]] Origin of(Operand operand) const {
    return operand.bank == Bank::Temporaries
               ? of_temporaries_.at(static_cast<std::size_t>(operand.place))
               : Origin::Other;
  }

  void take(const Op& step, std::int32_t index) {
    if (step.result.bank == Bank::Temporaries) {
      of_temporaries_.at(static_cast<std::size_t>(step.result.place)) = origin_of(step, index);
    }
  }

  /// Whether a comparison most likely is to hold before what is on one of its sides is joined.
  [[nodiscard]] bool is_mixed(const Op& comparison) const {
    return of(comparison.a) == Origin::ComparedToLogic || is_mixed(comparison.a, comparison.b) ||
           is_mixed(comparison.b, comparison.a);
  }

 private:
  [[nodiscard]] bool is_mixed(Operand joined, Operand other) const {
    const Origin origin = of(joined);
    return origin == Origin::LogicOfNumber ||
           ((origin == Origin::Logic || origin == Origin::Not) && is_number(other));
  }

  /// A written number that is no truth.
  [[nodiscard]] bool is_number(Operand operand) const {
    return operand.bank == Bank::Constants &&
           is_no_truth(program_.constants[static_cast<std::size_t>(operand.place)]);
  }

  /// Whether such a number stands first in the text of a step, which knows it as a truth.
  [[nodiscard]] bool begins_with_number(std::int32_t step) const {
    const syntax::ShortSpan where = program_.spans[static_cast<std::size_t>(step)];
    const std::string_view text =
        program_.file->text().substr(where.begin, where.end - where.begin);
    double number = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return is_no_truth(number);
  }

  [[nodiscard]] Origin origin_of(const Op& step, std::int32_t index) const {
    if (is_logic(step.code)) {
      return begins_with_number(index) ? Origin::LogicOfNumber : Origin::Logic;
    }
    if (is_comparison(step.code)) {
      const Origin right = of(step.b);
      return right == Origin::Logic || right == Origin::LogicOfNumber ? Origin::ComparedToLogic
                                                                      : Origin::Other;
    }
    return step.code == OpCode::Not ? Origin::Not : Origin::Other;
  }

  const sinumerik::CompiledProgram& program_;
  std::array<Origin, sinumerik::kTemporaryCount> of_temporaries_{};
};

}  // namespace

std::vector<std::int32_t> mixed_comparisons(const sinumerik::CompiledProgram& program) {
  std::vector<std::int32_t> found;
  Origins origins(program);
  bool is_told = false;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(program.ops.size()); ++i) {
    const Op& step = program.ops[static_cast<std::size_t>(i)];
    if (step.code == OpCode::Block) {
      origins.forget();
      is_told = false;
    }
    if (!is_told && is_comparison(step.code) && origins.is_mixed(step)) {
      found.push_back(i);
      is_told = true;
    }
    origins.take(step, i);
  }
  return found;
}

}  // namespace g31::analysis

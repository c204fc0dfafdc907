#include "interpreter/analysis/mixed_comparisons.h"

#include <algorithm>
#include <array>
#include <cstddef>

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
  ComparedToLogic,  ///< a comparison with such a value on its right
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

class Origins {
 public:
  void forget() { of_temporaries_ = {}; }

  [[nodiscard]] Origin of(Operand operand) const {
    return operand.bank == Bank::Temporaries
               ? of_temporaries_.at(static_cast<std::size_t>(operand.place))
               : Origin::Other;
  }

  void take(const Op& step) {
    if (step.result.bank != Bank::Temporaries) {
      return;
    }
    const bool compares_logic = is_comparison(step.code) && of(step.b) == Origin::Logic;
    of_temporaries_.at(static_cast<std::size_t>(step.result.place)) =
        is_logic(step.code) ? Origin::Logic
        : compares_logic    ? Origin::ComparedToLogic
                            : Origin::Other;
  }

 private:
  std::array<Origin, sinumerik::kTemporaryCount> of_temporaries_{};
};

}  // namespace

std::vector<std::int32_t> mixed_comparisons(const sinumerik::CompiledProgram& program) {
  std::vector<std::int32_t> found;
  Origins origins;
  bool is_told = false;
  for (std::size_t i = 0; i < program.ops.size(); ++i) {
    const Op& step = program.ops[i];
    if (step.code == OpCode::Block) {
      origins.forget();
      is_told = false;
    }
    if (!is_told && is_comparison(step.code) && origins.of(step.a) == Origin::ComparedToLogic) {
      found.push_back(static_cast<std::int32_t>(i));
      is_told = true;
    }
    origins.take(step);
  }
  return found;
}

}  // namespace g31::analysis

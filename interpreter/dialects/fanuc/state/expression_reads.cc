#include "interpreter/dialects/fanuc/state/expression_reads.h"

#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"

namespace g31::fanuc {

runtime::MissedTouches::Holder holder_of(std::size_t depth, std::int32_t number) {
  constexpr int kLevelShift = 32;
  const auto level = is_local(number) ? static_cast<std::uint64_t>(depth) + 1 : 0;
  return level << kLevelShift | static_cast<std::uint32_t>(number);
}

void ExpressionReads::begins(const Op& op) {
  of_a_ = reading_of(op.a);
  if (op.code == OpCode::End) {
    missed_.reads(of_a_);
  } else {
    of_b_ = reading_of(op.b);
  }
}

void ExpressionReads::ends(const Op& op, Cell a, Cell b) {
  if (!is_comparison(op.code)) {
    missed_.reads(of_a_);
    missed_.reads(of_b_);
  } else if (!a.is_vacant() && !b.is_vacant()) {
    // Whether a variable is vacant says nothing of its value.
    missed_.compares({a.raw(), of_a_}, {b.raw(), of_b_});
  }
  made_of_[op.result] = missed_.set_aside();
}

ExpressionReads::Reading ExpressionReads::reading_of(const Operand& operand) {
  if (operand.bank == Bank::Locals || operand.bank == Bank::Commons) {
    missed_.reads(holder_of(depth_, operand.place));
    return missed_.set_aside();
  }
  return operand.bank == Bank::Temporaries ? made_of_[static_cast<std::size_t>(operand.place)]
                                           : nullptr;
}

}  // namespace g31::fanuc

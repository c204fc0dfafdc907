#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/runtime/missed_touches.h"

namespace g31::fanuc {

/// A local or common variable among what keeps the result of a skip move.
/// @param depth  of the call level
runtime::MissedTouches::Holder holder_of(std::size_t depth, std::int32_t number);

/// Says what an expression reads of skip moves without a signal, operation by operation.
class ExpressionReads {
 public:
  /// @param depth  of the call level
  ExpressionReads(runtime::MissedTouches& missed, std::size_t depth)
      : missed_(missed), depth_(depth) {}

  void begins(const Op& op);
  /// What the operation itself has read, by a computed number of a variable, is known by now.
  void ends(const Op& op, Cell a, Cell b);

 private:
  using Reading = runtime::MissedTouches::Reading;

  Reading reading_of(const Operand& operand);

  runtime::MissedTouches& missed_;
  std::size_t depth_;
  Reading of_a_;
  Reading of_b_;
  std::array<Reading, kTemporaryCount> made_of_;
};

}  // namespace g31::fanuc

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::sinumerik {

/// Writes the steps of a program: one behind the other, with their constants, and with places for
/// what a block computes on its way.
class CodeWriter {
 public:
  /// @param program  outlives the writer
  explicit CodeWriter(CompiledProgram& program) : program_(program) {}

  /// A block begins: what was computed before is not needed any more.
  void begin_block(ShortSpan block);
  /// The step that its block began with.
  [[nodiscard]] std::size_t first_step() const { return first_step_; }

  /// @returns its number
  std::int32_t emit(OpCode code, Operand result, Operand a, Operand b, ShortSpan where);
  /// The step that was written last.
  Op& last() { return program_.ops.back(); }
  Op& step(std::int32_t number) { return program_.ops[static_cast<std::size_t>(number)]; }
  /// The number of the step that comes next.
  [[nodiscard]] std::int32_t here() const { return static_cast<std::int32_t>(program_.ops.size()); }
  /// Takes back the steps from this one on.
  void cut(std::size_t first_step);

  Operand number_constant(double value);
  Operand text_constant(std::string value);
  Operand error_constant(BlockError error);
  /// A place that no result of the block has taken; nullopt: there is none left.
  std::optional<Operand> temporary(Type type);

 private:
  CompiledProgram& program_;
  std::size_t first_step_ = 0;
  std::int32_t numbers_used_ = 0;
  std::int32_t texts_used_ = 0;
  std::int32_t frames_used_ = 0;
};

}  // namespace g31::sinumerik

#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "interpreter/dialects/fanuc/code/compile.h"

namespace g31::fanuc {

/// Where a program can go on behind one of its steps.
struct StepExits {
  std::array<syntax::Index, 3> listed = {};
  std::size_t count = 0;   ///< of `listed`
  bool any_label = false;  ///< any block with a sequence number: the target is known when running
  bool ends = false;       ///< M02, M30, M99, #3000: nothing behind the step follows

  /// Steps; one behind the last step is the end of the text.
  [[nodiscard]] std::span<const syntax::Index> steps() const { return {listed.data(), count}; }
};

/// Whether a step is `#3000 = ..`, which ends every run of it.
bool is_macro_alarm(const Step& step);

/// A number that stands there; nullopt: it is computed, or vacant.
std::optional<double> constant_in(const CompiledProgram& program, Operand operand);

/// What IF and WHILE find when both sides of their one comparison are numbers.
std::optional<bool> constant_condition(const CompiledProgram& program, const Step& step);

/// All ways that the program itself shows, without those that constants shut.  A jump whose target
/// is computed, or is not there, may go to any label; one of a window leads out of it where the
/// label is not behind it there.  An alarm is no way.
StepExits exits_of(const CompiledProgram& program, syntax::Index step);

}  // namespace g31::fanuc

#pragma once

#include <optional>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/code/value_limits.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"

namespace g31::analysis {

/// A value that cannot stand where it stands.
struct WrongConstant {
  fanuc::WrongValue wrong;
  syntax::ShortSpan where;
};

/// What ends every run of a step, because constants do not go where they are to go: a division by
/// 0, a function that has no value there, a variable that the control has not or does not let read
/// or write, a number with too many digits.  What parameters and the set-up sheet decide is not
/// among it.  nullopt: nothing, or only a run knows.
std::optional<WrongConstant> wrong_constant(const fanuc::CompiledProgram& program,
                                            const fanuc::Step& step, const fanuc::Profile& profile);

/// The same of L in a block that calls a program.
std::optional<WrongConstant> wrong_repeats(const syntax::Word& word);

}  // namespace g31::analysis

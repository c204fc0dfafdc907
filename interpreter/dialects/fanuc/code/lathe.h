#pragma once

#include <optional>
#include <string>

#include "interpreter/dialects/fanuc/code/compile.h"

namespace g31::fanuc {

/// Where a program shows that it was written for a lathe, and by what.
struct LatheSigns {
  syntax::ShortSpan where;  ///< of the first
  std::string what;         ///< "T0101, G96 S"
};

/// A program of the T series reads as one of the M series up to its first U, and means something
/// else: diameters, offsets in the T word, G50 S for the highest speed, G92 for a thread.  The
/// speed limit alone tells it, of the other signs two kinds, on a machine without Y one.  A tool
/// change by T and M6 in one block clears a program of those, but T0101 M6 only where Y, a plane or
/// a length offset shows a mill; weak signs count only where nothing is milled.
/// @returns nullopt: nothing speaks for a lathe
std::optional<LatheSigns> lathe_signs(const CompiledProgram& program, bool has_y = true);

}  // namespace g31::fanuc

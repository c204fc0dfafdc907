#pragma once

#include <string_view>

#include "interpreter/dialects/fanuc/vocabulary/alarms.h"
#include "interpreter/syntax/tree.h"

namespace g31::fanuc {

/// The deepest bracket nesting that the controls allow, function brackets included (MB-043).
inline constexpr int kBracketLimit = 5;

/// Where a text begins: at the beginning of its file, or behind a line end in the middle of a
/// program.
enum class TextBegins { AtFile, InProgram };

/// Reads a whole tape: `%`, O programs, blocks.
///
/// Never fails as a whole: a block that cannot be understood becomes BlockKind::Bad with its error
/// (row of alarms.def) and reading goes on with the next line, as unreachable nonsense does no harm
/// on a control either.
/// @param text shorter than 4 GiB; the tree's spans point into it
syntax::Tree parse(std::string_view text, TextBegins begins = TextBegins::AtFile);

}  // namespace g31::fanuc

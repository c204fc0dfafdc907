#pragma once

#include <span>
#include <vector>

#include "interpreter/dialects/sinumerik/text/macros.h"
#include "interpreter/dialects/sinumerik/text/scanner.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"

// What a name of the program makes of the tokens of a block before they are read.

namespace g31::sinumerik {

/// Replaces the names that DEFINE has made, once: what stands in their place is taken as it is.
/// @param tokens  of a block, the end included; stay as they are where that would be too many
/// @param seen    by the program, those that come first at the front
/// @returns whether the block is not too long for it
bool expand_macros(std::vector<Token>& tokens, std::span<const Macros* const> seen);

/// A letter that DEF or PROC took as a name is one, unless a number follows it; a letter and a
/// number are, where they are defined together.
void find_letter_names(std::vector<Token>& tokens, const NameMap<std::int32_t>& locals);

}  // namespace g31::sinumerik

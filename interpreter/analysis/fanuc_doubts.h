#pragma once

#include <vector>

#include "interpreter/analysis/fanuc_words.h"
#include "interpreter/analysis/finding.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/source/source_file.h"
#include "interpreter/syntax/tree.h"

namespace g31::analysis {

/// Words O behind others of their block: no call finds a program of such a number, and what stands
/// behind one belongs to the program before it.
std::vector<Finding> lost_heads(const source::SourceFile& file, const syntax::Tree& tree);

/// Comparisons whose two sides are different numbers, or a number and #0: they always come out the
/// same, and a # may be missing.  One of a number with itself is a loop without end by intention.
std::vector<Finding> constant_comparisons(const source::SourceFile& file, const syntax::Tree& tree);

/// Addresses that stand twice in a block, and two G codes of one group: the last one counts.  T may
/// call one tool and make another ready.  Blocks that call are left out, and those that may by the
/// sheet.
std::vector<Finding> doubled_words(const source::SourceFile& file, const syntax::Tree& tree,
                                   const fanuc::Profile& profile, const WordReading& reading);

}  // namespace g31::analysis

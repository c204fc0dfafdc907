#pragma once

#include <vector>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/source_file.h"
#include "interpreter/syntax/tree.h"

namespace g31::analysis {

/// Words O behind others of their block: no call finds a program of such a number, and what stands
/// behind one belongs to the program before it.
std::vector<Finding> lost_heads(const source::SourceFile& file, const syntax::Tree& tree);

}  // namespace g31::analysis

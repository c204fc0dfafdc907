#pragma once

#include <vector>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/source_file.h"
#include "interpreter/syntax/tree.h"

namespace g31::analysis {

/// Comments of the blocks of a tape that end with their line for want of a `)`: what stands behind
/// them there does not run, which nobody sees.
std::vector<Finding> open_comments(const source::SourceFile& file, const syntax::Tree& tree);

}  // namespace g31::analysis

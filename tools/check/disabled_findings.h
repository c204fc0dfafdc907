#pragma once

#include <span>
#include <vector>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/source_file.h"
#include "interpreter/source/source_map.h"
#include "tools/session/message_comments.h"

namespace g31::check {

/// The findings of a file without those that its comments disable, in the order of their places.
/// A comment that leaves nothing out, or names no rule, is a finding itself (NC010).
/// @param file      of the findings and the comments, known to `sources`
/// @param comments  of the file; those that disable count
std::vector<analysis::Finding> without_disabled(std::vector<analysis::Finding> found,
                                                const source::SourceFile& file,
                                                std::span<const session::MessageComment> comments,
                                                const source::SourceMap& sources);

}  // namespace g31::check

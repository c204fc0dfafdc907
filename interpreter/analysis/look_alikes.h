#pragma once

#include <optional>

#include "interpreter/analysis/flow.h"
#include "interpreter/source/source_file.h"
#include "interpreter/syntax/tree.h"

namespace g31::analysis {

/// Word processors and PDF files put other characters in the place of those that a control reads:
/// a dash where a minus is meant, a blank that does not break.  @returns the plain character in the
/// place of such a one at the beginning of a fault; nullopt: there is none
std::optional<Repair> plain_character(const source::SourceFile& file, syntax::ShortSpan fault);

}  // namespace g31::analysis

#pragma once

#include <span>
#include <string>

#include "interpreter/analysis/finding.h"

namespace g31::check {

/// The JSON text of schema `g31.check/1` (docs: the command-line contract), ending in a line break.
/// Columns count characters from 1.  Bytes that are no UTF-8 are replaced by U+FFFD.
std::string check_document(std::span<const analysis::Finding> findings);

/// One line for each finding, as GitHub turns it into an annotation: `::error file=...::message`.
std::string github_annotations(std::span<const analysis::Finding> findings);

}  // namespace g31::check

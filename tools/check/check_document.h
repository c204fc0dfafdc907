#pragma once

#include <span>
#include <string>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/source_map.h"

namespace g31::check {

/// The JSON text of schema `g31.check/1` (docs: the command-line contract), ending in a line break.
/// Columns count characters from 1.  Bytes that are no UTF-8 are replaced by U+FFFD.
/// @param unread   what is wrong with files that could not be looked at, a line each
/// @param sources  of the findings
std::string check_document(std::span<const analysis::Finding> findings,
                           std::span<const std::string> unread, const source::SourceMap& sources);

/// A document of the same schema without findings, with all rules.
std::string rules_document();

/// One line for each finding, as GitHub turns it into an annotation: `::error file=...::message`.
std::string github_annotations(std::span<const analysis::Finding> findings,
                               const source::SourceMap& sources);

}  // namespace g31::check

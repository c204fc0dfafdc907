#pragma once

#include <span>
#include <string>
#include <string_view>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/source_map.h"

namespace g31::check {

/// Findings and fixes as a log of SARIF 2.1.0 (OASIS), which code hosts and editors read.  Columns
/// count characters from 1 (`columnKind`), the end is one past.  Paths become URIs: relative ones
/// stay so, absolute ones are of the scheme file.
/// @param version  of g31
std::string sarif_log(std::span<const analysis::Finding> findings, const source::SourceMap& sources,
                      std::string_view version);

}  // namespace g31::check

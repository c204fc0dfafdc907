#pragma once

#include <string>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/source_map.h"

namespace g31::check {

/// A stretch of a program as documents tell it.  Lines count from 1, columns count characters from
/// 1, the end is one past.
struct Extent {
  std::string file;
  int line = 0;
  int column = 0;
  int end_line = 0;
  int end_column = 0;
  /// Of the first line, printable (interpreter/source/printable.h), its first 1,000 bytes.
  std::string line_text;
};

/// Where a finding stands: on one line, and never of no width.
Extent extent_of(const analysis::Finding& finding, const source::SourceMap& sources);

/// What an edit takes away: over the ends of lines where it says so.
Extent extent_of(const analysis::Edit& edit, const source::SourceMap& sources);

}  // namespace g31::check

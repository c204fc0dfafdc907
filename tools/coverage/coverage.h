#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "interpreter/analysis/program_set.h"
#include "interpreter/source/source_map.h"
#include "tools/coverage/block_counts.h"

namespace g31::coverage {

/// What ran of one file.  Lines count from 1.
struct FileCoverage {
  std::string file;                    ///< as it was opened
  std::map<int, std::uint64_t> lines;  ///< with a block: how often the first of them ran
  /// With a condition that was asked: how often it was not met, and met.
  std::map<int, std::array<std::uint64_t, 2>> conditions;
};

/// What ran of each file that has a block which ran, by file names.  Lines of no block, such as %
/// and O lines and comments, are in none.  Texts that a run makes for itself are left out.
/// @param sources   of the run
/// @param programs  of the control that ran them; gets the files
/// @param texts     of these programs
std::vector<FileCoverage> coverage_of(const BlockCounts& counts, const source::SourceMap& sources,
                                      analysis::ProgramSet& programs,
                                      const source::SourceMap& texts);

}  // namespace g31::coverage

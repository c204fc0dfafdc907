#pragma once

#include <cstdint>
#include <vector>

#include "interpreter/analysis/flow.h"
#include "interpreter/dialects/sinumerik/code/code.h"

namespace g31::analysis {

/// A block of a SINUMERIK program and where its steps lead.
struct SinumerikBlock {
  std::int32_t first_step = 0;
  syntax::ShortSpan span;
  std::vector<Edge> edges;
  std::vector<Fault> faults;
  std::vector<Call> calls;
  Leaves leaves;
  bool to_any_label = false;
};

struct SinumerikWays {
  std::vector<SinumerikBlock> blocks;
  std::vector<BlockIndex> block_of;  ///< of each step
  WrittenFiles written;
};

/// Follows the steps of a program from block to block.
SinumerikWays ways_of(const sinumerik::CompiledProgram& program);

}  // namespace g31::analysis

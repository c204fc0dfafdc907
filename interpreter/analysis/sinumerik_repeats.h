#pragma once

#include <vector>

#include "interpreter/analysis/sinumerik_ways.h"

namespace g31::analysis {

/// REPEAT runs blocks from `first` up to, not including, `end`, and goes on at `behind`.
struct RepeatedPart {
  BlockIndex first = 0;
  BlockIndex end = 0;
  BlockIndex behind = 0;
};

/// A way to the block behind a part leads through the part once more, or on behind its REPEAT,
/// while the part is being repeated.
void close_parts(const std::vector<RepeatedPart>& parts, std::vector<SinumerikBlock>& blocks);

}  // namespace g31::analysis

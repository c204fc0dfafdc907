#include "interpreter/analysis/sinumerik_repeats.h"

#include <cstddef>
#include <map>
#include <utility>

namespace g31::analysis {

void close_parts(const std::vector<RepeatedPart>& parts, std::vector<SinumerikBlock>& blocks) {
  if (parts.empty()) {
    return;
  }
  std::map<BlockIndex, std::vector<RepeatedPart>> by_end;
  for (const RepeatedPart& part : parts) {
    by_end[part.end].push_back(part);
  }
  std::vector<std::size_t> leads_from(blocks.size(), blocks.size());  // by where an edge leads
  for (std::size_t from = 0; from < blocks.size(); ++from) {
    SinumerikBlock& block = blocks[from];
    for (const Edge& edge : block.edges) {
      leads_from[edge.to] = from;
    }
    const auto add = [&](BlockIndex to) {
      if (std::exchange(leads_from[to], from) != from) {
        block.edges.push_back({to, EdgeKind::Part});
      }
    };
    for (std::size_t i = 0; i < block.edges.size(); ++i) {
      const auto ending = by_end.find(block.edges[i].to);
      if (ending == by_end.end()) {
        continue;
      }
      for (const RepeatedPart& part : ending->second) {
        add(part.first);
        add(part.behind);
      }
    }
    for (const RepeatedPart& part : parts) {
      if (block.to_any_label) {
        add(part.first);
        add(part.behind);
      }
    }
  }
}

}  // namespace g31::analysis

#include "interpreter/analysis/flow_builder.h"

#include <algorithm>

namespace g31::analysis {
namespace {

std::uint32_t count_of(const auto& list) {
  return static_cast<std::uint32_t>(list.size());
}

/// What has come to a list since its range began.
void close_range(Range& range, const auto& list) {
  range.count = count_of(list) - range.first;
}

}  // namespace

void FlowBuilder::begin_block(syntax::ShortSpan span) {
  end_block();
  Block block;
  block.span = span;
  block.edges.first = count_of(flow_.edges);
  block.faults.first = count_of(flow_.faults);
  block.calls.first = count_of(flow_.calls);
  block.accesses.first = count_of(flow_.accesses);
  block.moves.first = count_of(flow_.moves);
  flow_.blocks.push_back(block);
}

void FlowBuilder::end_block() {
  if (flow_.blocks.empty()) {
    return;
  }
  Block& block = flow_.blocks.back();
  std::ranges::stable_sort(edges_, {}, &Edge::to);
  const auto to_same = [](const Edge& a, const Edge& b) { return a.to == b.to; };
  edges_.erase(std::unique(edges_.begin(), edges_.end(), to_same), edges_.end());
  flow_.edges.insert(flow_.edges.end(), edges_.begin(), edges_.end());
  edges_.clear();
  close_range(block.edges, flow_.edges);
  close_range(block.faults, flow_.faults);
  close_range(block.calls, flow_.calls);
  close_range(block.accesses, flow_.accesses);
  close_range(block.moves, flow_.moves);
}

void FlowBuilder::access(const Variable& variable, Access access) {
  const auto [place, is_new] = variables_.try_emplace(variable, count_of(flow_.variables));
  if (is_new) {
    flow_.variables.push_back(variable);
  }
  access.variable = place->second;
  flow_.accesses.push_back(access);
}

void FlowBuilder::move(Move::Kind kind, const std::vector<AxisTarget>& axes) {
  flow_.moves.push_back({kind, {count_of(flow_.axes), count_of(axes)}});
  flow_.axes.insert(flow_.axes.end(), axes.begin(), axes.end());
}

Flow FlowBuilder::finish() {
  end_block();
  return std::move(flow_);
}

}  // namespace g31::analysis

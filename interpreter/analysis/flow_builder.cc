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
  flow_.blocks.push_back(block);
}

void FlowBuilder::end_block() {
  if (flow_.blocks.empty()) {
    return;
  }
  Block& block = flow_.blocks.back();
  std::ranges::stable_sort(edges_, {}, &Edge::to);
  const auto same = std::ranges::unique(edges_, {}, &Edge::to);
  edges_.erase(same.begin(), same.end());
  flow_.edges.insert(flow_.edges.end(), edges_.begin(), edges_.end());
  edges_.clear();
  close_range(block.edges, flow_.edges);
  close_range(block.faults, flow_.faults);
  close_range(block.calls, flow_.calls);
}

bool FlowBuilder::has_call() const {
  return flow_.calls.size() > flow_.blocks.back().calls.first;
}

Flow FlowBuilder::finish() {
  end_block();
  return std::move(flow_);
}

}  // namespace g31::analysis

#include "interpreter/analysis/flow.h"

namespace g31::analysis {
namespace {

/// Walks a flow from its first block.
class FlowWalk {
 public:
  explicit FlowWalk(const Flow& flow) : flow_(flow), reached_(flow.blocks.size(), false) {}

  std::vector<bool> run() {
    visit(0);
    while (!open_.empty()) {
      const BlockIndex index = open_.back();
      const Block& block = flow_.blocks[index];
      open_.pop_back();
      if (block.faults.count > 0) {
        visit(index + 1);
      }
      for (const Edge& edge : flow_.edges_of(block)) {
        visit(edge.to);
      }
      if (block.to_any_label && !labels_reached_) {
        labels_reached_ = true;
        for (const Label& label : flow_.labels) {
          visit(label.block);
        }
      }
    }
    return std::move(reached_);
  }

 private:
  void visit(BlockIndex block) {
    if (block < reached_.size() && !reached_[block]) {
      reached_[block] = true;
      open_.push_back(block);
    }
  }

  const Flow& flow_;
  std::vector<bool> reached_;
  std::vector<BlockIndex> open_;
  bool labels_reached_ = false;
};

}  // namespace

std::vector<bool> reached_blocks(const Flow& flow) {
  return FlowWalk(flow).run();
}

}  // namespace g31::analysis

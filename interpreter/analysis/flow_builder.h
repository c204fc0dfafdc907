#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/analysis/flow.h"

namespace g31::analysis {

/// Writes the flat lists of a Flow block by block, in the order of the text.
class FlowBuilder {
 public:
  FlowBuilder(std::string program, const source::SourceFile& file) {
    flow_.program = std::move(program);
    flow_.file = &file;
  }

  /// What follows belongs to a new block.
  void begin_block(syntax::ShortSpan span);
  /// The block that was begun last.
  Block& block() { return flow_.blocks.back(); }
  /// Which of them it is.
  [[nodiscard]] BlockIndex index() const {
    return static_cast<BlockIndex>(flow_.blocks.size() - 1);
  }
  /// The block may be followed by another one, which may stand behind the last one that there will
  /// be.  Of several edges to one block the first counts.
  void edge(BlockIndex to, EdgeKind kind) { edges_.push_back({to, kind}); }
  void fault(Fault fault) { flow_.faults.push_back(std::move(fault)); }
  void call(Call call) { flow_.calls.push_back(std::move(call)); }
  /// @param access  its variable is told by the first parameter
  void access(const Variable& variable, Access access);
  void move(Move::Kind kind, const std::vector<AxisTarget>& axes);
  void label(std::string name) { flow_.labels.push_back({std::move(name), index()}); }

  void writes(WrittenFiles files) { flow_.written = std::move(files); }

  /// The last block is whole, too.
  Flow finish();

 private:
  void end_block();

  Flow flow_;
  std::vector<Edge> edges_;  ///< of the present block, as they come
  std::map<Variable, std::uint32_t> variables_;
};

}  // namespace g31::analysis

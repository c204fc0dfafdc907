#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace g31::syntax {

/// The loops and branches of a compiled program: stretches of steps, each within another one or
/// beside it.
class NestedSteps {
 public:
  using Step = std::int32_t;

  /// Steps rise from call to call, those of close() among them.
  /// @param begin  step of the block that says under which condition the blocks behind it run
  void open(Step begin) {
    open_.push_back(static_cast<Which>(stretches_.size()));
    stretches_.push_back({begin, begin, innermost_});
    change(begin + 1, open_.back());
  }
  /// The stretch that was opened last and is not closed yet.
  /// @param end  one past its last step
  /// @pre there is one
  void close(Step end) {
    Stretch& stretch = stretches_[static_cast<std::size_t>(open_.back())];
    stretch.end = end;
    open_.pop_back();
    change(end, stretch.outer);
  }
  /// No more will come.  What was never closed is none.
  void finish() {
    for (Stretch& stretch : stretches_) {
      stretch.outer = closed(stretch.outer);
    }
  }

  /// Whether a jump goes into a stretch that it is not in; to the block that begins one it may go.
  /// @pre finish() has been called
  [[nodiscard]] bool enters(Step from, Step to) const {
    const auto behind = std::ranges::upper_bound(changes_, to, {}, &Change::step);
    const Which inner = behind == changes_.begin() ? kNone : closed((behind - 1)->innermost);
    if (inner == kNone) {
      return false;
    }
    const Stretch& stretch = stretches_[static_cast<std::size_t>(inner)];
    return from < stretch.begin || from >= stretch.end;
  }

 private:
  using Which = std::int32_t;  ///< of stretches_
  static constexpr Which kNone = -1;
  struct Stretch {
    Step begin = 0;
    Step end = 0;  ///< begin: not closed
    Which outer = kNone;
  };
  /// From a step on this stretch is the innermost.
  struct Change {
    Step step = 0;
    Which innermost = kNone;
  };

  void change(Step step, Which innermost) {
    innermost_ = innermost;
    changes_.push_back({step, innermost});
  }
  /// The innermost of those around that were closed; its outer one is right already.
  [[nodiscard]] Which closed(Which which) const {
    const bool is_open = which != kNone && stretches_[static_cast<std::size_t>(which)].begin ==
                                               stretches_[static_cast<std::size_t>(which)].end;
    return is_open ? stretches_[static_cast<std::size_t>(which)].outer : which;
  }

  std::vector<Stretch> stretches_;  ///< in the order of their begins
  std::vector<Change> changes_;     ///< rising
  std::vector<Which> open_;
  Which innermost_ = kNone;
};

}  // namespace g31::syntax

#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

#include "interpreter/runtime/outcome.h"

namespace g31::runtime {

/// Counts what a run does and says when its budget is spent.
///
/// The clock is read at every kBlocksPerLook-th block and every kWorkPerLook-th piece of work, so
/// that asking costs a comparison.  Wall time is overrun by what happens between two looks.
class BudgetWatch {
 public:
  enum class Spent { Blocks, Time };

  /// Time runs from here on.
  explicit BudgetWatch(const Budget& budget) : budget_(budget), started_(Clock::now()) {}

  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }

  /// Counts the next block; or says why it may not run.
  std::optional<Spent> next_block() {
    if (blocks_ >= next_look_) [[unlikely]] {
      if (blocks_ >= budget_.blocks) {
        return Spent::Blocks;
      }
      if (is_time_up()) {
        return Spent::Time;
      }
      next_look_ = std::min(blocks_ + kBlocksPerLook, budget_.blocks);
    }
    ++blocks_;
    return std::nullopt;
  }

  /// To be asked before each move within a block, and before each block that may move: work that
  /// can take a millisecond.  @returns whether there is no time left for it
  bool is_too_late() { return ++work_ % kWorkPerLook == 0 && is_time_up(); }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::uint64_t kBlocksPerLook = 8192;
  static constexpr std::uint64_t kWorkPerLook = 128;

  [[nodiscard]] bool is_time_up() const {
    const std::chrono::duration<double> passed = Clock::now() - started_;
    return passed.count() > budget_.wall_seconds;
  }

  Budget budget_;
  Clock::time_point started_;
  std::uint64_t blocks_ = 0;
  std::uint64_t next_look_ = 0;  ///< at which block the budget is judged again
  std::uint64_t work_ = 0;
};

}  // namespace g31::runtime

#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "interpreter/runtime/block_listener.h"
#include "interpreter/runtime/outcome.h"

namespace g31::runtime {

/// Stands where every block of a program begins: counts it, says when the budget of the run is
/// spent, and tells the listener of the block.
///
/// Without a listener a block costs one comparison: the clock is read at every kBlocksPerLook-th
/// block and every kWorkPerLook-th piece of work.  Wall time is overrun by what happens between two
/// looks; the time of a pause does not count.
class BlockWatch {
 public:
  /// Why a block does not begin now.
  enum class Halt : std::uint8_t {
    Blocks,   ///< the budget of blocks is spent
    Time,     ///< the budget of time is spent
    Paused,   ///< the listener wants a pause; the block begins when it is asked for again
    Stopped,  ///< the listener or an interruption ends the run
  };

  /// Time runs from here on.
  /// @param listener  outlives the watch; nullptr: none
  explicit BlockWatch(const Budget& budget, BlockListener* listener = nullptr)
      : budget_(budget),
        listener_(listener),
        write_listener_(listener != nullptr && listener->hears_writes() ? listener : nullptr),
        started_(Clock::now()) {}

  [[nodiscard]] std::uint64_t blocks() const { return blocks_; }

  /// What the program writes is charged there; nullptr: nowhere.
  [[nodiscard]] OutputBudget* output() const { return budget_.output; }

  /// Who is to be told of assignments; nullptr: nobody.
  [[nodiscard]] BlockListener* write_listener() const { return write_listener_; }

  /// Counts the next block where neither budget nor listener is to be asked.  @returns whether it
  /// was counted; else next_block() is to be called
  bool counts_at_once() {
    if (blocks_ >= next_look_) [[unlikely]] {
      return false;
    }
    ++blocks_;
    return true;
  }

  /// Counts the next block; or says why it may not begin.
  /// @param place_of  () -> BlockPlace, but for its number; called for a listener only
  template <typename PlaceOf>
  std::optional<Halt> next_block(PlaceOf&& place_of) {
    if (counts_at_once()) {
      return std::nullopt;
    }
    if (const auto spent = spent_budget()) {
      return spent;
    }
    if (listener_ != nullptr && !std::exchange(is_heard_, false)) {
      BlockPlace place = place_of();
      place.number = blocks_ + 1;
      if (const auto halt = halt_of(listener_->on_block(place))) {
        return halt;
      }
    }
    ++blocks_;
    return std::nullopt;
  }

  /// To be asked before each move within a block, and before each block that may move: work that
  /// can take a millisecond.  @returns why it may not begin
  std::optional<Halt> before_work() {
    return ++work_ % kWorkPerLook == 0 ? look_around() : std::nullopt;
  }

  /// The block may have waited for somebody, a printer: the next one is asked for at once.
  void has_waited() { next_time_ = next_look_ = blocks_; }

  /// The run has gone down or up to another level of calls.
  /// @param name_of_program  () -> std::string; called for a listener only
  template <typename NameOfProgram>
  void level_changed(std::size_t depth, NameOfProgram&& name_of_program) const {
    if (listener_ != nullptr) {
      listener_->on_level(static_cast<std::uint16_t>(depth), name_of_program());
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::uint64_t kBlocksPerLook = 8192;
  static constexpr std::uint64_t kWorkPerLook = 128;

  [[nodiscard]] bool is_time_up() const {
    const std::chrono::duration<double> passed = Clock::now() - started_;
    return passed.count() > budget_.wall_seconds;
  }

  [[nodiscard]] std::optional<Halt> look_around() const {
    if (is_interrupted(budget_.interruption)) {
      return Halt::Stopped;
    }
    if (budget_.progress != nullptr) {
      (*budget_.progress)(blocks_);
    }
    return is_time_up() ? std::optional(Halt::Time) : std::nullopt;
  }

  std::optional<Halt> spent_budget() {
    if (is_heard_) {
      started_ += Clock::now() - paused_;
    }
    if (blocks_ >= budget_.blocks) {
      return Halt::Blocks;
    }
    if (blocks_ >= next_time_) {
      if (const auto halt = look_around()) {
        return halt;
      }
      next_time_ = blocks_ + kBlocksPerLook;
    }
    next_look_ = listener_ != nullptr ? 0 : std::min(next_time_, budget_.blocks);
    return std::nullopt;
  }

  std::optional<Halt> halt_of(Verdict verdict) {
    switch (verdict) {
      case Verdict::Run:
        return std::nullopt;
      case Verdict::Pause:
        is_heard_ = true;
        paused_ = Clock::now();
        return Halt::Paused;
      case Verdict::Stop:
        break;
    }
    return Halt::Stopped;
  }

  Budget budget_;
  BlockListener* listener_;
  BlockListener* write_listener_;
  Clock::time_point started_;
  Clock::time_point paused_;
  bool is_heard_ = false;  ///< the listener has paused the run at the block that comes next
  std::uint64_t blocks_ = 0;
  std::uint64_t next_look_ = 0;  ///< at which block budget or listener are asked again
  std::uint64_t next_time_ = 0;  ///< at which block the clock is read again
  std::uint64_t work_ = 0;
};

}  // namespace g31::runtime

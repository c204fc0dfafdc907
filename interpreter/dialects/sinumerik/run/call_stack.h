#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/state/failure.h"
#include "interpreter/dialects/sinumerik/state/level.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/source/location.h"

namespace g31::sinumerik {

/// MCALL: the program that is called behind each block that moves.
struct ModalCall {
  const CompiledProgram* program = nullptr;
  std::vector<BoundValue> values;
  std::size_t depth = 0;  ///< of the level that said MCALL
};

/// The program levels of a run, and where in them it stands.
class CallStack {
 public:
  CallStack();

  /// The running one.
  [[nodiscard]] Level& level() const { return *levels_[depth_]; }
  /// @param which  0: the main program
  [[nodiscard]] Level& level(std::size_t which) const { return *levels_[which]; }
  [[nodiscard]] std::size_t depth() const { return depth_; }
  /// Levels that there are or have been.
  [[nodiscard]] std::size_t count() const { return levels_.size(); }
  /// Whether no further level may begin.  A text of EXECSTRING counts as one.
  [[nodiscard]] bool is_full() const;
  /// Alarm 12550 where a program names a variable of the main program although none runs, but data
  /// that are loaded.
  [[nodiscard]] MaybeFailure missing_of_main(const CompiledProgram& program) const;
  /// The level that enter() begins.
  Level& next();
  void enter();
  void leave() { --depth_; }
  /// Stands on another level for a look.  @returns the one before
  std::size_t look_at(std::size_t depth) { return std::exchange(depth_, depth); }
  /// Only the main level is left, as new.
  void reset();

  /// The step being done, of the running level.
  [[nodiscard]] std::int32_t current() const { return current_; }
  void set_current(std::int32_t step) { current_ = step; }

  /// Whether the program is through.
  [[nodiscard]] bool has_ended() const { return has_ended_; }
  void end() { has_ended_ = true; }
  /// @returns what it was before
  bool set_ended(bool ended) { return std::exchange(has_ended_, ended); }

  /// A synchronised action runs among the variables of a level: places in its own text are where
  /// it is written.
  struct ActionPlace {
    std::size_t depth = 0;
    source::Location where;
  };
  void begin_action(ActionPlace place) { action_ = place; }
  void end_action() { action_.reset(); }

  std::optional<ModalCall> modal_call;

  // What reports show of it

  /// The running block of a level, or the one in which it waits for the program that it called.
  [[nodiscard]] source::Location place_of(std::size_t which) const;
  [[nodiscard]] source::Location here() const { return place_of(depth_); }
  /// The level whose block an alarm shows.  DISPLOF hides the blocks of its program behind the
  /// call; ACTBLOCNO shows the block itself, of programs with DISPLOF that it calls, too.
  [[nodiscard]] std::size_t shown_level() const;
  /// All levels, the innermost first; none before a run.
  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const;

 private:
  static std::vector<runtime::CallSite> waiting_on(const Level& level);

  std::vector<std::unique_ptr<Level>> levels_;
  std::optional<ActionPlace> action_;
  std::uint64_t begun_ = 0;  // levels
  std::size_t depth_ = 0;
  std::int32_t current_ = 0;
  bool has_ended_ = false;
};

}  // namespace g31::sinumerik

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "interpreter/dialects/sinumerik/code/callable_programs.h"
#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/run/operands.h"

namespace g31::sinumerik {

/// The synchronised actions of a run.
class SynchronisedActions {
 public:
  /// What runs their texts among the variables of a level.
  struct Among {
    /// Whether a condition holds, or why it cannot be told.
    std::function<Result<bool, std::string>(const CompiledProgram&, std::size_t depth)> holds;
    /// @param where  the action is written: what goes wrong in its own text goes wrong there
    std::function<MaybeFailure(const CompiledProgram&, std::size_t depth,
                               const source::Location& where)>
        act;
  };

  /// All must outlive the actions.
  /// @param words  of the running block: what actions do leaves them alone
  SynchronisedActions(CallablePrograms& programs, const CallStack& stack, Operands& operands,
                      Channel& channel, BlockWords& words, Among among)
      : programs_(programs),
        stack_(stack),
        operands_(operands),
        channel_(channel),
        words_(words),
        among_(std::move(among)) {}

  /// ID=n WHEN condition DO ...: compiled among the variables of its program.
  MaybeFailure take(const Op& op);
  /// CANCEL
  void cancel(int number) { modal_.erase(number); }
  /// LOCK and UNLOCK, which stand in actions
  void set_locked(int number, bool locked);
  [[nodiscard]] bool is_acting() const { return is_acting_; }
  /// RDISABLE
  MaybeFailure disable_reading();
  /// An NC block with what synchronised actions do before and behind it.
  MaybeFailure execute(const Block& block);
  /// All are gone.
  void clear();

 private:
  struct Code {
    const CompiledProgram* condition = nullptr;
    const CompiledProgram* actions = nullptr;
  };
  struct Action {
    ActionKind kind = ActionKind::Once;
    ActionScope scope = ActionScope::NextBlock;
    bool deletes_distance = false;
    const CompiledProgram* home = nullptr;  ///< whose variables it names
    std::size_t depth = 0;                  ///< of its level
    Code code;
    source::Location where;
    bool held = false;        ///< its condition, when judged last; of FROM: ever
    bool is_through = false;  ///< WHEN that has acted
    bool is_locked = false;
  };
  [[nodiscard]] std::pair<std::string, std::string> texts_of(const Op& op) const;
  MaybeFailure act();
  MaybeFailure act_on(Action& action);
  MaybeFailure wait_to_read();
  [[nodiscard]] Result<std::size_t, Failure> level_of(const Action& action) const;

  CallablePrograms& programs_;
  const CallStack& stack_;
  Operands& operands_;
  Channel& channel_;
  BlockWords& words_;
  Among among_;
  std::vector<Action> next_;     ///< of the next block
  std::map<int, Action> modal_;  ///< by ID
  /// What they compiled, by program, condition and actions.
  std::map<std::tuple<const CompiledProgram*, std::string, std::string>, Code> codes_;
  bool is_acting_ = false;
  bool disables_reading_ = false;  ///< RDISABLE has acted when the actions were judged last
};

}  // namespace g31::sinumerik

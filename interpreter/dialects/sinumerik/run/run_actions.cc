// Synchronised actions, as far as one block at a time can be true: each is judged before and behind
// every NC block.  Source: SINUMERIK function manual Synchronized actions, 2.1 (scopes, WHEN,
// WHENEVER, FROM, EVERY) and 2.4 (actions).

#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/synchronised_actions.h"
#include "interpreter/dialects/sinumerik/text/text_format.h"

namespace g31::sinumerik {

/// The condition and the actions, with the values that variables have now.
std::pair<std::string, std::string> SynchronisedActions::texts_of(const Op& op) const {
  std::string condition;
  std::string actions;
  std::string* into = &condition;
  for (const Argument& piece : operands_.arguments_of(op)) {
    if (piece.form == Argument::Form::Omitted) {
      into = &actions;
    } else if (piece.form == Argument::Form::Whole) {
      *into += operands_.text(piece.value);
    } else {
      *into += piece.type == Type::String ? written_constant(operands_.text(piece.value))
                                          : written_constant(piece.type, operands_.number(piece));
    }
  }
  return {std::move(condition), std::move(actions)};
}

MaybeFailure SynchronisedActions::take(const Op& op) {
  constexpr std::size_t kMostTexts = 10000;
  const auto [condition, actions] = texts_of(op);
  Action action;
  action.kind = static_cast<ActionKind>(op.detail / kActionScopes);
  action.scope = static_cast<ActionScope>(op.detail % kActionScopes);
  action.deletes_distance = op.result.place != 0;
  action.home = stack_.level().program;
  action.depth = stack_.depth();
  action.where = stack_.here();
  if (codes_.size() >= kMostTexts) {
    return failure(AlarmId::TooComplex, "too many different synchronised actions");
  }
  Code& code = codes_[{action.home, condition, actions}];
  if (code.condition == nullptr) {
    code.condition = programs_.expression(condition, *action.home);
    code.actions = programs_.snippet(actions, *action.home, "synchronised action");
  }
  for (const CompiledProgram* const part : {code.condition, code.actions}) {
    if (MaybeFailure missing = stack_.missing_of_main(*part)) {
      return missing;
    }
  }
  action.code = code;
  if (action.scope == ActionScope::NextBlock) {
    next_.push_back(std::move(action));
    return std::nullopt;
  }
  const double number = operands_.number(op.a);
  if (MaybeFailure wrong = failure(wrong_action_number(number))) {
    return wrong;
  }
  modal_[static_cast<int>(number)] = std::move(action);
  return std::nullopt;
}

MaybeFailure SynchronisedActions::disable_reading() {
  if (!is_acting_) {
    return failure(outside_of_action(ProcedureId::RDISABLE));
  }
  disables_reading_ = true;
  return std::nullopt;
}

void SynchronisedActions::set_locked(int number, bool locked) {
  const auto found = modal_.find(number);
  if (found != modal_.end()) {
    found->second.is_locked = locked;
  }
}

void SynchronisedActions::clear() {
  next_.clear();
  modal_.clear();
}

/// Judges all actions; those that are through go away.
MaybeFailure SynchronisedActions::act() {
  if (is_acting_) {
    return std::nullopt;
  }
  is_acting_ = true;
  disables_reading_ = false;
  // Inputs that the sheet scripts go on with the time, without a look of the program's.
  constexpr int kNoCode = -1;
  channel_.inputs.hear(kNoCode, channel_.now());
  BlockWords words = std::exchange(words_, {});
  MaybeFailure wrong;
  for (auto at = modal_.begin(); at != modal_.end() && !wrong;) {
    wrong = act_on(at->second);
    at = at->second.is_through ? modal_.erase(at) : std::next(at);
  }
  for (Action& action : next_) {
    wrong = wrong ? wrong : act_on(action);
  }
  words_ = std::move(words);
  is_acting_ = false;
  return wrong;
}

/// The level whose variables an action names; alarm 12140 when it has gone.
Result<std::size_t, Failure> SynchronisedActions::level_of(const Action& action) const {
  const bool is_there =
      action.depth <= stack_.depth() && stack_.level(action.depth).program == action.home;
  const bool has_variables = !action.home->locals.empty();
  if (!is_there && has_variables) {
    Failure gone =
        failure(AlarmId::NotImplemented,
                "a synchronised action with local variables after the end of their program");
    gone.where = action.where;
    return gone;
  }
  return is_there ? action.depth : std::size_t{0};
}

MaybeFailure SynchronisedActions::act_on(Action& action) {
  if (action.is_through || action.is_locked) {
    return std::nullopt;
  }
  const auto depth = level_of(action);
  if (!depth) {
    return depth.error();
  }
  const auto value = among_.holds(*action.code.condition, depth.value());
  if (!value) {
    Failure wrong = failure(AlarmId::BadArguments, "condition: " + value.error());
    wrong.where = action.where;
    return wrong;
  }
  const bool holds = value.value();
  const bool held =
      std::exchange(action.held, holds || (action.kind == ActionKind::From && action.held));
  const bool acts = action.kind == ActionKind::Edge   ? holds && !held
                    : action.kind == ActionKind::From ? holds || held
                                                      : holds;
  if (!acts) {
    return std::nullopt;
  }
  action.is_through = action.kind == ActionKind::Once;
  channel_.deletes_distance = channel_.deletes_distance || action.deletes_distance;
  return among_.act(*action.code.actions, depth.value(), action.where);
}

/// RDISABLE: the axes have come to rest, and the next block waits until no action holds it any
/// more.
MaybeFailure SynchronisedActions::wait_to_read() {
  constexpr double kCycleS = 0.001;
  constexpr double kLongestWaitS = 900.0;
  MaybeFailure wrong = finish_motion(channel_);
  for (double waited_s = 0.0; !wrong && disables_reading_; waited_s += kCycleS) {
    if (const auto halt = channel_.watch.before_work()) {
      return halt_failure(*halt);
    }
    if (waited_s > kLongestWaitS) {
      return message_failure(runtime::Status::Budget, source::DiagnosticId::WaitsForOperator,
                             ", RDISABLE for a quarter of an hour");
    }
    channel_.port.dwell(kCycleS);
    wrong = act();
  }
  return wrong;
}

MaybeFailure SynchronisedActions::execute(const Block& block) {
  if (is_acting_ || (modal_.empty() && next_.empty())) {
    return execute_block(channel_, block);
  }
  channel_.action_override_percent = 100.0;
  channel_.deletes_distance = false;
  MaybeFailure wrong = act();
  wrong = wrong ? wrong : execute_block(channel_, block);
  channel_.action_override_percent = 100.0;
  channel_.deletes_distance = false;
  wrong = wrong ? wrong : act();
  wrong = wrong || !disables_reading_ ? wrong : wait_to_read();
  channel_.deletes_distance = false;
  channel_.action_override_percent = 100.0;
  next_.clear();
  return wrong;
}

}  // namespace g31::sinumerik

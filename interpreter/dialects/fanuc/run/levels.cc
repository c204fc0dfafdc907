#include "interpreter/dialects/fanuc/run/levels.h"

#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/state/expression_reads.h"

namespace g31::fanuc {

MaybeFailure Levels::enter(const Entry& entry) {
  const bool is_macro = entry.kind == CallKind::Macro;
  const CallLevels& most = control_.profile.calls;
  const int limit = is_macro ? most.macros : most.subprograms;
  const bool in_kind = stack_.count(entry.kind) < limit;
  const bool together = in_kind && static_cast<int>(stack_.frames().size()) > most.together;
  if (!in_kind || together) {
    Failure failure;
    failure.id = is_macro && !together ? AlarmId::MacroNesting : AlarmId::NestedTooDeep;
    failure.detail = together ? fmt::format("calls nest at most {} deep", most.together)
                              : fmt::format("{} nest at most {} deep",
                                            is_macro ? "macros" : "subprograms", limit);
    if (entry.program == frame().program) {
      failure.detail += fmt::format(", and {} calls itself", name_of(*entry.program));
    }
    return failure;
  }
  if (is_macro) {
    control_.variables.push_level();
  }
  Frame& level = stack_.push();
  level.program = entry.program;
  level.step = entry.first_step;
  level.first_step = entry.first_step;
  level.kind = entry.kind;
  level.by = entry.by;
  level.storage = entry.storage;
  level.repeats_left = entry.repeats - 1;
  level.modal_calls = stack_.caller().modal_calls;
  arrive();
  return std::nullopt;
}

void Levels::leave() {
  const Frame& done = frame();
  if (done.of_modal_call) {
    done.of_modal_call->locals = control_.variables.level();
  }
  if (done.kind == CallKind::Macro) {
    const std::size_t depth = control_.variables.depth();
    if (control_.touches.missed.any()) {
      control_.touches.missed.forget(holder_of(depth, kFirstLocal), holder_of(depth, kLocalCount));
    }
    control_.variables.pop_level();
  }
  stack_.pop();
  arrive();
}

void Levels::repeat() {
  Frame& now = frame();
  now.step = now.first_step;
  for (const std::size_t depth : {stack_.depth() - 1, stack_.depth()}) {
    control_.outlet.calls_changed();
    control_.watch.level_changed(depth, [&] { return name_of(*now.program); });
  }
}

/// Another program runs from now on.
void Levels::arrive() {
  control_.modal.word('O') = frame().program->key.number;
  control_.outlet.calls_changed();
  control_.watch.level_changed(stack_.depth(), [&] { return name_of(*frame().program); });
}

}  // namespace g31::fanuc

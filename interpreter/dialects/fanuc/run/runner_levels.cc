#include <algorithm>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/run/runner.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

/// P of M98 beyond four digits carries the count before the number (MB-214).
constexpr int kCountFactor = 10'000;

constexpr int kExternalCall = 198;

}  // namespace

int Runner::levels(CallKind kind) const {
  int count = 0;
  for (const Frame& level : frames_) {
    count += level.kind == kind ? 1 : 0;
  }
  return count;
}

MaybeFailure Runner::enter(const Entry& entry) {
  const bool is_macro = entry.kind == CallKind::Macro;
  const CallLevels& most = control_.profile.calls;
  const int limit = is_macro ? most.macros : most.subprograms;
  const bool in_kind = levels(entry.kind) < limit;
  const bool together = in_kind && static_cast<int>(frames_.size()) > most.together;
  if (!in_kind || together) {
    Failure failure;
    failure.id = is_macro && !together ? AlarmId::MacroNesting : AlarmId::NestedTooDeep;
    failure.detail = together ? fmt::format("calls nest at most {} deep", most.together)
                              : fmt::format("{} nest at most {} deep",
                                            is_macro ? "macros" : "subprograms", limit);
    return failure;
  }
  if (is_macro) {
    control_.variables.push_level();
  }
  Frame level;
  level.program = entry.program;
  level.step = entry.first_step;
  level.first_step = entry.first_step;
  level.kind = entry.kind;
  level.by = entry.by;
  level.storage = entry.storage;
  level.repeats_left = entry.repeats - 1;
  level.modal_calls = frame().modal_calls;
  frames_.push_back(std::move(level));
  control_.modal.word('O') = entry.program->number;
  control_.watch.level_changed(frames_.size() - 1, [&] { return name_of(*frame().program); });
  return std::nullopt;
}

/// M198, or the M code of parameter 6030 (MB-222).
bool Runner::calls_external(int m) const {
  const int renamed = nearest_integer(control_.parameters.get(ParameterId::ExternalCall));
  return m == (renamed > 0 ? renamed : kExternalCall);
}

/// What M98 or M198 calls, how often and from which block on (MB-214 to MB-216).
Result<Entry, Failure> Runner::subprogram_entry(const EvaluatedWord& m) {
  const EvaluatedWord* const p = words_.find('P');
  const EvaluatedWord* const q = words_.find(control_.profile.start_letter);
  const auto times = repeats();
  if (!times) {
    return times.error();
  }
  if (p == nullptr && q == nullptr) {
    return at_word(AlarmId::CallWithoutProgram, m, fmt::format("M{} without P", m.number));
  }
  if (p == nullptr) {
    if (auto failure = keep_whole(frame())) {
      return *std::move(failure);
    }
  }
  Entry entry{frame().program, CallKind::Subprogram, CalledBy::Program, times.value()};
  if (p != nullptr) {
    const auto number = integer_of(*p);
    if (!number) {
      return number.error();
    }
    EvaluatedWord program_word = *p;
    program_word.form = ValueForm::Integer;
    program_word.number = number.value();
    if (number.value() >= kCountFactor && library_.find(number.value()) == nullptr) {
      program_word.number = number.value() % kCountFactor;
      entry.repeats = number.value() / kCountFactor;
    }
    const auto program = called_program(program_word);
    if (!program) {
      return program.error();
    }
    entry.program = program.value();
  }
  if (q != nullptr) {
    const auto found = entry.program->find_label(nearest_integer(q->number), 0);
    if (!found) {
      return at_word(AlarmId::SequenceNotFound, *q, fmt::format("no N{}", q->number));
    }
    entry.first_step = *found;
  }
  return entry;
}

/// What a block does beside its call.
/// @param arguments  letters of words that belong to the call
MaybeFailure Runner::execute_beside(const EvaluatedWord& call,
                                    std::initializer_list<char> arguments) {
  BlockWords others;
  for (const EvaluatedWord& word : words_.all()) {
    if (&word != &call && std::ranges::find(arguments, word.letter) == arguments.end()) {
      others.add(word);
    }
  }
  return execute(others, location_of(frame()));
}

/// M98 P L Q, M198 P: motion of the block first, then the call (MB-213 to MB-217, MB-222).
MaybeFailure Runner::subprogram_call(const EvaluatedWord& m) {
  const auto found = subprogram_entry(m);
  if (!found) {
    return found.error();
  }
  Entry entry = found.value();
  if (calls_external(nearest_integer(m.number))) {
    entry.storage = Storage::External;
    if (std::ranges::find(frames_, Storage::External, &Frame::storage) != frames_.end()) {
      return at_word(AlarmId::ExternalTwice, m, "M198 in a program that M198 called");
    }
  }
  if (auto failure = execute_beside(m, {'P', 'L', control_.profile.start_letter})) {
    return failure;
  }
  return entry.repeats == 0 ? std::nullopt : enter(entry);
}

/// M97 P L: the blocks from N of P on, to M99, as a subprogram of the same text.
MaybeFailure Runner::local_call(const EvaluatedWord& m) {
  const EvaluatedWord* const p = words_.find('P');
  const auto times = repeats();
  if (p == nullptr || !times) {
    return p == nullptr ? MaybeFailure(at_word(AlarmId::CallWithoutProgram, m, "M97 without P"))
                        : MaybeFailure(times.error());
  }
  if (auto failure = keep_whole(frame())) {
    return failure;
  }
  const auto sequence = integer_of(*p);
  if (!sequence) {
    return sequence.error();
  }
  const auto step = frame().program->find_label(sequence.value(), frame().current);
  if (!step) {
    return at_word(AlarmId::SequenceNotFound, *p, fmt::format("no N{}", sequence.value()));
  }
  if (auto failure = execute_beside(m, {'P', 'L'})) {
    return failure;
  }
  Entry entry{frame().program, CallKind::Subprogram, CalledBy::Program, times.value()};
  entry.first_step = *step;
  return entry.repeats == 0 ? std::nullopt : enter(entry);
}

/// M96 P Q: on at block N of P while input Q is 0.
MaybeFailure Runner::jump_by_input(const EvaluatedWord& m) {
  constexpr int kFirstInput = 11000;
  const EvaluatedWord* const p = words_.find('P');
  const EvaluatedWord* const q = words_.find('Q');
  if (p == nullptr || q == nullptr) {
    return at_word(AlarmId::NoDataAfterAddress, m, "M96 needs P, a block, and Q, an input");
  }
  const auto sequence = integer_of(*p);
  const auto input = integer_of(*q);
  if (!sequence || !input) {
    return sequence ? input.error() : sequence.error();
  }
  const auto value = control_.all_variables.read(kFirstInput + input.value());
  control_.touches.missed.compares();
  if (!value) {
    return at_word(value.error(), *q, fmt::format("there is no input {}", input.value()));
  }
  if (value.value().or_zero() != 0.0) {
    return std::nullopt;
  }
  return go_to(frame(), sequence.value(),
               at_word(AlarmId::SequenceNotFound, *p, fmt::format("no N{}", sequence.value())));
}

/// M99: back to the caller, to block P of it, or to the top of the main program; L replaces the
/// repeats that are left (MB-218 to MB-221).
MaybeFailure Runner::return_from_call() {
  const EvaluatedWord* const p = words_.find('P');
  Frame& now = frame();
  if (words_.has('L')) {
    const auto left = repeats();
    if (!left) {
      return left.error();
    }
    now.repeats_left = left.value();
  }
  if (now.kind != CallKind::Main && p == nullptr && now.repeats_left > 0) {
    --now.repeats_left;
    now.step = now.first_step;
    return std::nullopt;
  }
  if (now.kind == CallKind::Main) {
    if (auto failure = keep_whole(now)) {
      return failure;
    }
    now.step = 0;
  } else {
    if (now.of_modal_call) {
      now.of_modal_call->locals = control_.variables.level();
    }
    if (now.kind == CallKind::Macro) {
      const std::size_t depth = control_.variables.depth();
      control_.touches.missed.forget(holder_of(depth, kFirstLocal), holder_of(depth, kLocalCount));
      control_.variables.pop_level();
    }
    frames_.pop_back();
    control_.modal.word('O') = frame().program->number;
    control_.watch.level_changed(frames_.size() - 1, [&] { return name_of(*frame().program); });
  }
  if (p == nullptr) {
    return std::nullopt;
  }
  const auto sequence = integer_of(*p);
  if (!sequence) {
    return sequence.error();
  }
  return go_to(frame(), sequence.value(),
               at_word(AlarmId::SequenceNotFound, *p, fmt::format("no N{}", sequence.value())));
}

}  // namespace g31::fanuc

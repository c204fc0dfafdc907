#include "interpreter/dialects/fanuc/run/subprograms.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

constexpr int kExternalCall = 198;

}  // namespace

bool Subprograms::calls_external(int m) const {
  const int renamed = nearest_integer(control_.parameters.get(ParameterId::ExternalCall));
  return m == (renamed > 0 ? renamed : kExternalCall);
}

/// What M98 or M198 calls, how often and from which block on (MB-214 to MB-216).
Result<Entry, Failure> Subprograms::entry_of(const EvaluatedWord& m) {
  const EvaluatedWord* const p = words_.find('P');
  const EvaluatedWord* const q = words_.find(control_.profile.start_letter);
  const auto times = repeats_of(words_, control_.profile);
  if (!times) {
    return times.error();
  }
  if (p == nullptr && q == nullptr) {
    return at_word(AlarmId::CallWithoutProgram, m, fmt::format("M{} without P", m.number));
  }
  if (p != nullptr && q != nullptr && !control_.profile.starts_in_called) {
    return at_word(AlarmId::CallWithoutProgram, *q,
                   fmt::format("M{0} takes P, a program, or {1}, a block of this one, not both",
                               m.number, q->letter));
  }
  if (p == nullptr) {
    if (auto failure = jumps_.keep_whole(frame())) {
      return *std::move(failure);
    }
  }
  Entry entry{frame().program, CallKind::Subprogram, CalledBy::Program, times.value()};
  if (p != nullptr) {
    if (auto failure = p->form == ValueForm::Name ? find_called(*p, entry) : count_in(*p, entry)) {
      return *std::move(failure);
    }
  }
  if (q != nullptr) {
    const auto sequence = integer_of(*q, control_.profile);
    if (!sequence) {
      return sequence.error();
    }
    const auto found = entry.program->find_label(sequence.value(), 0);
    if (!found) {
      return at_word(AlarmId::SequenceNotFound, *q, fmt::format("no N{}", q->number));
    }
    entry.first_step = *found;
  }
  return entry;
}

/// P: a number, which the count may stand before.
MaybeFailure Subprograms::count_in(const EvaluatedWord& p, Entry& entry) {
  const auto number = integer_of(p, control_.profile);
  if (!number) {
    return number.error();
  }
  EvaluatedWord program_word = p;
  program_word.form = ValueForm::Integer;
  program_word.number = number.value();
  const int factor = control_.profile.count_factor;
  if (factor > 0 && number.value() >= factor && !programs_.has(number.value())) {
    program_word.number = number.value() % factor;
    entry.repeats = number.value() / factor;
  }
  return find_called(program_word, entry);
}

MaybeFailure Subprograms::find_called(const EvaluatedWord& p, Entry& entry) {
  const auto program = programs_.called(p, *frame().program);
  if (!program) {
    return program.error();
  }
  entry.program = program.value();
  return std::nullopt;
}

/// What a block does beside its call.
/// @param arguments  letters of words that belong to the call
MaybeFailure Subprograms::execute_beside(const EvaluatedWord& call,
                                         std::initializer_list<char> arguments) {
  const BlockWords others = words_.only([&](const EvaluatedWord& word) {
    return &word != &call && std::ranges::find(arguments, word.letter) == arguments.end();
  });
  return execute_words(control_, others, levels_.stack().here());
}

MaybeFailure Subprograms::call(const EvaluatedWord& m) {
  const auto found = entry_of(m);
  if (!found) {
    return found.error();
  }
  Entry entry = found.value();
  if (calls_external(nearest_integer(m.number))) {
    entry.storage = Storage::External;
    const std::vector<Frame>& frames = levels_.stack().frames();
    if (std::ranges::find(frames, Storage::External, &Frame::storage) != frames.end()) {
      return at_word(AlarmId::ExternalTwice, m, "M198 in a program that M198 called");
    }
  }
  if (auto failure = execute_beside(m, {'P', 'L', control_.profile.start_letter})) {
    return failure;
  }
  return entry.repeats == 0 ? std::nullopt : levels_.enter(entry);
}

MaybeFailure Subprograms::call_local(const EvaluatedWord& m) {
  const EvaluatedWord* const p = words_.find('P');
  const auto times = repeats_of(words_, control_.profile);
  if (p == nullptr || !times) {
    return p == nullptr ? MaybeFailure(at_word(AlarmId::CallWithoutProgram, m, "M97 without P"))
                        : MaybeFailure(times.error());
  }
  if (auto failure = jumps_.keep_whole(frame())) {
    return failure;
  }
  const auto sequence = integer_of(*p, control_.profile);
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
  return entry.repeats == 0 ? std::nullopt : levels_.enter(entry);
}

MaybeFailure Subprograms::jump_by_input(const EvaluatedWord& m) {
  constexpr int kFirstInput = 11000;
  const EvaluatedWord* const p = words_.find('P');
  const EvaluatedWord* const q = words_.find('Q');
  if (p == nullptr || q == nullptr) {
    return at_word(AlarmId::NoDataAfterAddress, m, "M96 needs P, a block, and Q, an input");
  }
  const auto sequence = integer_of(*p, control_.profile);
  const auto input = integer_of(*q, control_.profile);
  if (!sequence || !input) {
    return sequence ? input.error() : sequence.error();
  }
  const auto value = control_.all_variables.read(kFirstInput + input.value());
  control_.touches.missed.decides();
  if (!value) {
    return at_word(value.error(), *q, fmt::format("there is no input {}", input.value()));
  }
  if (value.value().or_zero() != 0.0) {
    return std::nullopt;
  }
  return go_to(frame(), *p);
}

MaybeFailure Subprograms::return_from(const BlockWords& words) {
  const EvaluatedWord* const p = words.find('P');
  Frame& now = frame();
  if (words.has('L')) {
    const auto left = repeats_of(words, control_.profile);
    if (!left) {
      return left.error();
    }
    now.repeats_left = left.value();
  }
  if (now.kind != CallKind::Main && p == nullptr && now.repeats_left > 0) {
    --now.repeats_left;
    levels_.repeat();
    return std::nullopt;
  }
  if (now.kind == CallKind::Main) {
    if (p != nullptr) {
      return go_to(now, *p);
    }
    if (auto failure = jumps_.keep_whole(now)) {
      return failure;
    }
    now.step = 0;
    ++control_.main_restarts;
    return std::nullopt;
  }
  // The block is looked for first: where the caller has none, the alarm is this program's.
  if (p != nullptr) {
    if (auto failure = go_to(levels_.stack().caller(), *p)) {
      return failure;
    }
  }
  levels_.leave();
  return std::nullopt;
}

/// A level goes on at the block that P names.
MaybeFailure Subprograms::go_to(Frame& level, const EvaluatedWord& p) {
  const auto sequence = integer_of(p, control_.profile);
  if (!sequence) {
    return sequence.error();
  }
  return jumps_.go_to(
      level, sequence.value(),
      at_word(AlarmId::SequenceNotFound, p, fmt::format("no N{}", sequence.value())));
}

MaybeFailure Subprograms::call_by_code(const EvaluatedWord& code, int program_number) {
  const auto program = programs_.called_by(code, program_number);
  if (!program) {
    return program.error();
  }
  if (auto failure = execute_beside(code, {})) {
    return failure;
  }
  return levels_.enter({program.value(), CallKind::Subprogram, CalledBy::Address, 1});
}

}  // namespace g31::fanuc

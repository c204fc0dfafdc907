#include <array>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/runner.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

/// Argument specification I (MB-191): the local variable of an address, 0 for none.
constexpr std::array<std::uint8_t, 26> kArgumentVariable = {
    // A B C  D  E  F  G  H   I  J  K  L  M   N  O  P  Q   R   S   T   U   V   W   X   Y   Z
    1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

/// What G66.1 does with the letters that are no arguments elsewhere (MB-205).
constexpr int kEveryBlockG = 10;
constexpr int kEveryBlockL = 12;
constexpr int kEveryBlockN = 14;
constexpr int kEveryBlockP = 16;

constexpr int kLargestRepeat = 9999;

/// P of M98 beyond four digits carries the count before the number (MB-214).
constexpr int kCountFactor = 10'000;

/// Variables that T and address calls leave their value in (MB-211, MB-212).
constexpr int kTCallVariable = 149;
constexpr int kTCallProgram = 9000;

/// Letters whose plain integer argument means least increments (MB-196).
bool counts_increments(char letter) {
  return std::string_view("ABCIJKQRUVWXYZ").find(letter) != std::string_view::npos;
}

/// Whether a word is part of the call itself: the code, P, L and N.
bool is_call_word(const EvaluatedWord& word, const EvaluatedWord& code) {
  return &word == &code || word.letter == 'P' || word.letter == 'L' || word.letter == 'N';
}

bool has_motion(const BlockWords& words) {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (words.has(kAxisLetters[axis])) {
      return true;
    }
  }
  return false;
}

}  // namespace

/// Calls what a word of the block calls.  @returns whether there was such a word
Result<bool, Failure> Runner::call_in_block() {
  const auto done = [](MaybeFailure failure) -> Result<bool, Failure> {
    return failure ? Result<bool, Failure>(*std::move(failure)) : true;
  };
  const auto& modal = frame().modal_calls;
  const bool every_block = !modal.empty() && modal.back()->every_block;
  for (const EvaluatedWord& word : words_.all()) {
    if (word.letter != 'G' && word.letter != 'M' && word.letter != 'T') {
      continue;
    }
    const int code = nearest_integer(word.number);
    if (word.letter == 'G') {
      if (word.number == 67.0) {
        return done(cancel_modal_call(word));
      }
      if (every_block) {
        return done(every_block_call());
      }
      if (word.number == 65.0) {
        return done(macro_call(word));
      }
      if (word.number == 66.0 || word.number == 66.1) {
        return done(set_modal_call(word));
      }
      const auto call = control_.macro_calls_g.find(code);
      if (call != control_.macro_calls_g.end() && word.number == code && code_calls_allowed()) {
        return done(code_macro(word, call->second));
      }
    } else if (word.letter == 'M' && !every_block && word.form != ValueForm::Decimal) {
      if (code == 98 || code == 198) {
        return done(subprogram_call(word));
      }
      if (code == 99) {
        return done(return_from_call());
      }
      const auto macro = control_.macro_calls_m.find(code);
      if (macro != control_.macro_calls_m.end() && code_calls_allowed()) {
        return done(code_macro(word, macro->second));
      }
      const auto sub = control_.subprogram_calls_m.find(code);
      if (sub != control_.subprogram_calls_m.end() && code_calls_allowed()) {
        return done(code_subprogram(word, sub->second));
      }
    } else if (word.letter == 'T' && control_.parameters.is_on(ParameterId::ToolCalls) && code_calls_allowed()) {
      control_.variables.set_common(kTCallVariable, Cell(code));
      return done(code_subprogram(word, kTCallProgram));
    }
  }
  return every_block ? done(every_block_call()) : false;
}

bool Runner::code_calls_allowed() const {
  for (const Frame& level : frames_) {
    if (level.by == CalledBy::Code) {
      return false;
    }
  }
  return true;
}

MaybeFailure Runner::macro_call(const EvaluatedWord& code) {
  std::vector<EvaluatedWord> arguments;
  for (const EvaluatedWord& word : words_.all()) {
    if (!is_call_word(word, code)) {
      arguments.push_back(word);
      if (kArgumentVariable[static_cast<std::size_t>(word.letter - 'A')] == 0) {
        return at_word(AlarmId::IllegalArgumentLetter, word,
                       fmt::format("{} as argument", word.letter));
      }
    }
  }
  const EvaluatedWord* const p = words_.find('P');
  if (p == nullptr) {
    return at_word(AlarmId::CallWithoutProgram, code, "G65 without P");
  }
  const auto program = called_program(*p);
  if (!program) {
    return program.error();
  }
  const auto times = repeats();
  if (!times) {
    return times.error();
  }
  if (times.value() == 0) {
    return std::nullopt;
  }
  if (auto failure = enter({program.value(), CallKind::Macro, CalledBy::Program, times.value()})) {
    return failure;
  }
  return pass_arguments(arguments);
}

/// G66 and G66.1: from the next block on; the block itself calls nothing (MB-203).
MaybeFailure Runner::set_modal_call(const EvaluatedWord& code) {
  auto call = std::make_shared<ModalCall>();
  const EvaluatedWord* const p = words_.find('P');
  if (p == nullptr) {
    return at_word(AlarmId::CallWithoutProgram, code, "G66 without P");
  }
  const auto program = called_program(*p);
  const auto times = repeats();
  if (!program || !times) {
    return program ? times.error() : program.error();
  }
  call->program = program.value();
  call->repeats = times.value();
  call->every_block = code.number != 66.0;
  for (const EvaluatedWord& word : words_.all()) {
    if (!is_call_word(word, code)) {
      call->arguments.push_back(word);
    }
  }
  frame().modal_calls.push_back(std::move(call));
  control_.modal.group[12] = {66, static_cast<std::int8_t>(code.number != 66.0 ? 1 : 0)};
  return std::nullopt;
}

MaybeFailure Runner::cancel_modal_call(const EvaluatedWord& code) {
  auto& calls = frame().modal_calls;
  if (calls.empty() && control_.profile.lone_cancel_is_alarm) {
    return at_word(AlarmId::NoModalCall, code, "G67 without G66");
  }
  if (!calls.empty()) {
    calls.pop_back();
  }
  control_.modal.group[12] = calls.empty() ? GNumber{67, 0} : GNumber{66, 0};
  return std::nullopt;
}

/// The modal call that a motion block of this program sets off.
MaybeFailure Runner::modal_call() {
  if (!has_motion(words_) || words_.has('O') || ended_) {
    return std::nullopt;
  }
  const std::shared_ptr<const ModalCall> call = frame().modal_calls.back();
  if (call->repeats == 0) {
    return std::nullopt;
  }
  if (auto failure = enter({call->program, CallKind::Macro, CalledBy::Program, call->repeats})) {
    return failure;
  }
  frame().modal_calls.pop_back();
  return pass_arguments(call->arguments);
}

/// G66.1: the words of the block become arguments, the block itself is not executed (MB-205).
MaybeFailure Runner::every_block_call() {
  const std::shared_ptr<const ModalCall> call = frame().modal_calls.back();
  const syntax::Block& block =
      frame().program->tree->blocks[frame().program->steps[frame().current].block];
  std::vector<EvaluatedWord> arguments = call->arguments;
  std::vector<std::pair<int, double>> others;
  if (block.sequence >= 0) {
    others.emplace_back(kEveryBlockN, block.sequence);
  }
  for (const EvaluatedWord& word : words_.all()) {
    switch (word.letter) {
      case 'G':
        others.emplace_back(kEveryBlockG, word.number);
        break;
      case 'L':
        others.emplace_back(kEveryBlockL, word.number);
        break;
      case 'P':
        others.emplace_back(kEveryBlockP, word.number);
        break;
      default:
        arguments.push_back(word);
    }
  }
  if (auto failure = enter({call->program, CallKind::Macro, CalledBy::Program, call->repeats})) {
    return failure;
  }
  frame().modal_calls.pop_back();
  for (const auto& [variable, value] : others) {
    control_.variables.set_local(variable, Cell(value));
  }
  return pass_arguments(arguments);
}

/// A G or M code that parameters or the sheet make a macro call (MB-207, MB-209).
MaybeFailure Runner::code_macro(const EvaluatedWord& code, int program_number) {
  const CompiledProgram* const program = library_.find(program_number);
  if (program == nullptr) {
    return at_word(AlarmId::CalledNotFound, code,
                   fmt::format("O{:04}, which {}{} calls, is in none of the files and folders",
                               program_number, code.letter, code.number));
  }
  const auto times = repeats();
  if (!times) {
    return times.error();
  }
  std::vector<EvaluatedWord> arguments;
  for (const EvaluatedWord& word : words_.all()) {
    if (&word != &code && word.letter != 'L' && word.letter != 'N') {
      arguments.push_back(word);
    }
  }
  if (times.value() == 0) {
    return std::nullopt;
  }
  if (auto failure = enter({program, CallKind::Macro, CalledBy::Code, times.value()})) {
    return failure;
  }
  return pass_arguments(arguments);
}

/// An M or T code that parameters make a subprogram call: the other words of the block are executed
/// first, the code itself is not (MB-210, MB-211).
MaybeFailure Runner::code_subprogram(const EvaluatedWord& code, int program_number) {
  const CompiledProgram* const program = library_.find(program_number);
  if (program == nullptr) {
    return at_word(AlarmId::CalledNotFound, code,
                   fmt::format("O{:04}, which {}{} calls, is in none of the files and folders",
                               program_number, code.letter, code.number));
  }
  BlockWords others;
  for (const EvaluatedWord& word : words_.all()) {
    if (&word != &code) {
      others.add(word);
    }
  }
  if (auto failure = execute(others, location_of(frame()))) {
    return failure;
  }
  return enter({program, CallKind::Subprogram, CalledBy::Code, 1});
}

Result<int, Failure> Runner::repeats() const {
  const EvaluatedWord* const l = words_.find('L');
  if (l == nullptr) {
    return 1;
  }
  const auto times = integer_of(*l);
  if (times && (times.value() < 0 || times.value() > kLargestRepeat)) {
    return at_word(AlarmId::IllegalAddress, *l, "L repeats 0 to 9999 times");
  }
  return times;
}

Result<const CompiledProgram*, Failure> Runner::called_program(const EvaluatedWord& p) {
  const auto number = integer_of(p);
  if (!number) {
    return number.error();
  }
  const CompiledProgram* const program = library_.find(number.value());
  if (program == nullptr) {
    return at_word(AlarmId::CalledNotFound, p,
                   fmt::format("O{:04} is in none of the files and folders", number.value()));
  }
  return program;
}

/// Sets the locals of the level just entered.  I J K may come again: then they belong to the next
/// triple (specification II, MB-192, MB-194), unless parameter 6008.7 says specification I only.
MaybeFailure Runner::pass_arguments(std::span<const EvaluatedWord> arguments) {
  const bool triples = !control_.parameters.is_on(ParameterId::OneTriple);
  int triple = 0;
  char last_of_triple = 'A';
  for (const EvaluatedWord& word : arguments) {
    int variable = kArgumentVariable[static_cast<std::size_t>(word.letter - 'A')];
    if (variable == 0) {
      return at_word(AlarmId::IllegalArgumentLetter, word,
                     fmt::format("{} as argument", word.letter));
    }
    if (triples && word.letter >= 'I' && word.letter <= 'K') {
      triple += word.letter <= last_of_triple ? 1 : 0;
      last_of_triple = word.letter;
      variable += 3 * triple;
    }
    if (variable > kLocalCount) {
      return at_word(AlarmId::IllegalArgumentLetter, word, "more than ten I J K");
    }
    double value = word.number;
    if (word.form == ValueForm::Integer && counts_increments(word.letter)) {
      value = control_.scale.length(word);
    }
    control_.variables.set_local(variable, Cell(value));
  }
  return std::nullopt;
}

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
  const bool together = static_cast<int>(frames_.size()) > most.together;
  if (levels(entry.kind) >= limit || together) {
    Failure failure;
    failure.id = is_macro ? AlarmId::MacroNesting : AlarmId::NestedTooDeep;
    failure.detail = together ? fmt::format("calls nest at most {} deep", most.together)
                              : fmt::format("{} nest at most {} deep",
                                            is_macro ? "macros" : "subprograms", limit);
    return failure;
  }
  if (is_macro) {
    control_.variables.push_level();
  }
  Frame level{entry.program, entry.first_step, 0, entry.kind, entry.by, entry.repeats - 1, {}};
  level.modal_calls = frame().modal_calls;
  frames_.push_back(std::move(level));
  control_.modal.word('O') = entry.program->number;
  return std::nullopt;
}

/// M98 P L Q, M198 P: motion of the block first, then the call (MB-213 to MB-217, MB-222).
MaybeFailure Runner::subprogram_call(const EvaluatedWord& m) {
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
      return failure;
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
  BlockWords others;
  for (const EvaluatedWord& word : words_.all()) {
    if (&word != &m && word.letter != 'P' && word.letter != 'L' &&
        word.letter != control_.profile.start_letter) {
      others.add(word);
    }
  }
  if (auto failure = execute(others, location_of(frame()))) {
    return failure;
  }
  return entry.repeats == 0 ? std::nullopt : enter(entry);
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
    now.step = 0;
    return std::nullopt;
  }
  if (now.kind == CallKind::Main) {
    if (auto failure = keep_whole(now)) {
      return failure;
    }
    now.step = 0;
  } else {
    if (now.kind == CallKind::Macro) {
      control_.variables.pop_level();
    }
    frames_.pop_back();
    control_.modal.word('O') = frame().program->number;
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

#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/runner.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

/// Argument specification I (MB-191): the local variable of an address, 0 for none.
constexpr std::array<std::uint8_t, 26> kArgumentVariable = {
    //  A  B  C  D  E  F  G  H   I  J  K  L  M   N  O  P  Q   R   S   T   U   V   W   X   Y   Z
    1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};

constexpr int kLargestRepeat = 9999;

/// No address of any control takes more (MB-032); it keeps positions and times finite, too.
constexpr double kLargestWord = 999'999'999.0;

/// Letters whose plain integer argument means least increments (MB-196).
bool counts_increments(char letter) {
  return std::string_view("ABCIJKQRUVWXYZ").find(letter) != std::string_view::npos;
}

}  // namespace

MaybeFailure Runner::evaluate_words(const Step& step) {
  const CompiledProgram& program = *frame().program;
  const syntax::Block& block = program.tree->blocks[step.block];
  words_.clear();
  const double increment = control_.scale.mm_per_unit() / control_.scale.length_counts();
  for (syntax::Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const syntax::Word& word = program.tree->words[i];
    EvaluatedWord evaluated{word.letter, word.form, word.number, word.span};
    if (word.form == ValueForm::Computed) {
      const Cell value = control_.evaluator.evaluate(
          program, program.word_code[i - program.first_word], increment);
      if (control_.evaluator.failed()) {
        return from_evaluation();
      }
      if (value.is_vacant()) {
        continue;
      }
      evaluated.number = value.raw();
    } else if (word.digits > control_.profile.digit_limit) {
      return at_word(AlarmId::TooManyDigits, evaluated, fmt::format("{} digits", word.digits));
    }
    if (std::abs(evaluated.number) > kLargestWord) {
      return at_word(AlarmId::TooManyDigits, evaluated,
                     fmt::format("{} is {:g}, beyond every address", word.letter, evaluated.number));
    }
    words_.add(evaluated);
  }
  return std::nullopt;
}

MaybeFailure Runner::nc_block(const Step& step) {
  if (auto failure = evaluate_words(step)) {
    return failure;
  }
  for (const EvaluatedWord& word : words_.all()) {
    if (word.letter != 'G') {
      continue;
    }
    const int g = nearest_integer(word.number);
    if (word.number == 65.0) {
      return macro_call(word);
    }
    const auto call = control_.macro_calls_g.find(g);
    if (call != control_.macro_calls_g.end() && word.number == g && code_calls_allowed()) {
      return code_call(word, call->second);
    }
  }
  const syntax::Block& block = frame().program->tree->blocks[step.block];
  const source::Location where = location(block.span);
  const EvaluatedWord* const m = words_.find('M');
  const int m_code = m != nullptr && m->form != ValueForm::Decimal ? nearest_integer(m->number) : -1;
  if (block.sequence >= 0) {
    control_.modal.word('N') = block.sequence;
  }
  if (m_code != 98 && m_code != 99) {
    if (auto failure = execute_block(control_, words_, where)) {
      return failure;
    }
    return program_stop(m_code, where);
  }
  return m_code == 98 ? subprogram_call() : return_from_call();
}

/// M00, M01, M02, M30: recorded stops and the end.
MaybeFailure Runner::program_stop(int m, source::Location where) {
  if (m == 0 || m == 1) {
    control_.observer.on_stop({m == 0 ? "M00" : "M01", "", where});
  }
  ended_ = m == 2 || m == 30;
  return std::nullopt;
}

bool Runner::code_calls_allowed() const {
  return frames_.back().kind != CallKind::CodeMacro;
}

MaybeFailure Runner::macro_call(const EvaluatedWord& code) {
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
  if (auto failure = enter(*program.value(), CallKind::Macro, times.value())) {
    return failure;
  }
  return pass_arguments(&code);
}

MaybeFailure Runner::code_call(const EvaluatedWord& code, int program_number) {
  const CompiledProgram* const program = library_.find(program_number);
  if (program == nullptr) {
    return at_word(AlarmId::CalledNotFound, code,
                   fmt::format("O{:04}, which G{} calls, is in none of the files and folders",
                               program_number, code.number));
  }
  const auto times = repeats();
  if (!times) {
    return times.error();
  }
  if (auto failure = enter(*program, CallKind::CodeMacro, times.value())) {
    return failure;
  }
  return pass_arguments(nullptr);
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
/// triple (specification II, MB-192, MB-194).
MaybeFailure Runner::pass_arguments(const EvaluatedWord* code) {
  int triple = 0;
  char last_of_triple = 'A';
  for (const EvaluatedWord& word : words_.all()) {
    const bool is_call_word = word.letter == 'G' ? (code == nullptr || &word == code)
                                                 : word.letter == 'P' || word.letter == 'L' ||
                                                       word.letter == 'N';
    if (is_call_word && !(word.letter == 'P' && code == nullptr)) {
      continue;
    }
    int variable = kArgumentVariable[static_cast<std::size_t>(word.letter - 'A')];
    if (variable == 0) {
      return at_word(AlarmId::IllegalArgumentLetter, word, fmt::format("{} as argument", word.letter));
    }
    if (word.letter >= 'I' && word.letter <= 'K') {
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

int Runner::levels(CallKind a, CallKind b) const {
  int count = 0;
  for (const Frame& f : frames_) {
    count += f.kind == a || f.kind == b ? 1 : 0;
  }
  return count;
}

MaybeFailure Runner::enter(const CompiledProgram& program, CallKind kind, int repeat_count) {
  const bool is_macro = kind == CallKind::Macro || kind == CallKind::CodeMacro;
  Failure failure;
  if (is_macro && levels(CallKind::Macro, CallKind::CodeMacro) >= control_.profile.macro_levels) {
    failure.id = AlarmId::MacroNesting;
    failure.detail = fmt::format("macros nest at most {} deep", control_.profile.macro_levels);
    return failure;
  }
  if (!is_macro &&
      levels(CallKind::Subprogram, CallKind::Subprogram) >= control_.profile.subprogram_levels) {
    failure.id = AlarmId::NestedTooDeep;
    failure.detail =
        fmt::format("subprograms nest at most {} deep", control_.profile.subprogram_levels);
    return failure;
  }
  if (repeat_count == 0) {
    return std::nullopt;
  }
  if (is_macro) {
    control_.variables.push_level();
  }
  frames_.push_back({&program, 0, 0, kind, repeat_count - 1});
  control_.modal.word('O') = program.number;
  return std::nullopt;
}

/// M98 P: motion of the block first, then the call (MB-217).
MaybeFailure Runner::subprogram_call() {
  const EvaluatedWord* const p = words_.find('P');
  if (p == nullptr) {
    return at_word(AlarmId::CallWithoutProgram, *words_.find('M'), "M98 without P");
  }
  const auto number = integer_of(*p);
  const auto times = repeats();
  if (!number || !times) {
    return number ? times.error() : number.error();
  }
  // P68003 is six times O8003 (MB-214).
  EvaluatedWord program_word = *p;
  int count = times.value();
  if (number.value() > 9999) {
    program_word.number = number.value() % 10000;
    program_word.form = ValueForm::Integer;
    count = number.value() / 10000;
  }
  const auto program = called_program(program_word);
  if (!program) {
    return program.error();
  }
  const source::Location where = location_of(frame());
  if (auto failure = execute_block(control_, words_, where)) {
    return failure;
  }
  return enter(*program.value(), CallKind::Subprogram, count);
}

/// M99: back to the caller, to block P of it, or to the top of the main program (MB-218 to MB-221).
MaybeFailure Runner::return_from_call() {
  const EvaluatedWord* const p = words_.find('P');
  Frame& now = frame();
  if (now.kind != CallKind::Main && p == nullptr && now.repeats_left > 0) {
    --now.repeats_left;
    now.step = 0;
    return std::nullopt;
  }
  if (now.kind != CallKind::Main) {
    if (now.kind != CallKind::Subprogram) {
      control_.variables.pop_level();
    }
    frames_.pop_back();
    control_.modal.word('O') = frame().program->number;
  } else {
    now.step = 0;
  }
  if (p == nullptr) {
    return std::nullopt;
  }
  const auto sequence = integer_of(*p);
  if (!sequence) {
    return sequence.error();
  }
  const auto found = frame().program->find_label(sequence.value(), frame().current);
  if (!found) {
    return at_word(AlarmId::SequenceNotFound, *p, fmt::format("no N{}", sequence.value()));
  }
  frame().step = *found;
  return std::nullopt;
}

}  // namespace g31::fanuc

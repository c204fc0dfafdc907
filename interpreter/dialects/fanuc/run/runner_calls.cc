#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/run/runner.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

/// Argument specification I (MB-191): the local variable of an address, 0 for none.
constexpr std::array<std::uint8_t, syntax::kLetterCount> kArgumentVariable = {
    // A B C  D  E  F  G  H   I  J  K  L  M   N  O  P  Q   R   S   T   U   V   W   X   Y   Z
    1, 2, 3, 7, 8, 9, 0, 11, 4, 5, 6, 0, 13, 0, 0, 0, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 0, 0};

/// What G66.1 does with the letters that are no arguments elsewhere (MB-205).
constexpr std::size_t kEveryBlockG = 10;
constexpr std::size_t kEveryBlockL = 12;
constexpr std::size_t kEveryBlockN = 14;
constexpr std::size_t kVariableOfP = 16;

constexpr int kLargestRepeat = 9999;

// Of a Haas.
constexpr int kJumpByInput = 96;
constexpr int kLocalCall = 97;

/// Letters whose plain integer argument means least increments (MB-196).
bool counts_increments(char letter) {
  return std::string_view("ABCIJKQRUVWXYZ").find(letter) != std::string_view::npos;
}

/// Whether a word is part of the call itself: the code, P and L.
bool is_call_word(const EvaluatedWord& word, const EvaluatedWord& code) {
  return &word == &code || word.letter == 'P' || word.letter == 'L';
}

Result<bool, Failure> has_called(MaybeFailure failure) {
  return failure ? Result<bool, Failure>(*std::move(failure)) : true;
}

}  // namespace

/// Calls what a word of the block calls.  @returns whether there was such a word
Result<bool, Failure> Runner::call_in_block() {
  const auto& modal = frame().modal_calls;
  const bool every_block = !modal.empty() && modal.back()->every_block;
  for (const EvaluatedWord& word : words_.all()) {
    auto called = word.letter == 'G'   ? call_by_g(word, every_block)
                  : every_block        ? Result<bool, Failure>(false)
                  : word.letter == 'M' ? call_by_m(word)
                                       : call_by_address(word);
    if (!called || called.value()) {
      return called;
    }
  }
  return every_block ? has_called(every_block_call()) : false;
}

Result<bool, Failure> Runner::call_by_g(const EvaluatedWord& word, bool every_block) {
  if (word.number == 67.0) {
    return has_called(cancel_modal_call(word));
  }
  if (every_block) {
    return has_called(every_block_call());
  }
  if (word.number == 65.0) {
    return has_called(macro_call(word));
  }
  if (word.number == 66.0 || word.number == 66.1) {
    return has_called(set_modal_call(word));
  }
  const int code = nearest_integer(word.number);
  const auto call = control_.code_calls.macro_by_g.find(code);
  if (call != control_.code_calls.macro_by_g.end() && word.number == code &&
      may_call(CalledBy::GCode)) {
    return has_called(code_macro(word, call->second, CalledBy::GCode));
  }
  return false;
}

Result<bool, Failure> Runner::call_by_m(const EvaluatedWord& word) {
  const int code = nearest_integer(word.number);
  if (word.form == ValueForm::Decimal) {
    return false;
  }
  if (code == 98 || calls_external(code)) {
    return has_called(subprogram_call(word));
  }
  if (code == 99) {
    return has_called(return_from_call());
  }
  if (control_.profile.has_local_calls && code == kLocalCall) {
    return has_called(local_call(word));
  }
  if (control_.profile.has_local_calls && code == kJumpByInput) {
    return has_called(jump_by_input(word));
  }
  if (!may_call(CalledBy::Address)) {
    return false;
  }
  // Behind other words it is an ordinary M code (MB-209).
  const bool comes_first = &word == &words_.all().front();
  const auto macro = control_.code_calls.macro_by_m.find(code);
  if (macro != control_.code_calls.macro_by_m.end() && comes_first) {
    return has_called(code_macro(word, macro->second, CalledBy::Address));
  }
  const auto sub = control_.code_calls.subprogram_by_m.find(code);
  if (sub == control_.code_calls.subprogram_by_m.end()) {
    return false;
  }
  return has_called(code_subprogram(word, sub->second));
}

/// T, S, B and the addresses of parameters 6090 and 6091 (MB-211, MB-212).
Result<bool, Failure> Runner::call_by_address(const EvaluatedWord& word) {
  const AddressCall& call =
      control_.code_calls.by_address.at(static_cast<std::size_t>(word.letter - 'A'));
  if (call.program == 0 || !may_call(CalledBy::Address)) {
    return false;
  }
  control_.variables.set_common(call.variable, Cell(argument_value(word)));
  return has_called(code_subprogram(word, call.program));
}

/// Inside a program that a code called, codes call nothing; with parameter 6008.6 those of the
/// other kind do (MB-208).
bool Runner::may_call(CalledBy by) const {
  const bool nests = control_.profile.has_series_30i_functions &&
                     control_.parameters.is_on(ParameterId::NestedCodeCalls);
  for (const Frame& level : frames_) {
    if (level.by == by || (level.by != CalledBy::Program && !nests)) {
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
                       fmt::format("{} as argument", syntax::letter_text(word.letter)));
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
  return enter_macro({program.value(), CallKind::Macro, CalledBy::Program, times.value()},
                     arguments);
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
  std::vector<EvaluatedWord> arguments;
  for (const EvaluatedWord& word : words_.all()) {
    if (!is_call_word(word, code)) {
      arguments.push_back(word);
    }
  }
  const auto locals = with_arguments({}, arguments);
  if (!locals) {
    return locals.error();
  }
  call->locals = locals.value();
  if (static_cast<int>(frame().modal_calls.size()) >= control_.profile.calls.macros) {
    return at_word(AlarmId::ModalCallNesting, code,
                   fmt::format("modal calls nest at most {} deep", control_.profile.calls.macros));
  }
  frame().modal_calls.push_back(std::move(call));
  control_.modal.group[Group::ModalCall] = {66,
                                            static_cast<std::int8_t>(code.number != 66.0 ? 1 : 0)};
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
  control_.modal.group[Group::ModalCall] = calls.empty() ? GNumber{67, 0} : GNumber{66, 0};
  return std::nullopt;
}

/// The modal call that a motion block of this program sets off.
MaybeFailure Runner::modal_call() {
  if (!commands_motion(words_) || ended_) {
    return std::nullopt;
  }
  const std::shared_ptr<ModalCall> call = frame().modal_calls.back();
  if (call->repeats == 0) {
    return std::nullopt;
  }
  if (auto failure = enter({call->program, CallKind::Macro, CalledBy::Program, call->repeats})) {
    return failure;
  }
  frame().modal_calls.pop_back();
  frame().of_modal_call = call;
  control_.variables.set_level(call->locals);
  return std::nullopt;
}

/// G66.1: the words of the block become arguments, the block itself is not executed (MB-205).
MaybeFailure Runner::every_block_call() {
  const std::shared_ptr<ModalCall> call = frame().modal_calls.back();
  std::vector<EvaluatedWord> arguments;
  Variables::Locals locals = call->locals;
  if (words_.sequence() > 0) {
    locals[kEveryBlockN] = Cell(words_.sequence());
  }
  for (const EvaluatedWord& word : words_.all()) {
    const std::size_t variable = word.letter == 'G'   ? kEveryBlockG
                                 : word.letter == 'L' ? kEveryBlockL
                                 : word.letter == 'P' ? kVariableOfP
                                                      : 0;
    if (variable == 0) {
      arguments.push_back(word);
    } else {
      locals[variable] = Cell(word.number);
    }
  }
  const auto passed = with_arguments(locals, arguments);
  if (!passed) {
    return passed.error();
  }
  if (auto failure = enter({call->program, CallKind::Macro, CalledBy::Program, call->repeats})) {
    return failure;
  }
  frame().modal_calls.pop_back();
  control_.variables.set_level(passed.value());
  return std::nullopt;
}

/// A G or M code that parameters or the sheet make a macro call (MB-207, MB-209).  P is an
/// argument, too: MELDAS, parameter #1241, "macro argument L/P valid".
MaybeFailure Runner::code_macro(const EvaluatedWord& code, int program_number, CalledBy by) {
  const CompiledProgram* const program = program_of(program_number);
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
    if (&word != &code && word.letter != 'L' && word.letter != 'N' && word.letter != 'P') {
      arguments.push_back(word);
    }
  }
  Variables::Locals locals;
  if (const EvaluatedWord* const p = words_.find('P')) {
    locals[kVariableOfP] = Cell(argument_value(*p));
  }
  return enter_macro({program, CallKind::Macro, by, times.value()}, arguments, locals);
}

/// An M or T code that parameters make a subprogram call: the other words of the block are executed
/// first, the code itself is not (MB-210, MB-211).
MaybeFailure Runner::code_subprogram(const EvaluatedWord& code, int program_number) {
  const CompiledProgram* const program = program_of(program_number);
  if (program == nullptr) {
    return at_word(AlarmId::CalledNotFound, code,
                   fmt::format("O{:04}, which {}{} calls, is in none of the files and folders",
                               program_number, code.letter, code.number));
  }
  if (auto failure = execute_beside(code, {})) {
    return failure;
  }
  return enter({program, CallKind::Subprogram, CalledBy::Address, 1});
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

/// The program of a number, and a word about a second one.
const CompiledProgram* Runner::program_of(int number) {
  const CompiledProgram* const found = library_.find(number);
  take_reports();
  return found;
}

void Runner::take_reports() {
  for (source::Diagnostic& report : library_.take_reports()) {
    control_.diagnostics.push_back(std::move(report));
  }
}

Result<const CompiledProgram*, Failure> Runner::called_program(const EvaluatedWord& p) {
  const auto number = integer_of(p);
  if (!number) {
    return number.error();
  }
  const CompiledProgram* const program = program_of(number.value());
  if (program == nullptr) {
    return at_word(AlarmId::CalledNotFound, p,
                   fmt::format("O{:04} is in none of the files and folders", number.value()));
  }
  return program;
}

/// Enters a macro as often as L says; never for L0.
MaybeFailure Runner::enter_macro(const Entry& entry, std::span<const EvaluatedWord> arguments,
                                 const Variables::Locals& given) {
  const auto locals = with_arguments(given, arguments);
  if (!locals) {
    return locals.error();
  }
  if (entry.repeats == 0) {
    return std::nullopt;
  }
  if (auto failure = enter(entry)) {
    return failure;
  }
  control_.variables.set_level(locals.value());
  follow_arguments();
  return std::nullopt;
}

/// The locals of the level that begins hold what the arguments were made of.
void Runner::follow_arguments() {
  runtime::MissedTouches& missed = control_.touches.missed;
  missed.passes_on();
  for (const auto& [variable, reading] : read_by_arguments_) {
    missed.reads(reading);
    missed.assigns(holder_of(control_.variables.depth(), variable));
  }
}

/// Puts arguments among locals.  I J K may come again: then they belong to the next triple
/// (specification II, MB-192, MB-194), unless parameter 6008.7 says specification I only.
Result<Variables::Locals, Failure> Runner::with_arguments(
    Variables::Locals locals, std::span<const EvaluatedWord> arguments) {
  const bool triples = !control_.parameters.is_on(ParameterId::OneTriple);
  int triple = 0;
  char last_of_triple = 'A';
  std::string in_triple;
  read_by_arguments_.clear();
  for (const EvaluatedWord& word : arguments) {
    int variable = kArgumentVariable[static_cast<std::size_t>(word.letter - 'A')];
    if (variable == 0) {
      return at_word(AlarmId::IllegalArgumentLetter, word,
                     fmt::format("{} as argument", syntax::letter_text(word.letter)));
    }
    if (triples && word.letter >= 'I' && word.letter <= 'K') {
      const bool begins = word.letter <= last_of_triple;
      if (begins && in_triple.find(word.letter) == in_triple.npos) {
        control_.warn_once(source::DiagnosticId::TripleOutOfOrder, location(word.span),
                           fmt::format("{} behind {}", word.letter, last_of_triple));
      }
      in_triple = begins ? std::string(1, word.letter) : in_triple + word.letter;
      triple += begins ? 1 : 0;
      last_of_triple = word.letter;
      variable += 3 * triple;
    }
    if (variable > kLocalCount) {
      return at_word(AlarmId::IllegalArgumentLetter, word, "more than ten I J K");
    }
    locals[static_cast<std::size_t>(variable)] = Cell(argument_value(word));
    for (const auto& [begin, reading] : read_by_words_) {
      if (begin == word.span.begin) {
        read_by_arguments_.emplace_back(variable, reading);
      }
    }
  }
  return locals;
}

/// A macro that an M code calls finds them in #4101 to #4126.
void Runner::keep_words() {
  for (const EvaluatedWord& word : words_.all()) {
    const std::size_t variable =
        word.letter >= 'A' && word.letter <= 'Z'
            ? kArgumentVariable[static_cast<std::size_t>(word.letter - 'A')]
            : 0;
    if (variable != 0) {
      control_.modal.arguments.at(variable) = argument_value(word);
    }
  }
}

/// What a word passes to a macro: without a point it counts least increments (MB-196).
double Runner::argument_value(const EvaluatedWord& word) const {
  return word.form == ValueForm::Integer && counts_increments(word.letter)
             ? control_.scale.length(word)
             : word.number;
}

}  // namespace g31::fanuc

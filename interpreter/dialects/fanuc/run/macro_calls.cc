#include "interpreter/dialects/fanuc/run/macro_calls.h"

#include <memory>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/vocabulary/argument_letters.h"

namespace g31::fanuc {
namespace {

/// What G66.1 does with the letters that are no arguments elsewhere (MB-205).
constexpr std::size_t kEveryBlockG = 10;
constexpr std::size_t kEveryBlockL = 12;
constexpr std::size_t kEveryBlockN = 14;

}  // namespace

MaybeFailure MacroCalls::call(const EvaluatedWord& code) {
  std::vector<EvaluatedWord>& arguments = arguments_of_call_;
  arguments.clear();
  for (const EvaluatedWord& word : words_.all()) {
    if (is_argument(word, code, control_.profile)) {
      arguments.push_back(word);
      if (argument_variable(word.letter) == 0) {
        return at_word(no_argument(word.letter), word);
      }
    }
  }
  if (auto failure = control_.profile.codes_before_call ? codes_before(code) : std::nullopt) {
    return failure;
  }
  tell_argument_before(arguments, code);
  const EvaluatedWord* const p = words_.find('P');
  if (p == nullptr) {
    return at_word(AlarmId::CallWithoutProgram, code, "G65 without P");
  }
  const auto program = programs_.called(*p, *frame().program);
  if (!program) {
    return program.error();
  }
  const auto times = repeats_of(words_, control_.profile);
  if (!times) {
    return times.error();
  }
  return enter({program.value(), CallKind::Macro, CalledBy::Program, times.value()}, arguments);
}

/// G54 G65 P..: the codes before the call are a block of their own.
MaybeFailure MacroCalls::codes_before(const EvaluatedWord& code) {
  const BlockWords codes = words_.only([&code](const EvaluatedWord& word) {
    return word.letter == 'G' && word.span.begin < code.span.begin;
  });
  return codes.all().empty() ? std::nullopt
                             : execute_words(control_, codes, levels_.stack().here());
}

/// X5. G65 P..: no axis moves (MB-190).
void MacroCalls::tell_argument_before(std::span<const EvaluatedWord> arguments,
                                      const EvaluatedWord& code) {
  if (!arguments.empty() && arguments.front().span.begin < code.span.begin) {
    const EvaluatedWord& word = arguments.front();
    control_.warn_once(source::DiagnosticId::ArgumentBeforeCall,
                       levels_.stack().location(word.span), syntax::letter_text(word.letter));
  }
}

MaybeFailure MacroCalls::call_by_code(const EvaluatedWord& code, int program_number, CalledBy by) {
  const auto program = programs_.called_by(code, program_number);
  if (!program) {
    return program.error();
  }
  const auto times = repeats_of(words_, control_.profile);
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
    locals[kVariableOfP] = Cell(argument_value(control_, *p));
  }
  return enter({program.value(), CallKind::Macro, by, times.value()}, arguments, locals);
}

MaybeFailure MacroCalls::set_modal(const EvaluatedWord& code) {
  auto call = std::make_shared<ModalCall>();
  const EvaluatedWord* const p = words_.find('P');
  if (p == nullptr) {
    return at_word(AlarmId::CallWithoutProgram, code, "G66 without P");
  }
  const auto program = programs_.called(*p, *frame().program);
  const auto times = repeats_of(words_, control_.profile);
  if (!program || !times) {
    return program ? times.error() : program.error();
  }
  call->program = program.value();
  call->repeats = times.value();
  call->every_block = code.number != 66.0;
  std::vector<EvaluatedWord> arguments;
  for (const EvaluatedWord& word : words_.all()) {
    if (is_argument(word, code, control_.profile)) {
      arguments.push_back(word);
    }
  }
  if (auto failure = arguments_.put_among(call->locals, arguments)) {
    return failure;
  }
  if (static_cast<int>(frame().modal_calls.size()) >= control_.profile.calls.macros) {
    return at_word(AlarmId::ModalCallNesting, code,
                   fmt::format("modal calls nest at most {} deep", control_.profile.calls.macros));
  }
  arguments_.keep_for_modal_call(frame().modal_calls.size());
  frame().modal_calls.push_back(std::move(call));
  control_.modal.group[Group::ModalCall] = {66,
                                            static_cast<std::int8_t>(code.number != 66.0 ? 1 : 0)};
  return std::nullopt;
}

MaybeFailure MacroCalls::cancel_modal(const EvaluatedWord& code) {
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

MaybeFailure MacroCalls::modal_call() {
  if (!commands_motion(words_, control_.profile) || levels_.stack().has_ended()) {
    return std::nullopt;
  }
  const std::shared_ptr<ModalCall> call = frame().modal_calls.back();
  if (call->repeats == 0) {
    return std::nullopt;
  }
  if (auto failure =
          levels_.enter({call->program, CallKind::Macro, CalledBy::Program, call->repeats})) {
    return failure;
  }
  frame().modal_calls.pop_back();
  frame().of_modal_call = call;
  control_.variables.set_level(call->locals);
  arguments_.follow_modal_call(frame().modal_calls.size());
  return std::nullopt;
}

MaybeFailure MacroCalls::every_block_call() {
  const std::shared_ptr<ModalCall> call = frame().modal_calls.back();
  std::vector<EvaluatedWord> arguments;
  Variables::Locals locals = call->locals;
  if (words_.sequence() > 0) {
    locals[kEveryBlockN] = Cell(words_.sequence());
  }
  for (const EvaluatedWord& word : words_.all()) {
    if (word.form == syntax::ValueForm::Name) {
      return at_word(AlarmId::IllegalArgumentLetter, word, "under G66.1 a name is no argument");
    }
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
  if (auto failure = arguments_.put_among(locals, arguments)) {
    return failure;
  }
  if (auto failure =
          levels_.enter({call->program, CallKind::Macro, CalledBy::Program, call->repeats})) {
    return failure;
  }
  frame().modal_calls.pop_back();
  control_.variables.set_level(locals);
  arguments_.follow_modal_call(frame().modal_calls.size());
  arguments_.follow();
  return std::nullopt;
}

/// Enters a macro as often as L says; never for L0.
MaybeFailure MacroCalls::enter(const Entry& entry, std::span<const EvaluatedWord> arguments,
                               Variables::Locals locals) {
  if (auto failure = arguments_.put_among(locals, arguments)) {
    return failure;
  }
  if (entry.repeats == 0) {
    return std::nullopt;
  }
  if (auto failure = levels_.enter(entry)) {
    return failure;
  }
  control_.variables.set_level(locals);
  arguments_.follow();
  return std::nullopt;
}

}  // namespace g31::fanuc

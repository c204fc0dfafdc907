#include "interpreter/dialects/fanuc/run/word_calls.h"

#include "interpreter/dialects/fanuc/code/word_limits.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

constexpr double kFirstCall = 65.0;  // of the G codes that call whatever the parameters say

Result<bool, Failure> has_called(MaybeFailure failure) {
  return failure ? Result<bool, Failure>(*std::move(failure)) : true;
}

}  // namespace

[[gnu::hot]] Result<bool, Failure> WordCalls::call_in_block() {
  cancels_ = false;
  returns_ = false;
  const auto& modal = frame().modal_calls;
  bool every_block = !modal.empty() && modal.back()->every_block;
  const std::uint32_t letters = every_block ? letters_of("G") : control_.code_calls.letters;
  const bool codes_call = every_block || !control_.code_calls.macro_by_g.empty();
  const auto words = words_.has_any(letters) ? words_.all() : std::span<const EvaluatedWord>();
  for (const EvaluatedWord& word : words) {
    if ((letters >> (word.letter - 'A') & 1U) == 0 ||
        (word.letter == 'G' && word.number < kFirstCall && !codes_call)) {
      continue;
    }
    auto called = word.letter == 'G'   ? call_by_g(word, every_block)
                  : word.letter == 'M' ? call_by_m(word)
                                       : call_by_address(word);
    if (!called || called.value() || returns_) {
      return called;
    }
    every_block = every_block && !cancels_;
  }
  return every_block ? has_called(macros_.every_block_call()) : false;
}

[[gnu::hot]] Result<bool, Failure> WordCalls::call_by_g(const EvaluatedWord& word,
                                                        bool every_block) {
  if (word.number == kCancelModal) {
    cancels_ = true;
    auto failure = macros_.cancel_modal(word);
    return failure ? Result<bool, Failure>(*std::move(failure)) : false;
  }
  if (every_block) {
    return has_called(macros_.every_block_call());
  }
  if (word.number == 65.0) {
    return has_called(macros_.call(word));
  }
  if (word.number == 66.0 || word.number == 66.1) {
    return has_called(macros_.set_modal(word));
  }
  const auto& macro_by_g = control_.code_calls.macro_by_g;
  const int code = nearest_integer(word.number);
  const auto call = macro_by_g.find(code);
  if (call != macro_by_g.end() && word.number == code && may_call(CalledBy::GCode)) {
    return has_called(macros_.call_by_code(word, call->second, CalledBy::GCode));
  }
  return false;
}

Result<bool, Failure> WordCalls::call_by_m(const EvaluatedWord& word) {
  const int code = nearest_integer(word.number);
  if (word.form == ValueForm::Decimal) {
    return false;
  }
  if (code == 98 || subprograms_.calls_external(code)) {
    return has_called(subprograms_.call(word));
  }
  if (code == kReturn) {
    returns_ = true;
    return false;
  }
  if (control_.profile.has_local_calls && code == kLocalCall) {
    return has_called(subprograms_.call_local(word));
  }
  if (control_.profile.has_local_calls && code == kJumpByInput) {
    return has_called(subprograms_.jump_by_input(word));
  }
  if (!may_call(CalledBy::Address)) {
    return false;
  }
  // Behind other words it is an ordinary M code (MB-209).
  const bool comes_first = &word == &words_.all().front();
  const auto macro = control_.code_calls.macro_by_m.find(code);
  if (macro != control_.code_calls.macro_by_m.end() && comes_first) {
    return has_called(macros_.call_by_code(word, macro->second, CalledBy::Address));
  }
  const auto sub = control_.code_calls.subprogram_by_m.find(code);
  if (sub == control_.code_calls.subprogram_by_m.end()) {
    return false;
  }
  return has_called(subprograms_.call_by_code(word, sub->second));
}

/// T, S, B and the addresses of parameters 6090 and 6091 (MB-211, MB-212).
Result<bool, Failure> WordCalls::call_by_address(const EvaluatedWord& word) {
  const AddressCall& call = address_call(word.letter);
  if (!may_call(CalledBy::Address)) {
    return false;
  }
  if (!fits_plain_word(word, control_.profile)) {
    return at_word(wrong_plain_word(word, control_.profile), word);
  }
  control_.variables.set_common(call.variable, Cell(argument_value(control_, word)));
  return has_called(subprograms_.call_by_code(word, call.program));
}

/// Inside a program that a code called, codes call nothing; with parameter 6008.6 those of the
/// other kind do (MB-208).
bool WordCalls::may_call(CalledBy by) const {
  const bool nests = control_.profile.has_series_30i_functions() &&
                     control_.parameters.is_on(ParameterId::NestedCodeCalls);
  for (const Frame& level : stack_.frames()) {
    if (level.by == by || (level.by != CalledBy::Program && !nests)) {
      return false;
    }
  }
  return true;
}

}  // namespace g31::fanuc

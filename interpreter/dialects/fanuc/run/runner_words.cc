#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/run/runner.h"
#include "interpreter/dialects/fanuc/text/scanner.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

/// No address of any control takes more (MB-032); it keeps positions and times finite, too.
constexpr double kLargestWord = 999'999'999.0;

bool is_dwell(const BlockWords& words) {
  const EvaluatedWord* const g = words.find('G');
  return g != nullptr && g->number == 4.0;
}

}  // namespace

MaybeFailure Runner::evaluate_words(const Step& step) {
  const CompiledProgram& program = *frame().program;
  const syntax::Block& block = program.tree->blocks[step.block];
  words_.clear();
  read_by_words_.clear();
  runtime::MissedTouches& missed = control_.touches.missed;
  for (syntax::Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const syntax::Word& word = program.tree->words[i];
    if (word.letter == '/') {
      if (skips_rest(word)) {
        break;
      }
      continue;
    }
    double number = word.number;
    if (word.form == ValueForm::Computed) {
      const double increment = 1.0 / control_.scale.length_counts();
      const Cell value =
          control_.evaluator.value(program, program.word_code[i - program.first_word], increment);
      if (control_.evaluator.failed()) {
        return from_evaluation();
      }
      if (value.is_vacant()) {
        continue;
      }
      number = value.raw();
      if (auto reading = missed.any() ? missed.set_aside() : nullptr) {
        read_by_words_.emplace_back(word.span.begin, std::move(reading));
      }
    } else if (word.digits > control_.profile.word_digit_limit) {
      return at_place(AlarmId::TooManyDigits, word.span, digit_count(word.digits));
    }
    if (std::abs(number) > kLargestWord) {
      return at_place(AlarmId::TooManyDigits, word.span,
                      fmt::format("{} is {:g}, beyond every address", word.letter, number));
    }
    words_.add(word, number);
  }
  for (const auto& [begin, reading] : read_by_words_) {
    missed.reads(reading);
  }
  return std::nullopt;
}

/// A `/` in the middle of a block: some controls skip from there, others refuse it (MB-006).
bool Runner::skips_rest(const syntax::Word& word) {
  control_.warn_once(source::DiagnosticId::SkipInsideBlock, location(word.span));
  return control_.block_skip.contains(static_cast<int>(word.number));
}

MaybeFailure Runner::nc_block(const Step& step) {
  if (const auto halt = control_.watch.before_work()) {
    return halt_failure(*halt);
  }
  if (auto failure = evaluate_words(step)) {
    return failure;
  }
  const syntax::Block& block = frame().program->tree->blocks[step.block];
  if (block.sequence >= 0) {
    control_.modal.word('N') = block.sequence;
    words_.set_sequence(block.sequence);
  }
  if (control_.profile.keeps_all_words) {
    keep_words();
  }
  const auto called = call_in_block();
  if (!called) {
    return called.error();
  }
  if (called.value()) {
    control_.touches.missed.passes_on();
    return std::nullopt;
  }
  return plain_block(location(block.span));
}

/// What the words of a block do, calls apart.
MaybeFailure Runner::execute(const BlockWords& words, source::Location where) {
  if (auto failure = execute_block(control_, words, where)) {
    return failure;
  }
  const bool compensates = control_.cutter.compensation.engaged();
  if (!compensates && !control_.lookahead.is_judged()) {
    return std::nullopt;
  }
  const BlockEffect effect = effect_of(words, control_.profile, control_.parameters);
  control_.lookahead.executed(effect);
  // Cutter compensation reads past a dwell, though statements behind it see the axes stand.
  const bool breaks = effect == BlockEffect::Finishes && !is_dwell(words);
  return compensates && breaks ? end_read_ahead(control_) : std::nullopt;
}

/// A block that calls nothing; its motion may set off a modal call.
MaybeFailure Runner::plain_block(source::Location where) {
  const EvaluatedWord* const m = words_.find('M');
  if (auto failure = execute(words_, where)) {
    return failure;
  }
  control_.touches.missed.moves();
  if (auto failure = skip_check(where)) {
    return failure;
  }
  if (auto failure = program_stop(m != nullptr ? nearest_integer(m->number) : -1, where)) {
    return failure;
  }
  return frame().modal_calls.empty() ? std::nullopt : modal_call();
}

/// M78 and M79 of a Haas: what the skip move of their block must come to.
MaybeFailure Runner::skip_check(source::Location where) {
  constexpr double kMustBeMissing = 78.0;
  constexpr double kMustCome = 79.0;
  const auto is_here = [&](const std::optional<source::Location>& skip) {
    return skip && skip->file == where.file && skip->begin == where.begin;
  };
  if (!control_.profile.checks_skip_signal) {
    return std::nullopt;
  }
  for (const EvaluatedWord& word : words_.all()) {
    if (word.letter == 'M' && word.number == kMustBeMissing) {
      if (is_here(control_.stopped_skip)) {
        return at_word(AlarmId::SkipSignalFound, word, "M78");
      }
      control_.touches.missed.asks();
    }
    if (word.letter == 'M' && word.number == kMustCome && is_here(control_.touches.missed.last())) {
      return at_word(AlarmId::SkipSignalMissing, word, "M79");
    }
  }
  return std::nullopt;
}

/// M00, M01, M02, M30: recorded stops and the end.
MaybeFailure Runner::program_stop(int m, source::Location where) {
  if (m == 0 || m == 1) {
    control_.observer.on_stop({m == 0 ? "M00" : "M01", "", where});
  }
  ended_ = m == 2 || m == 30;
  return std::nullopt;
}

}  // namespace g31::fanuc

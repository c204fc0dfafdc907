#include "interpreter/dialects/fanuc/run/running_words.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/code/word_limits.h"
#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/run/evaluation_failure.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

bool is_dwell(const BlockWords& words) {
  const EvaluatedWord* const g = words.find('G');
  return g != nullptr && g->number == 4.0;
}

}  // namespace

[[gnu::hot]] MaybeFailure RunningWords::read(const Step& step) {
  const CompiledProgram& program = *frame().program;
  const syntax::Block& block = program.tree->blocks[step.block];
  words_.clear();
  readings_.clear();
  const std::span all = std::span(program.tree->words).subspan(block.first_word, block.word_count);
  if (auto failure = block.is_plain ? read_plain(block, all) : read_all(program, all)) {
    return failure;
  }
  if (block.sequence >= 0) {
    control_.modal.word('N') = block.sequence;
    words_.set_sequence(block.sequence);
  }
  return std::nullopt;
}

/// Of a block in which nothing is to be worked out.
MaybeFailure RunningWords::read_plain(const syntax::Block& block,
                                      std::span<const syntax::Word> words) {
  const int most = control_.profile.word_digit_limit;
  if (block.digits > std::min(most, kDigitsOfLargestWord)) [[unlikely]] {
    for (const syntax::Word& word : words) {
      if (!fits_address(word.number, word.digits, most)) {
        return at_word(wrong_word(word.letter, word.number, word.digits, most), word);
      }
    }
  }
  words_.show(words, block.letters);
  return std::nullopt;
}

MaybeFailure RunningWords::read_all(const CompiledProgram& program,
                                    std::span<const syntax::Word> words) {
  runtime::MissedTouches& missed = control_.touches.missed;
  const int most = control_.profile.word_digit_limit;
  for (const syntax::Word& word : words) {
    if (word.letter == '/') {
      if (skips_rest(word)) {
        break;
      }
      continue;
    }
    double number = word.number;
    const bool is_computed = word.form == ValueForm::Computed;
    if (is_computed) {
      const double increment = 1.0 / control_.scale.length_counts();
      const auto place = static_cast<std::size_t>(&word - program.tree->words.data());
      const Cell value = control_.evaluator.value(
          program, program.word_code[place - program.first_word], increment);
      if (control_.evaluator.failed()) {
        return evaluation_failure(control_.evaluator);
      }
      if (value.is_vacant()) {
        continue;
      }
      number = value.raw();
      if (auto reading = missed.any() ? missed.set_aside() : nullptr) {
        readings_.emplace_back(word.span.begin, std::move(reading));
      }
    }
    const std::uint8_t digits = is_computed ? std::uint8_t{0} : word.digits;
    if (!fits_address(number, digits, most)) [[unlikely]] {
      return at_word(wrong_word(word.letter, number, digits, most), word);
    }
    words_.add(word, number);
  }
  for (const auto& [begin, reading] : readings_) {
    missed.reads(reading);
  }
  return std::nullopt;
}

/// A `/` in the middle of a block: some controls skip from there, others refuse it (MB-006).
bool RunningWords::skips_rest(const syntax::Word& word) {
  control_.warn_once(source::DiagnosticId::SkipInsideBlock, stack_.location(word.span));
  return control_.block_skip.contains(static_cast<int>(word.number));
}

void RunningWords::leave_out_end_of_call(bool returns) {
  BlockWords others = words_.only([returns](const EvaluatedWord& word) {
    const bool cancels = word.letter == 'G' && word.number == kCancelModal;
    return !cancels && !(returns && is_of_return(word));
  });
  others.set_sequence(words_.sequence());
  words_ = std::move(others);
}

[[gnu::hot]] MaybeFailure execute_words(Control& control, const BlockWords& words,
                                        source::Location where) {
  if (auto failure = execute_block(control, words, where)) {
    return failure;
  }
  const bool compensates = control.cutter.compensation.engaged();
  if (!compensates && !control.lookahead.is_judged()) {
    return std::nullopt;
  }
  const BlockEffect effect = effect_of(words, control.profile, control.parameters);
  control.lookahead.executed(effect);
  // Cutter compensation reads past a dwell, though statements behind it see the axes stand.
  const bool breaks = effect == BlockEffect::Finishes && !is_dwell(words);
  return compensates && breaks ? end_read_ahead(control) : std::nullopt;
}

}  // namespace g31::fanuc

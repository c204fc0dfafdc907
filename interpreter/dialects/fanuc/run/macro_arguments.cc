#include "interpreter/dialects/fanuc/run/macro_arguments.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/state/expression_reads.h"
#include "interpreter/dialects/fanuc/vocabulary/argument_letters.h"

namespace g31::fanuc {
namespace {

using syntax::ValueForm;

/// Where arguments wait that modal calls keep: below all levels of locals.
std::size_t modal_depth(std::size_t which) {
  constexpr std::size_t kBelowAll = 1000;
  return kBelowAll + which;
}

}  // namespace

double argument_value(const Control& control, const EvaluatedWord& word) {
  if (word.form != ValueForm::Integer) {
    return word.number;
  }
  if (kIncrementArguments.find(word.letter) != std::string_view::npos) {
    return control.scale.length(word);
  }
  const bool is_feed = word.letter == 'E' || word.letter == 'F';
  return is_feed && control.profile.counts_feed_arguments ? written_feed(control, word)
                                                          : word.number;
}

MaybeFailure MacroArguments::put_among(Variables::Locals& locals,
                                       std::span<const EvaluatedWord> arguments) {
  const bool triples = !control_.parameters.is_on(ParameterId::OneTriple);
  int triple = 0;
  char last_of_triple = 'A';
  std::string in_triple;
  made_of_.clear();
  for (const EvaluatedWord& word : arguments) {
    int variable = argument_variable(word.letter);
    if (variable == 0) {
      return at_word(no_argument(word.letter), word);
    }
    if (triples && word.letter >= 'I' && word.letter <= 'K') {
      const bool begins = word.letter <= last_of_triple;
      if (begins && in_triple.find(word.letter) == in_triple.npos) {
        control_.warn_once(source::DiagnosticId::TripleOutOfOrder, stack_.location(word.span),
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
    locals[static_cast<std::size_t>(variable)] = Cell(argument_value(control_, word));
    for (const auto& [begin, reading] : running_.readings()) {
      if (begin == word.span.begin) {
        made_of_.emplace_back(variable, reading);
      }
    }
  }
  return std::nullopt;
}

/// Each argument by itself: what the block has read as a whole is of no variable.
void MacroArguments::assign_to(std::size_t depth) {
  runtime::MissedTouches& missed = control_.touches.missed;
  missed.passes_on();
  for (const auto& [variable, reading] : made_of_) {
    missed.reads(reading);
    missed.assigns(holder_of(depth, variable));
  }
}

void MacroArguments::follow() {
  assign_to(control_.variables.depth());
}

void MacroArguments::keep_for_modal_call(std::size_t which) {
  const std::size_t depth = modal_depth(which);
  control_.touches.missed.forget(holder_of(depth, kFirstLocal), holder_of(depth, kLocalCount));
  assign_to(depth);
}

void MacroArguments::follow_modal_call(std::size_t which) {
  runtime::MissedTouches& missed = control_.touches.missed;
  missed.passes_on();
  for (std::int32_t variable = kFirstLocal; missed.any() && variable <= kLocalCount; ++variable) {
    missed.reads(holder_of(modal_depth(which), variable));
    missed.assigns(holder_of(control_.variables.depth(), variable));
  }
}

void MacroArguments::keep_words() {
  for (const EvaluatedWord& word : running_.words().all()) {
    const int variable = argument_variable(word.letter);
    if (variable != 0) {
      control_.modal.arguments.at(static_cast<std::size_t>(variable)) =
          word.letter == 'F' ? written_feed(control_, word) : argument_value(control_, word);
    }
  }
}

}  // namespace g31::fanuc

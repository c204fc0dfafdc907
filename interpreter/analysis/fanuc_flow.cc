#include "interpreter/analysis/fanuc_flow.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "interpreter/analysis/fanuc_accesses.h"
#include "interpreter/analysis/fanuc_constants.h"
#include "interpreter/analysis/fanuc_moves.h"
#include "interpreter/analysis/flow_builder.h"
#include "interpreter/dialects/fanuc/code/exits.h"

namespace g31::analysis {
namespace {

using syntax::BlockKind;
using syntax::Index;
using syntax::ValueForm;
using syntax::Word;

/// In messages.
std::string shown_name(const fanuc::CompiledProgram& program) {
  return program.key.is_empty() ? std::string("the program") : to_text(program.key);
}

class FanucTranslation {
 public:
  using AlarmId = fanuc::AlarmId;
  using OpCode = fanuc::OpCode;
  using Step = fanuc::Step;

  FanucTranslation(const fanuc::CompiledProgram& program, const fanuc::Profile& profile,
                   const WordReading& reading)
      : program_(program),
        profile_(profile),
        reading_(reading),
        words_(program, profile, reading),
        builder_(to_text(program.key), *program.file) {}

  Flow run() {
    for (Index i = 0; i < program_.steps.size(); ++i) {
      step(i);
    }
    return builder_.finish();
  }

 private:
  void step(Index index);
  void follow(Index index);
  void nc_words(const syntax::Block& block);
  void call(const syntax::Block& block, const Word& code);
  void local_target(const syntax::Block& block, const Word& code);
  [[nodiscard]] bool is_missing_block(const Word& word) const;
  void tell_missing_block(const Word& word);
  [[nodiscard]] std::string target_of(const Word& p) const;
  void add_unsimulated(const Word& code);
  void constant_jump(const Step& step, Index index, double sequence, bool goes);
  void stop(Fault fault);
  [[nodiscard]] Fault fault_of(AlarmId id, syntax::ShortSpan where,
                               const std::string& detail) const;
  [[nodiscard]] std::optional<double> constant_value(Index code) const;
  [[nodiscard]] const Word* last_word(const syntax::Block& block, char letter) const;

  const fanuc::CompiledProgram& program_;
  const fanuc::Profile& profile_;
  const WordReading& reading_;
  FanucWords words_;
  FlowBuilder builder_;
  bool stops_ = false;  ///< an alarm ends every run of the present block
};

Fault FanucTranslation::fault_of(AlarmId id, syntax::ShortSpan where,
                                 const std::string& detail) const {
  const fanuc::AlarmInfo& row = fanuc::info(id);
  const bool of_target =
      id == AlarmId::JumpNotFound || id == AlarmId::IllegalJump || id == AlarmId::SequenceNotFound;
  return {of_target                    ? Fault::Kind::Target
          : id == AlarmId::EndOfRecord ? Fault::Kind::End
                                       : Fault::Kind::Block,
          fanuc::number_of(id, profile_.alarm_numbers), where,
          fmt::format("{}: {}", row.text, detail), std::string(row.remedy)};
}

void FanucTranslation::stop(Fault fault) {
  builder_.fault(std::move(fault));
  stops_ = true;
}

void FanucTranslation::step(Index index) {
  const Step& step = program_.steps[index];
  const syntax::Block& block = program_.tree->blocks[step.block];
  builder_.begin_block(block.span);
  stops_ = false;
  if (block.sequence >= 0) {
    builder_.label(fmt::format("N{}", block.sequence));
  }
  const WordFindings words = step.kind == BlockKind::Nc ? words_.judge(block) : WordFindings();
  for (const LostPoint& lost : words.lost_points) {
    builder_.fault({Fault::Kind::LostPoint, 0, lost.where, lost.message, lost.remedy});
  }
  if (step.kind == BlockKind::Bad) {
    const syntax::SyntaxError& error = program_.errors[static_cast<std::size_t>(step.number)];
    stop(fault_of(static_cast<AlarmId>(error.error), error.where, error.message));
  } else if (step.kind == BlockKind::Nc) {
    nc_words(block);
    add_moves(program_, block, profile_, builder_);
  } else if (step.kind == BlockKind::Assign) {
    stops_ = fanuc::is_macro_alarm(step);
  }
  const auto constant = stops_ ? std::nullopt : wrong_constant(program_, step, profile_);
  if (const auto& found = constant || stops_ ? constant : words.wrong) {
    stop(fault_of(found->wrong.id, found->where, found->wrong.detail));
  }
  add_accesses(program_, step, builder_);
  follow(index);
  Leaves& leaves = builder_.block().leaves;
  leaves.by_alarm = stops_;
  if (leaves.by_running_out && !leaves.by_end && !leaves.by_return) {
    builder_.fault(fault_of(AlarmId::EndOfRecord, block.span,
                            fmt::format("{} ends without M30, M02 or M99", shown_name(program_))));
  }
}

/// Where the program goes on: what the step's exits say.
void FanucTranslation::follow(Index index) {
  const Step& step = program_.steps[index];
  const fanuc::StepExits exits = fanuc::exits_of(program_, index);
  for (const Index to : exits.steps()) {
    const bool is_next = to == index + 1;
    const bool is_skip = is_next && step.skip_switch != 0;
    if (stops_ && !is_skip) {
      continue;
    }
    if (to < program_.steps.size()) {
      const bool is_behind = is_next && step.kind != BlockKind::Goto;
      builder_.edge(to, is_behind || is_skip ? EdgeKind::Next : EdgeKind::Jump);
    } else {
      builder_.block().leaves.by_running_out = true;
    }
  }
  if (stops_) {
    return;
  }
  const bool jumps = step.kind == BlockKind::Goto || step.kind == BlockKind::IfGoto;
  const auto sequence = jumps ? constant_value(step.value) : std::nullopt;
  if (sequence) {
    constant_jump(step, index, *sequence, exits.any_label);
  } else if (exits.any_label) {
    builder_.block().to_any_label = true;
  }
}

/// GOTO with a number.
/// @param goes  the compiler did not link it; else its condition never holds, or it is an edge
void FanucTranslation::constant_jump(const Step& step, Index index, double sequence, bool goes) {
  const double rounded = std::round(sequence);
  const bool in_range = rounded >= profile_.smallest_target && rounded <= profile_.largest_sequence;
  const auto found =
      in_range ? program_.find_label(static_cast<std::int32_t>(rounded), index) : std::nullopt;
  if (found) {
    if (goes) {
      builder_.edge(*found, EdgeKind::Jump);
    }
    return;
  }
  builder_.fault(fault_of(in_range ? AlarmId::JumpNotFound : AlarmId::IllegalJump,
                          program_.op_spans[step.value],
                          in_range ? fmt::format("{} has no N{}", shown_name(program_), rounded)
                                   : fmt::format("GOTO {}", rounded)));
  stops_ = step.kind == BlockKind::Goto;
}

std::optional<double> FanucTranslation::constant_value(Index code) const {
  const fanuc::Op& op = program_.ops[code];
  return op.code == OpCode::End ? fanuc::constant_in(program_, op.a) : std::nullopt;
}

const Word* FanucTranslation::last_word(const syntax::Block& block, char letter) const {
  const Word* found = nullptr;
  for (Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    found = program_.tree->words[i].letter == letter ? &program_.tree->words[i] : found;
  }
  return found;
}

/// Ends and calls; of several calls in a block the first counts.
void FanucTranslation::nc_words(const syntax::Block& block) {
  bool has_call = false;
  for (Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const Word& word = program_.tree->words[i];
    const bool is_computed = word.form == ValueForm::Computed;
    Leaves& leaves = builder_.block().leaves;
    if (word.letter == 'M') {
      leaves.by_end |= is_computed || word.number == 2.0 || word.number == 30.0;
      leaves.by_return |= is_computed || word.number == 99.0;
    }
    if (fanuc::calls_program(word) && !has_call) {
      has_call = true;
      call(block, word);
    } else if (word.letter == 'M' && !is_computed && profile_.has_local_calls) {
      local_target(block, word);
    } else if (!has_call && !is_computed && word.letter == 'G') {
      add_unsimulated(word);
    }
  }
}

/// A code that a run refuses or passes over: the control does not, or it lacks a code of its
/// family.
void FanucTranslation::add_unsimulated(const Word& code) {
  const fanuc::GCode* const row = fanuc::find_g_code(code.number, profile_.own_g_codes);
  // Sheet and parameters make numbers call macros, which a check without them cannot know; builders
  // take those from 100 on.  A sheet that makes one a call says all of them.  G66.1 makes arguments
  // of all words.
  const bool may_be_called = row == nullptr && reading_.calling_codes.empty() &&
                             code.number >= fanuc::kFirstCallingCode &&
                             code.number <= fanuc::kLastCallingCode;
  if (may_be_called || reading_.every_block_calls ||
      reading_.calling_codes.contains(fanuc::nearest_integer(code.number))) {
    return;
  }
  if (row == nullptr) {
    builder_.fault({Fault::Kind::NotSimulated,
                    fanuc::number_of(AlarmId::ImproperGCode, profile_.alarm_numbers), code.span,
                    fmt::format("G{}, which this control has not: a run ends here", code.number),
                    ""});
    return;
  }
  const bool is_missing = !fanuc::has_g_code(profile_, *row);
  const bool ends_run = is_missing || row->action == fanuc::GAction::Refused;
  if (ends_run || fanuc::is_passed_over(row->action)) {
    const int alarm =
        ends_run ? fanuc::number_of(AlarmId::ImproperGCode, profile_.alarm_numbers) : 0;
    builder_.fault({Fault::Kind::NotSimulated, alarm, code.span,
                    fmt::format("{}, {}: {}", to_text(row->number),
                                is_missing ? "which this control has not" : row->text,
                                ends_run ? "a run ends here" : "a run passes over it"),
                    ""});
  }
}

/// M97 P calls blocks of the program itself, M96 P Q goes on at one where an input is off.
void FanucTranslation::local_target(const syntax::Block& block, const Word& code) {
  const bool calls = code.number == fanuc::kLocalCall;
  if (!calls && code.number != fanuc::kJumpByInput) {
    return;
  }
  const bool may_be_skipped = last_word(block, '/') != nullptr;
  const Word* const p = last_word(block, 'P');
  if (p == nullptr && calls) {
    builder_.fault(fault_of(AlarmId::CallWithoutProgram, code.span, "M97 without P"));
    stops_ = !may_be_skipped;
  } else if (p != nullptr && is_missing_block(*p)) {
    tell_missing_block(*p);
    stops_ = calls && !may_be_skipped;
  }
}

/// Whether a word names a block that the program has not.
bool FanucTranslation::is_missing_block(const Word& word) const {
  return word.form == ValueForm::Integer && program_.extent == fanuc::Extent::Whole &&
         !program_.find_label(static_cast<std::int32_t>(word.number), 0);
}

void FanucTranslation::tell_missing_block(const Word& word) {
  builder_.fault(
      fault_of(AlarmId::SequenceNotFound, word.span, fmt::format("no N{}", word.number)));
}

/// Which program a call names; empty: only a run knows.
std::string FanucTranslation::target_of(const Word& p) const {
  return p.form == ValueForm::Name
             ? to_text(fanuc::key_between_angles(program_.file->text(), p.span))
         : p.form == ValueForm::Integer ? fmt::format("O{:04}", p.number)
                                        : std::string();
}

void FanucTranslation::call(const syntax::Block& block, const Word& code) {
  const Word* const p = last_word(block, 'P');
  const bool is_subprogram = code.letter == 'M';
  const bool may_be_skipped = last_word(block, '/') != nullptr;
  if (p == nullptr) {
    // M98 Q100 calls the program itself.
    const Word* const start = last_word(block, profile_.start_letter);
    if (!is_subprogram || start == nullptr) {
      builder_.fault(fault_of(AlarmId::CallWithoutProgram, code.span,
                              fmt::format("{}{} without P", code.letter, code.number)));
      stops_ = !may_be_skipped;
    } else if (is_missing_block(*start)) {
      tell_missing_block(*start);
      stops_ = !may_be_skipped;
    } else {
      builder_.call({Call::Kind::Subprogram, to_text(program_.key), false, code.span, {}});
    }
    return;
  }
  const Word* const l = last_word(block, 'L');
  if (const auto found = l != nullptr ? wrong_repeats(*l) : std::nullopt) {
    builder_.fault(fault_of(found->wrong.id, found->where, found->wrong.detail));
    stops_ = !may_be_skipped;
    return;
  }
  Call made;
  made.kind = is_subprogram         ? Call::Kind::Subprogram
              : code.number == 65.0 ? Call::Kind::Macro
                                    : Call::Kind::Modal;
  made.target = target_of(*p);
  made.where = p->span;
  const Word* const start = is_subprogram ? last_word(block, profile_.start_letter) : nullptr;
  if (start != nullptr && start->form == ValueForm::Integer && profile_.starts_in_called) {
    made.start = {static_cast<std::int32_t>(start->number), start->span};
  }
  builder_.call(std::move(made));
}

}  // namespace

Flow flow_of(const fanuc::CompiledProgram& program, const fanuc::Profile& profile,
             const WordReading& reading) {
  return FanucTranslation(program, profile, reading).run();
}

}  // namespace g31::analysis

#include "interpreter/dialects/fanuc/code/compile.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/code/compile_expression.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using syntax::Block;
using syntax::BlockKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Index;
using syntax::kNone;

/// Sequence numbers up to here exist on every control; the run judges larger ones (MB-172).
constexpr double kAlwaysInRange = 99'999.0;

class Compiler {
 public:
  Compiler(const source::SourceFile& file, const syntax::Tree& tree, std::size_t which,
           const Profile& profile, Extent extent)
      : tree_(tree), program_(tree.programs.at(which)), profile_(profile) {
    out_.extent = extent;
    out_.key = key_in(file.text(), program_);
    out_.file = &file;
    out_.tree = &tree;
    out_.constants.emplace_back();
  }

  CompiledProgram run() {
    const Index end = program_.first_block + program_.block_count;
    out_.steps.reserve(program_.block_count);
    out_.first_word =
        end > program_.first_block ? tree_.blocks[program_.first_block].first_word : 0;
    bool has_statements = false;
    for (Index i = program_.first_block; i < end; ++i) {
      const BlockKind kind = tree_.blocks[i].kind;
      has_statements |= kind != BlockKind::Nc && kind != BlockKind::Empty;
      step(i);
    }
    const bool is_whole = out_.extent == Extent::Whole;
    if (is_whole && !std::ranges::is_sorted(out_.labels, {}, &Label::sequence)) {
      std::ranges::stable_sort(out_.labels, {}, &Label::sequence);
    }
    if (has_statements) {
      link_then();
      link_loops();
      if (is_whole) {
        link_jumps();
      }
    }
    return std::move(out_);
  }

 private:
  void step(Index block_index);
  void assign(const Block& block, Step& step);
  void nc_words(const Block& block, Step& step);
  void called_name(const Block& block, const syntax::Word& name, Step& step);
  void link_then();
  void link_loops();
  [[nodiscard]] bool is_conditional(Index block) const;
  [[nodiscard]] bool goes_on(const Step& step) const;
  void judge_loop(Step& step, std::size_t depth);
  void link_jumps();
  [[gnu::cold]] void refuse_statement_beside(Index words, Step& step);
  void mark_bad(Step& step, AlarmId id, syntax::ShortSpan where, std::string message);

  const syntax::Tree& tree_;
  const syntax::Program& program_;
  const Profile& profile_;
  CompiledProgram out_;
  ExpressionCompiler expressions_{tree_, profile_, out_};
};

void Compiler::mark_bad(Step& step, AlarmId id, syntax::ShortSpan where, std::string message) {
  step.kind = BlockKind::Bad;
  step.number = static_cast<std::int32_t>(out_.errors.size());
  out_.errors.push_back({static_cast<int>(id), where, std::move(message)});
}

void Compiler::step(Index block_index) {
  const Block& block = tree_.blocks[block_index];
  if (block.sequence >= 0) {
    out_.labels.push_back({block.sequence, static_cast<Index>(out_.steps.size())});
  }
  Step& step = out_.steps.emplace_back();  // a copy would wait for its parts
  step.kind = block.kind;
  step.skip_switch = block.skip_switch;
  step.number = block.number;
  step.block = block_index;
  switch (block.kind) {
    case BlockKind::Empty:
    case BlockKind::Do:
    case BlockKind::End:
    case BlockKind::Output:
    case BlockKind::SetNames:
      break;
    case BlockKind::Nc:
      if (!block.is_plain) {
        nc_words(block, step);
      }
      if (!profile_.conditions_rule_blocks && (block.goes_on || is_conditional(block_index))) {
        refuse_statement_beside(block_index, step);
      }
      break;
    case BlockKind::Assign:
      assign(block, step);
      if (block.is_bare && !profile_.has_bare_message) {
        mark_bad(step, AlarmId::ExpressionFormat, block.span,
                 "a number is expected behind =, for example #3006=1(TEXT)");
      }
      break;
    case BlockKind::IfGoto:
      step.condition = expressions_.condition(block.condition);
      step.value = expressions_.value(block.value);
      break;
    case BlockKind::Goto:
      step.value = expressions_.value(block.value);
      break;
    case BlockKind::IfThen:
      step.condition = expressions_.condition(block.condition);
      if (!profile_.has_then && !block.is_bare) {
        mark_bad(step, AlarmId::StatementFormat, block.span,
                 "this control has no THEN, only IF [...] GOTO");
      }
      break;
    case BlockKind::While:
      step.condition = expressions_.condition(block.condition);
      break;
    case BlockKind::Bad: {
      const syntax::SyntaxError& error = tree_.errors[static_cast<std::size_t>(block.number)];
      mark_bad(step, static_cast<AlarmId>(error.error), error.where, error.message);
      break;
    }
  }
  if (auto misuse = expressions_.take_misuse()) {
    mark_bad(step, misuse->id, misuse->where, std::move(misuse->message));
  }
}

/// A statement in one block with words is that of some controls only.
void Compiler::refuse_statement_beside(Index words, Step& step) {
  if (is_conditional(words)) {
    mark_bad(step, AlarmId::StatementFormat, tree_.blocks[words].span,
             "THEN takes a macro statement, not a loop or NC words");
    return;
  }
  const Block& statement = tree_.blocks[words + 1];
  const bool is_jump = statement.kind == BlockKind::Goto;
  mark_bad(step, is_jump ? AlarmId::MixedStatement : AlarmId::IllegalAddress,
           {tree_.blocks[words].span.end, statement.span.end},
           is_jump ? "GOTO needs a block of its own" : "'[' is not an address letter");
}

/// Whether the block is what an IF decides upon.
bool Compiler::is_conditional(Index block) const {
  return block > program_.first_block && tree_.blocks[block - 1].kind == BlockKind::IfThen;
}

void Compiler::assign(const Block& block, Step& step) {
  const Expr& target = tree_.exprs[block.target];
  if (target.kind == ExprKind::Variable && tree_.exprs[target.a].kind == ExprKind::Number) {
    step.number = expressions_.written_number(tree_.exprs[target.a]);
    step.target_kind = is_local(step.number)    ? TargetKind::Local
                       : is_common(step.number) ? TargetKind::Common
                                                : TargetKind::Numbered;
  } else {
    step.target_kind = TargetKind::Computed;
    step.target = expressions_.target_number(target);
  }
  step.value = expressions_.value(block.value);
}

void Compiler::nc_words(const Block& block, Step& step) {
  for (Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const syntax::Word& word = tree_.words[i];
    if (word.form == syntax::ValueForm::Computed) {
      out_.word_code.resize(i - out_.first_word, kNone);
      out_.word_code.push_back(expressions_.value(word.expr));
    }
    if (word.form == syntax::ValueForm::Name) {
      called_name(block, word, step);
    }
    if (word.is_bare && !profile_.has_bare_expressions && step.kind != BlockKind::Bad) {
      mark_bad(step, AlarmId::IllegalAddress, word.span,
               fmt::format("an expression after {0} needs brackets: {0}[...]",
                           syntax::letter_text(word.letter)));
    }
  }
}

/// A call by `<NAME>`.
void Compiler::called_name(const Block& block, const syntax::Word& name, Step& step) {
  const auto words = std::span(tree_.words).subspan(block.first_word, block.word_count);
  if (!profile_.has_program_names) {
    mark_bad(step, AlarmId::NoProgramNames, name.span, "a call by name");
  } else if (!is_program_name(between_angles(out_.file->text(), name.span))) {
    mark_bad(step, AlarmId::CalledByNameFormat, name.span,
             "a name is 1 to 32 letters, digits and - + _ .");
  } else if (std::ranges::count(words, 'P', &syntax::Word::letter) > 1) {
    mark_bad(step, AlarmId::CalledByNameFormat, name.span, "P and a name call two programs");
  }
}

/// Whether the next step is of the same line: what a condition before it rules as well.
bool Compiler::goes_on(const Step& step) const {
  return step.kind == BlockKind::IfThen || tree_.blocks[step.block].goes_on;
}

void Compiler::link_then() {
  for (std::size_t i = 0; i < out_.steps.size(); ++i) {
    if (out_.steps[i].kind == BlockKind::IfThen) {
      std::size_t after = i + 1;
      while (after < out_.steps.size() && goes_on(out_.steps[after])) {
        ++after;
      }
      out_.steps[i].jump = static_cast<Index>(std::min(after + 1, out_.steps.size()));
    }
  }
}

/// Loops that this control does not know by number, or not so deep (MB-179, MB-339, MB-371).
void Compiler::judge_loop(Step& step, std::size_t depth) {
  const LoopRule& rule = profile_.loops;
  const syntax::ShortSpan where = tree_.blocks[step.block].span;
  if (step.number > rule.largest_number) {
    mark_bad(step, AlarmId::IllegalLoopNumber, where,
             fmt::format("a loop number is 1 to {}", rule.largest_number));
  } else if (depth > static_cast<std::size_t>(rule.nesting)) {
    mark_bad(step, AlarmId::IllegalLoopNumber, where,
             fmt::format("loops nest at most {} deep", rule.nesting));
  }
}

void Compiler::link_loops() {
  constexpr std::int32_t kAnyNumber = -1;
  struct Loop {
    Index step;
    std::int32_t number;
  };
  std::vector<Loop> open;
  for (Index i = 0; i < out_.steps.size(); ++i) {
    Step& step = out_.steps[i];
    if (step.kind == BlockKind::Bad && tree_.blocks[step.block].begins_loop) {
      open.push_back({i, kAnyNumber});
      out_.loops.open(static_cast<std::int32_t>(i));
    } else if (step.kind == BlockKind::While || step.kind == BlockKind::Do) {
      const bool is_open = std::ranges::find(open, step.number, &Loop::number) != open.end();
      open.push_back({i, step.number});
      out_.loops.open(static_cast<std::int32_t>(i));
      if (is_open) {
        mark_bad(step, AlarmId::EndMissing, tree_.blocks[step.block].span,
                 "a loop with this number is already open");
      } else {
        judge_loop(step, open.size());
      }
    } else if (step.kind == BlockKind::End) {
      if (open.empty() || (open.back().number != step.number && open.back().number != kAnyNumber)) {
        const AlarmId id = open.empty() ? AlarmId::DoMissing : AlarmId::EndMissing;
        mark_bad(
            step, id, tree_.blocks[step.block].span,
            open.empty() ? "this END has no DO" : "this END does not close the innermost loop");
        continue;
      }
      step.jump = open.back().step;
      out_.steps[open.back().step].jump = i + 1;
      out_.loops.close(static_cast<std::int32_t>(i + 1));
      open.pop_back();
    }
  }
  out_.loops.finish();
  for (const Loop& loop : open) {
    Step& step = out_.steps[loop.step];
    if (loop.number != kAnyNumber) {
      mark_bad(step, AlarmId::EndMissing, tree_.blocks[step.block].span, "this DO has no END");
    }
  }
}

void Compiler::link_jumps() {
  for (Index i = 0; i < out_.steps.size(); ++i) {
    Step& step = out_.steps[i];
    if (step.kind != BlockKind::Goto && step.kind != BlockKind::IfGoto) {
      continue;
    }
    if (const auto sequence = out_.constant_target(step)) {
      const auto found = out_.find_label(*sequence, i);
      step.jump = found.value_or(kNone);
      step.enters_loop = found && out_.enters_loop(i, *found);
    }
  }
}

}  // namespace

std::optional<Index> CompiledProgram::find_label(std::int32_t sequence, Index from) const {
  const auto first = std::ranges::lower_bound(labels, sequence, {}, &Label::sequence);
  const auto last = std::ranges::upper_bound(first, labels.end(), sequence, {}, &Label::sequence);
  if (first == last) {
    return std::nullopt;
  }
  const auto behind = std::ranges::upper_bound(first, last, from, {}, &Label::step);
  return behind != last ? behind->step : first->step;
}

std::optional<std::int32_t> CompiledProgram::constant_target(const Step& jump) const {
  const Op& target = ops[jump.value];
  if (target.code != OpCode::End || target.a.bank != Bank::Constants) {
    return std::nullopt;
  }
  const double sequence = constants[static_cast<std::size_t>(target.a.place)].or_zero();
  return sequence >= 1.0 && sequence <= kAlwaysInRange
             ? std::optional(static_cast<std::int32_t>(sequence))
             : std::nullopt;
}

bool CompiledProgram::enters_loop(Index from, Index to) const {
  return loops.enters(static_cast<std::int32_t>(from), static_cast<std::int32_t>(to));
}

ProgramKey key_in(std::string_view text, const syntax::Program& program) {
  return program.number != 0 ? ProgramKey{program.number, {}}
                             : ProgramKey{0, std::string(between_angles(text, program.name))};
}

CompiledProgram compile(const source::SourceFile& file, const syntax::Tree& tree, std::size_t which,
                        const Profile& profile, Extent extent) {
  return Compiler(file, tree, which, profile, extent).run();
}

}  // namespace g31::fanuc

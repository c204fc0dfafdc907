#include "interpreter/dialects/fanuc/compile.h"

#include <algorithm>
#include <cmath>
#include <ranges>

#include "interpreter/dialects/fanuc/variable_ranges.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using syntax::Block;
using syntax::BlockKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Index;
using syntax::kNone;
using syntax::Operator;

/// Sequence numbers up to here exist on every control; the run judges larger ones (MB-172).
constexpr double kAlwaysInRange = 99'999.0;

bool is_comparison(const Expr& expr) {
  return expr.kind == ExprKind::Binary && expr.op >= Operator::Equal;
}

/// #12 and #[12.5]: the number of the variable, rounded as a computed one is (MB-099).
std::int32_t literal_variable(const Expr& number) {
  return static_cast<std::int32_t>(std::round(std::min(number.number, 1e9)));
}

class Compiler {
 public:
  Compiler(const source::SourceFile& file, const syntax::Tree& tree, const syntax::Program& program)
      : tree_(tree), program_(program) {
    out_.number = program.number;
    out_.file = &file;
    out_.tree = &tree;
  }

  CompiledProgram run() {
    const Index end = program_.first_block + program_.block_count;
    out_.steps.reserve(program_.block_count);
    out_.first_word = end > program_.first_block ? tree_.blocks[program_.first_block].first_word : 0;
    for (Index i = program_.first_block; i < end; ++i) {
      step(i);
    }
    link_then();
    link_loops();
    std::ranges::stable_sort(out_.labels, {}, &Label::sequence);
    link_jumps();
    return std::move(out_);
  }

 private:
  void step(Index block_index);
  void assign(const Block& block, Step& step);
  void nc_words(const Block& block);
  void link_then();
  void link_loops();
  void link_jumps();
  Index code(Index expr);
  Index condition_code(const Block& block, Step& step);
  void emit(Index expr);
  void emit_chain(Index index);
  void emit_variable(const Expr& expr);
  void push(const Op& op, syntax::ShortSpan span);
  void mark_bad(Step& step, AlarmId id, syntax::ShortSpan where, std::string message);

  const syntax::Tree& tree_;
  const syntax::Program& program_;
  CompiledProgram out_;
  Index condition_ = kNone;  ///< the comparison that IF or WHILE asks for
  std::optional<syntax::ShortSpan> misplaced_comparison_;
};

void Compiler::mark_bad(Step& step, AlarmId id, syntax::ShortSpan where, std::string message) {
  step.kind = BlockKind::Bad;
  step.number = static_cast<std::int32_t>(out_.errors.size());
  out_.errors.push_back({static_cast<int>(id), where, std::move(message)});
}

void Compiler::step(Index block_index) {
  const Block& block = tree_.blocks[block_index];
  Step step;
  step.kind = block.kind;
  step.skip_switch = block.skip_switch;
  step.number = block.number;
  step.block = block_index;
  if (block.sequence >= 0) {
    out_.labels.push_back({block.sequence, static_cast<Index>(out_.steps.size())});
  }
  switch (block.kind) {
    case BlockKind::Empty:
    case BlockKind::Do:
    case BlockKind::End:
    case BlockKind::Output:
    case BlockKind::SetNames:
      break;
    case BlockKind::Nc:
      nc_words(block);
      break;
    case BlockKind::Assign:
      assign(block, step);
      break;
    case BlockKind::IfGoto:
      step.condition = condition_code(block, step);
      step.value = code(block.value);
      break;
    case BlockKind::Goto:
      step.value = code(block.value);
      break;
    case BlockKind::IfThen:
    case BlockKind::While:
      step.condition = condition_code(block, step);
      break;
    case BlockKind::Bad: {
      const syntax::SyntaxError& error = tree_.errors[static_cast<std::size_t>(block.number)];
      mark_bad(step, static_cast<AlarmId>(error.error), error.where, error.message);
      break;
    }
  }
  if (misplaced_comparison_) {
    mark_bad(step, AlarmId::ExpressionFormat, *misplaced_comparison_,
             "a comparison is no number; it stands in IF and WHILE only");
    misplaced_comparison_.reset();
  }
  out_.steps.push_back(step);
}

void Compiler::assign(const Block& block, Step& step) {
  const Expr& target = tree_.exprs[block.target];
  const Expr& number = tree_.exprs[target.a];
  if (number.kind == ExprKind::Number) {
    step.number = literal_variable(number);
    step.target_kind = variable_kind(step.number);
  } else {
    step.target_kind = OpCode::Indirect;
    step.target = code(target.a);
  }
  step.value = code(block.value);
}

void Compiler::nc_words(const Block& block) {
  for (Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const syntax::Word& word = tree_.words[i];
    out_.word_code.resize(i - out_.first_word, kNone);
    out_.word_code.push_back(word.form == syntax::ValueForm::Computed ? code(word.expr) : kNone);
  }
}

Index Compiler::condition_code(const Block& block, Step& step) {
  const Expr& condition = tree_.exprs[block.condition];
  if (!is_comparison(condition)) {
    mark_bad(step, AlarmId::StatementFormat, condition.span,
             "a condition compares two values with EQ NE GT LT GE or LE");
    return kNone;
  }
  condition_ = block.condition;
  return code(block.condition);
}

Index Compiler::code(Index expr) {
  const auto begin = static_cast<Index>(out_.ops.size());
  emit(expr);
  push({}, tree_.exprs[expr].span);
  return begin;
}

void Compiler::push(const Op& op, syntax::ShortSpan span) {
  out_.ops.push_back(op);
  out_.op_spans.push_back(span);
}

void Compiler::emit_variable(const Expr& expr) {
  const Expr& number = tree_.exprs[expr.a];
  Op op;
  if (number.kind == ExprKind::Number) {
    op.number = literal_variable(number);
    op.code = variable_kind(op.number);
  } else {
    emit(expr.a);
    op.code = OpCode::Indirect;
  }
  push(op, expr.span);
}

/// 1+2+3... is a tree as deep as it is long: its left side is walked in a loop, as no stack is as
/// deep as a hostile line is long.
void Compiler::emit_chain(Index index) {
  std::vector<Index> chain;
  Index left = index;
  for (; tree_.exprs[left].kind == ExprKind::Binary; left = tree_.exprs[left].a) {
    chain.push_back(left);
  }
  emit(left);
  for (const Index place : std::views::reverse(chain)) {
    const Expr& expr = tree_.exprs[place];
    emit(expr.b);
    if (is_comparison(expr) && place != condition_) {
      misplaced_comparison_ = expr.span;
    }
    Op op;
    op.code = OpCode::Binary;
    op.op = expr.op;
    push(op, expr.span);
  }
}

void Compiler::emit(Index index) {
  const Expr& expr = tree_.exprs[index];
  Op op;
  switch (expr.kind) {
    case ExprKind::Number:
      op.code = OpCode::Constant;
      op.constant = expr.number;
      op.number = expr.digits;
      break;
    case ExprKind::Variable:
      emit_variable(expr);
      return;
    case ExprKind::Negate:
      emit(expr.a);
      op.code = OpCode::Negate;
      break;
    case ExprKind::Binary:
      emit_chain(index);
      return;
    case ExprKind::Call:
      emit(expr.a);
      op.function = expr.function;
      op.code = OpCode::Call;
      if (expr.b != kNone) {
        emit(expr.b);
        op.code = OpCode::Call2;
      }
      break;
  }
  push(op, expr.span);
}

void Compiler::link_then() {
  for (std::size_t i = 0; i < out_.steps.size(); ++i) {
    if (out_.steps[i].kind == BlockKind::IfThen) {
      std::size_t after = i + 1;
      while (after < out_.steps.size() && out_.steps[after].kind == BlockKind::IfThen) {
        ++after;
      }
      out_.steps[i].jump = static_cast<Index>(std::min(after + 1, out_.steps.size()));
    }
  }
}

void Compiler::link_loops() {
  struct Loop {
    Index step;
    std::int32_t number;
  };
  std::vector<Loop> open;
  for (Index i = 0; i < out_.steps.size(); ++i) {
    Step& step = out_.steps[i];
    if (step.kind == BlockKind::While || step.kind == BlockKind::Do) {
      const bool is_open = std::ranges::find(open, step.number, &Loop::number) != open.end();
      open.push_back({i, step.number});
      if (is_open) {
        mark_bad(step, AlarmId::EndMissing, tree_.blocks[step.block].span,
                 "a loop of this number is open already");
      }
    } else if (step.kind == BlockKind::End) {
      if (open.empty() || open.back().number != step.number) {
        const AlarmId id = open.empty() ? AlarmId::DoMissing : AlarmId::EndMissing;
        mark_bad(step, id, tree_.blocks[step.block].span,
                 open.empty() ? "this END has no DO" : "this END closes another loop than the innermost");
        continue;
      }
      step.jump = open.back().step;
      out_.steps[open.back().step].jump = i + 1;
      open.pop_back();
    }
  }
  for (const Loop& loop : open) {
    Step& step = out_.steps[loop.step];
    mark_bad(step, AlarmId::EndMissing, tree_.blocks[step.block].span, "this DO has no END");
  }
}

void Compiler::link_jumps() {
  for (Index i = 0; i < out_.steps.size(); ++i) {
    Step& step = out_.steps[i];
    if (step.kind != BlockKind::Goto && step.kind != BlockKind::IfGoto) {
      continue;
    }
    const Op& target = out_.ops[step.value];
    const bool in_range = target.constant >= 1.0 && target.constant <= kAlwaysInRange;
    if (target.code == OpCode::Constant && out_.ops[step.value + 1].code == OpCode::End && in_range) {
      const auto found = out_.find_label(static_cast<std::int32_t>(target.constant), i);
      step.jump = found.value_or(kNone);
    }
  }
}

}  // namespace

std::optional<Index> CompiledProgram::find_label(std::int32_t sequence, Index from) const {
  const auto same = std::ranges::equal_range(labels, sequence, {}, &Label::sequence);
  if (same.empty()) {
    return std::nullopt;
  }
  const auto behind = std::ranges::upper_bound(same, from, {}, &Label::step);
  return behind != same.end() ? behind->step : same.front().step;
}

CompiledProgram compile(const source::SourceFile& file, const syntax::Tree& tree,
                        std::size_t which) {
  return Compiler(file, tree, tree.programs.at(which)).run();
}

}  // namespace g31::fanuc

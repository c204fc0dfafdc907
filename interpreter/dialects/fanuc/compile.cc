#include "interpreter/dialects/fanuc/compile.h"

#include <algorithm>

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

bool is_comparison(const Expr& expr) {
  return expr.kind == ExprKind::Binary && expr.op >= Operator::Equal;
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
  void emit_variable(const Expr& expr);
  void push(const Op& op, syntax::ShortSpan span);
  void mark_bad(Step& step, AlarmId id, syntax::ShortSpan where, std::string message);

  const syntax::Tree& tree_;
  const syntax::Program& program_;
  CompiledProgram out_;
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
  out_.steps.push_back(step);
}

void Compiler::assign(const Block& block, Step& step) {
  const Expr& target = tree_.exprs[block.target];
  const Expr& number = tree_.exprs[target.a];
  if (is_comparison(tree_.exprs[block.value])) {
    mark_bad(step, AlarmId::ExpressionFormat, tree_.exprs[block.value].span,
             "a comparison is no number; it stands in IF and WHILE only");
    return;
  }
  if (number.kind == ExprKind::Number) {
    step.number = static_cast<std::int32_t>(std::min(number.number, 1e9));
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
    op.number = static_cast<std::int32_t>(std::min(number.number, 1e9));
    op.code = variable_kind(op.number);
  } else {
    emit(expr.a);
    op.code = OpCode::Indirect;
  }
  push(op, expr.span);
}

void Compiler::emit(Index index) {
  const Expr& expr = tree_.exprs[index];
  Op op;
  switch (expr.kind) {
    case ExprKind::Number:
      op.code = OpCode::Constant;
      op.constant = expr.number;
      break;
    case ExprKind::Variable:
      emit_variable(expr);
      return;
    case ExprKind::Negate:
      emit(expr.a);
      op.code = OpCode::Negate;
      break;
    case ExprKind::Binary:
      emit(expr.a);
      emit(expr.b);
      op.code = OpCode::Binary;
      op.op = expr.op;
      break;
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
  std::vector<Index> open;
  for (Index i = 0; i < out_.steps.size(); ++i) {
    Step& step = out_.steps[i];
    if (step.kind == BlockKind::While || step.kind == BlockKind::Do) {
      open.push_back(i);
    } else if (step.kind == BlockKind::End) {
      if (open.empty() || out_.steps[open.back()].number != step.number) {
        const AlarmId id = open.empty() ? AlarmId::DoMissing : AlarmId::EndMissing;
        mark_bad(step, id, tree_.blocks[step.block].span,
                 open.empty() ? "this END has no DO" : "this END closes another loop than the innermost");
        continue;
      }
      step.jump = open.back();
      out_.steps[open.back()].jump = i + 1;
      open.pop_back();
    }
  }
  for (const Index i : open) {
    mark_bad(out_.steps[i], AlarmId::EndMissing, tree_.blocks[out_.steps[i].block].span,
             "this DO has no END");
  }
}

void Compiler::link_jumps() {
  for (Index i = 0; i < out_.steps.size(); ++i) {
    Step& step = out_.steps[i];
    if (step.kind != BlockKind::Goto && step.kind != BlockKind::IfGoto) {
      continue;
    }
    const Op& target = out_.ops[step.value];
    if (target.code == OpCode::Constant && out_.ops[step.value + 1].code == OpCode::End &&
        target.constant < 1e9) {
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

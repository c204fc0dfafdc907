#include "interpreter/analysis/fanuc_accesses.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/code/compile_expression.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"

namespace g31::analysis {
namespace {

using syntax::BlockKind;
using syntax::Expr;
using syntax::ExprKind;
using syntax::Index;
using syntax::kNone;

class FanucAccesses {
 public:
  FanucAccesses(const fanuc::CompiledProgram& program, FlowBuilder& builder)
      : program_(program), tree_(*program.tree), builder_(builder) {}

  void add(const syntax::Block& block) {
    read(block.condition);
    read(block.value);
    for (Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
      read(tree_.words[i].expr);
    }
    if (block.target != kNone) {
      read(tree_.exprs[block.target].a);  // the index of #[...]
    }
    std::ranges::stable_sort(found_, {}, [](const Found& f) { return f.where.begin; });
    for (const Found& found : found_) {
      add(found, Access::Kind::Read);
    }
    if (block.target != kNone) {
      add({variable_of(tree_.exprs[block.target]), tree_.exprs[block.target].span},
          Access::Kind::Write);
    }
  }

 private:
  struct Found {
    Variable variable;
    syntax::ShortSpan where;
  };

  /// Every variable of an expression.  Its own stack: a hostile line is longer than the program's.
  void read(Index expr) {
    std::vector<Index> open = {expr};
    while (!open.empty()) {
      const Index index = open.back();
      open.pop_back();
      if (index == kNone) {
        continue;
      }
      const Expr& now = tree_.exprs[index];
      if (now.kind == ExprKind::Variable || now.kind == ExprKind::Name) {
        const Variable variable = variable_of(now);
        if (!variable.name.empty()) {
          found_.push_back({variable, now.span});
        }
      }
      open.insert(open.end(), {now.a, now.b, now.c});
    }
  }

  /// #0 is no variable: its name is empty.
  [[nodiscard]] Variable variable_of(const Expr& expr) const {
    using Scope = Variable::Scope;
    if (expr.kind == ExprKind::Name) {
      const auto length = expr.span.end - expr.span.begin;
      return {Scope::Computed,
              fanuc::upper_case(program_.file->text().substr(expr.span.begin, length))};
    }
    if (tree_.exprs[expr.a].kind != ExprKind::Number) {
      return {Scope::Computed, "#[]"};
    }
    const std::int32_t number = fanuc::literal_variable(tree_.exprs[expr.a]);
    const Scope scope = fanuc::is_local(number)    ? Scope::Local
                        : fanuc::is_common(number) ? Scope::Global
                                                   : Scope::System;
    return {scope, number == 0 ? std::string() : fmt::format("#{}", number)};
  }

  void add(const Found& found, Access::Kind kind) {
    builder_.access(found.variable, {kind, 0, kWholeVariable, found.where});
  }

  const fanuc::CompiledProgram& program_;
  const syntax::Tree& tree_;
  FlowBuilder& builder_;
  std::vector<Found> found_;
};

}  // namespace

void add_accesses(const fanuc::CompiledProgram& program, const fanuc::Step& step,
                  FlowBuilder& builder) {
  if (step.kind != BlockKind::Bad) {
    FanucAccesses(program, builder).add(program.tree->blocks[step.block]);
  }
}

}  // namespace g31::analysis

#include <algorithm>

#include "interpreter/dialects/fanuc/code/compile.h"

namespace g31::fanuc {
namespace {

using syntax::BlockKind;
using syntax::Index;
using syntax::kNone;

/// Walks the control flow of one program from its first step.
class Walk {
 public:
  explicit Walk(const CompiledProgram& program)
      : program_(program), seen_(program.steps.size(), false) {}

  std::vector<bool> run() {
    visit(0);
    while (!open_.empty()) {
      const Index step = open_.back();
      open_.pop_back();
      follow(step);
    }
    return std::move(seen_);
  }

 private:
  void visit(Index step) {
    if (step < seen_.size() && !seen_[step]) {
      seen_[step] = true;
      open_.push_back(step);
    }
  }

  void visit_all_labels() {
    for (const Label& label : program_.labels) {
      visit(label.step);
    }
  }

  void follow(Index index);
  void follow_words(Index index);

  const CompiledProgram& program_;
  std::vector<bool> seen_;
  std::vector<Index> open_;
};

void Walk::follow(Index index) {
  const Step& step = program_.steps[index];
  if (step.skip_switch != 0) {
    visit(index + 1);
  }
  switch (step.kind) {
    case BlockKind::Goto:
    case BlockKind::IfGoto:
      if (step.jump != kNone) {
        visit(step.jump);
      } else {
        visit_all_labels();
      }
      if (step.kind == BlockKind::IfGoto) {
        visit(index + 1);
      }
      return;
    case BlockKind::IfThen:
    case BlockKind::While:
      visit(step.jump);
      visit(index + 1);
      return;
    case BlockKind::End:
      visit(step.jump);
      return;
    case BlockKind::Nc:
      follow_words(index);
      return;
    case BlockKind::Bad:
      return;
    case BlockKind::Empty:
    case BlockKind::Assign:
    case BlockKind::Do:
    case BlockKind::Output:
    case BlockKind::SetNames:
      visit(index + 1);
      return;
  }
}

void Walk::follow_words(Index index) {
  const syntax::Block& block = program_.tree->blocks[program_.steps[index].block];
  bool ends = false;
  bool names_target = false;
  bool may_be_skipped = false;
  for (Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const syntax::Word& word = program_.tree->words[i];
    may_be_skipped |= word.letter == '/';
    ends |= !may_be_skipped && word.letter == 'M' && word.form == syntax::ValueForm::Integer &&
            (word.number == 99.0 || word.number == 30.0 || word.number == 2.0);
    names_target |= word.letter == 'P';
  }
  if (!ends) {
    visit(index + 1);
  } else if (names_target) {
    visit_all_labels();  // M99 P in a main program goes on at any block of it
  }
}

}  // namespace

std::vector<syntax::SyntaxError> reachable_errors(const CompiledProgram& program) {
  std::vector<syntax::SyntaxError> found;
  const std::vector<bool> reached = Walk(program).run();
  for (std::size_t i = 0; i < program.steps.size(); ++i) {
    const Step& step = program.steps[i];
    if (reached[i] && step.kind == BlockKind::Bad) {
      found.push_back(program.errors[static_cast<std::size_t>(step.number)]);
    }
  }
  return found;
}

}  // namespace g31::fanuc

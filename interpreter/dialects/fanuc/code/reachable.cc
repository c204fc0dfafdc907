#include <vector>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/code/exits.h"

namespace g31::fanuc {
namespace {

using syntax::Index;

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
      follow(exits_of(program_, step));
      // A block behind a wrong one counts as reached, so that all mistakes are told at once.
      if (program_.steps[step].kind == syntax::BlockKind::Bad) {
        visit(step + 1);
      }
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

  void follow(const StepExits& exits) {
    for (const Index step : exits.steps()) {
      visit(step);
    }
    if (exits.any_label) {
      visit_all_labels();
    }
  }

  void visit_all_labels() {
    if (labels_visited_) {
      return;
    }
    labels_visited_ = true;
    for (const Label& label : program_.labels) {
      visit(label.step);
    }
  }

  const CompiledProgram& program_;
  std::vector<bool> seen_;
  std::vector<Index> open_;
  bool labels_visited_ = false;
};

}  // namespace

std::vector<syntax::SyntaxError> reachable_errors(const CompiledProgram& program) {
  std::vector<syntax::SyntaxError> found;
  if (program.errors.empty()) {
    return found;
  }
  const std::vector<bool> reached = Walk(program).run();
  for (std::size_t i = 0; i < program.steps.size(); ++i) {
    const Step& step = program.steps[i];
    if (reached[i] && step.kind == syntax::BlockKind::Bad) {
      found.push_back(program.errors[static_cast<std::size_t>(step.number)]);
    }
  }
  return found;
}

}  // namespace g31::fanuc

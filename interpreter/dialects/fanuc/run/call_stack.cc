#include "interpreter/dialects/fanuc/run/call_stack.h"

#include <algorithm>
#include <span>

namespace g31::fanuc {

std::string name_of(const CompiledProgram& program) {
  return program.key.is_empty() ? std::string("the main program") : to_text(program.key);
}

void CallStack::start(const CompiledProgram& main) {
  frames_.clear();
  push().program = &main;
}

Frame& CallStack::push() {
  Frame& begun = frames_.emplace_back();
  begun.number = ++begun_;
  return begun;
}

int CallStack::count(CallKind kind) const {
  const auto is_such = [kind](const Frame& level) { return level.kind == kind; };
  return static_cast<int>(std::ranges::count_if(frames_, is_such));
}

source::Location CallStack::location(syntax::ShortSpan span) const {
  return location_in(*frames_.back().program, span);
}

source::Location CallStack::location_of(const Frame& frame) {
  const CompiledProgram& program = *frame.program;
  return location_in(program, program.tree->blocks[program.steps[frame.current].block].span);
}

std::vector<runtime::CallLevel> CallStack::levels() const {
  std::vector<runtime::CallLevel> levels;
  for (std::size_t i = frames_.size(); i-- > 0;) {
    runtime::CallLevel& level = levels.emplace_back();
    level.program = name_of(*frames_[i].program);
    level.where = location_of(frames_[i]);
    level.number = frames_[i].number;
  }
  return levels;
}

std::size_t CallStack::locals_of(std::size_t level) const {
  if (frames_.empty()) {
    return 0;
  }
  const std::size_t calls = frames_.size() - std::min(level, frames_.size() - 1);
  const auto own_locals = [](const Frame& called) { return called.kind == CallKind::Macro; };
  return static_cast<std::size_t>(
      std::ranges::count_if(std::span(frames_).first(calls), own_locals));
}

}  // namespace g31::fanuc

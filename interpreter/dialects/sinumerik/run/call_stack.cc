#include "interpreter/dialects/sinumerik/run/call_stack.h"

#include <algorithm>

namespace g31::sinumerik {

CallStack::CallStack() {
  levels_.push_back(std::make_unique<Level>());
}

bool CallStack::is_full() const {
  constexpr std::size_t kDeepestLevel = 16;  // main program included
  std::size_t begun = depth_ + 1;
  for (std::size_t i = 0; i <= depth_; ++i) {
    begun += level(i).waiting.size();
  }
  return begun >= kDeepestLevel;
}

MaybeFailure CallStack::missing_of_main(const CompiledProgram& program) const {
  if (!program.sees_main || level(0).own_place().first->leads) {
    return std::nullopt;
  }
  const auto found = std::ranges::find(program.variables, Storage::OfMain,
                                       [](const Variable& one) { return one.storage; });
  return found != program.variables.end() ? MaybeFailure(failure(AlarmId::NotDefined, found->name))
                                          : std::nullopt;
}

Level& CallStack::next() {
  if (levels_.size() <= depth_ + 1) {
    levels_.push_back(std::make_unique<Level>());
  }
  return *levels_[depth_ + 1];
}

void CallStack::reset() {
  depth_ = 0;
  current_ = 0;
  has_ended_ = false;
  action_.reset();
  modal_call.reset();
  *levels_.front() = Level();
  level().number = ++begun_;
}

void CallStack::enter() {
  ++depth_;
  level().number = ++begun_;
}

source::Location CallStack::place_of(std::size_t which) const {
  if (action_ && action_->depth == which) {
    return action_->where;
  }
  const CompiledProgram& program = *level(which).program;
  const std::int32_t step = which == depth_ ? current_ : std::max(level(which).step - 1, 0);
  const auto at = static_cast<std::size_t>(step);
  return location_in(program, at < program.spans.size() ? program.spans[at] : ShortSpan());
}

std::size_t CallStack::shown_level() const {
  std::size_t which = depth_;
  for (; which > 0 && level(which).program->hides_blocks; --which) {
    if (level(which).program->shows_actual_block) {
      return depth_;
    }
  }
  return which;
}

/// What waits on a level for a text that runs there, the innermost first.
std::vector<runtime::CallSite> CallStack::waiting_on(const Level& level) {
  std::vector<runtime::CallSite> places;
  for (std::size_t i = level.waiting.size(); i-- > 0;) {
    const CompiledProgram& program = *level.waiting[i].program;
    const auto step = static_cast<std::size_t>(level.waiting[i].step - 1);
    places.push_back({program.name, location_in(program, program.spans[step])});
  }
  return places;
}

std::vector<runtime::CallLevel> CallStack::call_levels() const {
  std::vector<runtime::CallLevel> levels;
  for (std::size_t i = 0; i <= depth_; ++i) {
    if (level(i).program == nullptr) {
      return levels;
    }
  }
  const std::size_t shown = shown_level();
  for (std::size_t i = depth_ + 1; i-- > 0;) {
    levels.push_back(
        {level(i).program->name, place_of(i), i <= shown, level(i).number, waiting_on(level(i))});
  }
  return levels;
}

}  // namespace g31::sinumerik

#include "interpreter/dialects/sinumerik/code/program_windows.h"

#include <utility>

namespace g31::sinumerik {

ProgramWindows::Place ProgramWindows::next() {
  if (program_ != nullptr) {
    steps_before_ += static_cast<std::int32_t>(program_->ops.size()) - 1;  // EndWindow
  }
  CompiledWindow window = compile_window(filed_.source(), globals_, end_);
  const bool begins_with_other = window.end == end_ && end_ < filed_.source().text.end;
  if (begins_with_other) {
    program_.reset();
    return {&filed_.code(globals_), steps_before_};
  }
  program_ = std::move(window.program);
  end_ = window.end;
  return {program_.get(), 0};
}

}  // namespace g31::sinumerik

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/run/runner.h"

namespace g31::fanuc {

void Runner::begin(const runtime::Budget& budget, runtime::BlockListener* listener) {
  const CompiledProgram* const main = library_.main_program();
  if (main == nullptr) {
    outcome_.status = runtime::Status::SyntaxError;
    outcome_.diagnostics.push_back(
        make_diagnostic(source::DiagnosticId::NoProgramInFile, {library_.main_text(), {}}));
    is_over_ = true;
    return;
  }
  is_over_ = refuse_broken(*main);
  if (!is_over_) {
    start(*main);
    control_.watch = runtime::BlockWatch(budget, listener);
  }
}

/// Refuses a main program with a block that is reached and cannot be understood.
bool Runner::refuse_broken(const CompiledProgram& main) {
  for (const syntax::SyntaxError& error : reachable_errors(main)) {
    const auto id = static_cast<AlarmId>(error.error);
    const AlarmInfo& row = info(id);
    outcome_.status = runtime::Status::SyntaxError;
    outcome_.diagnostics.push_back({source::Severity::Error,
                                    std::to_string(number_of(id, control_.profile.alarm_numbers)),
                                    {main.file, error.where.widened()},
                                    fmt::format("{}: {}", row.text, error.message),
                                    std::string(row.remedy),
                                    {}});
  }
  return outcome_.status == runtime::Status::SyntaxError;
}

void Runner::start(const CompiledProgram& main) {
  frames_.assign(1, Frame());
  frame().program = &main;
  control_.modal.word('O') = main.number;
  control_.coordinates.arrived_at_machine(control_.port.position());
}

runtime::Advance Runner::advance() {
  if (is_over_) {
    return runtime::Advance::Ended;
  }
  is_paused_ = false;
  const MaybeFailure failure = loop();
  if (is_paused_) {
    return runtime::Advance::Paused;
  }
  is_over_ = true;
  if (failure) {
    outcome_ = outcome_of(*failure);
  } else {
    control_.report_silent_skip();
  }
  return runtime::Advance::Ended;
}

runtime::Outcome Runner::finish() {
  if (frames_.empty()) {
    return outcome_;
  }
  if (!is_over_) {
    outcome_ = outcome_of(halt_failure(runtime::BlockWatch::Halt::Stopped));
    is_over_ = true;
  }
  control_.tell_repeats();
  outcome_.diagnostics = control_.diagnostics;
  outcome_.blocks = control_.watch.blocks();
  return outcome_;
}

std::vector<runtime::CallLevel> Runner::call_levels() const {
  std::vector<runtime::CallLevel> levels;
  if (frames_.empty()) {
    return levels;
  }
  levels.push_back({name_of(*frames_.back().program), next_place().where});
  for (std::size_t i = frames_.size() - 1; i > 0; --i) {
    levels.push_back({name_of(*frames_[i - 1].program), location_of(frames_[i - 1])});
  }
  return levels;
}

std::size_t Runner::locals_level(std::size_t depth) const {
  const auto own_locals = [](const Frame& level) { return level.kind == CallKind::Macro; };
  return static_cast<std::size_t>(
      std::ranges::count_if(std::span(frames_).first(depth + 1), own_locals));
}

}  // namespace g31::fanuc

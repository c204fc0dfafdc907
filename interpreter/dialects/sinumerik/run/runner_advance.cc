#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "interpreter/dialects/sinumerik/run/runner.h"
#include "interpreter/runtime/guarded.h"

namespace g31::sinumerik {
namespace {

/// An archive of a whole control has much that no program here asks for.
source::Diagnostic unknown_data_note(const CompiledProgram& program) {
  constexpr std::size_t kShown = 5;
  const std::vector<UnknownDatum>& unknown = program.unknown_data;
  std::string names;
  for (std::size_t i = 0; i < std::min(unknown.size(), kShown); ++i) {
    names += (i > 0 ? ", " : "") + unknown[i].name;
  }
  source::Diagnostic note = make_diagnostic(
      source::DiagnosticId::NotSimulated, location_in(program, unknown.front().where),
      fmt::format("{} data of this file, {}{}", unknown.size(), names,
                  unknown.size() > kShown ? " and others" : ""));
  note.severity = source::Severity::Note;
  return note;
}

template <typename Work>
MaybeFailure guarded(const Work& work) {
  return runtime::guarded(work, budget_failure, defect_failure);
}

}  // namespace

void Runner::begin(const runtime::Budget& budget, runtime::BlockListener* listener) {
  const CompiledProgram* const main = programs_.main_program();
  is_over_ = true;
  if (main == nullptr) {
    outcome_.status = runtime::Status::SyntaxError;
    const source::SourceFile* const text = programs_.main_text();
    outcome_.diagnostics.push_back(
        make_diagnostic(source::DiagnosticId::NoProgramInFile,
                        text != nullptr ? text->at({}) : source::Location()));
    return;
  }
  if (early_failure_) {
    outcome_ = *early_failure_;
    outcome_.diagnostics = channel_.diagnostics;
    return;
  }
  start(*main);
  has_run_ = true;
  channel_.arrived_at_machine();
  channel_.watch = runtime::BlockWatch(budget, listener);
  if (const MaybeFailure wrong = calls_.take_no_arguments()) {
    end(wrong);
    return;
  }
  is_over_ = false;
}

runtime::Advance Runner::advance() {
  if (is_over_) {
    return runtime::Advance::Ended;
  }
  is_paused_ = false;
  // To the end of the last motion, or a pause.
  const MaybeFailure reason = guarded([this] {
    runtime::BlockListener* const listener = channel_.watch.write_listener();
    MaybeFailure failure = listener != nullptr ? heard_loop(*listener) : loop();
    return failure || is_paused_ ? failure : finish_motion(channel_);
  });
  if (is_paused_) {
    return runtime::Advance::Paused;
  }
  end(reason);
  return runtime::Advance::Ended;
}

/// Waits until the axes stand.
/// @param reason  why the run ends before its program does, if it does
/// @returns the same, or what has shown in the motion that was still open
MaybeFailure Runner::come_to_rest(const MaybeFailure& reason) {
  if (reason && reason->broken_off) {
    return reason;
  }
  return guarded([&]() -> MaybeFailure {
    const auto late = channel_.outlet.come_to_rest();
    return late ? from_fault(*late) : reason;
  });
}

/// @param reason  why the run ends before its program does, if it does
void Runner::end(const MaybeFailure& reason) {
  is_over_ = true;
  is_paused_ = false;
  if (const MaybeFailure failure = come_to_rest(reason)) {
    if (runtime::breaks_off(failure->status)) {
      missed_.break_off();
    }
    outcome_ = outcome_of(*failure);
    drop_motion(channel_);
  } else {
    missed_.end();
  }
  if (!stack_.level(0).has_arguments()) {
    stack_.level(0) = Level();  // its variables are nowhere
  }
  channel_.warnings.tell_repeats(channel_.diagnostics);
  outcome_.diagnostics = channel_.diagnostics;
  outcome_.blocks = channel_.watch.blocks();
  channel_.watch = runtime::BlockWatch(runtime::Budget{});
}

runtime::Outcome Runner::finish() {
  if (!is_over_) {
    end(halt_failure(runtime::BlockWatch::Halt::Stopped));
  }
  return outcome_;
}

void Runner::run_before(const CompiledProgram& program) {
  // Data are lines without jumps: these are more than any archive has.
  constexpr runtime::Budget kMost = {1'000'000, 10.0};
  if (early_failure_) {
    return;
  }
  channel_.watch = runtime::BlockWatch(kMost);
  start(program);
  if (const MaybeFailure reason = loop()) {
    early_failure_ = outcome_of(*reason);
  }
  if (!program.unknown_data.empty()) {
    channel_.diagnostics.push_back(unknown_data_note(program));
  }
  channel_.watch = runtime::BlockWatch(runtime::Budget{});
  stack_.reset();  // an alarm may have left levels that it called
}

}  // namespace g31::sinumerik

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interpreter/runtime/overloaded.h"
#include "tools/disk/disk.h"
#include "tools/report/run_recorder.h"
#include "tools/session/ending.h"
#include "tools/session/prepare.h"
#include "tools/session/programs.h"
#include "tools/session/run.h"
#include "tools/session/world.h"

// Goes through a program block by block, as a debugger would.

namespace g31::testing {

/// Where a listener pauses a run.
class Pauses final : public runtime::BlockListener {
 public:
  /// At each of the first `most` blocks.
  static Pauses at_each(std::uint64_t most) { return {most, {}}; }
  /// At these blocks, by number.
  static Pauses at(std::set<std::uint64_t> numbers) { return {0, std::move(numbers)}; }

  Pauses(std::uint64_t most, std::set<std::uint64_t> numbers)
      : most_(most), numbers_(std::move(numbers)) {}

  runtime::Verdict on_block(const runtime::BlockPlace& place) override {
    last = place;
    return place.number <= most_ || numbers_.contains(place.number) ? runtime::Verdict::Pause
                                                                    : runtime::Verdict::Run;
  }
  void on_level(std::uint16_t depth, const std::string& program) override {
    depths.push_back(depth);
    programs.push_back(program);
  }

  runtime::BlockPlace last;
  std::vector<std::uint16_t> depths;
  std::vector<std::string> programs;  ///< of those levels

 private:
  std::uint64_t most_;
  std::set<std::uint64_t> numbers_;
};

inline std::string shown(const runtime::ShownValue& value) {
  return std::visit(
      runtime::Overloaded{[](runtime::Cell cell) {
                            return cell.is_vacant() ? std::string("vacant")
                                                    : fmt::format("{}", cell.raw());
                          },
                          [](const std::string& text) { return fmt::format("\"{}\"", text); }},
      value);
}

/// Pauses at each of the first blocks, and keeps from what it hears of writes the values that
/// variables should have.
class WatchedVariables final : public runtime::BlockListener {
 public:
  explicit WatchedVariables(std::uint64_t most) : most_(most) {}

  runtime::Verdict on_block(const runtime::BlockPlace& place) override {
    return place.number <= most_ ? runtime::Verdict::Pause : runtime::Verdict::Run;
  }
  [[nodiscard]] bool hears_writes() const override { return true; }
  void on_write(const runtime::WriteEvent& event) override {
    events.push_back(event);
    values[event.name] = shown(event.now);
  }

  std::vector<runtime::WriteEvent> events;
  std::map<std::string, std::string> values;  ///< as they were last written, by name

 private:
  std::uint64_t most_;
};

/// "line:column"
inline std::string shown(const source::ShownPlace& place) {
  return fmt::format("{}:{}", place.line, place.column);
}

/// A job over its simulated world that can be run once, as a whole or in steps.
class SteppedRun {
 public:
  /// @pre the request can be prepared; a test fails otherwise
  SteppedRun(const session::Request& request, runtime::BlockListener* listener,
             const runtime::Budget& budget)
      : prepared_(session::prepare(request, disk_)) {
    if (!prepared_) {
      ADD_FAILURE() << session::render(prepared_.error());
      return;
    }
    const setup::Job& job = prepared_.value().job;
    const session::Control& control = prepared_.value().control;
    world_.emplace(session::build_world(job, request.seed));
    const auto programs = session::open_programs(control, request, disk_, job.control);
    if (!*world_ || !programs) {
      ADD_FAILURE() << session::render(*world_ ? programs.error() : world_->error());
      return;
    }
    programs_ = programs.value();
    const auto run = session::Run::open(job, *programs_, machine(), recorder_);
    if (!run) {
      refused_ = session::render(run.error());
      return;
    }
    run_ = run.value();
    run_->session().begin(budget, listener);
  }

  /// Why there is nothing to run; "": there is.
  [[nodiscard]] const std::string& refused() const { return refused_; }
  session::Session& session() { return run_->session(); }

  [[nodiscard]] source::ShownPlace place(const source::Location& where) const {
    return programs_->sources().show(where);
  }

  /// All that can be seen of a paused run, as text.
  std::string state(const std::vector<std::string>& expressions) {
    std::string text = fmt::format("{} s at", machine().time_s());
    for (const double q : machine().position()) {
      text += fmt::format(" {}", q);
    }
    const auto levels = session().call_levels();
    for (std::size_t i = 0; i < levels.size(); ++i) {
      text += fmt::format("\n{} {}{}", levels[i].program, shown(place(levels[i].where)),
                          levels[i].is_shown ? "" : " hidden");
      text += values(i, runtime::Scope::Local);
      for (const std::string& expression : expressions) {
        const auto value = session().evaluate(i, expression);
        text += fmt::format("; {} -> {}", expression, value ? shown(value.value()) : value.error());
      }
    }
    return text + values(0, runtime::Scope::Common);
  }

  /// What became of the run, as text: outcome, moves, printouts, variables, files.
  std::string result() {
    const runtime::Outcome outcome = session().finish();
    std::string text = fmt::format("{}, {} blocks, {} s", session::status_name(outcome),
                                   outcome.blocks, machine().time_s());
    for (const source::Diagnostic& diagnostic : outcome.diagnostics) {
      text += "\n" + source::render_text(diagnostic, programs_->sources());
    }
    for (const runtime::MoveEvent& move : recorder_.moves()) {
      text += fmt::format("\nG{} F{}", move.g, move.feed_mm_min);
      for (const double q : move.q_M_to) {
        text += fmt::format(" {}", q);
      }
    }
    for (const auto& [name, value] : session().permanent_variables()) {
      text += fmt::format("\n{} = {}", name, value);
    }
    for (const auto& [name, content] : session().files()) {
      text += fmt::format("\n{}: {}", name, content);
    }
    return text + "\n" + recorder_.output();
  }

 private:
  [[nodiscard]] machine::MachiningCentre& machine() const { return *world_->value().machine; }

  std::string values(std::size_t level, runtime::Scope scope) {
    std::string text;
    for (const auto& [name, value] : session().values(level, scope)) {
      text += fmt::format("; {} = {}", name, shown(value));
    }
    return text;
  }

  disk::Disk disk_;
  Result<session::Prepared, session::Refusal> prepared_;
  runtime::OutputBudget output_;
  report::RunRecorder recorder_{{report::RecordWhat::Keep::Yes, report::RecordWhat::Keep::Yes},
                                output_};
  std::optional<Result<session::World, session::Refusal>> world_;
  std::shared_ptr<session::Programs> programs_;
  std::shared_ptr<session::Run> run_;
  std::string refused_;
};

}  // namespace g31::testing

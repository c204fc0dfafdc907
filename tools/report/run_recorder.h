#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/output_budget.h"
#include "machine/port/machine_port.h"
#include "tools/session/missed_skips.h"

namespace g31::report {

/// What of a run is kept; moves and touches can be millions.
struct RecordWhat {
  enum class Keep { No, Yes };
  Keep moves = Keep::No;
  Keep touches = Keep::No;
};

/// Keeps what a running program does, for the result document, as far as the budget lets it.
class RunRecorder : public runtime::Observer {
 public:
  /// Of the stops the first ones are kept: a loop that stops at each pass may run for hours.
  static constexpr std::size_t kMostStops = 10000;
  static constexpr std::size_t kMostEvents = 10000;  ///< the same

  /// @param budget  is charged for what is kept; outlives the recorder
  /// @param clock   knows when a move has ended; outlives the recorder; nullptr: nobody does
  RunRecorder(RecordWhat what, runtime::OutputBudget& budget,
              const machine::MachinePort* clock = nullptr)
      : what_(what), budget_(budget), clock_(clock) {}

  void on_move(const runtime::MoveEvent& event) override;
  void on_moves_undone(std::uint64_t count) override;
  void on_touch(const runtime::TouchEvent& event) override;
  void on_fault(const runtime::FaultEvent& event) override;
  void on_stop(const runtime::StopEvent& event) override;
  void on_event(const runtime::RecordedEvent& event) override;
  void on_output(const runtime::OutputEvent& event) override;

  [[nodiscard]] const std::vector<runtime::MoveEvent>& moves() const { return moves_; }
  /// Machine time at the end of each move, s, as if the axes came to rest there; empty without a
  /// clock.
  [[nodiscard]] const std::vector<double>& move_times() const { return move_times_; }
  [[nodiscard]] const std::vector<runtime::TouchEvent>& touches() const { return touches_; }
  [[nodiscard]] const std::vector<runtime::StopEvent>& stops() const { return stops_; }
  [[nodiscard]] const std::vector<runtime::RecordedEvent>& events() const { return events_; }
  [[nodiscard]] std::size_t events_left_out() const { return events_left_out_; }
  /// The move that did not end.
  [[nodiscard]] const std::optional<runtime::FaultEvent>& fault() const { return fault_; }
  /// Measuring moves that had their signal.
  [[nodiscard]] std::size_t touch_count() const { return touch_count_; }
  [[nodiscard]] std::size_t stops_left_out() const { return stops_left_out_; }
  /// In UTF-8.
  [[nodiscard]] const std::string& output() const { return output_; }
  [[nodiscard]] const session::MissedSkips& missed_skips() const { return missed_skips_; }

 protected:
  [[nodiscard]] runtime::OutputBudget& budget() { return budget_; }

 private:
  RecordWhat what_;
  runtime::OutputBudget& budget_;
  const machine::MachinePort* clock_;
  std::vector<runtime::MoveEvent> moves_;
  std::vector<double> move_times_;
  std::vector<runtime::TouchEvent> touches_;
  std::vector<runtime::StopEvent> stops_;
  std::size_t stops_left_out_ = 0;
  std::vector<runtime::RecordedEvent> events_;
  std::size_t events_left_out_ = 0;
  std::size_t touch_count_ = 0;
  std::optional<runtime::FaultEvent> fault_;
  std::string output_;
  session::MissedSkips missed_skips_;
};

}  // namespace g31::report

#pragma once

#include <string_view>

#include "machine/port/machine_port.h"
#include "tools/cli/desk.h"
#include "tools/cli/printouts.h"
#include "tools/cli/run_tables.h"
#include "tools/report/event_log.h"
#include "tools/report/run_recorder.h"

namespace g31::cli {

/// Prints while the program runs.  Without a document nothing is kept: an endless loop may print
/// and stop for hours.
class EchoingRecorder final : public report::RunRecorder {
 public:
  /// All of them outlive the recorder.
  /// @param tables  readings get a row at every stop
  EchoingRecorder(const RunOptions& options, Printouts& printouts,
                  const machine::MachinePort& machine, const Tables& tables,
                  runtime::OutputBudget& budget);
  /// Who else hears of what happens; both outlive the recorder.
  /// @param events  nullptr: nobody wants them
  void tell(Desk& desk, report::EventLog* events);
  /// Printouts are kept without a document, too.
  void keep_output() { keeps_output_ = true; }

  void on_move(const runtime::MoveEvent& event) override;
  void on_moves_undone(std::uint64_t count) override;
  void on_touch(const runtime::TouchEvent& event) override;
  void on_fault(const runtime::FaultEvent& event) override;
  void on_standstill(source::Location where) override;
  void on_output(const runtime::OutputEvent& event) override;
  void on_message(const runtime::OutputEvent& event) override;
  void on_stop(const runtime::StopEvent& event) override;
  void on_event(const runtime::RecordedEvent& event) override;

 private:
  void print(const runtime::OutputEvent& event, std::string_view shown);
  void read_sensors();

  Printouts& printouts_;
  bool keeps_;
  bool keeps_output_;
  const machine::MachinePort& machine_;
  report::ReadingsFile* readings_;
  const Watch* watch_;  // null: nobody watches
  Desk* desk_ = nullptr;
  report::EventLog* events_ = nullptr;
};

}  // namespace g31::cli

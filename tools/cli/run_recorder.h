#pragma once

#include <string_view>

#include "machine/port/machine_port.h"
#include "tools/cli/printouts.h"
#include "tools/cli/run_tables.h"
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
  /// Printouts are kept without a document, too.
  void keep_output() { keeps_output_ = true; }

  void on_move(const runtime::MoveEvent& event) override;
  void on_standstill(source::Location where) override;
  void on_output(const runtime::OutputEvent& event) override;
  void on_message(const runtime::OutputEvent& event) override;
  void on_stop(const runtime::StopEvent& event) override;

 private:
  template <typename Form>
  void print(const runtime::OutputEvent& event, const Form& form);
  void read_sensors();

  Printouts& printouts_;
  bool keeps_;
  bool keeps_output_;
  const machine::MachinePort& machine_;
  report::ReadingsFile* readings_;
};

}  // namespace g31::cli

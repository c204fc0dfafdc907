#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/printer_port.h"
#include "interpreter/runtime/shown_value.h"
#include "machine/port/machine_port.h"
#include "tools/cli/run_options.h"
#include "tools/cli/run_preparation.h"

namespace g31::cli {

/// A control of either dialect with its programs, ready to run the main one.
class ControlSession {
 public:
  ControlSession() = default;
  ControlSession(const ControlSession&) = delete;
  ControlSession& operator=(const ControlSession&) = delete;
  virtual ~ControlSession() = default;

  /// A printer at a serial line; a control without one leaves it alone.
  virtual void connect(runtime::PrinterPort& /*printer*/) {}
  /// @returns what in the set-up this control cannot understand; empty: all of it
  virtual std::vector<std::string> configure(const runtime::ControlSetup& setup) = 0;
  virtual runtime::Outcome run(const runtime::Budget& budget) = 0;
  /// The value of what --print names; the reason when there is none.
  virtual Result<runtime::ShownValue, std::string> variable(const std::string& name) = 0;
  /// What a control keeps over power off.
  [[nodiscard]] virtual std::map<std::string, double> permanent_variables() const = 0;
  /// Files that are there before the run; a control that writes none leaves them alone.
  virtual void give_files(const std::map<std::string, std::string>& /*files*/) {}
  /// All files after the run, by name.
  [[nodiscard]] virtual std::map<std::string, std::string> files() const = 0;
};

using SessionPointer = std::shared_ptr<ControlSession>;

/// Loads the programs for the control that was chosen.  Machine and observer must outlive the
/// session.
Result<SessionPointer, Refusal> open_session(const ChosenControl& control,
                                             const RunOptions& options, machine::MachinePort& port,
                                             runtime::Observer& observer);

/// The same with programs that are read already; all four must outlive the session.
SessionPointer open_session(const fanuc::Profile& profile, fanuc::ProgramLibrary& library,
                            machine::MachinePort& port, runtime::Observer& observer);

}  // namespace g31::cli

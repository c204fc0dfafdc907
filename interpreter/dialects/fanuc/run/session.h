#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/fanuc/code/library.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/runtime/block_listener.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/keyframe.h"
#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/printer_port.h"
#include "machine/port/machine_port.h"

namespace g31::fanuc {

class Inspector;
class Runner;

/// A control of the Fanuc dialect with its programs, ready to run one of them.
class Session {
 public:
  /// All four must outlive the session.
  Session(const Profile& profile, ProgramLibrary& library, machine::MachinePort& port,
          runtime::Observer& observer);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Takes over a set-up.  @returns what in it this control cannot understand; empty: all of it
  std::vector<runtime::RefusedSetting> configure(const runtime::ControlSetup& setup);

  /// Connects a printer that POPEN, PCLOS, DPRNT and BPRNT drive; it must outlive the session.
  /// The observer hears the printouts with or without one.
  void connect(runtime::PrinterPort& printer);

  /// Runs the library's main program to its end.
  runtime::Outcome run(const runtime::Budget& budget);

  /// The same block by block: from before its first one to each pause that the listener wants, and
  /// to the end; finish() at a pause ends the run there.
  /// @param listener  outlives the session; nullptr: none
  void begin(const runtime::Budget& budget, runtime::BlockListener* listener);
  runtime::Advance advance();
  runtime::Outcome finish();

  /// The control as it is now.
  [[nodiscard]] std::unique_ptr<runtime::Keyframe> keyframe() const;

  // At a pause and behind the end.  Level 0 is the innermost; nothing of the run changes.
  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const;
  runtime::NamedValues values(std::size_t level, runtime::Scope scope);
  Result<runtime::Cell, std::string> evaluate(std::size_t level, const std::string& text);

  /// The value of a variable as `--print` names it ("#100"); the reason when there is none.
  Result<runtime::Cell, std::string> variable(const std::string& name);

  /// The machine coordinate that "G54" and the like give the origin; mm or deg.
  [[nodiscard]] std::optional<double> work_offset(const std::string& name, int axis) const;
  /// Work offsets and tool offsets that are not 0: "work_offsets.G54.X", "tools.5.length".
  [[nodiscard]] std::map<std::string, runtime::TableValue> tables() const;

  /// #500 to #999 that are not vacant: what a control keeps over power off.
  [[nodiscard]] std::map<std::string, double> permanent_variables() const;

 private:
  std::unique_ptr<Runner> runner_;
  std::unique_ptr<Inspector> inspector_;
};

}  // namespace g31::fanuc

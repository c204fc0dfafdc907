#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/block_listener.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/keyframe.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/printer_port.h"
#include "interpreter/runtime/shown_value.h"
#include "machine/base/result.h"

namespace g31::session {

/// A control of either dialect with its programs, ready to run the main one once.
class Session {
 public:
  Session() = default;
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  virtual ~Session() = default;

  /// A printer at a serial line, which outlives the session; a control without one leaves it alone.
  virtual void connect(runtime::PrinterPort& /*printer*/) {}
  /// @returns what in the set-up this control cannot understand; empty: all of it
  virtual std::vector<runtime::RefusedSetting> configure(const runtime::ControlSetup& setup) = 0;

  /// Stands before the first block of the main program.
  /// @param listener  hears of each block; outlives the session; nullptr: none
  virtual void begin(const runtime::Budget& budget, runtime::BlockListener* listener) = 0;
  /// Goes on to the end, or to the next pause that the listener wants.
  virtual runtime::Advance advance() = 0;
  /// What became of the run, which ends here if it stands at a pause.
  virtual runtime::Outcome finish() = 0;
  /// All of it at once.
  /// @param listener  as there; pauses nowhere
  runtime::Outcome run(const runtime::Budget& budget, runtime::BlockListener* listener = nullptr) {
    begin(budget, listener);
    advance();
    return finish();
  }

  /// What the control holds now, call levels apart.
  [[nodiscard]] virtual std::unique_ptr<runtime::Keyframe> keyframe() const = 0;

  // At a pause.  Level 0 is the innermost; nothing of the run changes for being looked at.

  /// Innermost first.
  [[nodiscard]] virtual std::vector<runtime::CallLevel> call_levels() const = 0;
  virtual runtime::NamedValues values(std::size_t level, runtime::Scope scope) = 0;
  /// What definitions and the set-up gave the variables that values() tells of all programs, before
  /// anything was written to them; those that nothing had set are left out.
  virtual runtime::NamedValues values_at_start() { return {}; }
  /// The value of an expression among the variables of a level; the reason when it has none.
  virtual Result<runtime::ShownValue, std::string> evaluate(std::size_t level,
                                                            const std::string& text) = 0;

  /// Why --print cannot ask for this name, whatever the run will do; nullopt: it can.
  virtual std::optional<std::string> wrong_name(const std::string& name) = 0;
  /// The value of what --print names; the reason when there is none.
  virtual Result<runtime::ShownValue, std::string> variable(const std::string& name) = 0;
  /// What a number is that nothing has set.
  [[nodiscard]] virtual runtime::Cell unset_number() const = 0;
  /// The machine coordinate that a work offset gives the origin, shifts of all kinds together; mm
  /// or deg.  nullopt: the control has no such offset.
  /// @param axis  as AxisPositions counts them
  [[nodiscard]] virtual std::optional<double> work_offset(const std::string& name,
                                                          int axis) const = 0;
  /// Work offsets, frames and tool data that are not as on a fresh control, by names for people.
  [[nodiscard]] virtual std::map<std::string, runtime::TableValue> tables() const = 0;
  /// What a control keeps over power off.
  [[nodiscard]] virtual std::map<std::string, double> permanent_variables() const = 0;
  /// Files that are there before the run; a control that writes none leaves them alone.
  virtual void give_files(const std::map<std::string, std::string>& /*files*/) {}
  /// All files after the run, by name; they live as long as the session.
  [[nodiscard]] virtual const std::map<std::string, std::string>& files() const = 0;
};

}  // namespace g31::session

#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/callable_programs.h"
#include "interpreter/runtime/block_listener.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/keyframe.h"
#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/shown_value.h"
#include "machine/port/machine_port.h"

namespace g31::sinumerik {

/// What --control calls it.
inline constexpr std::string_view kControlName = "sinumerik-828d";

class Runner;

/// A SINUMERIK control with its programs, ready to run one of them.
class Session {
 public:
  /// All three must outlive the session; a library serves any number of sessions, on any number of
  /// threads.
  Session(ProgramLibrary& library, machine::MachinePort& port, runtime::Observer& observer);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Takes over a set-up.  @returns what in it this control cannot understand; empty: all of it
  std::vector<runtime::RefusedSetting> configure(const runtime::ControlSetup& setup);

  /// Runs the library's main program to its end.
  runtime::Outcome run(const runtime::Budget& budget);

  /// The same block by block: from before its first one to each pause that the listener wants, and
  /// to the end; finish() at a pause ends the run there.
  /// @param listener  outlives the session; nullptr: none
  void begin(const runtime::Budget& budget, runtime::BlockListener* listener);
  runtime::Advance advance();
  runtime::Outcome finish();

  /// The channel as it is now.
  [[nodiscard]] std::unique_ptr<runtime::Keyframe> keyframe() const;

  // At a pause.  Level 0 is the innermost; nothing of the run changes.
  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const;
  /// Local: variables and parameters, frames apart.  Common: numbers that differ from what they are
  /// after power on and loading.
  runtime::NamedValues values(std::size_t level, runtime::Scope scope);
  /// Of the variables of all programs that are not as definitions and the set-up gave them: what
  /// they were given.
  [[nodiscard]] runtime::NamedValues values_at_start() const;
  Result<runtime::ShownValue, std::string> evaluate(std::size_t level, const std::string& text);

  /// Why a text is no expression among the variables of the main program; nullopt: it is one.
  std::optional<std::string> wrong_expression(const std::string& text);

  /// The value of what `--print` names, any expression of the language; the reason when there is
  /// none.  Local variables are those of the main program; before the run they have their first
  /// values.
  Result<runtime::ShownValue, std::string> variable(const std::string& name);

  /// The machine coordinate that "G54" and the like give the origin; mm or deg.
  [[nodiscard]] std::optional<double> work_offset(const std::string& name, int axis) const;
  /// Settable frames and tool data that are not as after power on: "$P_UIFR[1,X,TR]",
  /// "$TC_DP3[5,1]".
  [[nodiscard]] std::map<std::string, runtime::TableValue> tables() const;

  /// R parameters, GUD and data that differ from what they are after power on and loading: numbers
  /// by the name that a program writes.  Texts, frames and tools are not among them: the sheet says
  /// those.
  [[nodiscard]] std::map<std::string, double> permanent_variables() const;

  /// The files that READ, WRITE and DELETE find, by name.
  void give_files(const std::map<std::string, std::string>& files);
  [[nodiscard]] const std::map<std::string, std::string>& files() const;

 private:
  /// An element of a variable, and its place among numbers or texts.
  struct ChangedElement {
    std::string name;
    Type type;
    std::size_t place;
  };
  [[nodiscard]] std::vector<ChangedElement> changed_elements() const;

  CallablePrograms programs_;
  std::unique_ptr<Runner> runner_;
  std::vector<double> numbers_at_start_;  ///< as definition and INI files leave them
  std::vector<std::string> texts_at_start_;
};

}  // namespace g31::sinumerik

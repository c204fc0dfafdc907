#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/fanuc/code/library.h"
#include "interpreter/runtime/outcome.h"
#include "machine/base/result.h"
#include "tools/cli/chosen_profile.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/run_command.h"
#include "tools/setup/job.h"
#include "tools/setup/setup_error.h"

namespace g31::cli {

/// Why a run cannot begin.
struct Refusal {
  ExitCode code = ExitCode::BadUsage;
  std::string text;  ///< whole lines
};

/// @param message  without "g31: error:" and line break
Refusal refusal(ExitCode code, std::string_view message);

/// Everything that the command line and the sheets say, read and checked before anything runs.
struct Prepared {
  setup::Job job;
  ChosenControl control;
  std::vector<std::string> prints;
  double trace_period_s = 0.0;
};

/// Reads sheets and variables; chooses the control.
Result<Prepared, Refusal> prepare(const RunOptions& options);

/// The control by --control, the sheets, the program's file ending or its text, in this order.
Result<ChosenControl, Refusal> chosen_control(const RunOptions& options, const setup::Job& job);

/// Puts the variables file under the sheets' [variables] and --set over them.
std::optional<Refusal> take_variables(const RunOptions& options, setup::Job& job);

/// What is wrong with sheets, as a refusal.
Refusal refusal_of(const setup::SetupErrors& errors);

/// The programs, the folder of the first one, --lib and the shipped macros, in this order.
std::optional<Refusal> fill_library(fanuc::ProgramLibrary& library, const RunOptions& options);

/// What a run that went through to its end, whichever, returns to the shell.
ExitCode exit_code_of(const runtime::Outcome& outcome);

/// The messages of a run, on standard error.
void print_diagnostics(const runtime::Outcome& outcome);

/// Says why on standard error.
ExitCode refuse(const Refusal& wrong);

}  // namespace g31::cli

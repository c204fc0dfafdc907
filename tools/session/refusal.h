#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/runtime/control_setup.h"
#include "tools/session/ending.h"
#include "tools/setup/job.h"
#include "tools/setup/setup_error.h"

namespace g31::session {

/// Why a run cannot begin, or what it leaves cannot be kept.
struct Refusal {
  Ending ending = Ending::BadInput;  ///< or Setup
  std::string message;               ///< one line; empty: the errors of the sheets say it
  setup::SetupErrors sheet_errors = {};
};

/// What is wrong with input.
Refusal bad_input(std::string message);
/// A folder that cannot be looked into.  @param why  in the system's words
Refusal closed_folder(const std::string& folder, const std::string& why);
/// A file that cannot be read, and why.  @param what  it is, as "program"; "": its path says it
Refusal unreadable(std::string_view what, const std::string& path);
/// What is wrong with a set-up, found out behind its sheets.
Refusal bad_setup(std::string message);
/// Somebody ended the work before anything came of it.
Refusal interrupted();
/// The limit of time is reached before anything came of the work.  @param with  what it was about
Refusal out_of_time(std::string_view with);
/// What is wrong with sheets.
Refusal refusal_of(setup::SetupErrors errors);

/// What a control does not take of a job's settings, each at its place.
/// @pre refused is not empty
Refusal refused_settings(const setup::Job& job,
                         const std::vector<runtime::RefusedSetting>& refused);

/// Whole lines, as a person reads them: `g31: error: ...`, or each error of the sheets at its
/// place.
std::string render(const Refusal& refusal);

}  // namespace g31::session

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/cli/run_result.h"
#include "tools/expect/expectation.h"

namespace g31::cli {

/// What the sheets expect, then what --expect does.
Result<expect::Expectations, session::Refusal> expectations_of(
    const setup::Job& job, const std::vector<std::string>& from_command_line);

/// Why the control has not what an expectation asks for; nullopt: it has all of it.
std::optional<session::Refusal> wrong_expectation(const expect::Expectations& expectations,
                                                  session::Run& run);

/// What of it has come, behind the run.
std::vector<expect::Judged> judged(const expect::Expectations& expectations,
                                   const OpenedRun& opened, const runtime::Outcome& outcome);

/// A message for each that has not (PRB701).
std::vector<source::Diagnostic> failures_of(const std::vector<expect::Judged>& judged);

}  // namespace g31::cli

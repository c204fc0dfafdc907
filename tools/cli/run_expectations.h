#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/cli/result_watch.h"
#include "tools/cli/run_result.h"
#include "tools/expect/expectation.h"

namespace g31::cli {

/// What the sheets expect, then what --expect does, which counts of a variable that both name.
/// @returns also that --expect says two things of one variable; one alone may be an exception to a
/// range before it
Result<expect::Expectations, session::Refusal> expectations_of(
    const setup::Job& job, const std::vector<std::string>& from_command_line);

/// The value of a variable; nullopt: it cannot be read.
std::optional<runtime::ShownValue> value_of(const OpenedRun& opened, const std::string& name);

/// What the run has come to, for judging it.
/// @param opened, watch  outlive the result
expect::Actual actual_of(const OpenedRun& opened, const runtime::Outcome& outcome,
                         const ResultWatch& watch);

/// A message for each that has not (PRB701).
std::vector<source::Diagnostic> failures_of(const std::vector<expect::Judged>& judged);

}  // namespace g31::cli

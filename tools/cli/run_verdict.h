#pragma once

#include <optional>
#include <vector>

#include "tools/cli/exit_code.h"
#include "tools/expect/expectation.h"
#include "tools/session/heard.h"

namespace g31::cli {

/// What a run came to, all that speaks for its exit code.
struct Verdict {
  source::Severity fail_on = source::Severity::Warning;
  const expect::Expectations& expectations;
  const std::vector<expect::Judged>& judged;  ///< of them
  bool has_unread_values = false;             ///< of --print
  std::optional<ExitCode> unwritten = {};     ///< what files that could not be written come to
};

/// The one place that decides.  A file that could not be written comes first; a value that cannot
/// be read is wrong usage, but it hides nothing else.  Where all is as expected the run is good,
/// whatever it ended with; findings count all the same unless their number is expected.  An
/// expectation that fails is a finding, unless the run ended otherwise than anybody named: then its
/// end counts.
ExitCode exit_code_of(const runtime::Outcome& outcome, const Verdict& verdict);

}  // namespace g31::cli

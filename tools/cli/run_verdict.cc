#include "tools/cli/run_verdict.h"

#include <algorithm>

namespace g31::cli {
namespace {

ExitCode without_files(const runtime::Outcome& outcome, const Verdict& verdict) {
  const ExitCode own = exit_code_of(session::ending_of(outcome, verdict.fail_on));
  const bool has_completed = outcome.status == runtime::Status::Completed;
  const bool is_sound =
      outcome.status != runtime::Status::Defect && outcome.status != runtime::Status::Interrupted;
  if (verdict.judged.empty() || !is_sound) {
    return own;
  }
  const bool names_an_ending = verdict.expectations.names_an_ending();
  if (!std::ranges::all_of(verdict.judged, &expect::Judged::holds)) {
    return has_completed || names_an_ending ? ExitCode::Findings : own;
  }
  return !has_completed || verdict.expectations.has<expect::Findings>() ? ExitCode::Completed : own;
}

}  // namespace

ExitCode exit_code_of(const runtime::Outcome& outcome, const Verdict& verdict) {
  if (verdict.unwritten) {
    return *verdict.unwritten;
  }
  const ExitCode code = without_files(outcome, verdict);
  const bool may_hide = code == ExitCode::Completed || code == ExitCode::Findings;
  return verdict.has_unread_values && may_hide ? ExitCode::BadUsage : code;
}

}  // namespace g31::cli

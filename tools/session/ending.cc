#include "tools/session/ending.h"

#include <algorithm>

#include "interpreter/source/diagnostic.h"
#include "machine/base/contract.h"

namespace g31::session {

runtime::Outcome with_findings(const std::vector<source::Diagnostic>& before,
                               runtime::Outcome outcome) {
  outcome.diagnostics.insert(outcome.diagnostics.begin(), before.begin(), before.end());
  return outcome;
}

Ending ending_of(const runtime::Outcome& outcome, source::Severity fail_on) {
  switch (outcome.status) {
    case runtime::Status::Completed: {
      const bool findings = std::ranges::any_of(
          outcome.diagnostics,
          [&](const source::Diagnostic& diagnostic) { return diagnostic.severity >= fail_on; });
      return findings ? Ending::Findings : Ending::Completed;
    }
    case runtime::Status::Alarm:
      return Ending::Alarm;
    case runtime::Status::Collision:
      return Ending::Collision;
    case runtime::Status::Setup:
      return Ending::Setup;
    case runtime::Status::Budget:
      return Ending::Budget;
    case runtime::Status::Interrupted:
      return Ending::Interrupted;
    case runtime::Status::Defect:
      return Ending::Defect;
    case runtime::Status::SyntaxError:
      return Ending::BadInput;
  }
  contract_violated("every status is an ending", __FILE__, __LINE__);
}

const char* status_name(const runtime::Outcome& outcome) {
  const bool is_alarm = outcome.status == runtime::Status::SyntaxError && outcome.alarm;
  switch (is_alarm ? runtime::Status::Alarm : outcome.status) {
#define RUN_STATUS(status, name, may_be_expected) \
  case runtime::Status::status:                   \
    return name;
#include "tools/expect/run_statuses.def"
#undef RUN_STATUS
  }
  contract_violated("every status has a name", __FILE__, __LINE__);
}

}  // namespace g31::session

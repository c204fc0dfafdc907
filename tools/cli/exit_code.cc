#include "tools/cli/exit_code.h"

#include <array>

#include "machine/base/contract.h"

namespace g31::cli {
namespace {

constexpr auto kExitCodeRows = std::to_array<ExitCodeRow>({
#define EXIT_CODE(name, code, text) {ExitCode::name, text},
#include "tools/cli/exit_codes.def"
#undef EXIT_CODE
});

}  // namespace

std::span<const ExitCodeRow> exit_codes() {
  return kExitCodeRows;
}

ExitCode exit_code_of(session::Ending ending) {
  switch (ending) {
    case session::Ending::Completed:
      return ExitCode::Completed;
    case session::Ending::Findings:
      return ExitCode::Findings;
    case session::Ending::BadInput:
      return ExitCode::BadUsage;
    case session::Ending::Alarm:
      return ExitCode::Alarm;
    case session::Ending::Collision:
      return ExitCode::Collision;
    case session::Ending::Setup:
      return ExitCode::Setup;
    case session::Ending::Budget:
      return ExitCode::Budget;
    case session::Ending::Interrupted:
      return ExitCode::Interrupted;
    case session::Ending::Defect:
      return ExitCode::Defect;
  }
  contract_violated("every ending has an exit code", __FILE__, __LINE__);
}

}  // namespace g31::cli

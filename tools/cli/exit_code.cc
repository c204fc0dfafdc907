#include "tools/cli/exit_code.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>

#include "machine/base/contract.h"

namespace g31::cli {
namespace {

constexpr auto kExitCodeRows = std::to_array<ExitCodeRow>({
#define EXIT_CODE(name, code, text) {ExitCode::name, text},
#include "tools/cli/exit_codes.def"
});

/// A list of codes as bits, of which each enumerator has one by its place in the table.
template <std::same_as<ExitCode>... Code>
constexpr std::uint32_t bits_of(Code... codes) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < kExitCodeRows.size(); ++i) {
    bits |= ((kExitCodeRows[i].code == codes) || ...) ? 1U << i : 0U;
  }
  return bits;
}

struct EndsRow {
  std::string_view command;
  std::uint32_t bits;
};

constexpr auto kEnds = [] {
  using enum ExitCode;
  return std::to_array<EndsRow>({
#define COMMAND_ENDS(command, ...) {command, bits_of(__VA_ARGS__)},
#include "tools/cli/exit_codes.def"
  });
}();

}  // namespace

std::span<const ExitCodeRow> exit_codes() {
  return kExitCodeRows;
}

std::vector<ExitCodeRow> exit_codes_of(std::string_view command) {
  const auto* const ends = std::ranges::find(kEnds, command, &EndsRow::command);
  G31_EXPECTS(command.empty() || ends != kEnds.end());
  std::vector<ExitCodeRow> rows;
  for (std::size_t i = 0; i < kExitCodeRows.size(); ++i) {
    if (command.empty() || (ends->bits >> i & 1U) != 0) {
      rows.push_back(kExitCodeRows[i]);
    }
  }
  return rows;
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

#include "tools/cli/exit_code.h"

#include <array>

namespace g31::cli {
namespace {

constexpr auto kRows = std::to_array<ExitCodeRow>({
#define EXIT_CODE(name, code, text) {ExitCode::name, text},
#include "tools/cli/exit_codes.def"
#undef EXIT_CODE
});

}  // namespace

std::span<const ExitCodeRow> exit_codes() {
  return kRows;
}

}  // namespace g31::cli

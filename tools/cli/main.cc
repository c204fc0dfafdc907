#include <cstdio>
#include <exception>

#include <malloc.h>

#include "tools/cli/command_line.h"
#include "tools/cli/exit_code.h"

namespace {

/// Windows of a long program come and go: what they leave stays with us for the next ones, instead
/// of going back to the system, which would have to clear it again.
void keep_freed_memory() {
  constexpr int kBytes = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, kBytes);
  mallopt(M_TRIM_THRESHOLD, kBytes);
}

}  // namespace

int main(int argc, char** argv) {
  using g31::cli::ExitCode;
  keep_freed_memory();
  try {
    return static_cast<int>(g31::cli::run_command_line(argc, argv, G31_VERSION));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "g31: defect: %s\n", error.what());
    return static_cast<int>(ExitCode::Defect);
  }
}

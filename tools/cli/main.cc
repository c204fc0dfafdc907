#include <csignal>
#include <cstdio>
#include <exception>

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

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

/// A standard stream that is closed stays one: no file that we open gets its number, and with it
/// what is meant for the stream.  It fails as before, because the other way is open.
void hold_closed_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) < 0) {
      (void)::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  using g31::cli::ExitCode;
  keep_freed_memory();
  hold_closed_streams();
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is an error of writing it
  try {
    return static_cast<int>(g31::cli::run_command_line(argc, argv, G31_VERSION));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "g31: defect: %s\n", error.what());
    return static_cast<int>(ExitCode::Defect);
  }
}

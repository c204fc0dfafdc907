#include "tools/cli/interruption.h"

#include <csignal>

#include "tools/disk/part_file.h"
#include "tools/disk/waiting.h"

namespace g31::cli {
namespace {

runtime::Interruption is_asked_for = false;

/// A second signal ends the program as if nobody had caught the first one.
void ask_for_it(int signal) {
  if (!is_asked_for.exchange(true)) {
    return;
  }
  disk::remove_unfinished_files();
  struct sigaction action = {};
  action.sa_handler = SIG_DFL;
  ::sigaction(signal, &action, nullptr);
  ::raise(signal);
}

/// What began g31 with the signal ignored, as nohup and a shell's background jobs do, wants it to
/// go on.
void catch_it(int signal) {
  struct sigaction action = {};
  if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) {
    return;
  }
  action = {};
  action.sa_handler = ask_for_it;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

const runtime::Interruption& catch_interruption() {
  catch_it(SIGINT);
  catch_it(SIGHUP);
  catch_it(SIGTERM);
  disk::give_up_waiting_when(is_asked_for);
  return is_asked_for;
}

}  // namespace g31::cli

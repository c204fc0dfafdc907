#include "tools/cli/interruption.h"

#include <csignal>

#include "tools/disk/waiting.h"

namespace g31::cli {
namespace {

runtime::Interruption is_asked_for = false;

void ask_for_it(int) {
  is_asked_for = true;
}

/// What began g31 with the signal ignored, as nohup and a shell's background jobs do, wants it to
/// go on.
void catch_once(int signal) {
  struct sigaction action = {};
  if (::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) {
    return;
  }
  action = {};
  action.sa_handler = ask_for_it;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

const runtime::Interruption& catch_interruption() {
  catch_once(SIGINT);
  catch_once(SIGHUP);
  catch_once(SIGTERM);
  disk::give_up_waiting_when(is_asked_for);
  return is_asked_for;
}

}  // namespace g31::cli

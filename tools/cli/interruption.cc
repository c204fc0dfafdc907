#include "tools/cli/interruption.h"

#include <csignal>

#include "tools/disk/waiting.h"

namespace g31::cli {
namespace {

runtime::Interruption is_asked_for = false;

void ask_for_it(int) {
  is_asked_for = true;
}

void catch_once(int signal) {
  struct sigaction action = {};
  action.sa_handler = ask_for_it;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

const runtime::Interruption& catch_interruption() {
  catch_once(SIGINT);
  disk::give_up_waiting_when(is_asked_for);
  return is_asked_for;
}

void catch_termination() {
  catch_once(SIGTERM);
}

}  // namespace g31::cli

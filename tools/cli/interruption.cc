#include "tools/cli/interruption.h"

#include <csignal>

namespace g31::cli {
namespace {

runtime::Interruption is_asked_for = false;

void ask_for_it(int) {
  is_asked_for = true;
}

}  // namespace

const runtime::Interruption& catch_interruption() {
  struct sigaction action = {};
  action.sa_handler = ask_for_it;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  ::sigaction(SIGINT, &action, nullptr);
  return is_asked_for;
}

}  // namespace g31::cli

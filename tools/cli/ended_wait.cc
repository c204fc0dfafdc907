#include "tools/cli/ended_wait.h"

#include "tools/disk/waiting.h"

namespace g31::cli {

session::Refusal with_ended_wait(const session::Refusal& wrong) {
  const auto why = disk::given_up_input();
  if (!why || wrong.ending != session::Ending::BadInput) {
    return wrong;
  }
  return why == disk::GivenUp::Interrupted
             ? session::interrupted()
             : session::out_of_time("the waiting for an input that nobody writes to");
}

}  // namespace g31::cli

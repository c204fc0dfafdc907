#include "tools/cli/ended_wait.h"

#include "tools/disk/waiting.h"

namespace g31::cli {

session::Refusal with_ended_wait(const session::Refusal& wrong) {
  if (wrong.ending != session::Ending::BadInput) {
    return wrong;
  }
  if (const auto why = disk::given_up_input()) {
    return why == disk::GivenUp::Interrupted
               ? session::interrupted()
               : session::out_of_time("the waiting for an input that nobody writes to");
  }
  session::Refusal told = wrong;
  const auto why = disk::given_up_output();
  if (why == disk::GivenUp::Interrupted) {
    told.ending = session::Ending::Interrupted;
  } else if (why == disk::GivenUp::Time) {
    told.ending = session::Ending::Budget;
  }
  return told;
}

}  // namespace g31::cli

#pragma once

#include "tools/session/refusal.h"

namespace g31::cli {

/// The refusal; where an input could not be read because Ctrl-C or --max-time has ended the waiting
/// for it, that in its place.  Where an output could not be written for that it ends so, in its own
/// words.
session::Refusal with_ended_wait(const session::Refusal& wrong);

}  // namespace g31::cli

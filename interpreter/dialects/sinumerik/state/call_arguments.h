#pragma once

#include <vector>

#include "interpreter/dialects/sinumerik/state/failure.h"
#include "interpreter/dialects/sinumerik/state/level.h"

namespace g31::sinumerik {

/// Makes the local variables of a level's program anew and puts what a call gives into its
/// parameters: values are converted, VAR parameters refer to the caller's variables.
MaybeFailure take_arguments(Level& into, const std::vector<BoundValue>& values);

}  // namespace g31::sinumerik

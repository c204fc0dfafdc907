#pragma once

#include "interpreter/dialects/fanuc/run/call_stack.h"
#include "interpreter/dialects/fanuc/state/control.h"

namespace g31::fanuc {

/// POPEN, PCLOS, DPRNT, BPRNT (MB-235 to MB-253); runs when it is read, like every macro statement.
MaybeFailure print(Control& control, const CallStack& stack, const Step& step);

}  // namespace g31::fanuc

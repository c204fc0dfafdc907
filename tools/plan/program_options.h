#pragma once

#include "machine/base/result.h"
#include "tools/plan/inspection_program.h"
#include "tools/plan/plan_touches.h"
#include "tools/session/control.h"
#include "tools/session/refusal.h"
#include "tools/setup/job.h"

namespace g31::plan {

/// How a program is written for the control and the probe of a set-up: which tool it calls, what
/// switches the probe, where the control's length of it ends.
/// @param job  has a probe
///
/// Error: no tool of the control is the probe.
Result<ProgramOptions, session::Refusal> program_options(const setup::Job& job,
                                                         const session::Control& control,
                                                         const PlannedTouches& touches);

}  // namespace g31::plan

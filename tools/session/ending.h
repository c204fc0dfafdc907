#pragma once

#include <cstdint>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "interpreter/source/diagnostic.h"

namespace g31::session {

/// What a run came to, or the attempt to begin one.
enum class Ending : std::uint8_t {
  Completed,
  Findings,  ///< completed, with messages that somebody is to look at
  BadInput,  ///< something cannot be read, understood or written; syntax errors included
  Alarm,
  Collision,
  Setup,  ///< the set-up does not fit: a missing tool, offset or mesh, an unknown control
  Budget,
  Interrupted,
  Defect,  ///< of g31 itself
};

/// An outcome that begins with what was found before the program ran.
runtime::Outcome with_findings(const std::vector<source::Diagnostic>& before,
                               runtime::Outcome outcome);

/// @param fail_on  the least severe message that makes findings of a completed run
Ending ending_of(const runtime::Outcome& outcome,
                 source::Severity fail_on = source::Severity::Warning);

/// How reports name what a run came to: "completed", "alarm", "collision", "setup", "budget",
/// "interrupted", "defect", or "usage" for input that could not be read and raises no alarm.
const char* status_name(const runtime::Outcome& outcome);

}  // namespace g31::session

#pragma once

#include <cstdint>
#include <vector>

#include "interpreter/runtime/outcome.h"
#include "interpreter/source/diagnostic.h"

namespace g31::session {

/// What a run came to, or the attempt to begin one.
enum class Ending : std::uint8_t {
  Completed,
  Findings,  ///< completed, with messages that are more than notes
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

Ending ending_of(const runtime::Outcome& outcome);

/// How reports name a status: "completed", "alarm", "collision", "setup", "budget",
/// "interrupted" or "defect".
const char* status_name(runtime::Status status);

}  // namespace g31::session

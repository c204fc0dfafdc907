#pragma once

#include <string_view>

#include "interpreter/runtime/time_budget.h"
#include "parts/geometry/goes_on.h"
#include "tools/session/refusal.h"

namespace g31::session {

/// What work on meshes asks; with no end where there is no time.
parts::GoesOn goes_on_within(const runtime::TimeBudget* time);

/// Why work on meshes was broken off.  @param with  what it was about
Refusal too_late(const runtime::TimeBudget& time, std::string_view with);

}  // namespace g31::session

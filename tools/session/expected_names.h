#pragma once

#include <optional>

#include "tools/expect/expectation.h"
#include "tools/session/refusal.h"
#include "tools/session/run.h"

namespace g31::session {

/// Why the control has not what an expectation or a characteristic asks for, at its place; nullopt:
/// it has all of it.
std::optional<Refusal> wrong_expectation(const expect::Expectations& expectations, Run& run);

}  // namespace g31::session

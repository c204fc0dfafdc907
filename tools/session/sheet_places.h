#pragma once

#include "interpreter/source/diagnostic.h"
#include "tools/setup/job.h"

namespace g31::session {

/// Looks up where the settings stand that messages are about (Diagnostic::setting).
void place_settings(const setup::Job& job, std::vector<source::Diagnostic>& diagnostics);

}  // namespace g31::session

#pragma once

#include <memory>

#include "tools/session/programs.h"

namespace g31::session {

/// open_programs() for the SINUMERIK.
Result<std::shared_ptr<Programs>, Refusal> open_sinumerik_programs(
    const ProgramPaths& paths, source::FileSystem& files, const runtime::ControlSetup& setup);

}  // namespace g31::session

#pragma once

#include <memory>

#include "tools/session/programs.h"

namespace g31::session {

/// open_programs() for a control of the Fanuc dialect.
Result<std::shared_ptr<Programs>, Refusal> open_fanuc_programs(const FanucControl& control,
                                                               const ProgramPaths& paths,
                                                               source::FileSystem& files);

}  // namespace g31::session

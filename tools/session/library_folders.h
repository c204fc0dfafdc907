#pragma once

#include <string>
#include <vector>

#include "interpreter/source/file_system.h"
#include "machine/base/result.h"
#include "tools/session/refusal.h"

namespace g31::session {

/// The folders that --lib names, each with those below it, the upper ones first; what is hidden is
/// not looked at.
/// @returns why one of them cannot be looked into
Result<std::vector<std::string>, Refusal> library_folders(const std::vector<std::string>& named,
                                                          source::FileSystem& files);

}  // namespace g31::session

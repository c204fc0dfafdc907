#pragma once

#include <string>

#include "machine/base/result.h"
#include "tools/setup/setup_error.h"
#include "tools/study/study.h"

namespace g31::study {

/// Reads a study file and checks every key of it.
/// @returns the study, or all that is wrong with it, in the order of its lines
Result<Study, setup::SetupErrors> read_study(const std::string& path);

}  // namespace g31::study

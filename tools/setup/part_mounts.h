#pragma once

#include "tools/setup/job.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// Makes what bed and axes carry bodies of the machine, which nothing may touch, and tells mounts
/// that the machine does not have.
/// @param job  its machine and its parts are filled in
void fill_mounts(Job& job, const Sheet& sheet, ErrorList& errors);

}  // namespace g31::setup

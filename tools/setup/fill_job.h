#pragma once

#include "tools/setup/job.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// The plain structs that a checked sheet describes; keys that are not given keep the defaults of
/// the structs.  Adds SET107 for every mesh that is not there.
Job fill_job(const Sheet& sheet, ErrorList& errors);

}  // namespace g31::setup

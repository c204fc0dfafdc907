#pragma once

#include "tools/expect/expectation.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// What [expect] of a sheet says, in the order in which it stands there.
expect::Expectations expectations_from(const Sheet& sheet);

}  // namespace g31::setup

#pragma once

#include <span>
#include <vector>

#include "parts/artefacts/part_setup.h"
#include "tools/expect/characteristic.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// The characteristics of a sheet, in its order.
/// @param parts  of the same sheet, which their true sizes are of
std::vector<expect::Characteristic> characteristics_from(const Sheet& sheet,
                                                         std::span<const parts::PartSetup> parts,
                                                         ErrorList& errors);

}  // namespace g31::setup

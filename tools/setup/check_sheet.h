#pragma once

#include "tools/setup/document.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// Checks every key of a document against keys.def.  What is wrong goes to `errors`, the rest is
/// returned.
Sheet check_sheet(const Document& document, ErrorList& errors);

/// The same for the file that [machine] names: it has a [machine] table, or its keys stand at the
/// top.
Sheet check_machine_file(const Document& document, ErrorList& errors);

}  // namespace g31::setup

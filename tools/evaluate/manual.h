#pragma once

#include <string_view>

#include "interpreter/runtime/reference.h"

namespace g31::evaluate {

/// What the tables say of a kind of evaluation, "circle", or of a result, "squareness", "spike_X";
/// the letters of ISO 230-2 stand with their kind, "positioning".
runtime::Entries explain(std::string_view topic);

/// All kinds with their results.
runtime::Entries everything();

}  // namespace g31::evaluate

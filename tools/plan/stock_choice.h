#pragma once

#include <string>

#include "machine/base/result.h"
#include "parts/solids/removal.h"
#include "tools/session/refusal.h"

namespace g31::plan {

/// What --stock says: "X,Y,Z" sizes of a block, mm, "box", or a file.
/// Error: sizes that no block has.
Result<parts::StockChoice, session::Refusal> stock_choice(const std::string& text);

}  // namespace g31::plan

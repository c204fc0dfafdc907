#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "machine/base/result.h"

namespace g31::setup {

/// A size as command line and sheets take it: bytes, or with a unit `500K`, `1.5M`, `2G`, each a
/// thousand times the one before; `B` behind it and small letters are the same.
///
/// Error: one line that says what is wrong and what would be right.
Result<std::uint64_t, std::string> parse_byte_count(std::string_view text);

}  // namespace g31::setup

#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tools/session/refusal.h"

namespace g31::cli {

/// Writes a whole text where an option wants it.
/// @param path  of a file, a device or a pipe; "-": standard output
std::optional<session::Refusal> write_out(const std::string& path, std::string_view text);

}  // namespace g31::cli

#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "tools/disk/part_file.h"
#include "tools/session/refusal.h"

namespace g31::cli {

/// Writes a whole text where an option wants it.
/// @param path  of a file, a device or a pipe; "-": standard output
std::optional<session::Refusal> write_out(const std::string& path, std::string_view text);
/// The same of a text that is made piece by piece.
std::optional<session::Refusal> write_out(const std::string& path,
                                          const std::function<void(disk::PartFile&)>& write);

/// What a command found, for people on standard output, and as a document where --json wants it;
/// a document on standard output stands there alone.
/// @param json  of the option: "" for none
std::optional<session::Refusal> write_result(const std::string& json,
                                             const std::function<std::string()>& for_people,
                                             const std::function<std::string()>& document);

}  // namespace g31::cli

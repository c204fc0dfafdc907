#pragma once

#include <optional>
#include <string>

namespace g31::disk {

/// SHA-256 of a file's bytes as 64 hexadecimal digits; nullopt when it is no regular file or cannot
/// be read.
std::optional<std::string> sha256_of(const std::string& path);

}  // namespace g31::disk

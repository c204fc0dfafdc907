#pragma once

#include <string>
#include <string_view>

namespace g31::fanuc {

/// Whether a text comes from a tape: ISO code with even parity in bit 8, or CR alone as the end of
/// its blocks (MB-008, MB-009).
bool is_tape_code(std::string_view text);

/// The text without parity bits and with LF for a CR that ends a block; every character keeps its
/// place.  Other texts stay as they are.
std::string from_tape_code(std::string text);

}  // namespace g31::fanuc

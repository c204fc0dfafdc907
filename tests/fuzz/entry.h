#pragma once

#include <cstdint>
#include <string_view>

namespace g31::fuzz {

/// Reads a text as a program file and as a later piece of one, compiles every program of it for
/// every control and renders every message.  Whatever the bytes are, no more than that happens.
void read_any_text(std::string_view bytes);

/// Runs the main program of a text for at most kBlocks blocks, as the letters behind its `%` say
/// (TapeChoices).  Nothing is read or written outside the text.  Every number that a result
/// document would show must be one.
void run_any_text(std::string_view bytes);

inline constexpr std::uint64_t kBlocks = 2000;

}  // namespace g31::fuzz

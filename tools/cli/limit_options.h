#pragma once

#include <cstdint>
#include <string>

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// Of a text that is to be a number of seconds above 0: what is wrong with it; empty: nothing.
std::string why_no_time(const std::string& text);

/// Adds --max-output.  @param what  whose bytes count, in words
void add_max_output(CLI::App& command, std::uint64_t& bytes, const std::string& what);

}  // namespace g31::cli

#pragma once

#include <cstdint>
#include <string>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace g31::cli {

/// Of a text that is to be a number of seconds above 0: what is wrong with it; empty: nothing.
std::string why_no_time(const std::string& text);

/// Of a text that is to be a whole number of 0 or more: the same.  CLI11 takes -1 for the largest
/// number there is.
std::string why_no_count(const std::string& text);

/// Of the word of an option: what is wrong with it where it is empty, as a variable of a shell that
/// is not set leaves it; empty: nothing.
std::string why_no_word(const std::string& text);

/// Takes numbers from `least` to `most`, and nothing that is no number: CLI::Range takes NaN, which
/// is neither below nor above.  Every range of an option that is no whole number is one.
CLI::Validator number_range(double least, double most);

/// Adds --max-output.  @param what  whose bytes count, in words
void add_max_output(CLI::App& command, std::uint64_t& bytes, const std::string& what);

}  // namespace g31::cli

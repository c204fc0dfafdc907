#pragma once

#include <cstdint>
#include <limits>
#include <string>

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace g31::cli {

/// Of a text that is to be a number of seconds above 0: what is wrong with it; empty: nothing.
std::string why_no_time(const std::string& text);

/// Of the word of an option: what is wrong with it where it is empty or blank, as a variable of a
/// shell that is not set leaves it; empty: nothing.
std::string why_no_word(const std::string& text);

/// The largest whole number that an option takes which has no limit of its own.
inline constexpr std::uint64_t kLargestCount = std::numeric_limits<std::uint64_t>::max();

/// Takes whole numbers from `least` to `most`, in decimal digits alone, for CLI::Option::transform.
/// CLI11 itself takes -1 and what is too large for the largest number there is, and 010 for 8.
/// Every whole number of an option is one.
CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);

/// Takes numbers from `least` to `most`, and nothing that is no number: CLI::Range takes NaN, which
/// is neither below nor above.  Every range of an option that is no whole number is one.
CLI::Validator number_range(double least, double most);

/// Adds --max-output.  @param what  whose bytes count, in words
void add_max_output(CLI::App& command, std::uint64_t& bytes, const std::string& what);

}  // namespace g31::cli

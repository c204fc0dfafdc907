#include "tools/cli/limit_options.h"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/setup/byte_count.h"

namespace g31::cli {

std::string why_no_time(const std::string& text) {
  double seconds = 0.0;
  const char* const last = text.data() + text.size();
  const auto end = std::from_chars(text.data(), last, seconds);
  const bool fits = end.ec == std::errc() && end.ptr == last && std::isfinite(seconds);
  return fits && seconds > 0.0 ? "" : fmt::format("{} is not a number of seconds above 0", text);
}

std::string why_no_word(const std::string& text) {
  return text.find_first_not_of(" \t") == std::string::npos ? "the word is empty" : "";
}

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  const auto take = [least, most](std::string& text) {
    std::uint64_t number = 0;
    const char* const last = text.data() + text.size();
    const auto end = std::from_chars(text.data(), last, number);
    if (end.ec != std::errc() || end.ptr != last || number < least || number > most) {
      return fmt::format("{} is not a whole number from {} to {}", text, least, most);
    }
    text = std::to_string(number);
    return std::string();
  };
  return {take, fmt::format("INT in [{} - {}]", least, most)};
}

CLI::Validator number_range(double least, double most) {
  const CLI::Range range(least, most);
  const auto why_not = [range, least, most](std::string& text) {
    return std::isnan(std::strtod(text.c_str(), nullptr))
               ? fmt::format("Value {} not in range {:f} to {:f}", text, least, most)
               : range(text);
  };
  return {why_not, range.get_description()};
}

void add_max_output(CLI::App& command, std::uint64_t& bytes, const std::string& what) {
  command
      .add_option_function<std::string>(
          "--max-output",
          [&bytes](const std::string& text) {
            const auto count = setup::parse_byte_count(text);
            if (!count) {
              throw CLI::ValidationError("--max-output", count.error());
            }
            bytes = count.value();
          },
          "bytes of " + what + ", or 500K, 64M, 2G (default 256M)")
      ->type_name("SIZE");
}

}  // namespace g31::cli

#include "tools/setup/byte_count.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "machine/base/letters.h"

namespace g31::setup {
namespace {

struct SizeUnit {
  char letter;
  double bytes;
};

constexpr SizeUnit kSizeUnits[] = {{'K', 1e3}, {'M', 1e6}, {'G', 1e9}};
constexpr double kMostBytes = 1e15;

/// Bytes of a unit as it stands behind a number; 0: there is no such unit.
double bytes_of(std::string_view unit) {
  if (!unit.empty() && capital_letter(unit.back()) == 'B') {
    unit.remove_suffix(1);
  }
  if (unit.empty()) {
    return 1.0;
  }
  for (const SizeUnit& known : kSizeUnits) {
    if (unit.size() == 1 && capital_letter(unit.front()) == known.letter) {
      return known.bytes;
    }
  }
  return 0.0;
}

}  // namespace

Result<std::uint64_t, std::string> parse_byte_count(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, std::chars_format::fixed);
  if (error == std::errc{} && std::isfinite(number)) {
    const double bytes = number * bytes_of({stop, static_cast<std::size_t>(end - stop)});
    if (bytes >= 1.0 && bytes <= kMostBytes) {
      return static_cast<std::uint64_t>(std::round(bytes));
    }
  }
  return fmt::format("\"{}\" is not a size from 1 byte to 1000000G: write 1000000, 500K, 64M or 2G",
                     text);
}

}  // namespace g31::setup

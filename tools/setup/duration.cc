#include "tools/setup/duration.h"

#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace g31::setup {
namespace {

struct TimeUnit {
  std::string_view name;
  double per_second;
};

// Dividing by a whole number rounds once: 182.32us is the double nearest to 0.00018232.
constexpr TimeUnit kUnits[] = {{"", 1.0}, {"s", 1.0}, {"ms", 1e3}, {"us", 1e6}, {"ns", 1e9}};

}  // namespace

Result<double, std::string> parse_duration(std::string_view text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error == std::errc{} && std::isfinite(number)) {
    const std::string_view rest(stop, static_cast<std::size_t>(end - stop));
    for (const TimeUnit& unit : kUnits) {
      const double seconds = number / unit.per_second;
      if (rest == unit.name && seconds > 0.0) {
        return seconds;
      }
    }
  }
  return fmt::format("\"{}\" is not a time above 0: write 182.32us, 4ms, 0.001s or 0.001", text);
}

}  // namespace g31::setup

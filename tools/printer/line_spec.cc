#include "tools/printer/line_spec.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace g31::printer {
namespace {

constexpr std::string_view kForm =
    "a serial line is DEVICE,BAUD,PARITY,DATA BITS,STOP BITS, for example /dev/ttyS0,4800,e,7,2";

constexpr std::array kRates = {50,   100,  110,  150,   200,   300,   600,   1200,
                               2400, 4800, 9600, 19200, 38400, 57600, 115200};

constexpr std::size_t kSettings = 4;

std::optional<int> whole_number(std::string_view text) {
  int number = 0;
  const char* const last = text.data() + text.size();
  const auto end = std::from_chars(text.data(), last, number);
  return end.ec == std::errc() && end.ptr == last ? std::optional(number) : std::nullopt;
}

std::optional<Parity> parity_of(std::string_view text) {
  if (text == "e" || text == "E") {
    return Parity::Even;
  }
  if (text == "o" || text == "O") {
    return Parity::Odd;
  }
  if (text == "n" || text == "N") {
    return Parity::None;
  }
  return std::nullopt;
}

/// A setting that may have one of two values.
std::optional<int> one_of(std::string_view text, int low, int high) {
  const auto number = whole_number(text);
  return number == low || number == high ? number : std::nullopt;
}

}  // namespace

bool names_a_line(std::string_view text) {
  return text.find(',') != std::string_view::npos;
}

Result<LineSpec, std::string> parse_line_spec(std::string_view text) {
  std::array<std::string_view, kSettings> parts;
  std::string_view rest = text;
  for (std::size_t i = kSettings; i-- > 0;) {
    const std::size_t comma = rest.rfind(',');
    if (comma == std::string_view::npos) {
      return fmt::format("{} parts instead of 5: {}", kSettings - i, kForm);
    }
    parts[i] = rest.substr(comma + 1);
    rest = rest.substr(0, comma);
  }
  if (rest.empty()) {
    return fmt::format("the device is missing: {}", kForm);
  }
  const auto baud = whole_number(parts[0]);
  if (!baud || !std::ranges::binary_search(kRates, *baud)) {
    return fmt::format("baud rate \"{}\": one of {}", parts[0], fmt::join(kRates, ", "));
  }
  const auto parity = parity_of(parts[1]);
  if (!parity) {
    return fmt::format("parity \"{}\": e (even), o (odd) or n (none)", parts[1]);
  }
  const auto data_bits = one_of(parts[2], 7, 8);
  if (!data_bits) {
    return fmt::format("data bits \"{}\": 7 or 8", parts[2]);
  }
  const auto stop_bits = one_of(parts[3], 1, 2);
  if (!stop_bits) {
    return fmt::format("stop bits \"{}\": 1 or 2", parts[3]);
  }
  return LineSpec{std::string(rest), *baud, *parity, *data_bits, *stop_bits};
}

}  // namespace g31::printer

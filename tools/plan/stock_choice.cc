#include "tools/plan/stock_choice.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <limits>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "tools/plan/measures.h"

namespace g31::plan {
namespace {

/// Numbers between commas; empty where a text is anything else.
std::vector<double> numbers_of(std::string_view text) {
  std::vector<double> numbers;
  for (const char* begin = text.data(); begin <= text.data() + text.size();) {
    double number = 0.0;
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(begin, end, number);
    if (error == std::errc::invalid_argument || (rest < end && *rest != ',')) {
      return {};
    }
    numbers.push_back(error == std::errc() ? number : std::numeric_limits<double>::infinity());
    begin = rest + 1;
  }
  return numbers;
}

}  // namespace

Result<parts::StockChoice, session::Refusal> stock_choice(const std::string& text) {
  parts::StockChoice stock;
  std::error_code unknown;
  const std::vector<double> sizes = numbers_of(text);
  const auto is_size = [](double mm) { return mm > 0.0 && mm <= kLongestMm; };
  if (sizes.size() == 3) {
    if (!std::ranges::all_of(sizes, is_size)) {
      return session::bad_input(
          fmt::format("--stock {}: expected sizes above 0, of at most {:g} mm", text, kLongestMm));
    }
    stock.block_mm = Point(sizes[0], sizes[1], sizes[2]);
  } else if (!sizes.empty() && !std::filesystem::exists(text, unknown)) {
    return session::bad_input(fmt::format(
        "--stock {}: expected three sizes X,Y,Z in mm, the name of a file, or box", text));
  } else if (text != "box") {
    stock.file = text;
  }
  return stock;
}

}  // namespace g31::plan

#include "tools/plan/printed_bytes.h"

#include <algorithm>
#include <bit>

namespace g31::plan {
namespace {

constexpr unsigned kBitEight = 0x80;

bool is_even(char c) {
  return std::popcount(static_cast<unsigned char>(c)) % 2 == 0;
}

}  // namespace

std::string without_parity(std::string_view bytes, BitEight parity) {
  std::string text;
  text.reserve(bytes.size());
  for (const char c : bytes) {
    const bool is_right = parity == BitEight::Ignored || is_even(c) == (parity == BitEight::Even);
    text += is_right ? static_cast<char>(static_cast<unsigned char>(c) & ~kBitEight) : kWrongByte;
  }
  return text;
}

std::string printed_text(std::string_view bytes) {
  const auto is_beyond = [](char c) { return (static_cast<unsigned char>(c) & kBitEight) != 0; };
  const auto even = static_cast<std::size_t>(std::ranges::count_if(bytes, is_even));
  const bool is_iso = std::ranges::any_of(bytes, is_beyond) && 10 * even >= 9 * bytes.size();
  return is_iso ? without_parity(bytes, BitEight::Even) : std::string(bytes);
}

}  // namespace g31::plan

#include "interpreter/dialects/fanuc/text/tape_code.h"

#include <algorithm>
#include <bit>

namespace g31::fanuc {
namespace {

constexpr unsigned char kParityBit = 0x80;
constexpr char kRubout = 0x7F;

/// Text of another code has letters and digits with an odd number of bits.
bool has_parity(std::string_view text) {
  bool any = false;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::popcount(byte) % 2 != 0) {
      return false;
    }
    any = any || byte >= kParityBit;
  }
  return any;
}

bool ends_blocks_by_return(std::string_view text) {
  return text.find('\n') == text.npos && text.find('\r') != text.npos;
}

}  // namespace

bool is_tape_code(std::string_view text) {
  return has_parity(text) || ends_blocks_by_return(text);
}

std::string from_tape_code(std::string text) {
  if (has_parity(text)) {
    for (char& c : text) {
      c = static_cast<char>(static_cast<unsigned char>(c) & ~kParityBit);
      c = c == kRubout ? '\0' : c;
    }
  }
  if (ends_blocks_by_return(text)) {
    std::ranges::replace(text, '\r', '\n');
  }
  return text;
}

}  // namespace g31::fanuc

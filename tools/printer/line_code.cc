#include "tools/printer/line_code.h"

#include <algorithm>
#include <bit>

namespace g31::printer {
namespace {

constexpr unsigned kCharacterBits = 0x7F;
constexpr unsigned kParityBit = 0x80;

char with_parity(char c, Parity parity) {
  const unsigned character = static_cast<unsigned char>(c) & kCharacterBits;
  const bool is_odd = std::popcount(character) % 2 != 0;
  const bool sets_bit = parity != Parity::None && is_odd == (parity == Parity::Even);
  return static_cast<char>(sets_bit ? character | kParityBit : character);
}

bool has_bit_eight(char c) {
  return (static_cast<unsigned char>(c) & kParityBit) != 0;
}

/// The printed characters of bytes whose bit 8 is a parity bit; Parity::None: it means nothing.
std::string without_parity(std::string_view bytes, Parity parity) {
  std::string text;
  text.reserve(bytes.size());
  for (const char c : bytes) {
    const char plain = with_parity(c, Parity::None);
    if (parity != Parity::None && c != with_parity(c, parity)) {
      text += kWrongByte;
    } else if (plain != '\0' && !control_code(plain)) {
      text += plain;
    }
  }
  return text;
}

bool makes_parity_here(const LineSpec& line) {
  return line.data_bits == 7 && line.parity != Parity::None;
}

}  // namespace

Frame frame_of(const LineSpec& line) {
  return makes_parity_here(line) ? Frame{8, Parity::None, line.stop_bits}
                                 : Frame{line.data_bits, line.parity, line.stop_bits};
}

double character_time_s(const LineSpec& line) {
  const int parity_bits = line.parity == Parity::None ? 0 : 1;
  const int bits = 1 + line.data_bits + parity_bits + line.stop_bits;
  return static_cast<double>(bits) / line.baud;
}

std::optional<std::string> encoded(std::string_view bytes, runtime::PrintCode code,
                                   const LineSpec& line) {
  if (code == runtime::PrintCode::Binary) {
    const bool fits = frame_of(line).data_bits == 8;
    return fits ? std::optional(std::string(bytes)) : std::nullopt;
  }
  Parity parity = Parity::None;
  if (makes_parity_here(line)) {
    parity = line.parity;
  } else if (line.data_bits == 8 && code == runtime::PrintCode::Iso) {
    parity = Parity::Even;
  }
  std::string coded(bytes);
  for (char& c : coded) {
    c = with_parity(c, parity);
  }
  return coded;
}

std::string decoded(std::string_view bytes, const LineSpec& line) {
  return line.data_bits == 7 ? without_parity(bytes, line.parity) : printed_text(bytes);
}

std::string printed_text(std::string_view bytes) {
  const auto even = static_cast<std::size_t>(
      std::ranges::count_if(bytes, [](char c) { return c == with_parity(c, Parity::Even); }));
  if (std::ranges::any_of(bytes, has_bit_eight) && 10 * even >= 9 * bytes.size()) {
    return without_parity(bytes, Parity::Even);
  }
  std::string text(bytes);
  std::erase_if(text, [](char c) { return !has_bit_eight(c) && (c == '\0' || control_code(c)); });
  return text;
}

std::optional<ControlCode> control_code(char received) {
  const unsigned character = static_cast<unsigned char>(received) & kCharacterBits;
  switch (const auto code = static_cast<ControlCode>(character)) {
    case ControlCode::DC1:
    case ControlCode::DC2:
    case ControlCode::DC3:
    case ControlCode::DC4:
      return code;
  }
  return std::nullopt;
}

}  // namespace g31::printer

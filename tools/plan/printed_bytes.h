#pragma once

#include <string>
#include <string_view>

namespace g31::plan {

/// Stands where a byte came with the wrong parity: no name and no number holds it.
inline constexpr char kWrongByte = '?';

enum class BitEight { Even, Odd, Ignored };

/// The characters of bytes whose bit 8 is a parity bit, or is of no meaning.
std::string without_parity(std::string_view bytes, BitEight parity);

/// The text of a printout that was kept as its bytes came: ISO code, which has even parity in bit
/// 8, is known by bytes beyond 127 where nine bytes of ten have even parity; anything else stays as
/// it is.
std::string printed_text(std::string_view bytes);

}  // namespace g31::plan

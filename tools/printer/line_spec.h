#pragma once

#include <string>
#include <string_view>

#include "machine/base/result.h"

namespace g31::printer {

enum class Parity { None, Even, Odd };

/// A serial line as its receiver is set up.
struct LineSpec {
  std::string device;
  int baud = 4800;
  Parity parity = Parity::Even;
  int data_bits = 7;  ///< 7 or 8, without the parity bit
  int stop_bits = 2;  ///< 1 or 2
};

/// Whether text is meant as a serial line and not as a file: it has a comma.
bool names_a_line(std::string_view text);

/// Reads DEVICE,BAUD,PARITY,DATA BITS,STOP BITS: "/dev/ttyS0,4800,e,7,2"; parity e, o or n.
/// @returns the line, or which part is wrong and what would be right
Result<LineSpec, std::string> parse_line_spec(std::string_view text);

}  // namespace g31::printer

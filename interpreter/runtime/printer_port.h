#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace g31::runtime {

/// What the bytes of a printout are, as the control means them (MB-248, MB-250).
enum class PrintCode {
  Ascii,  ///< characters of 7 bits, bit 8 clear
  Iso,    ///< characters of 7 bits, bit 8 makes their number of ones even
  Binary  ///< numbers of BPRNT: all 8 bits count, never a parity
};

/// The printer at the control's port.  Unlike an observer it can refuse: then the program ends with
/// an alarm at the block that wanted to print.  Every function may wait for the printer, but not
/// without end.
class PrinterPort {
 public:
  /// Why the printer did not take it; nullopt: it did.
  using Problem = std::optional<std::string>;

  PrinterPort() = default;
  PrinterPort(const PrinterPort&) = delete;
  PrinterPort& operator=(const PrinterPort&) = delete;
  virtual ~PrinterPort() = default;

  /// POPEN: the printer is to listen (DC2; MB-235).
  virtual Problem select() = 0;
  /// A piece of a printout, without parity.
  virtual Problem send(std::string_view bytes, PrintCode code) = 0;
  /// PCLOS: the printer is released (DC4; MB-235).
  virtual Problem release() = 0;
};

}  // namespace g31::runtime

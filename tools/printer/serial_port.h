#pragma once

#include <memory>
#include <string>

#include "machine/base/result.h"
#include "tools/printer/line_spec.h"

namespace g31::printer {

/// A serial device that is open and set up; closed and as it was found at its end.
class SerialPort {
 public:
  SerialPort() = default;
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;
  virtual ~SerialPort() = default;

  /// Reads and writes never block.
  [[nodiscard]] virtual int descriptor() const = 0;
};

/// Opens the device: a port with modem lines through libserialport, request to send and terminal
/// ready on; a terminal without any (pseudo-terminals, as socat makes them) as it is, since
/// libserialport takes none.
/// @returns the port, or why the device is none or cannot be set so
Result<std::shared_ptr<SerialPort>, std::string> open_serial_port(const LineSpec& line);

}  // namespace g31::printer

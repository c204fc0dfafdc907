#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "tools/printer/serial_port.h"

namespace g31::printer {

/// The line carries nothing any more: the other end hung up, the adapter was pulled out.
struct LineBroken {
  std::string why;
};

/// Bytes to and from a port.  Never waits longer than it is told to.
class SerialLine {
 public:
  explicit SerialLine(std::shared_ptr<SerialPort> port) : port_(std::move(port)) {}

  /// Hands bytes over.  @returns how many the port took, perhaps none
  Result<std::size_t, LineBroken> write(std::string_view bytes);

  /// What came in, as soon as something has, at the latest after the time; empty: nothing.
  Result<std::string, LineBroken> read(std::chrono::nanoseconds longest);

 private:
  std::shared_ptr<SerialPort> port_;
};

}  // namespace g31::printer

#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "interpreter/runtime/interruption.h"
#include "interpreter/runtime/printer_port.h"
#include "machine/base/result.h"
#include "tools/printer/line_code.h"
#include "tools/printer/serial_line.h"

namespace g31::printer {

/// A printer at a serial line, fed as a control feeds it.
///
/// DC2 goes before the printout and DC4 after it (MB-235).  When the printer sends DC3, output
/// stops within ten characters, as the controls' connection manuals promise, until it sends DC1. So
/// that this holds with any driver and adapter, no more than a few characters are handed over ahead
/// of the time that they take on the line.
class SerialPrinter final : public runtime::PrinterPort {
 public:
  /// @param patience  how long the printer may keep the program waiting at a time; a control waits
  ///                  without end
  /// @param interruption  what is left is not sent any more then; outlives this; nullptr: never
  /// @returns why the line cannot be opened
  static Result<std::shared_ptr<SerialPrinter>, std::string> open(
      const LineSpec& line, std::chrono::nanoseconds patience,
      const runtime::Interruption* interruption = nullptr);

  Problem select() override;
  Problem send(std::string_view bytes, runtime::PrintCode code) override;
  Problem release() override;

 private:
  using Clock = std::chrono::steady_clock;

  SerialPrinter(LineSpec line, std::chrono::nanoseconds patience, std::shared_ptr<SerialPort> port,
                const runtime::Interruption* interruption);
  Problem send_control(ControlCode code);
  Problem transmit(std::string_view coded);
  Problem until_sent();
  Problem while_stopped();
  Problem listen(std::chrono::nanoseconds longest);
  [[nodiscard]] std::string problem(std::string_view what) const;

  LineSpec line_;
  std::chrono::nanoseconds patience_;
  const runtime::Interruption* interruption_;
  SerialLine wire_;
  std::chrono::nanoseconds character_time_;
  Clock::time_point sent_by_;  // when the line has carried all that it was given
  bool selected_ = false;
  bool stopped_ = false;  // the printer sent DC3 and no DC1 since
};

}  // namespace g31::printer

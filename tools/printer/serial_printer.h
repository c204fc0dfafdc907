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
  using Clock = std::chrono::steady_clock;

  /// How long the printer may keep the program waiting; a control waits without end.
  struct Patience {
    std::chrono::nanoseconds at_a_time;
    Clock::time_point at_all = Clock::time_point::max();
    /// What is left is not sent any more then; outlives the printer; nullptr: never.
    const runtime::Interruption* interruption = nullptr;
  };

  /// @returns why the line cannot be opened
  static Result<std::shared_ptr<SerialPrinter>, std::string> open(const LineSpec& line,
                                                                  const Patience& patience);

  // Each throws runtime::BudgetSpent where Patience::at_all is over.

  Problem select() override;
  Problem send(std::string_view bytes, runtime::PrintCode code) override;
  Problem release() override;

 private:
  SerialPrinter(LineSpec line, const Patience& patience, std::shared_ptr<SerialPort> port);
  Problem send_control(ControlCode code);
  Problem transmit(std::string_view coded);
  Problem until_sent();
  Problem while_stopped();
  [[nodiscard]] bool may_go_on() const;
  Problem listen(std::chrono::nanoseconds longest);
  [[nodiscard]] std::string problem(std::string_view what) const;

  LineSpec line_;
  Patience patience_;
  SerialLine wire_;
  std::chrono::nanoseconds character_time_;
  Clock::time_point sent_by_;  // when the line has carried all that it was given
  bool selected_ = false;
  bool stopped_ = false;  // the printer sent DC3 and no DC1 since
};

}  // namespace g31::printer

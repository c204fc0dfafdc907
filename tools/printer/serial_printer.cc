#include "tools/printer/serial_printer.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/budget_spent.h"

namespace g31::printer {
namespace {

/// Handed over at once: with what a port of the PC keeps of its own, still within ten.
constexpr std::size_t kAhead = 4;

/// How long a printer that has stopped is listened to before somebody may interrupt.
constexpr std::chrono::steady_clock::duration kBetweenLooks = std::chrono::milliseconds(100);

double seconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

}  // namespace

SerialPrinter::SerialPrinter(LineSpec line, const Patience& patience,
                             std::shared_ptr<SerialPort> port)
    : line_(std::move(line)),
      patience_(patience),
      wire_(std::move(port)),
      character_time_(std::chrono::duration_cast<std::chrono::nanoseconds>(
          std::chrono::duration<double>(character_time_s(line_)))),
      sent_by_(Clock::now()) {}

Result<std::shared_ptr<SerialPrinter>, std::string> SerialPrinter::open(const LineSpec& line,
                                                                        const Patience& patience) {
  const auto port = open_serial_port(line);
  if (!port) {
    return port.error();
  }
  return std::shared_ptr<SerialPrinter>(new SerialPrinter(line, patience, port.value()));
}

runtime::PrinterPort::Problem SerialPrinter::select() {
  if (selected_) {
    return std::nullopt;
  }
  selected_ = true;
  return send_control(ControlCode::DC2);
}

runtime::PrinterPort::Problem SerialPrinter::send(std::string_view bytes, runtime::PrintCode code) {
  const auto coded = encoded(bytes, code, line_);
  if (!coded) {
    return problem("the numbers of BPRNT need 8 data bits, or 7 and a parity bit");
  }
  return transmit(*coded);
}

runtime::PrinterPort::Problem SerialPrinter::release() {
  if (!selected_) {
    return std::nullopt;
  }
  selected_ = false;
  auto wrong = send_control(ControlCode::DC4);
  // The last characters may not be cut off by the end of the program.
  return wrong ? wrong : until_sent();
}

runtime::PrinterPort::Problem SerialPrinter::send_control(ControlCode code) {
  const char character = static_cast<char>(code);
  return send({&character, 1}, runtime::PrintCode::Iso);
}

runtime::PrinterPort::Problem SerialPrinter::transmit(std::string_view coded) {
  Clock::time_point last_taken = Clock::now();
  while (!coded.empty() && may_go_on()) {
    if (auto wrong = until_sent()) {
      return wrong;
    }
    if (auto wrong = while_stopped()) {
      return wrong;
    }
    const auto taken = wire_.write(coded.substr(0, kAhead));
    if (!taken) {
      return problem(fmt::format("the line is broken: {}", taken.error().why));
    }
    const Clock::time_point now = Clock::now();
    if (taken.value() > 0) {
      last_taken = now;
    } else if (now - last_taken > patience_.at_a_time) {
      return problem(
          fmt::format("the line accepted no character for {:g} s", seconds(patience_.at_a_time)));
    }
    coded.remove_prefix(taken.value());
    // A line that takes nothing is tried again after the time of one character.
    const auto count = static_cast<std::int64_t>(std::max<std::size_t>(taken.value(), 1));
    sent_by_ = std::max(sent_by_, now) + count * character_time_;
  }
  return std::nullopt;
}

runtime::PrinterPort::Problem SerialPrinter::until_sent() {
  do {
    if (auto wrong = listen(sent_by_ - Clock::now())) {
      return wrong;
    }
  } while (Clock::now() < sent_by_ && may_go_on());
  return std::nullopt;
}

runtime::PrinterPort::Problem SerialPrinter::while_stopped() {
  const Clock::time_point last = Clock::now() + patience_.at_a_time;
  while (stopped_ && may_go_on()) {
    const Clock::duration left = last - Clock::now();
    if (left <= left.zero()) {
      return problem(fmt::format("the printer sent DC3 (stop) and no DC1 (resume) for {:g} s",
                                 seconds(patience_.at_a_time)));
    }
    if (auto wrong = listen(std::min(left, kBetweenLooks))) {
      return wrong;
    }
  }
  return std::nullopt;
}

/// @returns false: interrupted
/// @throws runtime::BudgetSpent
bool SerialPrinter::may_go_on() const {
  if (Clock::now() > patience_.at_all) {
    throw runtime::BudgetSpent(source::DiagnosticId::BudgetTime,
                               fmt::format(" while {} is waited for", line_.device));
  }
  return !runtime::is_interrupted(patience_.interruption);
}

/// Takes what the printer says, if anything, in the given time at most.
runtime::PrinterPort::Problem SerialPrinter::listen(std::chrono::nanoseconds longest) {
  const auto received = wire_.read(longest);
  if (!received) {
    return problem(fmt::format("the line is broken: {}", received.error().why));
  }
  for (const char c : received.value()) {
    const auto code = control_code(c);
    if (code == ControlCode::DC3) {
      stopped_ = true;
    } else if (code == ControlCode::DC1) {
      stopped_ = false;
    }
  }
  return std::nullopt;
}

std::string SerialPrinter::problem(std::string_view what) const {
  return fmt::format("{}: {}", line_.device, what);
}

}  // namespace g31::printer

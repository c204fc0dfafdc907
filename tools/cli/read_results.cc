#include "tools/cli/read_results.h"

#include <chrono>
#include <cstddef>
#include <cstdio>

#include <fmt/format.h>

#include "tools/cli/read_input.h"
#include "tools/plan/judgement.h"
#include "tools/plan/printed_bytes.h"
#include "tools/printer/line_code.h"
#include "tools/printer/line_spec.h"
#include "tools/printer/serial_line.h"
#include "tools/printer/serial_port.h"

namespace g31::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostReceived = 16'000'000;
constexpr InputLimit kLargestPrintout{kMostReceived, "a printout of results is far smaller"};

/// Bytes of a line of 7 bits have the parity that the port does not take off.
std::string text_of_line(const std::string& bytes, const printer::LineSpec& line) {
  if (line.data_bits != 7) {
    return plan::printed_text(bytes);
  }
  switch (line.parity) {
    case printer::Parity::Even:
      return plan::without_parity(bytes, plan::BitEight::Even);
    case printer::Parity::Odd:
      return plan::without_parity(bytes, plan::BitEight::Odd);
    case printer::Parity::None:
      break;
  }
  return plan::without_parity(bytes, plan::BitEight::Ignored);
}

bool has_all(const std::string& text, const std::vector<plan::Measure>& measures) {
  const std::size_t whole = text.rfind('\n');  // a number without its end may go on
  return whole != std::string::npos &&
         plan::count(plan::judged(measures, text.substr(0, whole)), plan::Verdict::Missing) == 0;
}

Result<std::string, session::Refusal> received(const JudgeOptions& options,
                                               const printer::LineSpec& line,
                                               const std::vector<plan::Measure>& measures) {
  auto port = printer::open_serial_port(line);
  if (!port) {
    return session::bad_input(fmt::format("{}: {}", options.results, port.error()));
  }
  printer::SerialLine wire(port.value());
  constexpr std::chrono::milliseconds kGlance{50};
  const std::chrono::duration<double> patience(options.wait_s);
  std::string bytes;
  for (auto heard = Clock::now(); Clock::now() - heard < patience;) {
    if (runtime::is_interrupted(options.interruption)) {
      return session::interrupted();
    }
    const auto part = wire.read(kGlance);
    if (!part) {
      std::fputs(fmt::format("{}: warning: {}\n", options.results, part.error().why).c_str(),
                 stderr);
      break;
    }
    if (part.value().empty()) {
      continue;
    }
    heard = Clock::now();
    bytes += part.value();
    if (bytes.size() > kMostReceived) {
      return session::bad_input(fmt::format("{}: more than {} bytes came; {}", options.results,
                                            kMostReceived, kLargestPrintout.advice));
    }
    if (has_all(text_of_line(bytes, line), measures)) {
      break;
    }
  }
  return text_of_line(bytes, line);
}

}  // namespace

Result<std::string, session::Refusal> read_results(const JudgeOptions& options,
                                                   const std::vector<plan::Measure>& measures,
                                                   disk::Disk& disk) {
  if (printer::names_a_line(options.results)) {
    const auto line = printer::parse_line_spec(options.results);
    return line ? received(options, line.value(), measures)
                : session::bad_input(fmt::format("{}: {}", options.results, line.error()));
  }
  const auto bytes = read_input(disk, options.results, kLargestPrintout);
  return bytes ? Result<std::string, session::Refusal>(plan::printed_text(bytes.value()))
               : bytes.error();
}

}  // namespace g31::cli

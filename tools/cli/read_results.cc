#include "tools/cli/read_results.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <utility>

#include <fmt/format.h>

#include "interpreter/source/printable.h"
#include "tools/cli/read_input.h"
#include "tools/plan/judgement.h"
#include "tools/printer/line_code.h"
#include "tools/printer/line_spec.h"
#include "tools/printer/serial_line.h"
#include "tools/printer/serial_port.h"

namespace g31::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostReceived = 16'000'000;
constexpr InputLimit kLargestPrintout{kMostReceived, "a printout of results is far smaller"};

bool has_all(const std::string& text, const std::vector<plan::Measure>& measures) {
  const std::size_t whole = text.rfind('\n');  // a number without its end may go on
  return whole != std::string::npos &&
         plan::count(plan::judged(measures, text.substr(0, whole)), plan::Verdict::Missing) == 0;
}

/// A printer ends each line: of one that was cut off a number may lack figures, so it does not
/// count.
plan::PrintedResults whole_lines(const std::string& from, const std::string& text) {
  const std::size_t last_end = text.rfind('\n');
  const std::size_t whole = last_end == std::string::npos ? 0 : last_end + 1;
  const std::string rest = source::printable(std::string_view(text).substr(whole));
  if (rest.find_first_not_of(" %?") != std::string::npos) {
    std::fputs(
        fmt::format("{}: warning: the last line has not come to its end, so that it does not "
                    "count: \"{}\"\n",
                    from, rest)
            .c_str(),
        stderr);
  }
  return {from, text.substr(0, whole)};
}

Result<plan::PrintedResults, session::Refusal> received(
    const JudgeOptions& options, const printer::LineSpec& line,
    const std::vector<plan::Measure>& measures) {
  auto port = printer::open_serial_port(line);
  if (!port) {
    return session::bad_input(fmt::format("{}: {}", options.results, port.error()));
  }
  printer::SerialLine wire(port.value());
  constexpr std::chrono::milliseconds kGlance{50};
  const std::chrono::duration<double> patience(options.wait_s);
  std::string bytes;
  bool is_judged = true;  // in a pause, so that a long printout is not read anew with each part
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
    if (!part.value().empty()) {
      heard = Clock::now();
      bytes += part.value();
      is_judged = false;
    } else if (!std::exchange(is_judged, true) &&
               has_all(printer::decoded(bytes, line), measures)) {
      break;
    }
    if (bytes.size() > kMostReceived) {
      return session::bad_input(fmt::format("{}: more than {} bytes came; {}", options.results,
                                            kMostReceived, kLargestPrintout.advice));
    }
  }
  return whole_lines(options.results, printer::decoded(bytes, line));
}

}  // namespace

Result<plan::PrintedResults, session::Refusal> read_results(
    const JudgeOptions& options, const std::vector<plan::Measure>& measures, disk::Disk& disk) {
  if (printer::names_a_line(options.results)) {
    const auto line = printer::parse_line_spec(options.results);
    return line ? received(options, line.value(), measures)
                : session::bad_input(fmt::format("{}: {}", options.results, line.error()));
  }
  const auto bytes = read_input(disk, options.results, kLargestPrintout);
  if (!bytes) {
    return bytes.error();
  }
  auto results = plan::printed_results(options.results, printer::printed_text(bytes.value()));
  return results ? Result<plan::PrintedResults, session::Refusal>(std::move(results.value()))
                 : session::bad_input(results.error());
}

}  // namespace g31::cli

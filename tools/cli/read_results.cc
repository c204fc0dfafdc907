#include "tools/cli/read_results.h"

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <string_view>
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

/// As much of a text as counts: a printer ends each line, and a number without its end may go on.
std::string_view ended_lines(std::string_view text) {
  return text.substr(0, text.rfind('\n') + 1);  // npos + 1 is 0
}

bool has_all(const std::string& text, const std::vector<plan::Measure>& measures) {
  const plan::Judgement judgement = plan::judged(measures, ended_lines(text));
  return plan::count(judgement, plan::Verdict::Missing) == 0;
}

/// What has come, with a word about a line that was cut off.
plan::PrintedResults results_of(const std::string& from, const std::string& text) {
  const std::string_view lines = ended_lines(text);
  const std::string rest = source::printable(std::string_view(text).substr(lines.size()));
  if (rest.find_first_not_of(" %?") != std::string::npos) {
    std::fputs(
        fmt::format("{}: warning: the last line has not come to its end, so that it does not "
                    "count: \"{}\"\n",
                    from, rest)
            .c_str(),
        stderr);
  }
  return {from, std::string(lines)};
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
  return results_of(options.results, printer::decoded(bytes, line));
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

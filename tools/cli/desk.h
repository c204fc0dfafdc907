#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "interpreter/runtime/observer.h"
#include "interpreter/source/diagnostic.h"
#include "interpreter/source/source_map.h"
#include "tools/cli/run_command.h"
#include "tools/cli/status_line.h"
#include "tools/report/run_document.h"

namespace g31::cli {

/// What people see of a run on standard error: stops and messages as they come, on a terminal how
/// far a long run is, then what was wrong, and one line at the end.
class Desk {
 public:
  /// @param sources  of the programs that run; both outlive the desk
  Desk(const RunOptions& options, const source::SourceMap& sources);

  /// A stop; behind the first kMostStops of them no further one shows.
  void stop(const runtime::StopEvent& event);
  static constexpr std::size_t kMostStops = 1000;
  /// A line for the operator that standard output does not have.
  void message(std::string_view utf8);
  void touch(const runtime::TouchEvent& event) const;

  /// How far the run is, where people watch.
  void progress(std::uint64_t blocks, double machine_time_s);
  /// Something is written to standard output, which may be the same terminal.
  void give_way() { line_.clear(); }

  /// Behind the run: its messages, the locals of the program that an alarm stands in, where a
  /// collision was.
  void tell(const report::RunResult& result, const report::RunRecorder& recorder) const;
  /// The last line.
  void end(const report::RunResult& result, const report::RunRecorder& recorder) const;

 private:
  [[nodiscard]] std::string place(source::Location where) const;
  void print(const source::Diagnostic& message) const;
  void tell_details(const report::RunResult& result, const report::RunRecorder& recorder) const;
  void say(const std::string& text) const;

  const RunOptions& options_;
  const source::SourceMap& sources_;
  bool is_coloured_;
  std::size_t stops_ = 0;
  mutable StatusLine line_;  // gives way to all that is said
};

}  // namespace g31::cli

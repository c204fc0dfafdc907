#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/output_budget.h"
#include "interpreter/source/source_map.h"
#include "machine/base/result.h"
#include "tools/disk/part_file.h"

namespace g31::report {

struct RunResult;

/// What happens in a run, one JSON object a line (NDJSON), each as it happens, diagnostics at the
/// end: `event` says what, the other members are those of the document of a run.
///
///   start  move  moves_undone  touch  stop  recorded  output  message  collision  diagnostic  end
class EventLog {
 public:
  /// Both outlive the log.
  /// @param sources  of the programs that run
  /// @param budget   is charged for each line but the first and the last ones, as what it tells of
  /// @returns why the file cannot be written
  static Result<std::shared_ptr<EventLog>, std::string> create(const std::string& path,
                                                               const source::SourceMap& sources,
                                                               runtime::OutputBudget& budget);

  /// The first line.
  void start(const RunResult& result);
  void add(const runtime::MoveEvent& event);
  void add_undone(std::uint64_t count);
  void add(const runtime::TouchEvent& event);
  void add(const runtime::StopEvent& event);
  void add(const runtime::RecordedEvent& event);
  void add(const runtime::FaultEvent& event);
  /// @param name  "output" or "message"
  /// @param text  as UTF-8
  void add_text(std::string_view name, std::string_view text);

  /// The messages of the run and the last line; gives the file its name.
  /// @returns why it is not whole
  std::optional<std::string> finish(const RunResult& result, std::size_t touches);

 private:
  EventLog(std::string path, std::shared_ptr<disk::PartFile> file, const source::SourceMap& sources,
           runtime::OutputBudget& budget);
  void put(runtime::Output output, const std::string& line);

  std::string path_;
  std::shared_ptr<disk::PartFile> file_;
  const source::SourceMap& sources_;
  runtime::OutputBudget& budget_;
  bool stops_at_m01_ = false;
};

}  // namespace g31::report

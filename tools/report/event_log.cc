#include "tools/report/event_log.h"

#include <filesystem>
#include <utility>

#include "tools/report/event_json.h"
#include "tools/report/run_document.h"
#include "tools/session/ending.h"

namespace g31::report {
namespace {

using runtime::Output;

std::string event_line(const Json& event) {
  std::string line = event.dump(-1, ' ', false, Json::error_handler_t::replace);
  line += '\n';
  return line;
}

/// The name of an event before its members.
Json named(std::string_view name, const Json& members) {
  Json event = {{"event", name}};
  event.update(members);
  return event;
}

}  // namespace

EventLog::EventLog(std::string path, std::shared_ptr<disk::PartFile> file,
                   const source::SourceMap& sources, runtime::OutputBudget& budget)
    : path_(std::move(path)), file_(std::move(file)), sources_(sources), budget_(budget) {}

Result<std::shared_ptr<EventLog>, std::string> EventLog::create(const std::string& path,
                                                                const source::SourceMap& sources,
                                                                runtime::OutputBudget& budget) {
  auto file = disk::PartFile::create(path);
  if (!file) {
    return disk::cannot_write(path, file.error());
  }
  return std::shared_ptr<EventLog>(new EventLog(path, file.value(), sources, budget));
}

void EventLog::start(const RunResult& result) {
  stops_at_m01_ = result.optional_stop;
  file_->write(event_line({{"event", "start"},
                           {"schema", "g31.events/1"},
                           {"version", result.version},
                           {"program", std::filesystem::path(result.program).filename().string()},
                           {"control", result.control},
                           {"seed", result.seed}}));
  file_->flush();
}

void EventLog::put(Output output, const std::string& line) {
  if (budget_.charge(output, line.size())) {
    file_->write(line);
    file_->flush();
  }
}

void EventLog::add(const runtime::MoveEvent& event) {
  Json members = move_json(event);
  add_place(members, event.where, sources_);
  put(Output::Moves, event_line(named("move", members)));
}

void EventLog::add_undone(std::uint64_t count) {
  put(Output::Moves, event_line({{"event", "moves_undone"}, {"count", count}}));
}

void EventLog::add(const runtime::TouchEvent& event) {
  put(Output::Touches, event_line(named("touch", touch_json(event, sources_))));
}

void EventLog::add(const runtime::StopEvent& event) {
  put(Output::Stops, event_line(named("stop", stop_json(event, sources_, stops_at_m01_))));
}

void EventLog::add(const runtime::RecordedEvent& event) {
  put(Output::Events, event_line(named("recorded", recorded_json(event, sources_))));
}

void EventLog::add(const runtime::FaultEvent& event) {
  put(Output::Moves, event_line(named("collision", collision_json(event, sources_))));
}

void EventLog::add_text(std::string_view name, std::string_view text) {
  put(Output::Printouts, event_line({{"event", name}, {"text", text}}));
}

std::optional<std::string> EventLog::finish(const RunResult& result, std::size_t touches) {
  for (const source::Diagnostic& diagnostic : result.outcome.diagnostics) {
    file_->write(event_line(named("diagnostic", diagnostic_json(diagnostic, sources_))));
  }
  file_->write(event_line({{"event", "end"},
                           {"status", session::status_name(result.outcome)},
                           {"exit_code", result.exit_code},
                           {"blocks", result.outcome.blocks},
                           {"touches", touches},
                           {"machine_time_s", result.machine_time_s}}));
  const auto problem = file_->finish();
  return problem ? std::optional(disk::cannot_write(path_, *problem)) : std::nullopt;
}

}  // namespace g31::report

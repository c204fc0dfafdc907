#include "tools/report/run_document.h"

#include <charconv>
#include <filesystem>
#include <map>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <utility>

#include <nlohmann/json.hpp>

#include "interpreter/runtime/overloaded.h"
#include "interpreter/source/latin_1.h"
#include "tools/report/event_json.h"
#include "tools/session/ending.h"

namespace g31::report {
namespace {

/// A detail that is nothing but a number, such as the shop's own of a macro alarm, is one.
Json detail_json(const std::string& detail) {
  int number = 0;
  const auto end = std::from_chars(detail.data(), detail.data() + detail.size(), number);
  const bool whole = end.ec == std::errc() && end.ptr == detail.data() + detail.size();
  return whole ? Json(number) : Json(detail);
}

Json json_of(const runtime::ShownValue& value) {
  return std::visit(
      runtime::Overloaded{
          [](runtime::Cell cell) { return cell.is_vacant() ? Json() : Json(cell.raw()); },
          [](const std::string& text) { return Json(source::text_as_utf8(text)); },
      },
      value);
}

Json values_json(const runtime::NamedValues& values) {
  Json object = Json::object();
  auto& members = object.get_ref<Json::object_t&>();
  std::unordered_set<std::string_view> known;  // the object looks through all of its own
  for (const auto& [name, value] : values) {
    if (known.insert(name).second) {
      members.emplace_back(name, json_of(value));
    } else {
      object[name] = json_of(value);
    }
  }
  return object;
}

Json alarm_json(const runtime::Alarm& alarm, const runtime::NamedValues& locals,
                const source::SourceMap& sources) {
  Json object = {{"number", alarm.number}, {"text", alarm.text}};
  add_place(object, alarm.where, sources);
  if (!alarm.detail.empty()) {
    object["detail"] = detail_json(alarm.detail);
  }
  if (!alarm.inside.empty()) {
    object["inside"] = sites_json(alarm.inside, sources);
  }
  object["calls"] = sites_json(alarm.calls, sources);
  object["locals"] = values_json(locals);
  return object;
}

Json change_json(const ValueChange& change) {
  return {
      {"name", change.name}, {"before", json_of(change.before)}, {"after", json_of(change.after)}};
}

Json allowed_json(const session::AllowedMessage& allowed, const source::SourceMap& sources) {
  Json object = diagnostic_json(allowed.message, sources);
  object["reason"] = source::text_as_utf8(allowed.reason);
  return object;
}

Json expectation_json(const expect::Judged& judged) {
  Json object = {{"name", judged.name},
                 {"expected", judged.expected},
                 {"got", judged.got},
                 {"holds", judged.holds}};
  add_place(object, judged.place);
  return object;
}

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

/// Numbers in its unit.
Json characteristic_json(const expect::MeasuredCharacteristic& row) {
  const expect::Characteristic& what = row.what;
  Json object = {
      {"name", what.name},
      {"variable", what.variable},
      {"unit", what.unit.name},
      {"nominal", or_null(what.nominal)},
      {"tolerance",
       what.tolerance ? Json::array({what.tolerance->lower, what.tolerance->upper}) : Json()},
      {"actual", or_null(row.actual)},
      {"deviation", or_null(row.deviation())},
      {"true", or_null(what.true_value())},
      {"measuring_error", or_null(row.measuring_error())},
      {"verdict", expect::name_of(row.verdict())}};
  add_place(object, what.place);
  return object;
}

Json input_json(const InputFile& input) {
  return {{"file", input.file}, {"sha256", input.sha256}};
}

/// The moves with place and time of their ends.
void add_timed_moves(const RunRecorder& recorder, const source::SourceMap& sources,
                     ObjectWriter& document) {
  const std::vector<double>& times = recorder.move_times();
  std::size_t number = 0;
  document.add_list("moves", recorder.moves(), [&](const runtime::MoveEvent& move) {
    Json object = move_json(move);
    if (number < times.size()) {
      object["time_s"] = times[number++];
    }
    add_place(object, move.where, sources);
    return object;
  });
}

Json call_json(const CallSpan& call, const source::SourceMap& sources) {
  Json object = {{"program", call.program}, {"level", call.level}};
  if (call.level > 0) {
    add_place(object, call.call, sources);
  }
  object["time_s"] = {call.time_from_s, call.time_to_s};
  object["blocks"] = {call.first_block, call.last_block};
  return object;
}

/// What is told of lines, by their numbers.
template <typename Told>
Json json_by_line(const std::map<int, Told>& told) {
  Json object = Json::object();
  auto& members = object.get_ref<Json::object_t&>();
  members.reserve(told.size());
  for (const auto& [line, value] : told) {
    members.emplace_back(std::to_string(line), value);  // operator[] would look through all of them
  }
  return object;
}

Json counts_json(const coverage::FileCoverage& coverage) {
  return {{"file", std::filesystem::path(coverage.file).filename().string()},
          {"lines", json_by_line(coverage.lines)},
          {"conditions", json_by_line(coverage.conditions)}};
}

Json history_json(const VariableHistory& history) {
  Json values = Json::array();
  for (const auto& [time_s, value] : history.values) {
    values.push_back(Json::array({time_s, json_of(value)}));
  }
  return {{"name", history.name}, {"writes", history.writes}, {"values", std::move(values)}};
}

void add_stops(const RunResult& result, const RunRecorder& recorder,
               const source::SourceMap& sources, ObjectWriter& document) {
  document.add_list("stops", recorder.stops(), [&](const runtime::StopEvent& stop) {
    return stop_json(stop, sources, result.optional_stop);
  });
  if (recorder.stops_left_out() > 0) {
    document.add("stops_left_out", recorder.stops_left_out());
  }
}

void add_events(const RunRecorder& recorder, const source::SourceMap& sources,
                ObjectWriter& document) {
  if (recorder.events().empty()) {
    return;
  }
  document.add_list("events", recorder.events(), [&](const runtime::RecordedEvent& event) {
    return recorded_json(event, sources);
  });
  if (recorder.events_left_out() > 0) {
    document.add("events_left_out", recorder.events_left_out());
  }
}

void add_chronicle(const RunResult& result, const source::SourceMap& sources,
                   ObjectWriter& document) {
  document.add_list("calls", result.chronicle->calls(),
                    [&](const CallSpan& call) { return call_json(call, sources); });
  document.add_list("counts", result.coverage, counts_json);
  document.add_list("history", result.chronicle->histories(), history_json);
}

void add_asked_lists(const RunResult& result, const RunRecorder& recorder,
                     const source::SourceMap& sources, const DocumentLists& lists,
                     ObjectWriter& document) {
  if (lists.moves && lists.blocks) {
    add_timed_moves(recorder, sources, document);
  } else if (lists.moves) {
    document.add_list("moves", recorder.moves(), move_json);
  }
  if (lists.touches) {
    document.add_list("touches", recorder.touches(),
                      [&](const runtime::TouchEvent& touch) { return touch_json(touch, sources); });
  }
  if (lists.blocks) {
    add_chronicle(result, sources, document);
  }
}

}  // namespace

void write_run_document(const RunResult& result, const RunRecorder& recorder,
                        const source::SourceMap& sources, const DocumentLists& lists,
                        const TextSink& sink) {
  const auto shown_by = [&](auto convert) {
    return [&sources, convert](const auto& event) { return convert(event, sources); };
  };
  ObjectWriter document(sink);
  document.add("schema", "g31.run/1");
  document.add("program", std::filesystem::path(result.program).filename().string());
  if (!result.version.empty()) {
    document.add("version", result.version);
  }
  document.add("control", result.control);
  document.add("seed", result.seed);
  document.add("status", session::status_name(result.outcome));
  document.add("exit_code", result.exit_code);
  document.add("alarm", result.outcome.alarm
                            ? alarm_json(*result.outcome.alarm, result.locals, sources)
                            : Json());
  document.add("variables", values_json(result.variables));
  if (result.changes) {
    document.add_list("changes", *result.changes, change_json);
  }
  document.add_text("output", recorder.output());
  document.add_latin_1("files", result.files);
  add_stops(result, recorder, sources, document);
  add_events(recorder, sources, document);
  add_asked_lists(result, recorder, sources, lists, document);
  if (!result.probe_state.empty()) {
    document.add("probe", {{"state", result.probe_state}});
  }
  if (recorder.fault()) {
    document.add("collision", collision_json(*recorder.fault(), sources));
  }
  document.add_list("diagnostics", result.outcome.diagnostics, shown_by(diagnostic_json));
  if (!result.allowed.empty()) {
    document.add_list("allowed", result.allowed, shown_by(allowed_json));
  }
  if (!result.expectations.empty()) {
    document.add_list("expectations", result.expectations, expectation_json);
  }
  if (!result.characteristics.empty()) {
    document.add_list("characteristics", result.characteristics, characteristic_json);
  }
  document.add_list("inputs", result.inputs, input_json);
  document.add("blocks", result.outcome.blocks);
  document.add("machine_time_s", result.machine_time_s);
  document.finish();
}

}  // namespace g31::report

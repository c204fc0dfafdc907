#include "tools/report/run_document.h"

#include <charconv>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "interpreter/runtime/overloaded.h"
#include "interpreter/source/latin_1.h"
#include "tools/session/ending.h"

namespace g31::report {
namespace {

using Json = nlohmann::ordered_json;

Json array_of(const Point& p) {
  return Json::array({p.x(), p.y(), p.z()});
}

/// X Y Z, and the rotary axes where one of them is not 0.
Json array_of(const AxisPositions& q) {
  Json list = array_of(linear_axes(q));
  if (!rotary_axes(q).isZero(0.0)) {
    for (Eigen::Index axis = kLinearAxisCount; axis < q.size(); ++axis) {
      list.push_back(q[axis]);
    }
  }
  return list;
}

void add_place(Json& object, const source::ShownPlace& place) {
  if (place.file.empty()) {
    return;
  }
  object["file"] = std::filesystem::path(place.file).filename().string();
  if (place.line > 0) {
    object["line"] = place.line;
    object["column"] = place.column;
  }
}

void add_place(Json& object, const source::Location& where, const source::SourceMap& sources) {
  add_place(object, sources.show(where));
}

Json sites_json(const std::vector<runtime::CallSite>& sites, const source::SourceMap& sources) {
  Json list = Json::array();
  for (const runtime::CallSite& call : sites) {
    Json site = {{"program", call.program}};
    add_place(site, call.where, sources);
    list.push_back(std::move(site));
  }
  return list;
}

/// A detail that is nothing but a number, such as the shop's own of a macro alarm, is one.
Json detail_json(const std::string& detail) {
  int number = 0;
  const auto end = std::from_chars(detail.data(), detail.data() + detail.size(), number);
  const bool whole = end.ec == std::errc() && end.ptr == detail.data() + detail.size();
  return whole ? Json(number) : Json(detail);
}

Json alarm_json(const runtime::Alarm& alarm, const source::SourceMap& sources) {
  Json object = {{"number", alarm.number}, {"text", alarm.text}};
  add_place(object, alarm.where, sources);
  if (!alarm.detail.empty()) {
    object["detail"] = detail_json(alarm.detail);
  }
  if (!alarm.inside.empty()) {
    object["inside"] = sites_json(alarm.inside, sources);
  }
  object["calls"] = sites_json(alarm.calls, sources);
  return object;
}

Json move_json(const runtime::MoveEvent& move) {
  Json object = {{"g", move.g}, {"to", array_of(move.q_M_to)}};
  if (move.g == 4) {
    object["t"] = move.seconds;
  } else if (move.feed_mm_min > 0.0) {
    object["feed"] = move.feed_mm_min;
  }
  return object;
}

/// How the program sees the place.
void add_view(Json& object, const runtime::ProgramView& view, const source::SourceMap& sources) {
  object["work"] = array_of(view.q_L);
  object["tool"] = view.tool ? Json(*view.tool) : Json();
  object["calls"] = sites_json(view.calls, sources);
}

Json touch_json(const runtime::TouchEvent& touch, const source::SourceMap& sources) {
  Json object = {{"block", touch.block}};
  add_place(object, touch.where, sources);
  object["triggered"] = touch.triggered;
  object["commanded"] = array_of(touch.q_M_commanded);
  object["latched"] = array_of(touch.q_M_latched);
  object["stopped"] = array_of(touch.q_M_stopped);
  object["contact"] = touch.contact ? array_of(touch.contact->p_M_point) : Json();
  object["normal"] = touch.contact ? array_of(touch.contact->n_M) : Json();
  object["part"] = touch.contact ? Json(touch.contact->part) : Json();
  object["feed"] = touch.feed_mm_min;
  if (touch.signals != 1) {
    object["signals"] = touch.signals;
  }
  object["time_s"] = touch.time_s;
  add_view(object, touch.view, sources);
  return object;
}

/// Where and how a move was broken off.
Json collision_json(const runtime::FaultEvent& fault, const source::SourceMap& sources) {
  Json object = {{"what", fault.what}, {"at", array_of(fault.q_M_at)}};
  add_place(object, fault.where, sources);
  add_view(object, fault.view, sources);
  object["contact"] = fault.contact ? array_of(fault.contact->p_M_point) : Json();
  object["normal"] = fault.contact ? array_of(fault.contact->n_M) : Json();
  object["part"] = fault.contact ? Json(fault.contact->part) : Json();
  object["move"] = fault.move ? move_json(*fault.move) : Json();
  return object;
}

Json json_of(const runtime::ShownValue& value) {
  return std::visit(
      runtime::Overloaded{
          [](runtime::Cell cell) { return cell.is_vacant() ? Json() : Json(cell.raw()); },
          [](const std::string& text) { return Json(source::as_utf8(text)); },
      },
      value);
}

Json stop_json(const runtime::StopEvent& stop, const source::SourceMap& sources) {
  Json object = {{"kind", stop.kind}, {"text", stop.text}};
  add_place(object, stop.where, sources);
  return object;
}

Json diagnostic_json(const source::Diagnostic& diagnostic, const source::SourceMap& sources) {
  Json object = {{"severity", source::name_of(diagnostic.severity)},
                 {"code", diagnostic.code},
                 {"message", diagnostic.message}};
  add_place(object, place_of(diagnostic, sources));
  if (!diagnostic.remedy.empty()) {
    object["remedy"] = diagnostic.remedy;
  }
  for (const source::Note& note : diagnostic.notes) {
    Json shown = {{"message", note.message}};
    add_place(shown, note.where, sources);
    object["notes"].push_back(std::move(shown));
  }
  return object;
}

Json allowed_json(const session::AllowedMessage& allowed, const source::SourceMap& sources) {
  Json object = diagnostic_json(allowed.message, sources);
  object["reason"] = source::as_utf8(allowed.reason);
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

Json input_json(const InputFile& input) {
  return {{"file", input.file}, {"sha256", input.sha256}};
}

}  // namespace

void write_run_document(const RunResult& result, const RunRecorder& recorder,
                        const source::SourceMap& sources, const TextSink& sink) {
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
  document.add("alarm", result.outcome.alarm ? alarm_json(*result.outcome.alarm, sources) : Json());
  Json variables = Json::object();
  for (const auto& [name, value] : result.variables) {
    variables[name] = json_of(value);
  }
  document.add("variables", variables);
  document.add_latin_1("output", recorder.output());
  document.add_latin_1("files", result.files);
  document.add_list("stops", recorder.stops(), shown_by(stop_json));
  if (recorder.stops_left_out() > 0) {
    document.add("stops_left_out", recorder.stops_left_out());
  }
  if (recorder.what().moves == RecordWhat::Keep::Yes) {
    document.add_list("moves", recorder.moves(), move_json);
  }
  if (recorder.what().touches == RecordWhat::Keep::Yes) {
    document.add_list("touches", recorder.touches(), shown_by(touch_json));
  }
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
  document.add_list("inputs", result.inputs, input_json);
  document.add("blocks", result.outcome.blocks);
  document.add("machine_time_s", result.machine_time_s);
  document.finish();
}

}  // namespace g31::report

#include "tools/report/event_json.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <utility>

namespace g31::report {
namespace {

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

/// How the program sees the place.
void add_view(Json& object, const runtime::ProgramView& view, const source::SourceMap& sources) {
  object["work"] = array_of(view.q_L);
  object["tool"] = view.tool ? Json(*view.tool) : Json();
  object["calls"] = sites_json(view.calls, sources);
}

}  // namespace

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

bool is_optional(const runtime::StopEvent& stop) {
  return stop.kind == "M01" || stop.kind == "M1";
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

Json move_json(const runtime::MoveEvent& move) {
  Json object = {{"g", move.g}, {"to", array_of(move.q_M_to)}};
  if (move.g == 4) {
    object["t"] = move.seconds;
  } else if (move.feed_mm_min > 0.0) {
    object["feed"] = move.feed_mm_min;
  }
  return object;
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
  object["work_commanded"] = array_of(touch.view.q_L_commanded);
  return object;
}

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

Json stop_json(const runtime::StopEvent& stop, const source::SourceMap& sources,
               bool stops_at_m01) {
  Json object = {{"kind", stop.kind}, {"text", stop.text}};
  add_place(object, stop.where, sources);
  if (is_optional(stop) && !stops_at_m01) {
    object["passed"] = true;
  }
  return object;
}

Json recorded_json(const runtime::RecordedEvent& event, const source::SourceMap& sources) {
  Json object = {{"kind", event.kind}};
  for (const runtime::RecordedEvent::Value& value : event.values) {
    const double whole = std::nearbyint(value.number);
    const bool is_whole = whole == value.number && std::abs(whole) < 1e9;
    object[std::string(value.name)] =
        is_whole ? Json(static_cast<std::int64_t>(whole)) : Json(value.number);
  }
  object["time_s"] = event.time_s;
  add_place(object, event.where, sources);
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

}  // namespace g31::report

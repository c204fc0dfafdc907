#pragma once

#include <nlohmann/json.hpp>

#include "interpreter/runtime/observer.h"
#include "interpreter/source/diagnostic.h"
#include "interpreter/source/source_map.h"

namespace g31::report {

// What happens in a run as members of the document, and as lines of events.

using Json = nlohmann::ordered_json;

/// Adds file, line and column, as far as they are known; files without their folder.
void add_place(Json& object, const source::ShownPlace& place);
void add_place(Json& object, const source::Location& where, const source::SourceMap& sources);

/// Whether a stop is one only with the switch for optional stops on.
bool is_optional(const runtime::StopEvent& stop);

Json sites_json(const std::vector<runtime::CallSite>& sites, const source::SourceMap& sources);
Json move_json(const runtime::MoveEvent& move);
Json touch_json(const runtime::TouchEvent& touch, const source::SourceMap& sources);
/// Where and how a move was broken off.
Json collision_json(const runtime::FaultEvent& fault, const source::SourceMap& sources);
/// @param stops_at_m01  else it is passed
Json stop_json(const runtime::StopEvent& stop, const source::SourceMap& sources, bool stops_at_m01);
Json recorded_json(const runtime::RecordedEvent& event, const source::SourceMap& sources);
Json diagnostic_json(const source::Diagnostic& diagnostic, const source::SourceMap& sources);

}  // namespace g31::report

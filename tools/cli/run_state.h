#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tools/report/run_document.h"
#include "tools/session/session.h"

namespace g31::cli {

struct StateValue {
  runtime::ShownValue value;
  /// Before any program; of an entry of a table on a fresh control.  nullopt: not set.
  std::optional<runtime::ShownValue> fresh;
};
/// Variables of all programs, offsets and tool data by their names, those that are set.
using RunState = std::map<std::string, StateValue>;
RunState state_of(session::Session& session);

/// What has changed, by names; vacant where a value is not known or not set.
/// @param session  behind the run
std::vector<report::ValueChange> changes_since(const RunState& before, session::Session& session);

/// Variables of all programs, then those of the main program.
runtime::NamedValues all_values(session::Session& session);

/// Of the level of calls whose block an alarm shows; none where that has ended meanwhile.
runtime::NamedValues locals_of(session::Session& session, const runtime::Alarm& alarm);

}  // namespace g31::cli

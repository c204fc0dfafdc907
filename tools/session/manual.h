#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interpreter/runtime/reference.h"
#include "tools/session/control.h"

namespace g31::session {

/// What the tables of a control, and the programs that come with g31 for it, say about a topic as a
/// user writes it; empty: nothing is known.
runtime::Entries explain(const std::string& topic, const Control& control);

/// Everything, in the order of the tables; then the programs.
runtime::Entries everything(const Control& control);

/// What may have been meant by a topic that the control does not know.
struct Suggestion {
  std::optional<Control> other_control = {};  ///< which knows it
  std::optional<std::string> nearest_topic = {};
  std::string_view examples = {};  ///< topics of this control, for one that is like none of them
};
Suggestion suggestion_for(const std::string& topic, const Control& control);

}  // namespace g31::session

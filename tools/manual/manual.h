#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/runtime/reference.h"
#include "tools/session/control.h"

namespace g31::manual {

/// What all tables say about a topic as a user writes it: those of the control, of the programs
/// that come for it, of set-up sheets and study files, shapes, evaluations and codes of messages.
/// Empty: nothing is named so.
runtime::Entries explain(const std::string& topic, const session::Control& control);

/// Everything, in the order of the tables.
runtime::Entries everything(const session::Control& control);

/// The entries in which every word of `words` stands at the beginning of a word, in letters of any
/// case: those that have them in the name first.
runtime::Entries search(const runtime::Entries& entries, std::string_view words);

/// The name of a key, section, shape or code that an unknown topic is nearest to.
std::optional<std::string> nearest_name_of(const std::string& topic);

}  // namespace g31::manual

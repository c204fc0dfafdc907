#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "interpreter/dialects/fanuc/explain/entry.h"

namespace g31::fanuc::reference {

/// What the tables say about a topic as a user writes it: "#5061", "#100-#149", "G31", "PS0112",
/// "alarm 112", "6001.1", "parameter 3410", "atan", "GOTO", "haas".  A bare number may be
/// an alarm and a parameter: both come.  Empty: nothing is known.
///
/// A pure function of its arguments, for the command line, editors and the manual alike.
Entries explain(std::string_view topic, const Profile& profile);

/// The known topic nearest to an unknown one.
std::optional<std::string> nearest_topic(std::string_view topic);

/// Everything, in the order of the tables.
Entries everything(const Profile& profile);

}  // namespace g31::fanuc::reference

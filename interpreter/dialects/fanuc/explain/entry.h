#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/runtime/reference.h"

namespace g31::fanuc::reference {

using runtime::Entries;
using runtime::Entry;
using runtime::Fact;

// One function a vocabulary; topics are upper case without blanks at their ends.  None of them: no
// entry.

/// "#5061", "#100-#149"
Entries variables(std::string_view topic, const Profile& profile);
/// "G31", "M98"
Entries codes(std::string_view topic, const Profile& profile);
/// "112", "PS0112", "P283", "ALARM 112"
Entries alarms(std::string_view topic, const Profile& profile);
/// All that are rows of alarms.def, rising by the control's numbers.
Entries all_alarms(const Profile& profile);
/// "6001.1", "3410", "PARAMETER 3410"
Entries parameters(std::string_view topic);
/// "ATAN", "GOTO", "DPRNT" and their abbreviations
Entries words(std::string_view topic, const Profile& profile);
/// "_ABSMT"
Entries variable_names(std::string_view topic);
/// "FANUC-16I"
Entries controls(std::string_view topic);

/// Topics that a user may have meant: names of codes, functions, statements and controls.
std::vector<std::string> topic_names();

}  // namespace g31::fanuc::reference

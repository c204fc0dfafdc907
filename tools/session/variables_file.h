#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"
#include "tools/setup/assignment.h"
#include "tools/setup/job.h"
#include "tools/setup/setup_error.h"

namespace g31::session {

/// The non-volatile variables of a control as text: one `#500=1.5` a line, rising.
std::string variables_text(const std::map<std::string, double>& variables);

/// A line of such a text.
struct KeptVariable {
  setup::Assignment assignment;
  source::ShownPlace place;
};

/// Reads such a text; blank lines and lines that begin with `;` do not count.
/// @param path  what errors call it
/// @returns the variables in their order, or every line that is none of these
Result<std::vector<KeptVariable>, setup::SetupErrors> parse_variables_text(const std::string& path,
                                                                           std::string_view text);

}  // namespace g31::session

#pragma once

#include <optional>
#include <string>

namespace g31::disk {

/// A folder that comes with g31 ("macros/fanuc"): beside the installed program under share/g31, or
/// in the source tree that a build folder lies in.  G31_HOME names another place.
std::optional<std::string> shipped_folder(const std::string& name);

}  // namespace g31::disk

#pragma once

#include <optional>
#include <string>

namespace g31::disk {

/// A folder that comes with g31 ("macros/fanuc"): beside the installed program under share/g31, or
/// in the source tree that a build folder lies in, or in share/g31 of that build folder.  G31_HOME
/// names another place.
std::optional<std::string> shipped_folder(const std::string& name);

/// What files and messages call such a folder, "<g31>/macros/fanuc": where g31 lies on one computer
/// says nothing to a reader on another.  Disk reads files by these names.
std::string shipped_name(const std::string& name);

/// The path on the disk of a file that may be named so; any other as it is.
std::string real_path(const std::string& path);

}  // namespace g31::disk

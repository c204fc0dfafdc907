#include "tools/disk/shipped.h"

#include <cstdlib>
#include <filesystem>

namespace g31::disk {

namespace fs = std::filesystem;

std::optional<std::string> shipped_folder(const std::string& name) {
  std::error_code error;
  if (const char* const home = std::getenv("G31_HOME")) {
    const fs::path folder = fs::path(home) / name;
    return fs::is_directory(folder, error) ? std::optional(folder.string()) : std::nullopt;
  }
  fs::path above = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path installed = above.parent_path() / "share" / "g31" / name;
  if (fs::is_directory(installed, error)) {
    return installed.string();
  }
  // build/<preset>/tools/cli: the source tree is a few folders up.
  for (int levels = 0; levels < 6 && above.has_parent_path();
       ++levels, above = above.parent_path()) {
    if (fs::is_directory(above / name, error)) {
      return (above / name).string();
    }
  }
  return std::nullopt;
}

}  // namespace g31::disk

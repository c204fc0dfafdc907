#include "tools/disk/shipped.h"

#include <cstdlib>
#include <filesystem>
#include <string_view>

namespace g31::disk {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view kHere = "<g31>/";

/// The folder that the shipped ones lie in, as far as the place of the program tells.
fs::path root_by_program() {
  std::error_code error;
  fs::path above = fs::read_symlink("/proc/self/exe", error).parent_path();
  const fs::path installed = above.parent_path() / "share" / "g31";
  if (fs::is_directory(installed / "macros", error)) {
    return installed;
  }
  // build/<preset>/tools/cli: the source tree is a few folders up.
  for (int levels = 0; levels < 6 && above.has_parent_path();
       ++levels, above = above.parent_path()) {
    if (fs::is_directory(above / "macros", error)) {
      return above;
    }
  }
  return {};
}

/// What a build makes lies in share/g31 of the build folder; the source tree does not have it.
fs::path built_folder(const std::string& name) {
  std::error_code error;
  fs::path above = fs::read_symlink("/proc/self/exe", error).parent_path();
  for (int levels = 0; levels < 4 && above.has_parent_path();
       ++levels, above = above.parent_path()) {
    if (fs::is_directory(above / "share" / "g31" / name, error)) {
      return above / "share" / "g31" / name;
    }
  }
  return {};
}

fs::path root() {
  if (const char* const home = std::getenv("G31_HOME")) {
    return home;
  }
  static const fs::path kByProgram = root_by_program();
  return kByProgram;
}

}  // namespace

std::optional<std::string> shipped_folder(const std::string& name) {
  const fs::path folder = root() / name;
  std::error_code error;
  if (fs::is_directory(folder, error)) {
    return folder.string();
  }
  const fs::path built = built_folder(name);
  return built.empty() ? std::nullopt : std::optional(built.string());
}

std::string shipped_name(const std::string& name) {
  return std::string(kHere) + name;
}

std::string real_path(const std::string& path) {
  return path.starts_with(kHere) ? (root() / path.substr(kHere.size())).string() : path;
}

}  // namespace g31::disk

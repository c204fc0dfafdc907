#include "tools/cli/new_command.h"

#include <filesystem>

#include <fmt/format.h>

#include "tools/cli/messages.h"
#include "tools/cli/starter_files.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"

namespace g31::cli {
namespace {

namespace fs = std::filesystem;

/// Why the folder cannot be begun; nullopt: nothing is in the way.
std::optional<session::Refusal> in_the_way(const fs::path& folder,
                                           const std::vector<StarterFile>& files) {
  std::error_code unreadable;
  if (fs::exists(folder, unreadable) && !fs::is_directory(folder, unreadable)) {
    return session::bad_input(fmt::format("{} is no folder: nothing is changed", folder.string()));
  }
  for (const StarterFile& file : files) {
    const fs::path path = folder / file.path;
    for (fs::path above = path.parent_path(); above != folder && above.has_relative_path();
         above = above.parent_path()) {
      if (fs::exists(above, unreadable) && !fs::is_directory(above, unreadable)) {
        return session::bad_input(
            fmt::format("{} is no folder: nothing is changed", above.string()));
      }
    }
    if (fs::symlink_status(path, unreadable).type() != fs::file_type::not_found) {
      return session::bad_input(fmt::format(
          "{} is there already: nothing is changed; name another folder", path.string()));
    }
  }
  return std::nullopt;
}

std::optional<session::Refusal> write_file(const fs::path& folder, const StarterFile& file) {
  const fs::path path = folder / file.path;
  std::error_code wrong;
  fs::create_directories(path.parent_path(), wrong);
  if (wrong) {
    return session::bad_input(
        fmt::format("cannot make the folder {}: {}", path.parent_path().string(), wrong.message()));
  }
  return write_out(path.string(), file.text);
}

}  // namespace

ExitCode new_command(const NewOptions& options) {
  const auto control = options.control.empty() ? session::default_control()
                                               : session::control_named(options.control);
  if (!control) {
    return refuse(session::bad_setup(control.error()));
  }
  const fs::path folder(options.folder);
  const std::vector<StarterFile> files = starter_files(control.value());
  if (const auto wrong = in_the_way(folder, files)) {
    return refuse(*wrong);
  }
  std::string text;
  for (const StarterFile& file : files) {
    if (const auto wrong = write_file(folder, file)) {
      return refuse(*wrong);
    }
    text += (folder / file.path).string() + "\n";
  }
  text += fmt::format("Now: g31 run {} --setup {}\n", (folder / files.front().path).string(),
                      (folder / "setup.toml").string());
  const auto wrong = write_out("-", text);
  return wrong ? refuse(*wrong) : ExitCode::Completed;
}

}  // namespace g31::cli

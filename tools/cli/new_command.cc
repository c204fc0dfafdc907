#include "tools/cli/new_command.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "tools/cli/messages.h"
#include "tools/cli/shown_command.h"
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

/// What has been made so far; unless it is kept it goes, so that nobody finds half a beginning and
/// the next try is not in its own way.
class Beginning {
 public:
  Beginning() = default;
  Beginning(const Beginning&) = delete;
  Beginning& operator=(const Beginning&) = delete;
  ~Beginning() {
    std::error_code ignored;
    for (auto path = made_.rbegin(); path != made_.rend(); ++path) {
      fs::remove(*path, ignored);  // a folder only where it is empty
    }
  }

  std::optional<session::Refusal> write(const fs::path& path, std::string_view text) {
    if (auto wrong = make_folder(path.parent_path())) {
      return wrong;
    }
    auto wrong = write_out(path.string(), text);
    if (!wrong) {
      made_.push_back(path);
    }
    return wrong;
  }

  void keep() { made_.clear(); }

 private:
  /// With those above it.
  std::optional<session::Refusal> make_folder(const fs::path& folder) {
    std::error_code wrong;
    if (folder.empty() || fs::is_directory(folder, wrong)) {
      return std::nullopt;
    }
    if (auto above = make_folder(folder.parent_path())) {
      return above;
    }
    wrong.clear();
    if (fs::create_directory(folder, wrong)) {
      made_.push_back(folder);
    }
    return wrong ? std::optional(session::bad_input(fmt::format("cannot make the folder {}: {}",
                                                                folder.string(), wrong.message())))
                 : std::nullopt;
  }

  std::vector<fs::path> made_;  ///< what lies in a folder behind it
};

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
  Beginning beginning;
  for (const StarterFile& file : files) {
    if (const auto wrong = beginning.write(folder / file.path, file.text)) {
      return refuse(*wrong);
    }
    text += (folder / file.path).string() + "\n";
  }
  beginning.keep();
  // A name that begins with - would be taken for an option.
  const fs::path shown = folder.string().starts_with('-') ? "." / folder : folder;
  ShownCommand command("g31 run");
  command.add((shown / files.front().path).string());
  command.add("--setup", (shown / "setup.toml").string());
  const auto wrong = write_out("-", text + "Now: " + command.line() + "\n");
  return wrong ? refuse(*wrong) : ExitCode::Completed;
}

}  // namespace g31::cli

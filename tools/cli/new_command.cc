#include "tools/cli/new_command.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "tools/cli/output_places.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/shown_command.h"
#include "tools/cli/starter_files.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"

namespace g31::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNewSchema = "g31.new/1";

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

/// The document g31.new/1.
std::string document_of(const session::Control& control, const std::vector<std::string>& files,
                        const std::string& command) {
  const nlohmann::ordered_json document = {{"schema", kNewSchema},
                                           {"control", session::name_of(control)},
                                           {"files", files},
                                           {"command", command}};
  constexpr int kIndent = 2;
  return document.dump(kIndent) + "\n";
}

}  // namespace

ExitCode new_command(const NewOptions& options) {
  const auto refused = [&options](const session::Refusal& wrong) {
    return refuse(wrong, options.json, kNewSchema);
  };
  const auto control = options.control.empty() ? session::default_control()
                                               : session::control_named(options.control);
  if (!control) {
    return refused(session::bad_setup(control.error()));
  }
  const fs::path folder(options.folder);
  const std::vector<StarterFile> files = starter_files(control.value());
  std::vector<std::string> made;
  for (const StarterFile& file : files) {
    made.push_back((folder / file.path).string());
  }
  if (const auto wrong = wrong_outputs({{"--json", options.json, true}}, {made})) {
    return refuse(*wrong);
  }
  if (const auto wrong = in_the_way(folder, files)) {
    return refused(*wrong);
  }
  Beginning beginning;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (const auto wrong = beginning.write(made[i], files[i].text)) {
      return refused(*wrong);
    }
  }
  beginning.keep();
  // A name that begins with - would be taken for an option.
  const fs::path shown = folder.string().starts_with('-') ? "." / folder : folder;
  ShownCommand command("g31 run");
  command.add((shown / files.front().path).string());
  command.add("--setup", (shown / "setup.toml").string());
  const auto wrong = write_result(
      options.json,
      [&] { return fmt::format("{}\nNow: {}\n", fmt::join(made, "\n"), command.line()); },
      [&] { return document_of(control.value(), made, command.line()); });
  return wrong ? refuse(*wrong) : ExitCode::Completed;
}

}  // namespace g31::cli

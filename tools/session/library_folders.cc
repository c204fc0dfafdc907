#include "tools/session/library_folders.h"

#include <optional>

#include <fmt/format.h>

namespace g31::session {
namespace {

std::optional<Refusal> add_tree(const std::string& folder, source::FileSystem& files,
                                std::vector<std::string>& folders) {
  if (const auto why = files.why_no_list(folder)) {
    return closed_folder(folder, *why);
  }
  folders.push_back(folder);
  for (const std::string& name : files.folders(folder)) {
    if (name.starts_with('.')) {
      continue;
    }
    if (auto wrong = add_tree(folder + "/" + name, files, folders)) {
      return wrong;
    }
  }
  return std::nullopt;
}

}  // namespace

Result<std::vector<std::string>, Refusal> library_folders(const std::vector<std::string>& named,
                                                          source::FileSystem& files) {
  std::vector<std::string> folders;
  for (const std::string& folder : named) {
    if (!files.has_folder(folder)) {
      return bad_input(fmt::format("--lib {}: no such folder", folder));
    }
    if (auto wrong = add_tree(folder, files, folders)) {
      return *std::move(wrong);
    }
  }
  return folders;
}

}  // namespace g31::session

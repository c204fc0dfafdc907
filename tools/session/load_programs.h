#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "interpreter/source/file_system.h"
#include "tools/disk/shipped.h"
#include "tools/session/programs.h"

namespace g31::session {

/// A folder and those below it, the upper ones first; what is hidden is not looked at.
/// @returns why one of them cannot be looked into
template <typename Library>
std::optional<Refusal> add_tree(Library& library, source::FileSystem& files,
                                const std::string& folder) {
  if (const auto why = files.why_no_list(folder)) {
    return bad_input(fmt::format("cannot read the folder {}: {}", folder, *why));
  }
  library.add_folder(folder);
  for (const std::string& below : files.folders(folder)) {
    if (below.starts_with('.')) {
      continue;
    }
    if (auto wrong = add_tree(library, files, folder + "/" + below)) {
      return wrong;
    }
  }
  return std::nullopt;
}

/// Fills a dialect's library in the order that Programs tells.
/// @param shipped  the folder of the programs shipped with g31: "macros/fanuc"
template <typename Library>
std::optional<Refusal> load_programs(Library& library, const ProgramPaths& paths,
                                     source::FileSystem& files, const std::string& shipped) {
  for (const std::string& program : paths.programs) {
    if (library.add_file(program) == Library::Added::Unreadable) {
      return bad_input(fmt::format("cannot read the program {}", program));
    }
  }
  library.add_folder(std::filesystem::path(paths.programs.front()).parent_path().string());
  for (const std::string& folder : paths.libraries) {
    if (!files.has_folder(folder)) {
      return bad_input(fmt::format("--lib {}: no such folder", folder));
    }
    if (auto wrong = add_tree(library, files, folder)) {
      return wrong;
    }
  }
  if (disk::shipped_folder(shipped)) {
    library.add_folder(disk::shipped_name(shipped));
  }
  return std::nullopt;
}

}  // namespace g31::session

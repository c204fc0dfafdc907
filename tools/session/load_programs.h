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
template <typename Library>
void add_tree(Library& library, source::FileSystem& files, const std::string& folder) {
  library.add_folder(folder);
  for (const std::string& below : files.folders(folder)) {
    if (!below.starts_with('.')) {
      add_tree(library, files, folder + "/" + below);
    }
  }
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
    add_tree(library, files, folder);
  }
  if (disk::shipped_folder(shipped)) {
    library.add_folder(disk::shipped_name(shipped));
  }
  return std::nullopt;
}

}  // namespace g31::session

#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "interpreter/source/file_system.h"
#include "tools/disk/shipped.h"
#include "tools/session/programs.h"

namespace g31::session {

/// Why a folder that --lib names is none to look into; nullopt: it is one.
inline std::optional<Refusal> wrong_library(source::FileSystem& files, const std::string& folder) {
  if (!files.has_folder(folder)) {
    return bad_input(fmt::format("--lib {}: no such folder", folder));
  }
  const auto why = files.why_no_list(folder);
  return why ? std::optional(closed_folder(folder, *why)) : std::nullopt;
}

/// A folder and those below it, the upper ones first; what is hidden is not looked at.
/// @returns why one below it cannot be looked into
template <typename Library>
std::optional<Refusal> add_tree(Library& library, source::FileSystem& files,
                                const std::string& folder) {
  library.add_folder(folder);
  for (const std::string& name : files.folders(folder)) {
    if (name.starts_with('.')) {
      continue;
    }
    const std::string below = folder + "/" + name;
    if (const auto why = files.why_no_list(below)) {
      return closed_folder(below, *why);
    }
    if (auto wrong = add_tree(library, files, below)) {
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
      return unreadable_program(program);
    }
  }
  library.add_folder(std::filesystem::path(paths.programs.front()).parent_path().string());
  for (const std::string& folder : paths.libraries) {
    if (auto wrong = wrong_library(files, folder)) {
      return wrong;
    }
    if (auto wrong = add_tree(library, files, folder)) {
      return wrong;
    }
  }
  if (disk::shipped_folder(shipped)) {
    library.add_shipped_folder(disk::shipped_name(shipped));
  }
  return std::nullopt;
}

}  // namespace g31::session

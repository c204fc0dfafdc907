#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "interpreter/source/file_system.h"
#include "tools/disk/shipped.h"
#include "tools/session/library_folders.h"
#include "tools/session/programs.h"

namespace g31::session {

/// Fills a dialect's library in the order that Programs tells.
/// @param shipped  the folder of the programs shipped with g31: "macros/fanuc"
template <typename Library>
std::optional<Refusal> load_programs(Library& library, const ProgramPaths& paths,
                                     source::FileSystem& files, const std::string& shipped) {
  for (const std::string& program : paths.programs) {
    if (library.add_file(program) == Library::Added::Unreadable) {
      return unreadable("program", program);
    }
  }
  library.add_folder(std::filesystem::path(paths.programs.front()).parent_path().string());
  const auto libraries = library_folders(paths.libraries, files);
  if (!libraries) {
    return libraries.error();
  }
  for (const std::string& folder : libraries.value()) {
    library.add_folder(folder);
  }
  if (disk::shipped_folder(shipped)) {
    library.add_shipped_folder(disk::shipped_name(shipped));
  }
  return std::nullopt;
}

}  // namespace g31::session

#pragma once

#include <string>
#include <vector>

namespace g31::check {

/// What is meant by the files and folders of a command line.
struct ProgramPaths {
  std::vector<std::string> files;    ///< each once, in the order named; those of a folder by name
  std::vector<std::string> named;    ///< of them those that are named themselves
  std::vector<std::string> trees;    ///< folders that are named
  std::vector<std::string> missing;  ///< named, but no file or folder
  /// A folder that is named or lies below one that is, whose files cannot be told.
  struct Closed {
    std::string folder;
    std::string why;  ///< in the system's words
  };
  std::vector<Closed> closed;
  std::vector<std::string> empty;  ///< folders that are named and hold no program
};

/// Files that are named, and the programs in folders and the folders below them, which are told by
/// their names: O1234 with any ending, .nc and its like, .MPF, .SPF and .ARC, and definition files
/// (.DEF) in a folder that has those three anywhere.  Other texts are told by how they begin.
ProgramPaths program_paths(const std::vector<std::string>& named);

}  // namespace g31::check

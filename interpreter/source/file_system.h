#pragma once

#include <optional>
#include <string>
#include <vector>

namespace g31::source {

/// The files of the world, as far as a run reads them.  Abstract so that tests need no disk.
class FileSystem {
 public:
  FileSystem() = default;
  FileSystem(const FileSystem&) = delete;
  FileSystem& operator=(const FileSystem&) = delete;
  virtual ~FileSystem() = default;

  /// The whole file, or nullopt when it cannot be read.
  virtual std::optional<std::string> read(const std::string& path) = 0;

  /// Names (without folder) of the regular files in a folder, sorted; empty when it cannot be read.
  virtual std::vector<std::string> list(const std::string& folder) = 0;
};

}  // namespace g31::source

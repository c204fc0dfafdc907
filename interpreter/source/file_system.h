#pragma once

#include <cstdint>
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

  /// How many bytes the file has; nullopt when it cannot be known, and then it is read whole.
  virtual std::optional<std::uint64_t> size(const std::string& path);

  /// The bytes from `offset`, at most `length` of them, fewer only at the end of the file; nullopt
  /// when they cannot be read.
  virtual std::optional<std::string> read_part(const std::string& path, std::uint64_t offset,
                                               std::size_t length);

  /// Names (without folder) of the regular files in a folder, sorted; empty when it cannot be read.
  virtual std::vector<std::string> list(const std::string& folder) = 0;

  /// Why what is in a folder cannot be told, in the system's words; nullopt: it can, for all that
  /// an implementation knows.
  virtual std::optional<std::string> why_no_list(const std::string& folder);

  /// Names (without path) of the folders in a folder, sorted; an implementation may know none.
  virtual std::vector<std::string> folders(const std::string& folder);

  /// Whether there is such a folder; one without files counts only where an implementation knows.
  virtual bool has_folder(const std::string& folder) { return !list(folder).empty(); }
};

/// The whole file of a program, with LF for each CR where its lines end with CR alone.
std::optional<std::string> read_program(FileSystem& files, const std::string& path);

}  // namespace g31::source

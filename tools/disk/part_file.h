#pragma once

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "machine/base/result.h"

namespace g31::disk {

/// A file that is written piece by piece under a temporary name beside it, so that memory stays
/// small and nobody ever sees half of it; a link to a file stays one.  A device or a pipe is
/// written as it is.
class PartFile {
 public:
  /// @returns why the file cannot be written, in the system's words
  static Result<std::shared_ptr<PartFile>, std::string> create(const std::string& path);

  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  /// Without finish() nothing stays behind.
  ~PartFile();

  /// What goes wrong is told by finish().
  void write(std::string_view text);

  /// Gives the file its name.  @returns why it is not whole; nullopt: it is
  std::optional<std::string> finish();

 private:
  PartFile(const std::string& path, bool in_place);
  void remove_temporary() const;

  std::string path_;
  bool in_place_;
  std::string temporary_;
  std::FILE* file_;
  int error_ = 0;  // errno of the first failure
};

}  // namespace g31::disk

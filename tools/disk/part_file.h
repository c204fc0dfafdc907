#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "machine/base/result.h"

namespace g31::disk {

/// What is made or replaced where a path is written: links are followed, and what the last one
/// leads to need not be there yet.
/// @returns why there is no such file, in the system's words
Result<std::filesystem::path, std::string> written_file(const std::string& path);

/// What is told of a path that cannot be written.  @param reason  in the system's words
std::string cannot_write(const std::string& path, std::string_view reason);

/// A file that is written piece by piece under a temporary name beside it, so that memory stays
/// small and nobody ever sees half of it; a link to a file stays one, be that file there or not,
/// and so do owner and mode of a file that is replaced.  Its bytes are on the disk before it gets
/// its name.  A device or a pipe is written as it is, a named pipe once somebody reads it within
/// 3 s and as long as something is taken from it (pipe_stream.h); "-" and what standard output goes
/// to are standard output.  What a killed run left of the same file is removed.
class PartFile {
 public:
  /// @returns why the file cannot be written, in the system's words
  static Result<std::shared_ptr<PartFile>, std::string> create(const std::string& path);

  PartFile(const PartFile&) = delete;
  PartFile& operator=(const PartFile&) = delete;
  /// Without finish() nothing stays behind.
  ~PartFile();

  /// What goes wrong is told by finish().
  /// @throws BrokenOff
  void write(std::string_view text);

  /// Thrown by write() of a file that minds it, when the program is interrupted.
  struct BrokenOff {};
  /// An interruption from now on breaks the writing off.
  void mind_interruption();

  /// What was written is to be seen by who reads a device or a pipe.
  void flush();

  /// Gives the file its name.  @returns why it is not whole; nullopt: it is
  std::optional<std::string> finish();

 private:
  PartFile(std::FILE* file, std::string path, std::string temporary)
      : file_(file), path_(std::move(path)), temporary_(std::move(temporary)) {}
  void close();
  void give_name();

  std::FILE* file_;
  std::string path_;
  std::string temporary_;  ///< "": it is written in place
  int error_ = 0;          ///< errno of the first failure
  bool minds_interruption_ = false;
};

/// Removes what has no name yet, for a handler of a signal that ends the program.
void remove_unfinished_files();

/// Why PartFile would not begin, asked before the work that fills it; a device or a pipe is not
/// disturbed before there is something to write.
/// @returns in the system's words; nullopt: nothing stands against it
std::optional<std::string> why_not_begun(const std::string& path);

}  // namespace g31::disk

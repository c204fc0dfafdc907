#pragma once

#include <memory>
#include <string>

#include "machine/base/result.h"

namespace g31::disk {

/// Why a file is not ours alone.
struct LockRefusal {
  enum class Kind {
    Held,         ///< by another process, all the time that was waited
    Foreign,      ///< FILE.lock, whose path `why` is, is a file of somebody that is no lock
    Unsupported,  ///< the file system keeps no locks
    Unwritable    ///< nothing can be made in its folder, so neither can the file be written anew
  };
  Kind kind = Kind::Held;
  std::string why;
};

/// Keeps other processes that ask for the same lock away from a file that is read, changed and
/// written anew.  The lock is on FILE.lock beside it (flock), for the file itself is replaced when
/// it is written; whoever ends, however it ends, holds it no more, and what a killed process leaves
/// is no lock.  A link stands for the file behind it.
///
/// A device and a pipe need no lock: nothing replaces them.
class FileLock {
 public:
  /// @param patience_s  how long to wait for another process
  static Result<std::shared_ptr<FileLock>, LockRefusal> take(const std::string& path,
                                                             double patience_s);

  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  /// Removes FILE.lock.
  ~FileLock();

 private:
  FileLock() = default;

  int descriptor_ = -1;  // -1: nothing needs to be locked
  std::string path_;     // of FILE.lock
};

}  // namespace g31::disk

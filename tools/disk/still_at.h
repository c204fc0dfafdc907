#pragma once

#include <string>

#include <sys/stat.h>

namespace g31::disk {

/// Whether the file of a name is the open one: another process may have removed that one meanwhile.
inline bool is_still_at(const std::string& name, int descriptor) {
  struct stat open = {};
  struct stat there = {};
  return ::fstat(descriptor, &open) == 0 && ::lstat(name.c_str(), &there) == 0 &&
         open.st_dev == there.st_dev && open.st_ino == there.st_ino;
}

}  // namespace g31::disk

#include "tools/disk/remembering_disk.h"

namespace g31::disk {

std::optional<std::string> RememberingDisk::read(const std::string& path) {
  looked_(path);
  auto text = disk_.read(path);
  if (text) {
    const std::lock_guard lock(mutex_);
    paths_.insert(path);
  }
  return text;
}

std::optional<std::string> RememberingDisk::read_part(const std::string& path, std::uint64_t offset,
                                                      std::size_t length) {
  looked_(path);
  return disk_.read_part(path, offset, length);
}

std::vector<std::string> RememberingDisk::paths() const {
  const std::lock_guard lock(mutex_);
  return {paths_.begin(), paths_.end()};
}

}  // namespace g31::disk

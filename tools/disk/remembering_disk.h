#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/source/file_system.h"

namespace g31::disk {

/// The disk, which remembers what was read of it in whole: who looks for a program looks into the
/// beginnings of many.  Any number of threads may read at a time.
class RememberingDisk final : public source::FileSystem {
 public:
  /// @param disk  outlives it
  explicit RememberingDisk(source::FileSystem& disk) : disk_(disk) {}

  std::optional<std::string> read(const std::string& path) override;
  std::optional<std::uint64_t> size(const std::string& path) override {
    looked_(path);
    return disk_.size(path);
  }
  std::optional<std::string> read_part(const std::string& path, std::uint64_t offset,
                                       std::size_t length) override;
  std::vector<std::string> list(const std::string& folder) override {
    looked_(folder);
    return disk_.list(folder);
  }
  std::optional<std::string> why_no_list(const std::string& folder) override {
    looked_(folder);
    return disk_.why_no_list(folder);
  }
  std::vector<std::string> folders(const std::string& folder) override {
    looked_(folder);
    return disk_.folders(folder);
  }
  bool has_folder(const std::string& folder) override {
    looked_(folder);
    return disk_.has_folder(folder);
  }

  /// Whom it tells of all that it is asked for, before it looks, be it there or not.
  void tell(std::function<void(const std::string& path)> looked) { looked_ = std::move(looked); }

  /// Paths as they were asked for, of all that has been read so far.
  [[nodiscard]] std::vector<std::string> paths() const;

 private:
  source::FileSystem& disk_;
  std::function<void(const std::string& path)> looked_ = [](const std::string&) {};
  mutable std::mutex mutex_;  ///< guards paths_
  std::set<std::string> paths_;
};

}  // namespace g31::disk

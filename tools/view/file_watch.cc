#include "tools/view/file_watch.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <thread>

#include <sys/stat.h>

#include "tools/disk/shipped.h"

namespace g31::view {
namespace {

/// A hash that does not depend on the order of the names.  Hidden files and the copies that
/// editors make while they save are left out.
std::uint64_t hash_of_names(const std::string& folder) {
  std::uint64_t sum = 0;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with('.') && !name.ends_with('~')) {
      sum += std::hash<std::string>()(name);
    }
  }
  return sum;
}

}  // namespace

Stamp stamp_of(const std::string& path) {
  struct stat found = {};
  if (::stat(path.c_str(), &found) != 0) {
    return {};
  }
  if (S_ISDIR(found.st_mode)) {
    return {true, hash_of_names(path), 0, found.st_ino};
  }
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  return {true, static_cast<std::uint64_t>(found.st_size),
          found.st_mtim.tv_sec * kNsPerSecond + found.st_mtim.tv_nsec, found.st_ino};
}

void FileWatch::begin() {
  Stamps stamps = now();
  const std::scoped_lock lock(mutex_);
  stamps_ = std::move(stamps);
}

void FileWatch::add(const std::string& path) {
  if (path == "-") {
    return;
  }
  const std::string real = path.empty() ? "." : disk::real_path(path);
  const std::scoped_lock lock(mutex_);
  if (!stamps_.contains(real)) {
    stamps_[real] = stamp_of(real);
  }
}

FileWatch::Stamps FileWatch::known() const {
  const std::scoped_lock lock(mutex_);
  return stamps_;
}

FileWatch::Stamps FileWatch::now() const {
  Stamps stamps = known();
  for (auto& [path, stamp] : stamps) {
    stamp = stamp_of(path);
  }
  return stamps;
}

bool FileWatch::has_changed() const {
  for (const auto& [path, stamp] : known()) {
    if (stamp_of(path) != stamp) {
      return true;
    }
  }
  return false;
}

void FileWatch::wait_for_rest() const {
  constexpr std::chrono::milliseconds kRest(50);
  constexpr int kMostRests = 40;
  Stamps before = now();
  for (int i = 0; i < kMostRests; ++i) {
    std::this_thread::sleep_for(kRest);
    Stamps behind = now();
    if (behind == before) {
      return;
    }
    before = std::move(behind);
  }
}

}  // namespace g31::view

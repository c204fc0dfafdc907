#pragma once

#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/source/file_system.h"

namespace g31::testing {

/// Files that only exist in a test, by their paths.
class FilesInMemory final : public source::FileSystem {
 public:
  explicit FilesInMemory(std::map<std::string, std::string> files) : files_(std::move(files)) {}
  std::optional<std::string> read(const std::string& path) override {
    ++reads_[path];
    const auto found = files_.find(path);
    return found != files_.end() ? std::optional(found->second) : std::nullopt;
  }
  std::optional<std::uint64_t> size(const std::string& path) override {
    const auto found = files_.find(path);
    return found != files_.end() ? std::optional<std::uint64_t>(found->second.size())
                                 : std::nullopt;
  }
  std::vector<std::string> list(const std::string& folder) override {
    std::vector<std::string> names;
    for (const auto& [path, text] : files_) {
      if (path.starts_with(folder + "/")) {
        names.push_back(path.substr(folder.size() + 1));
      }
    }
    return names;
  }
  /// How often a file has been read, whether it is there or not.
  [[nodiscard]] int reads(const std::string& path) const {
    const auto found = reads_.find(path);
    return found != reads_.end() ? found->second : 0;
  }
  [[nodiscard]] int reads() const {
    return std::accumulate(reads_.begin(), reads_.end(), 0,
                           [](int sum, const auto& of_file) { return sum + of_file.second; });
  }

 private:
  std::map<std::string, std::string> files_;
  std::map<std::string, int> reads_;
};

}  // namespace g31::testing

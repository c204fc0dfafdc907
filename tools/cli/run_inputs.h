#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/source/file_system.h"
#include "tools/report/run_document.h"
#include "tools/session/prepare.h"

namespace g31::cli {

/// The disk, which remembers what was read of it in whole: who looks for a program looks into the
/// beginnings of many.
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

  /// Paths as they were asked for.
  [[nodiscard]] const std::set<std::string>& paths() const { return paths_; }

 private:
  source::FileSystem& disk_;
  std::function<void(const std::string& path)> looked_ = [](const std::string&) {};
  std::set<std::string> paths_;
};

/// The files that a run depends on, each with what it was when it was added.
class RunInputs {
 public:
  /// A file that is there already stays as it was.
  void add(const std::string& path);
  /// Programs and sheets of a command line; what the job names; what was read.
  void add(const session::Request& request);
  void add(const setup::Job& job);
  void add(const RememberingDisk& disk);

  /// In the order of adding.  What comes with g31 is named from its own root.
  [[nodiscard]] const std::vector<report::InputFile>& files() const { return files_; }

 private:
  std::set<std::string> known_;
  std::vector<report::InputFile> files_;
};

}  // namespace g31::cli

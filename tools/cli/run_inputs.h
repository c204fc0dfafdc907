#pragma once

#include <set>
#include <string>
#include <vector>

#include "tools/disk/remembering_disk.h"
#include "tools/report/run_document.h"
#include "tools/session/prepare.h"

namespace g31::cli {

/// The files that a run depends on, each with what it was when it was added.
class RunInputs {
 public:
  /// A file that is there already stays as it was.
  void add(const std::string& path);
  /// Programs and sheets of a command line; what the job names; what was read.
  void add(const session::Request& request);
  void add(const setup::Job& job);
  void add(const disk::RememberingDisk& disk);

  /// In the order of adding.  What comes with g31 is named from its own root.
  [[nodiscard]] const std::vector<report::InputFile>& files() const { return files_; }

 private:
  std::set<std::string> known_;
  std::vector<report::InputFile> files_;
};

}  // namespace g31::cli

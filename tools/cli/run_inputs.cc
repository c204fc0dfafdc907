#include "tools/cli/run_inputs.h"

#include <filesystem>

#include "tools/disk/file_hash.h"
#include "tools/disk/shipped.h"
#include "tools/setup/job_files.h"

namespace g31::cli {
namespace {

/// Without the place where g31 is installed.
std::string name_of_input(const std::string& path) {
  const std::string root = "machine/library";
  const auto folder = disk::shipped_folder(root);
  return folder && path.starts_with(*folder + "/")
             ? disk::shipped_name(root + path.substr(folder->size()))
             : path;
}

}  // namespace

void RunInputs::add(const std::string& path) {
  if (path.empty() || !known_.insert(std::filesystem::path(path).lexically_normal()).second) {
    return;
  }
  if (auto hash = disk::sha256_of(disk::real_path(path))) {
    files_.push_back({name_of_input(path), *hash});
  }
}

void RunInputs::add(const session::Request& request) {
  for (const std::string& path : request.programs) {
    add(path);
  }
  for (const std::string& path : request.setups) {
    add(path);
  }
}

void RunInputs::add(const setup::Job& job) {
  for (const std::string& path : setup::files_of(job)) {
    add(path);
  }
}

void RunInputs::add(const disk::RememberingDisk& disk) {
  for (const std::string& path : disk.paths()) {
    add(path);
  }
}

}  // namespace g31::cli

#include "tools/session/program_files.h"

#include <cstdint>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

#include "tools/disk/disk.h"

namespace g31::session {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFile = 16U << 20U;

bool is_for_program(const fs::directory_entry& entry) {
  std::error_code error;
  const bool is_plain = entry.symlink_status(error).type() == fs::file_type::regular;
  return is_plain && !entry.path().filename().string().starts_with('.') &&
         entry.file_size(error) <= kLargestFile;
}

}  // namespace

Result<ProgramFiles, std::string> ProgramFiles::open(const std::string& folder) {
  ProgramFiles files;
  files.folder_ = folder;
  if (folder.empty()) {
    return files;
  }
  std::error_code error;
  disk::Disk disk;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (!is_for_program(entry)) {
      continue;
    }
    auto content = disk.read(entry.path().string());
    if (!content) {
      return fmt::format("{}: {}", entry.path().string(),
                         disk::why_unreadable(entry.path().string()));
    }
    files.at_start_[entry.path().filename().string()] = *std::move(content);
  }
  if (error) {
    return error.message();
  }
  return files;
}

ProgramFiles::Changes ProgramFiles::changed(const Contents& now) const {
  Changes changed;
  for (const auto& [name, content] : now) {
    const auto before = at_start_.find(name);
    if (before == at_start_.end() || before->second != content) {
      changed[name] = content;
    }
  }
  return changed;
}

std::vector<std::string> ProgramFiles::deleted(const Contents& now) const {
  std::vector<std::string> names;
  for (const auto& [name, content] : at_start_) {
    if (!now.contains(name)) {
      names.push_back(name);
    }
  }
  return names;
}

std::vector<std::string> ProgramFiles::paths(const Contents& now) const {
  std::vector<std::string> all;
  if (!folder_.empty()) {
    for (const auto& [name, content] : changed(now)) {
      all.push_back((fs::path(folder_) / name).string());
    }
    for (const std::string& name : deleted(now)) {
      all.push_back((fs::path(folder_) / name).string());
    }
  }
  return all;
}

std::optional<std::string> ProgramFiles::save(const Contents& now) const {
  if (folder_.empty()) {
    return std::nullopt;
  }
  for (const auto& [name, content] : changed(now)) {
    const fs::path path = fs::path(folder_) / name;
    std::error_code error;
    if (fs::is_symlink(path, error)) {
      fs::remove(path, error);  // it would lead out of the folder
    }
    if (auto wrong = disk::write_whole_file(path.string(), content)) {
      return wrong;
    }
  }
  for (const std::string& name : deleted(now)) {
    std::error_code error;
    if (!fs::remove(fs::path(folder_) / name, error) && error) {
      return fmt::format("cannot delete {} in {}: {}", name, folder_, error.message());
    }
  }
  return std::nullopt;
}

}  // namespace g31::session

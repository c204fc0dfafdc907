#include "tools/disk/part_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace g31::disk {
namespace {

namespace fs = std::filesystem;

Result<fs::path, std::string> behind_link(const std::string& path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) {
    return fs::path(path);
  }
  const fs::path target = fs::weakly_canonical(path, error);
  if (target.empty()) {
    return error.message();
  }
  return target;
}

/// A device or a pipe: it takes what is written, and nothing may stand in its place.
bool is_device_or_pipe(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace

Result<std::shared_ptr<PartFile>, std::string> PartFile::create(const std::string& path) {
  const auto target = behind_link(path);
  if (!target) {
    return target.error();
  }
  std::shared_ptr<PartFile> file(
      new PartFile(target.value().string(), is_device_or_pipe(target.value())));
  if (file->file_ == nullptr) {
    return std::string(std::strerror(file->error_));
  }
  return file;
}

PartFile::PartFile(const std::string& path, bool in_place)
    : path_(path),
      in_place_(in_place),
      temporary_(in_place ? path : fmt::format("{}.{}.part", path, ::getpid())),
      file_(std::fopen(temporary_.c_str(), "wb")) {
  error_ = file_ == nullptr ? errno : 0;
}

PartFile::~PartFile() {
  if (file_ != nullptr) {
    std::fclose(file_);
    remove_temporary();
  }
}

void PartFile::write(std::string_view text) {
  if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
    error_ = errno;
  }
}

std::optional<std::string> PartFile::finish() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && error_ == 0) {
    error_ = errno;
  }
  if (error_ == 0 && !in_place_ && std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    error_ = errno;
  }
  if (error_ == 0) {
    return std::nullopt;
  }
  remove_temporary();
  return std::string(std::strerror(error_));
}

void PartFile::remove_temporary() const {
  if (!in_place_) {
    std::remove(temporary_.c_str());
  }
}

}  // namespace g31::disk

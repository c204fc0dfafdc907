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

}  // namespace

Result<std::shared_ptr<PartFile>, std::string> PartFile::create(const std::string& path) {
  const auto target = behind_link(path);
  if (!target) {
    return target.error();
  }
  std::shared_ptr<PartFile> file(new PartFile(target.value().string()));
  if (file->file_ == nullptr) {
    return std::string(std::strerror(file->error_));
  }
  return file;
}

PartFile::PartFile(const std::string& path)
    : path_(path),
      temporary_(fmt::format("{}.{}.part", path, ::getpid())),
      file_(std::fopen(temporary_.c_str(), "wb")) {
  error_ = file_ == nullptr ? errno : 0;
}

PartFile::~PartFile() {
  if (file_ != nullptr) {
    std::fclose(file_);
    std::remove(temporary_.c_str());
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
  if (error_ == 0 && std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    error_ = errno;
  }
  if (error_ == 0) {
    return std::nullopt;
  }
  std::remove(temporary_.c_str());
  return std::string(std::strerror(error_));
}

}  // namespace g31::disk

#include "tools/disk/disk.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "tools/disk/part_file.h"

namespace g31::disk {

namespace fs = std::filesystem;

namespace {

/// The names of those entries of a folder that are wanted, sorted.
template <typename Wanted>
std::vector<std::string> names_in(const std::string& folder, Wanted is_wanted) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder.empty() ? "." : folder, error), end; !error && it != end;
       it.increment(error)) {
    if (is_wanted(*it)) {
      names.push_back(it->path().filename().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

std::optional<std::uint64_t> Disk::size(const std::string& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return std::nullopt;
  }
  const auto size = fs::file_size(path, error);
  return error ? std::nullopt : std::optional<std::uint64_t>(size);
}

std::optional<std::string> Disk::read(const std::string& path) {
  if (const auto known = size(path)) {
    return read_part(path, 0, static_cast<std::size_t>(*known));
  }
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!in || fs::is_directory(path, error)) {
    return std::nullopt;
  }
  // A pipe or a device: nobody knows how much will come, and there may be no end of it.
  constexpr std::size_t kPiece = 1 << 20;
  std::string text;
  while (in && text.size() <= kMostOfAPipe) {
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    in.read(text.data() + before, static_cast<std::streamsize>(kPiece));
    text.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  return in.bad() || text.size() > kMostOfAPipe ? std::nullopt : std::optional(std::move(text));
}

std::optional<std::string> Disk::read_part(const std::string& path, std::uint64_t offset,
                                           std::size_t length) {
  std::ifstream in(path, std::ios::binary);
  std::string part(length, '\0');
  if (!in.seekg(static_cast<std::streamoff>(offset)) ||
      (!in.read(part.data(), static_cast<std::streamsize>(length)) && !in.eof())) {
    return std::nullopt;
  }
  part.resize(static_cast<std::size_t>(in.gcount()));
  return part;
}

std::vector<std::string> Disk::list(const std::string& folder) {
  return names_in(folder, [](const fs::directory_entry& entry) {
    std::error_code ignored;
    return entry.is_regular_file(ignored);
  });
}

std::vector<std::string> Disk::folders(const std::string& folder) {
  return names_in(folder, [](const fs::directory_entry& entry) {
    std::error_code ignored;
    return entry.is_directory(ignored) && !entry.is_symlink(ignored);
  });
}

bool Disk::has_folder(const std::string& folder) {
  std::error_code unreadable;
  return fs::is_directory(folder, unreadable);
}

std::optional<std::string> write_whole_file(const std::string& path, std::string_view text) {
  return write_whole_file(path, [&](PartFile& file) { file.write(text); });
}

std::optional<std::string> write_whole_file(const std::string& path,
                                            const std::function<void(PartFile&)>& write) {
  const auto file = PartFile::create(path);
  if (file) {
    write(*file.value());
  }
  const auto reason = file ? file.value()->finish() : file.error();
  return reason ? std::optional(fmt::format("cannot write {}: {}",
                                            path == "-" ? "standard output" : path, *reason))
                : std::nullopt;
}

}  // namespace g31::disk

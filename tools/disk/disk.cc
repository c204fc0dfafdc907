#include "tools/disk/disk.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <istream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include "tools/disk/part_file.h"
#include "tools/disk/shipped.h"

namespace g31::disk {

namespace fs = std::filesystem;

namespace {

/// The names of those entries of a folder that are wanted, sorted.
template <typename Wanted>
std::vector<std::string> names_in(const std::string& folder, Wanted is_wanted) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder.empty() ? "." : real_path(folder), error), end;
       !error && it != end; it.increment(error)) {
    if (is_wanted(*it)) {
      names.push_back(it->path().filename().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

std::atomic<const std::atomic<bool>*> standard_input_is_given_up = nullptr;

/// Whether standard input has more, or its end, before it is given up.
bool comes_in_time() {
  // A signal ends the waiting, but one that came just before it does not.
  constexpr int kLookMs = 100;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  for (;;) {
    const int ready = ::poll(&input, 1, kLookMs);
    if (ready != 0) {
      return ready > 0 || errno != EINTR;
    }
    const std::atomic<bool>* const is_over = standard_input_is_given_up;
    if (is_over != nullptr && *is_over) {
      return false;
    }
  }
}

/// nullopt where it fails, brings more than a pipe may, or is waited for in vain: a handled signal
/// asks for the end of the work.
std::optional<std::string> read_standard_input() {
  constexpr std::size_t kPiece = 1 << 20;
  std::string text;
  std::vector<char> piece(kPiece);
  while (text.size() <= Disk::kMostOfAPipe) {
    if (!comes_in_time()) {
      return std::nullopt;
    }
    const ssize_t count = ::read(STDIN_FILENO, piece.data(), kPiece);
    if (count == 0) {
      return text;
    }
    if (count < 0) {
      return std::nullopt;
    }
    text.append(piece.data(), static_cast<std::size_t>(count));
  }
  return std::nullopt;
}

/// Reads a stream to its end; nullopt where it fails or brings more than a pipe may.
std::optional<std::string> read_to_end(std::istream& in) {
  // Nobody knows how much will come, and there may be no end of it.
  constexpr std::size_t kPiece = 1 << 20;
  std::string text;
  while (in && text.size() <= Disk::kMostOfAPipe) {
    const std::size_t before = text.size();
    text.resize(before + kPiece);
    in.read(text.data() + before, static_cast<std::streamsize>(kPiece));
    text.resize(before + static_cast<std::size_t>(in.gcount()));
  }
  return in.bad() || text.size() > Disk::kMostOfAPipe ? std::nullopt
                                                      : std::optional(std::move(text));
}

/// Standard input brings its text once; whoever reads "-" again reads the same.
const std::optional<std::string>& standard_input() {
  static const std::optional<std::string> kText = read_standard_input();
  return kText;
}

bool is_standard_input(const std::string& path) {
  return path == "-";
}

}  // namespace

void give_standard_input_up_when(const std::atomic<bool>& is_over) {
  standard_input_is_given_up = &is_over;
}

std::optional<std::uint64_t> Disk::size(const std::string& named) {
  if (is_standard_input(named)) {
    const auto& text = standard_input();
    return text ? std::optional<std::uint64_t>(text->size()) : std::nullopt;
  }
  const std::string path = real_path(named);
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return std::nullopt;
  }
  const auto size = fs::file_size(path, error);
  return error ? std::nullopt : std::optional<std::uint64_t>(size);
}

std::optional<std::string> Disk::read(const std::string& named) {
  if (is_standard_input(named)) {
    return standard_input();
  }
  if (const auto known = size(named)) {
    return read_part(named, 0, static_cast<std::size_t>(*known));
  }
  const std::string path = real_path(named);
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!in || fs::is_directory(path, error)) {
    return std::nullopt;
  }
  return read_to_end(in);  // a pipe or a device
}

std::optional<std::string> Disk::read_part(const std::string& path, std::uint64_t offset,
                                           std::size_t length) {
  if (is_standard_input(path)) {
    const auto& text = standard_input();
    return text && offset <= text->size() ? std::optional(text->substr(offset, length))
                                          : std::nullopt;
  }
  std::ifstream in(real_path(path), std::ios::binary);
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
  return fs::is_directory(real_path(folder), unreadable);
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

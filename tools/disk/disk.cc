#include "tools/disk/disk.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "tools/disk/part_file.h"
#include "tools/disk/pipe_stream.h"
#include "tools/disk/shipped.h"
#include "tools/disk/waiting.h"

namespace g31::disk {

namespace fs = std::filesystem;

namespace {

/// The names of those entries of a folder that are wanted, sorted.
template <typename Wanted>
std::vector<std::string> names_in(const std::string& folder, Wanted is_wanted) {
  std::vector<std::string> names;
  look_into(folder, [&](const fs::directory_entry& entry) {
    if (is_wanted(entry)) {
      names.push_back(entry.path().filename().string());
    }
  });
  std::ranges::sort(names);
  return names;
}

bool is_standard_input(const std::string& path) {
  return path == "-";
}

/// Reads to the end; nullopt where that fails, more comes than a pipe may bring, or it is waited
/// for in vain.
/// @param descriptor  not blocking, or standard input
std::optional<std::string> read_to_end(int descriptor) {
  // Nobody knows how much will come, and there may be no end of it.
  constexpr std::size_t kPiece = 1 << 20;
  std::string text;
  std::vector<char> piece(kPiece);
  while (text.size() <= Disk::kMostOfAPipe) {
    if (wait_for_input(descriptor)) {
      return std::nullopt;
    }
    const ssize_t count = ::read(descriptor, piece.data(), kPiece);
    if (count == 0) {
      return text;
    }
    if (count < 0 && errno != EAGAIN && errno != EINTR) {
      return std::nullopt;
    }
    text.append(piece.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  return std::nullopt;
}

/// What a file has there, at most so many bytes; nullopt where that fails.
std::optional<std::string> read_from(int descriptor, std::uint64_t offset, std::size_t length) {
  std::string part(length, '\0');
  std::size_t done = 0;
  while (done < length) {
    const ssize_t count =
        ::pread(descriptor, part.data() + done, length - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno != EINTR) {
      return std::nullopt;
    }
    if (count == 0) {
      break;  // the end of the file
    }
    done += static_cast<std::size_t>(std::max<ssize_t>(count, 0));
  }
  part.resize(done);
  return part;
}

std::optional<std::string> read_pipe(const std::string& path) {
  if (is_standard_input(path)) {
    return read_to_end(STDIN_FILENO);
  }
  std::error_code error;
  if (fs::is_directory(path, error)) {
    return std::nullopt;
  }
  // Without O_NONBLOCK a pipe that nobody writes to would keep us here for ever.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) {
    return std::nullopt;
  }
  auto text = read_to_end(descriptor);
  ::close(descriptor);
  return text;
}

/// Standard input, a pipe or a device brings its text once; whoever reads it again reads the same.
/// @param path  "-", or as the system knows it
const std::optional<std::string>& text_of_pipe(const std::string& path) {
  static std::mutex mutex;
  static std::map<std::string, std::optional<std::string>> texts;
  const std::scoped_lock lock(mutex);
  const auto known = texts.find(path);
  return known != texts.end() ? known->second : texts.emplace(path, read_pipe(path)).first->second;
}

/// Whether it brings its text once, and nobody knows before how much.
bool is_pipe(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return is_standard_input(path) ||
         (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

}  // namespace

std::optional<std::uint64_t> Disk::size(const std::string& named) {
  if (is_standard_input(named)) {
    const auto& text = text_of_pipe(named);
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
  const std::string path = real_path(named);
  if (is_pipe(path)) {
    return text_of_pipe(path);
  }
  const auto known = size(named);
  return known ? read_part(named, 0, static_cast<std::size_t>(*known)) : std::nullopt;
}

std::optional<std::string> Disk::read_part(const std::string& named, std::uint64_t offset,
                                           std::size_t length) {
  const std::string path = real_path(named);
  if (is_pipe(path)) {
    const auto& text = text_of_pipe(path);
    return text && offset <= text->size() ? std::optional(text->substr(offset, length))
                                          : std::nullopt;
  }
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC);
  if (descriptor < 0) {
    return std::nullopt;
  }
  auto part = read_from(descriptor, offset, length);
  ::close(descriptor);
  return part;
}

std::string why_unreadable(const std::string& path) {
  std::error_code ignored;
  if (path != "-" && fs::is_directory(path, ignored)) {
    return "it is a folder";
  }
  return path == "-" || fs::exists(path, ignored) ? "it cannot be opened, or not be read to its end"
                                                  : "no such file";
}

std::optional<std::string> look_into(const std::string& folder,
                                     const std::function<void(const fs::directory_entry&)>& look) {
  const std::string path = folder.empty() ? "." : real_path(folder);
  std::error_code error;
  for (fs::directory_iterator it(path, error), end; !error && it != end; it.increment(error)) {
    look(*it);
  }
  std::error_code unknown;
  if (!error && fs::hard_link_count(path, unknown) == 0) {
    error =
        std::make_error_code(std::errc::no_such_file_or_directory);  // deleted while we are in it
  }
  return error ? std::optional(error.message()) : std::nullopt;
}

std::vector<std::string> Disk::list(const std::string& folder) {
  return names_in(folder, [](const fs::directory_entry& entry) {
    std::error_code ignored;
    return entry.is_regular_file(ignored);
  });
}

std::optional<std::string> Disk::why_no_list(const std::string& folder) {
  return look_into(folder, [](const fs::directory_entry&) {});
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
  if (!file) {
    return cannot_write(path, file.error());
  }
  try {
    file.value()->mind_interruption();
    write(*file.value());
  } catch (const PartFile::BrokenOff&) {
    give_up_output(GivenUp::Interrupted);
    return cannot_write(path, words_for(ECANCELED));
  }
  const auto reason = file.value()->finish();
  return reason ? std::optional(cannot_write(path, *reason)) : std::nullopt;
}

}  // namespace g31::disk

#include "tools/disk/part_file.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tools/disk/pipe_stream.h"
#include "tools/disk/still_at.h"
#include "tools/disk/waiting.h"

namespace g31::disk {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSuffix = ".part";

/// Names of temporary files, where a handler of signals finds them; nullptr: a free place.
std::array<std::atomic<const char*>, 16> unfinished = {};

void note_unfinished(const char* name) {
  for (std::atomic<const char*>& place : unfinished) {
    const char* free = nullptr;
    if (place.compare_exchange_strong(free, name)) {
      return;
    }
  }
}

void forget_unfinished(const char* name) {
  for (std::atomic<const char*>& place : unfinished) {
    const char* here = name;
    place.compare_exchange_strong(here, nullptr);
  }
}

std::string last_error() {
  return words_for(errno);
}

/// A device or a pipe: it takes what is written, and nothing may stand in its place.
bool is_device_or_pipe(const struct stat& is) {
  return !S_ISREG(is.st_mode) && !S_ISDIR(is.st_mode);
}

bool is_standard_output(const struct stat& is) {
  struct stat output = {};
  return ::fstat(STDOUT_FILENO, &output) == 0 && output.st_dev == is.st_dev &&
         output.st_ino == is.st_ino;
}

/// The number is that of the process.
std::string temporary_name(const std::string& target, int number) {
  return fmt::format("{}.{}{}", target, number, kSuffix);
}

/// Whether nobody writes a temporary file any more: who does holds its lock (flock).  Numbers alone
/// do not tell: a process of another container may have ours.
bool is_abandoned(const std::string& name) {
  const int descriptor = ::open(name.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) {
    return errno == ELOOP;  // a link, which we have not made
  }
  const bool is_held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  return !is_held;
}

/// The process in the name of a temporary file of `target`; 0: it is none of those.
int process_in(const std::string& name, const std::string& target) {
  int process = 0;
  if (!name.starts_with(target + ".") || !name.ends_with(kSuffix)) {
    return 0;
  }
  const char* const first = name.data() + target.size() + 1;
  const char* const last = name.data() + name.size() - kSuffix.size();
  const auto [end, error] = std::from_chars(first, last, process);
  return first < last && end == last && error == std::errc() ? process : 0;
}

/// What runs that are no more have left of a file.
void remove_left_overs(const fs::path& target) {
  std::error_code error;
  const fs::path folder = target.parent_path().empty() ? fs::path(".") : target.parent_path();
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    const int process = process_in(name, target.filename().string());
    if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH &&
        is_abandoned(it->path().string())) {
      std::error_code ignored;
      fs::remove(it->path(), ignored);
    }
  }
}

/// A file that nobody had, with its lock; below 0: errno says why there is none.
int new_locked_file(const std::string& name) {
  constexpr mode_t kAsUsual = 0666;  // less what umask takes
  constexpr int kHow = O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC;
  for (;;) {
    const int descriptor = ::open(name.c_str(), kHow, kAsUsual);
    // Without locks, as on some network drives, it is ours by its number.
    if (descriptor < 0 || ::flock(descriptor, LOCK_EX | LOCK_NB) != 0 ||
        is_still_at(name, descriptor)) {
      return descriptor;
    }
    ::close(descriptor);  // another process has taken it for abandoned before it was locked
  }
}

/// A temporary file of a target that nobody had.  @param name  gets its own
/// @returns nullptr: errno says why there is none
std::FILE* new_file(const std::string& target, std::string& name) {
  constexpr int kMostProcesses = 1 << 22;  // as the system numbers them
  constexpr int kMostOfOneNumber = 100;
  int descriptor = -1;
  for (int further = 0; descriptor < 0 && further < kMostOfOneNumber; ++further) {
    name = temporary_name(target, ::getpid() + further * kMostProcesses);
    descriptor = new_locked_file(name);
    if (descriptor < 0 && errno != EEXIST) {
      break;
    }
    if (descriptor < 0 && is_abandoned(name) && ::unlink(name.c_str()) == 0) {
      descriptor = new_locked_file(name);
    }
  }
  return descriptor < 0 ? nullptr : ::fdopen(descriptor, "wb");
}

/// The new file looks like the one that it will replace, as far as we may.
void take_after(std::FILE* file, const struct stat& replaced) {
  const bool is_ours = ::fchown(::fileno(file), replaced.st_uid, replaced.st_gid) == 0;
  // A mode that was meant for another owner would give ours away, and one that was meant for
  // another group would give it to ours.
  constexpr mode_t kPermissions = 0777;
  constexpr mode_t kOfGroup = 0070;
  if (is_ours || replaced.st_uid == ::geteuid()) {
    const mode_t kept = is_ours ? kPermissions : kPermissions & ~kOfGroup;
    (void)::fchmod(::fileno(file), replaced.st_mode & kept);
  }
}

/// The name of a file in its folder is on the disk, too.
void keep_folder(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  const int descriptor =
      ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    (void)::fsync(descriptor);
    ::close(descriptor);
  }
}

}  // namespace

std::string cannot_write(const std::string& path, std::string_view reason) {
  return fmt::format("cannot write {}: {}", path == "-" ? "standard output" : path, reason);
}

Result<fs::path, std::string> written_file(const std::string& path) {
  constexpr int kMostLinks = 40;  // as the system follows
  fs::path file(path);
  std::error_code error;
  for (int followed = 0; fs::is_symlink(file, error); ++followed) {
    if (followed == kMostLinks) {
      return words_for(ELOOP);
    }
    const fs::path target = fs::read_symlink(file, error);
    if (error) {
      return error.message();
    }
    file = file.parent_path() / target;
  }
  return file;
}

Result<std::shared_ptr<PartFile>, std::string> PartFile::create(const std::string& path) {
  const auto made = [](std::FILE* file, const std::string& name, const std::string& temporary) {
    return std::shared_ptr<PartFile>(new PartFile(file, name, temporary));
  };
  struct stat is = {};
  const bool is_there = path != "-" && ::stat(path.c_str(), &is) == 0;
  if (path == "-" || (is_there && is_standard_output(is))) {
    return made(stdout, path, "");
  }
  if (is_there && S_ISFIFO(is.st_mode)) {
    const auto pipe = open_pipe(path);
    return pipe ? Result<std::shared_ptr<PartFile>, std::string>(made(pipe.value(), path, ""))
                : pipe.error();
  }
  if (is_there && is_device_or_pipe(is)) {
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    return file != nullptr ? Result<std::shared_ptr<PartFile>, std::string>(made(file, path, ""))
                           : last_error();
  }
  const auto target = written_file(path);
  if (!target) {
    return target.error();
  }
  remove_left_overs(target.value());
  const std::string name = target.value().string();
  std::string temporary;
  std::FILE* const file = new_file(name, temporary);
  if (file == nullptr) {
    return last_error();
  }
  if (::stat(name.c_str(), &is) == 0) {
    take_after(file, is);
  }
  auto unnamed = made(file, name, temporary);
  note_unfinished(unnamed->temporary_.c_str());
  return unnamed;
}

PartFile::~PartFile() {
  forget_unfinished(temporary_.c_str());
  if (file_ != nullptr && temporary_.empty()) {
    close();
  } else if (file_ != nullptr) {
    std::fclose(file_);  // nothing of it stays, so the disk need not have it
    std::remove(temporary_.c_str());
  }
}

void PartFile::mind_interruption() {
  minds_interruption_ = !is_interrupted();
}

void PartFile::write(std::string_view text) {
  if (minds_interruption_ && is_interrupted()) {
    throw BrokenOff();
  }
  if (error_ == 0 && std::fwrite(text.data(), 1, text.size(), file_) != text.size()) {
    error_ = errno;
  }
}

/// Standard output stays open.
void PartFile::close() {
  std::FILE* const file = std::exchange(file_, nullptr);
  const bool is_kept =
      std::fflush(file) == 0 && (temporary_.empty() || ::fsync(::fileno(file)) == 0);
  // Of standard output something else may have failed before.
  if (error_ == 0 && (!is_kept || std::ferror(file) != 0)) {
    error_ = errno != 0 ? errno : EIO;
  }
  if (file != stdout && std::fclose(file) != 0 && error_ == 0) {
    error_ = errno;
  }
}

void PartFile::give_name() {
  if (error_ == 0 && std::rename(temporary_.c_str(), path_.c_str()) != 0) {
    error_ = errno;
  }
  if (error_ == 0) {
    keep_folder(path_);
  } else {
    std::remove(temporary_.c_str());
  }
}

void PartFile::flush() {
  if (temporary_.empty()) {
    (void)std::fflush(file_);  // finish() tells what goes wrong
  }
}

std::optional<std::string> PartFile::finish() {
  // It stays locked until it has its name.
  const int lock = temporary_.empty() ? -1 : ::fcntl(::fileno(file_), F_DUPFD_CLOEXEC, 0);
  close();
  if (!temporary_.empty()) {
    give_name();
  }
  if (lock >= 0) {
    ::close(lock);
  }
  return error_ == 0 ? std::nullopt : std::optional(words_for(error_));
}

void remove_unfinished_files() {
  for (const std::atomic<const char*>& place : unfinished) {
    if (const char* const name = place) {
      ::unlink(name);
    }
  }
}

std::optional<std::string> why_not_begun(const std::string& path) {
  struct stat is = {};
  const bool is_there = path != "-" && ::stat(path.c_str(), &is) == 0;
  if (path == "-" || (is_there && is_device_or_pipe(is))) {
    return std::nullopt;
  }
  if (is_there && S_ISDIR(is.st_mode)) {
    return words_for(EISDIR);
  }
  const auto file = PartFile::create(path);
  return file ? std::nullopt : std::optional(file.error());
}

}  // namespace g31::disk

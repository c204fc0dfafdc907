#include "tools/disk/file_lock.h"

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string_view>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace g31::disk {
namespace {

namespace fs = std::filesystem;
using LockClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenAttempts(10);

/// Whether the file at a path is the open one: another process may have removed that one meanwhile.
bool is_still_at(const std::string& path, int descriptor) {
  struct stat open = {};
  struct stat there = {};
  return ::fstat(descriptor, &open) == 0 && ::stat(path.c_str(), &there) == 0 &&
         open.st_dev == there.st_dev && open.st_ino == there.st_ino;
}

/// Says in the file who holds it.
void sign(int descriptor) {
  const std::string text = fmt::format("{}\n", ::getpid());
  if (::ftruncate(descriptor, 0) == 0) {
    (void)!::pwrite(descriptor, text.data(), text.size(), 0);
  }
}

std::string holder_of(int descriptor) {
  char text[16] = {};
  const ssize_t read = ::pread(descriptor, text, sizeof text - 1, 0);
  const std::string_view line(text, read > 0 ? static_cast<std::size_t>(read) : 0);
  const std::string_view number = line.substr(0, line.find('\n'));
  const bool is_number =
      !number.empty() && number.find_first_not_of("0123456789") == std::string_view::npos;
  return is_number ? fmt::format("process {}", number) : "another process";
}

/// One that another user made can be locked, too; below 0: there can be none.
int opened(const std::string& path) {
  constexpr int kHow = O_NOFOLLOW | O_CLOEXEC;
  const int descriptor = ::open(path.c_str(), kHow | O_RDWR | O_CREAT, 0666);
  return descriptor >= 0 || errno != EACCES ? descriptor : ::open(path.c_str(), kHow | O_RDONLY);
}

/// Whether a file could not be made for want of a folder, by errno and a look: there are folders
/// where nothing is made (/proc) and nothing replaced.
bool lacks_folder(const std::string& path) {
  const int reason = errno;
  std::error_code unknown;
  const bool is_lacking = (reason == ENOENT || reason == ENOTDIR) &&
                          !fs::is_directory(fs::path(path).parent_path(), unknown);
  errno = reason;
  return is_lacking;
}

/// What came of one attempt; errno says why it failed.
enum class Attempt { Taken, Gone, Failed };

Attempt attempt(const std::string& path, int descriptor) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    return Attempt::Failed;
  }
  return is_still_at(path, descriptor) ? Attempt::Taken : Attempt::Gone;
}

/// nullopt: nothing can be replaced there.
std::optional<std::string> lock_path_of(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error);
  const fs::path file = error ? fs::path(path) : target;
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) {
    return std::nullopt;
  }
  return fmt::format("{}.lock", file.string());
}

}  // namespace

Result<std::shared_ptr<FileLock>, LockRefusal> FileLock::take(const std::string& path,
                                                              double patience_s) {
  const std::shared_ptr<FileLock> lock(new FileLock());
  const auto lock_path = lock_path_of(path);
  const auto start = LockClock::now();
  while (lock_path) {
    const int descriptor = opened(*lock_path);
    if (descriptor < 0 && (errno == EACCES || errno == EROFS || lacks_folder(*lock_path))) {
      return LockRefusal{LockRefusal::Kind::Unwritable, std::strerror(errno)};
    }
    if (descriptor < 0) {
      break;  // what cannot be made beside the file cannot replace it either
    }
    const Attempt came = attempt(*lock_path, descriptor);
    if (came == Attempt::Taken) {
      sign(descriptor);
      lock->descriptor_ = descriptor;
      lock->path_ = *lock_path;
      break;
    }
    const int error = errno;
    const std::string holder = holder_of(descriptor);
    ::close(descriptor);
    if (came == Attempt::Failed && error != EWOULDBLOCK && error != EINTR) {
      return LockRefusal{LockRefusal::Kind::Unsupported, std::strerror(error)};
    }
    const std::chrono::duration<double> waited = LockClock::now() - start;
    if (came == Attempt::Failed && waited.count() >= patience_s) {
      return LockRefusal{LockRefusal::Kind::Held, holder};
    }
    std::this_thread::sleep_for(kBetweenAttempts);
  }
  return lock;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) {
    ::unlink(path_.c_str());  // first: who waits for it sees that it is another one then
    ::close(descriptor_);
  }
}

}  // namespace g31::disk

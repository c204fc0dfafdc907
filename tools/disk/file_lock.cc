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
#include <unistd.h>

#include "tools/disk/still_at.h"

namespace g31::disk {
namespace {

namespace fs = std::filesystem;
using LockClock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenAttempts(10);

/// What a lock says: the number of its process, or nothing; NUL where a machine lost its power.
bool is_lock(std::string_view text) {
  constexpr std::string_view kSays("0123456789\n\0", 12);
  return text.find_first_not_of(kSays) == std::string_view::npos;
}

/// Says in the file who holds it.
void sign(int descriptor) {
  const std::string text = fmt::format("{}\n", ::getpid());
  if (::ftruncate(descriptor, 0) == 0) {
    (void)!::pwrite(descriptor, text.data(), text.size(), 0);
  }
}

/// The beginning of the file, longer than any number of a process.
std::string text_of(int descriptor) {
  char text[16] = {};
  const ssize_t read = ::pread(descriptor, text, sizeof text, 0);
  return {text, read > 0 ? static_cast<std::size_t>(read) : 0};
}

std::string holder_of(int descriptor) {
  const std::string text = text_of(descriptor);
  const std::string number = text.substr(0, text.find('\n'));
  return is_lock(text) && !number.empty() ? fmt::format("process {}", number) : "another process";
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
enum class Attempt { Taken, Gone, Foreign, Failed };

Attempt attempt(const std::string& path, int descriptor) {
  if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    return Attempt::Failed;
  }
  if (!is_still_at(path, descriptor)) {
    return Attempt::Gone;
  }
  return is_lock(text_of(descriptor)) ? Attempt::Taken : Attempt::Foreign;
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
    if (came == Attempt::Foreign) {
      ::close(descriptor);
      return LockRefusal{LockRefusal::Kind::Foreign, *lock_path};
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

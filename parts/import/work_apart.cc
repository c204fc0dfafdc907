#include "parts/import/work_apart.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

namespace g31::parts {
namespace {

// How a child ends; EXIT_FAILURE is left to libraries, and to sanitizers that find something.
constexpr int kDone = 0;
constexpr int kOutOfMemory = 3;
constexpr int kThrew = 4;

/// A file of the system, closed at its end.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  [[nodiscard]] int number() const { return number_; }
  void close() {
    if (number_ >= 0) {
      ::close(number_);
      number_ = -1;
    }
  }

 private:
  int number_;
};

/// What a child has of its parent that is not for it.
void leave_parent() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it does not outlive who waits for it
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE}) {
    std::signal(number, SIG_DFL);
  }
  // A terminal sends these to both: who waits for it ends it, and says so.
  for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
    std::signal(number, SIG_IGN);
  }
  rlimit limit{};
  ::setrlimit(RLIMIT_CORE, &limit);
  limit.rlim_cur = kMostSecondsApart;
  limit.rlim_max = kMostSecondsApart + 1;
  ::setrlimit(RLIMIT_CPU, &limit);
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
#if !defined(G31_UNDER_SANITIZERS)  // what these find is to be seen
  ::dup2(nowhere, STDERR_FILENO);
#endif
}

bool write_all(int to, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(to, bytes.data(), bytes.size());
    if (written < 0 && errno != EINTR) {
      return false;
    }
    bytes.remove_prefix(written > 0 ? static_cast<std::size_t>(written) : 0);
  }
  return true;
}

/// @param take  gets what the work returned; false: it could not
/// @return how a child ends
int code_of(const std::function<std::string()>& work,
            const std::function<bool(std::string)>& take) {
  try {
    return take(work()) ? kDone : kThrew;
  } catch (const std::bad_alloc&) {
    return kOutOfMemory;
  } catch (const std::exception&) {
    return kThrew;
  }
}

[[noreturn]] void work_in_child(const std::function<std::string()>& work, int to) {
  leave_parent();
  ::_exit(code_of(work, [to](const std::string& bytes) { return write_all(to, bytes); }));
}

/// Until the other end is closed.
std::string read_all(int from, const Steps& steps) {
  constexpr int kAskEveryMs = 100;
  constexpr std::size_t kPiece = 1U << 16U;
  std::array<char, kPiece> piece{};
  std::string bytes;
  for (;;) {
    steps.ask();
    pollfd waiting{from, POLLIN, 0};
    if (::poll(&waiting, 1, kAskEveryMs) <= 0) {
      continue;  // nothing has come, or a signal has: what it means is asked above
    }
    const ssize_t count = ::read(from, piece.data(), piece.size());
    if (count > 0) {
      bytes.append(piece.data(), static_cast<std::size_t>(count));
    } else if (count == 0 || errno != EINTR) {
      return bytes;
    }
  }
}

/// What a child says with the code that it ends with; "": the work is done.
std::string end_with(int code) {
  switch (code) {
    case kDone:
      return "";
    case kOutOfMemory:
      return "it takes more memory than there is";
    case kThrew:
      return "it breaks off at this file";
    default:
      return fmt::format("its process ends with exit code {}", code);
  }
}

/// How a process ended; "": well.
std::string end_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0) {
    if (errno != EINTR) {
      return "its process is lost";
    }
  }
  if (WIFSIGNALED(status)) {
    const int number = WTERMSIG(status);
    return number == SIGXCPU || number == SIGKILL
               ? fmt::format("it takes more than {} s or too much memory", kMostSecondsApart)
               : fmt::format("it breaks off at this file with signal {} ({})", number,
                             ::strsignal(number));
  }
  return end_with(WEXITSTATUS(status));
}

#if defined(G31_UNDER_SANITIZERS)
/// The sanitizers' memory has locks that GCC 12 does not free in a child: where another thread
/// holds one at the fork, the child waits for ever.  (glibc's own memory is free there.)
bool child_may_wait_for_ever() {
  const std::filesystem::directory_iterator threads("/proc/self/task");
  return std::distance(begin(threads), end(threads)) > 1;
}

WorkApart done_here(const std::function<std::string()>& work) {
  WorkApart done;
  const int code = code_of(work, [&done](std::string bytes) {
    done.bytes = std::move(bytes);
    return true;
  });
  done.why_not = end_with(code);
  return done;
}
#endif

}  // namespace

WorkApart done_apart(const std::function<std::string()>& work, const GoesOn& goes_on) {
#if defined(G31_UNDER_SANITIZERS)
  if (child_may_wait_for_ever()) {
    return done_here(work);
  }
#endif
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    return {"", fmt::format("no process can be made for it: {}", std::strerror(errno))};
  }
  Descriptor from(ends[0]);
  Descriptor to(ends[1]);
  const pid_t child = ::fork();
  if (child < 0) {
    return {"", fmt::format("no process can be made for it: {}", std::strerror(errno))};
  }
  if (child == 0) {
    from.close();
    work_in_child(work, to.number());
  }
  to.close();
  try {
    WorkApart done{read_all(from.number(), Steps(goes_on)), ""};
    done.why_not = end_of(child);
    return done;
  } catch (const BrokenOff&) {
    ::kill(child, SIGKILL);
    static_cast<void>(end_of(child));
    throw;
  }
}

}  // namespace g31::parts

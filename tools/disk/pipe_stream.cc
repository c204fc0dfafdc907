#include "tools/disk/pipe_stream.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstddef>
#include <cstring>
#include <ctime>
#include <string_view>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

namespace g31::disk {
namespace {

/// While it lives, a pipe without a reader is EPIPE for this thread, not the end of the process:
/// what has been done so far is still told.
class WithoutPipeSignal {
 public:
  WithoutPipeSignal() {
    ::sigemptyset(&pipe_);
    ::sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    ::sigpending(&pending);
    was_pending_ = ::sigismember(&pending, SIGPIPE) != 0;
    ::pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  WithoutPipeSignal(const WithoutPipeSignal&) = delete;
  WithoutPipeSignal& operator=(const WithoutPipeSignal&) = delete;
  ~WithoutPipeSignal() {
    const int error = errno;
    if (!was_pending_) {
      constexpr timespec kAtOnce{0, 0};
      while (::sigtimedwait(&pipe_, nullptr, &kAtOnce) < 0 && errno == EINTR) {
      }
    }
    ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = error;
  }

 private:
  sigset_t pipe_ = {};
  sigset_t before_ = {};
  bool was_pending_ = false;
};

class Pipe {
 public:
  Pipe(int descriptor, double stall_s) : descriptor_(descriptor), stall_s_(stall_s) {}
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() { ::close(descriptor_); }

  /// Keeps the last line until its end is there.  @returns whether all is on its way
  bool write(std::string_view text) {
    waiting_ += text;
    std::size_t sent = 0;
    while (error_ == 0) {
      const std::size_t piece = piece_of(std::string_view(waiting_).substr(sent));
      if (piece == 0) {
        break;
      }
      send(std::string_view(waiting_).substr(sent, piece));
      sent += piece;
    }
    waiting_.erase(0, sent);
    errno = error_;
    return error_ == 0;
  }

  bool finish() {
    for (std::string_view rest = waiting_; error_ == 0 && !rest.empty();) {
      const std::string_view piece = rest.substr(0, PIPE_BUF);
      send(piece);
      rest.remove_prefix(piece.size());
    }
    errno = error_;
    return error_ == 0;
  }

 private:
  /// How much of it goes out together: all of it, or nothing (POSIX, of PIPE_BUF bytes at most).
  static std::size_t piece_of(std::string_view text) {
    const std::string_view most = text.substr(0, PIPE_BUF);
    const std::size_t end = most.rfind('\n');
    return end != std::string_view::npos ? end + 1 : most.size() == PIPE_BUF ? most.size() : 0;
  }

  void send(std::string_view piece) {
    const WithoutPipeSignal quiet;
    while (error_ == 0) {
      if (::write(descriptor_, piece.data(), piece.size()) >= 0) {
        return;
      }
      if (errno == EAGAIN) {
        wait();
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
  }

  /// A pipe is ready once there is room for PIPE_BUF bytes.
  void wait() {
    if (const auto why = wait_for_output(descriptor_, stall_s_)) {
      error_ = error_of(*why);
    }
  }

  int descriptor_;
  double stall_s_;
  int error_ = 0;
  std::string waiting_;
};

ssize_t write_to(void* pipe, const char* bytes, std::size_t size) {
  return static_cast<Pipe*>(pipe)->write({bytes, size}) ? static_cast<ssize_t>(size) : 0;
}

int close_pipe(void* pipe) {
  auto* const closing = static_cast<Pipe*>(pipe);
  const bool is_whole = closing->finish();
  const int error = errno;
  delete closing;
  errno = error;
  return is_whole ? 0 : EOF;
}

}  // namespace

std::FILE* pipe_stream(int descriptor, double stall_s) {
  auto* const pipe = new Pipe(descriptor, stall_s);
  std::FILE* const file = ::fopencookie(pipe, "wb", {nullptr, write_to, nullptr, close_pipe});
  if (file == nullptr) {
    delete pipe;
  }
  return file;
}

Result<std::FILE*, std::string> open_pipe(const std::string& path) {
  constexpr int kLooksPerSecond = 50;
  for (int looks = 1;; ++looks) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor >= 0) {
      std::FILE* const file = pipe_stream(descriptor);
      return file != nullptr ? Result<std::FILE*, std::string>(file) : words_for(errno);
    }
    if (errno != ENXIO) {
      return words_for(errno);
    }
    const double waited_s = static_cast<double>(looks) / kLooksPerSecond;
    if (const auto why = why_give_up_output(waited_s, kPipePatienceS)) {
      return why == GivenUp::Stall
                 ? fmt::format("nobody has read this pipe for {} s", kPipePatienceS)
                 : words_for(error_of(*why));
    }
    ::usleep(1'000'000 / kLooksPerSecond);
  }
}

int error_of(GivenUp why) {
  switch (why) {
    case GivenUp::Interrupted:
      return ECANCELED;
    case GivenUp::Time:
      return ETIME;
    case GivenUp::Stall:
      break;
  }
  return ETIMEDOUT;
}

std::string words_for(int error) {
  switch (error) {
    case ETIMEDOUT:
      return fmt::format("whoever reads this pipe has taken nothing for {} s", kPipeStallS);
    case ETIME:
      return "the limit of computing time is reached and whoever reads this pipe takes nothing: "
             "--max-time raises the limit";
    case ECANCELED:
      return "the work was interrupted and whoever reads this pipe takes nothing";
    case EPIPE:
      return "nobody reads this pipe any more";
    default:
      return std::strerror(error);
  }
}

}  // namespace g31::disk

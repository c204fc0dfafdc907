#include "tools/printer/serial_line.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

#include <poll.h>
#include <unistd.h>

namespace g31::printer {
namespace {

/// A signal, or a port that is busy: nothing is wrong, nothing was done.
bool is_passing(int error) {
  return error == EAGAIN || error == EINTR;
}

}  // namespace

Result<std::size_t, LineBroken> SerialLine::write(std::string_view bytes) {
  const ssize_t written = ::write(port_->descriptor(), bytes.data(), bytes.size());
  if (written < 0 && !is_passing(errno)) {
    return LineBroken{std::strerror(errno)};
  }
  return static_cast<std::size_t>(std::max<ssize_t>(written, 0));
}

Result<std::string, LineBroken> SerialLine::read(std::chrono::nanoseconds longest) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  const std::int64_t wait_ns = std::max<std::int64_t>(longest.count(), 0);
  const timespec wait = {wait_ns / kSecond, wait_ns % kSecond};
  pollfd watched = {port_->descriptor(), POLLIN, 0};
  const int ready = ::ppoll(&watched, 1, &wait, nullptr);
  if (ready < 0 && !is_passing(errno)) {
    return LineBroken{std::strerror(errno)};
  }
  constexpr int kHangUp = POLLHUP | POLLERR | POLLNVAL;
  if (ready > 0 && (watched.revents & kHangUp) != 0) {
    return LineBroken{"the other end hung up"};
  }
  if (ready <= 0) {
    return std::string();
  }
  std::array<char, 64> bytes = {};
  const ssize_t count = ::read(port_->descriptor(), bytes.data(), bytes.size());
  if (count < 0 && !is_passing(errno)) {
    return LineBroken{std::strerror(errno)};
  }
  return std::string(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
}

}  // namespace g31::printer

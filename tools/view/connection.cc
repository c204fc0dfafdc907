#include "tools/view/connection.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <poll.h>
#include <sys/socket.h>

namespace g31::view {
namespace {

/// How long a client may take nothing of the answer.
constexpr std::chrono::seconds kSendPatience(2);

}  // namespace

/// @returns whether it came before the time and the end of the server
bool Connection::waits_for(short event, Clock::time_point last) const {
  constexpr int kBetweenLooksMs = 50;
  while (!ends_ && Clock::now() < last) {
    pollfd watched{socket_, event, 0};
    const int found = ::poll(&watched, 1, kBetweenLooksMs);
    if (found > 0) {
      return true;
    }
    if (found < 0 && errno != EINTR) {
      return false;
    }
  }
  return false;
}

bool Connection::is_readable() const {
  return first_ < count_ || waits_for(POLLIN, request_by_);
}

bool Connection::is_writable() const {
  char next = 0;
  const bool has_hung_up = ::recv(socket_, &next, 1, MSG_PEEK | MSG_DONTWAIT) == 0;
  return !has_hung_up && waits_for(POLLOUT, Clock::now() + kSendPatience);
}

ssize_t Connection::read(char* bytes, std::size_t size) {
  if (first_ == count_) {
    if (!is_readable()) {
      return -1;
    }
    const ssize_t count = ::recv(socket_, bytes_.data(), bytes_.size(), MSG_DONTWAIT);
    if (count <= 0) {
      return count;
    }
    first_ = 0;
    count_ = static_cast<std::size_t>(count);
  }
  const std::size_t given = std::min(size, count_ - first_);
  std::memcpy(bytes, bytes_.data() + first_, given);
  first_ += given;
  return static_cast<ssize_t>(given);
}

ssize_t Connection::write(const char* bytes, std::size_t size) {
  return is_writable() ? ::send(socket_, bytes, size, MSG_DONTWAIT | MSG_NOSIGNAL) : -1;
}

// Both ends are at the loopback; nobody asks for the ports.
void Connection::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip = "127.0.0.1";
  port = 0;
}

void Connection::get_local_ip_and_port(std::string& ip, int& port) const {
  get_remote_ip_and_port(ip, port);
}

}  // namespace g31::view

#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

#include <httplib.h>

namespace g31::view {

/// What a client and the server say to each other.  It waits for nobody once the server ends, and
/// else for a limited time: a client that sends its request byte by byte holds nothing up.
class Connection final : public httplib::Stream {
 public:
  /// @param socket  stays the caller's
  /// @param ends    the server ends; outlives the connection
  Connection(socket_t socket, const std::atomic<bool>& ends) : socket_(socket), ends_(ends) {}

  /// Whether the client is there and takes something, or will in time.
  [[nodiscard]] bool is_writable() const override;
  [[nodiscard]] bool is_readable() const override;
  /// @returns how many bytes came; 0: the client says no more; -1: not in time
  ssize_t read(char* bytes, std::size_t size) override;
  /// @returns how many bytes went out; -1: none
  ssize_t write(const char* bytes, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  [[nodiscard]] socket_t socket() const override { return socket_; }

 private:
  using Clock = std::chrono::steady_clock;

  [[nodiscard]] bool waits_for(short event, Clock::time_point last) const;

  socket_t socket_;
  const std::atomic<bool>& ends_;
  Clock::time_point request_by_ = Clock::now() + std::chrono::seconds(5);
  std::array<char, 4096> bytes_ = {};  ///< read ahead, for the library asks for one at a time
  std::size_t first_ = 0;
  std::size_t count_ = 0;
};

}  // namespace g31::view

#pragma once

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

namespace g31::testing {

/// A printer at the far end of a pseudo-terminal.  It hears every byte as it would come over a line
/// of 8 data bits: a pseudo-terminal makes and checks no parity of its own.
class PlayedPrinter {
 public:
  using Clock = std::chrono::steady_clock;
  /// Called on the printer's thread whenever something has come.
  using Reaction = std::function<void(PlayedPrinter&, const std::string& received)>;

  explicit PlayedPrinter(Reaction reaction = {}) : reaction_(std::move(reaction)) {
    far_ = ::posix_openpt(O_RDWR | O_NOCTTY);
    const bool unlocked = ::grantpt(far_) == 0 && ::unlockpt(far_) == 0;
    EXPECT_TRUE(far_ >= 0 && unlocked);
    device_ = ::ptsname(far_);
    // Held, so that the far end lives on after the program has closed its own.
    near_ = ::open(device_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
    termios raw = {};
    ::tcgetattr(near_, &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(near_, TCSANOW, &raw);
  }
  PlayedPrinter(const PlayedPrinter&) = delete;
  PlayedPrinter& operator=(const PlayedPrinter&) = delete;
  ~PlayedPrinter() {
    heard();
    hang_up();
    ::close(near_);
  }

  /// "/dev/pts/3"
  [[nodiscard]] const std::string& device() const { return device_; }

  /// Begins to listen.
  void start() {
    thread_ = std::thread([this] { listen(); });
    // A process that is forked while a thread begins may find the sanitizers' memory locked.
    while (!listens_) {
      std::this_thread::yield();
    }
  }

  /// All that came since the start; the printer listens no more.
  std::string heard() {
    is_over_ = true;
    if (thread_.joinable()) {
      thread_.join();
    }
    return received_;
  }

  // What a reaction may do.
  void say(char c) const { EXPECT_EQ(::write(far_, &c, 1), 1); }
  /// Listens for a while.  @returns how many bytes came
  std::size_t listen_for(std::chrono::milliseconds time) {
    const std::size_t before = received_.size();
    const Clock::time_point last = Clock::now() + time;
    while (Clock::now() < last) {
      take(std::chrono::duration_cast<std::chrono::milliseconds>(last - Clock::now()));
    }
    return received_.size() - before;
  }
  /// The cable is pulled out.
  void hang_up() {
    if (far_ >= 0) {
      ::close(far_);
      far_ = -1;
    }
  }

  /// The settings of the line as they are now.
  [[nodiscard]] termios settings() const {
    termios now = {};
    EXPECT_EQ(::tcgetattr(near_, &now), 0);
    return now;
  }
  /// Fills the line so that it takes no more.
  void choke() const {
    const std::string filling(4096, 'x');
    bool took = true;
    while (took) {
      took = false;
      while (::write(near_, filling.data(), filling.size()) > 0) {
        took = true;
      }
      while (::write(near_, filling.data(), 1) > 0) {
        took = true;
      }
      // The kernel makes room behind our back as it passes the bytes on.
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }

 private:
  void listen() {
    listens_ = true;
    bool more = true;
    while (far_ >= 0 && (more || !is_over_)) {
      more = take(std::chrono::milliseconds(20));
      if (more && reaction_) {
        reaction_(*this, received_);
      }
    }
  }

  bool take(std::chrono::milliseconds longest) {
    pollfd watched = {far_, POLLIN, 0};
    if (::poll(&watched, 1, static_cast<int>(longest.count()) + 1) <= 0) {
      return false;
    }
    char bytes[256];
    const ssize_t count = ::read(far_, bytes, sizeof bytes);
    if (count > 0) {
      received_.append(bytes, static_cast<std::size_t>(count));
    }
    return count > 0;
  }

  Reaction reaction_;
  int far_ = -1;
  int near_ = -1;
  std::string device_;
  std::string received_;
  std::atomic<bool> listens_ = false;
  std::atomic<bool> is_over_ = false;
  std::thread thread_;
};

}  // namespace g31::testing

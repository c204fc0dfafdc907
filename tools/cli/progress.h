#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <string>

namespace g31::cli {

/// Whether people see how far work is: standard error is a terminal, and nobody wants silence.
bool shows_progress(bool quiet);

/// One line on a terminal that says how far work has come and how long it will still take, once it
/// has taken a second; elsewhere nothing.  The line is gone when the work has ended.
class Progress {
 public:
  /// @param total  pieces of work; 0: nobody knows how many
  /// @param what   the pieces, "runs"; where nobody knows how many, the work
  /// @param shows  shows_progress()
  Progress(std::size_t total, std::string what, bool shows);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  /// A piece is done, or the work is still going on.  From any thread.
  void one_done();

 private:
  [[nodiscard]] std::string line(std::size_t done, double elapsed_s) const;

  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kQuietAtFirst{1000};
  static constexpr std::chrono::milliseconds kBetweenLines{100};

  std::size_t total_;
  std::string what_;
  bool shows_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_line_ = begin_ + kQuietAtFirst;
  bool has_line_ = false;
  std::atomic<std::size_t> done_ = 0;
  std::mutex mutex_;
};

}  // namespace g31::cli

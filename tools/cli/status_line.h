#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>

namespace g31::cli {

/// Whether standard error is a terminal that has colours and can take a line back.
bool takes_control_codes();

/// Whether people see how far work is: on such a terminal, where nobody wants silence.
bool shows_progress(bool quiet);

/// How many letters a line of the terminal has that standard error is; any number where nobody
/// knows.
std::size_t terminal_width();

/// One line on a terminal that says what goes on, once that has taken a second; elsewhere nothing.
class StatusLine {
 public:
  /// @param shows  shows_progress()
  explicit StatusLine(bool shows) : shows_(shows) {}
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;
  ~StatusLine() { clear(); }

  /// From any thread.  A text that the terminal has no room for is cut: what goes on in its next
  /// line would stay there.
  /// @param text  asked for where it is time for another line, with the seconds since the beginning
  void show(const std::function<std::string(double elapsed_s)>& text);

  /// The line is gone until the next one is shown: the terminal is somebody else's.
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kQuietAtFirst{1000};
  static constexpr std::chrono::milliseconds kBetweenLines{100};

  bool shows_;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point next_line_ = begin_ + kQuietAtFirst;
  bool has_line_ = false;
  std::mutex mutex_;
};

/// How far a run is.
void show_run(StatusLine& line, std::uint64_t blocks, double machine_time_s);

}  // namespace g31::cli

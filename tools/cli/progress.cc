#include "tools/cli/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace g31::cli {

bool shows_progress(bool quiet) {
  return !quiet && ::isatty(STDERR_FILENO) == 1;
}

Progress::Progress(std::size_t total, std::string what, bool shows)
    : total_(total), what_(std::move(what)), shows_(shows) {}

Progress::~Progress() {
  if (has_line_) {
    std::fputs("\r\033[K", stderr);
  }
}

std::string Progress::line(std::size_t done, double elapsed_s) const {
  if (total_ == 0) {
    return fmt::format("{}, {:.0f} s", what_, elapsed_s);
  }
  constexpr std::size_t kWidth = 40;
  const std::size_t shown = std::min(done, total_);
  const double part = static_cast<double>(shown) / static_cast<double>(total_);
  const auto filled = static_cast<std::size_t>(part * static_cast<double>(kWidth));
  const std::string bar = std::string(filled, '#') + std::string(kWidth - filled, '.');
  return fmt::format("[{}] {} of {} {}, {:.0f} s left", bar, shown, total_, what_,
                     std::ceil(elapsed_s * (1.0 - part) / part));
}

void Progress::one_done() {
  const std::size_t done = ++done_;
  if (!shows_) {
    return;
  }
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  if (now < next_line_) {
    return;
  }
  next_line_ = now + kBetweenLines;
  has_line_ = true;
  const double elapsed_s = std::chrono::duration<double>(now - begin_).count();
  std::fputs(fmt::format("\r{}\033[K", line(done, elapsed_s)).c_str(), stderr);
  std::fflush(stderr);
}

}  // namespace g31::cli

#include "tools/cli/status_line.h"

#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace g31::cli {

bool shows_progress(bool quiet) {
  return !quiet && ::isatty(STDERR_FILENO) == 1;
}

void StatusLine::show(const std::function<std::string(double elapsed_s)>& text) {
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
  std::fputs(fmt::format("\r{}\033[K", text(elapsed_s)).c_str(), stderr);
  std::fflush(stderr);
}

void StatusLine::clear() {
  const std::lock_guard lock(mutex_);
  if (has_line_) {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    has_line_ = false;
  }
}

}  // namespace g31::cli

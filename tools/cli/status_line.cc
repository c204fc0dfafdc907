#include "tools/cli/status_line.h"

#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "machine/base/utf_8.h"

namespace g31::cli {

bool takes_control_codes() {
  const char* const kind = std::getenv("TERM");
  const bool is_dumb = kind != nullptr && std::string_view(kind) == "dumb";
  return !is_dumb && ::isatty(STDERR_FILENO) == 1;
}

bool shows_progress(bool quiet) {
  return !quiet && takes_control_codes();
}

std::size_t terminal_width() {
  winsize size = {};
  const bool is_known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : std::numeric_limits<std::size_t>::max();
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
  // A letter in the last column would move some terminals on to the next line.
  const std::string said = text(elapsed_s);
  const std::size_t fits = bytes_of_characters(said, terminal_width() - 1);
  std::fputs(fmt::format("\r{}\033[K", std::string_view(said).substr(0, fits)).c_str(), stderr);
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

void show_run(StatusLine& line, std::uint64_t blocks, double machine_time_s) {
  line.show([&](double elapsed_s) {
    return fmt::format("running: {} blocks, {:.0f} s of machine time, {:.0f} s here", blocks,
                       machine_time_s, elapsed_s);
  });
}

}  // namespace g31::cli

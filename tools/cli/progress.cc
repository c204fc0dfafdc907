#include "tools/cli/progress.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace g31::cli {

Progress::Progress(std::size_t total, std::string what, bool shows)
    : total_(total), what_(std::move(what)), line_(shows) {}

std::string Progress::text(std::size_t done, double elapsed_s) const {
  if (total_ == 0) {
    return fmt::format("{}, {:.0f} s", what_, elapsed_s);
  }
  const std::size_t shown = std::min(done, total_);
  const double part = static_cast<double>(shown) / static_cast<double>(total_);
  const std::string said = fmt::format("{} of {} {}, {:.0f} s left", shown, total_, what_,
                                       std::ceil(elapsed_s * (1.0 - part) / part));
  constexpr std::size_t kBarWidth = 40;
  if (kBarWidth + said.size() + std::string_view("[] ").size() >= terminal_width()) {
    return said;
  }
  const auto filled = static_cast<std::size_t>(part * static_cast<double>(kBarWidth));
  const std::string bar = std::string(filled, '#') + std::string(kBarWidth - filled, '.');
  return fmt::format("[{}] {}", bar, said);
}

void Progress::one_done() {
  const std::size_t done = ++done_;
  line_.show([&](double elapsed_s) { return text(done, elapsed_s); });
}

}  // namespace g31::cli

#include "tools/disk/waiting.h"

#include <cerrno>
#include <chrono>
#include <limits>

#include <poll.h>

namespace g31::disk {
namespace {

/// A signal ends the waiting, but one that came just before it does not.
constexpr int kBetweenLooksMs = 100;
constexpr double kNever = std::numeric_limits<double>::infinity();

std::atomic<const std::atomic<bool>*> interruption = nullptr;
std::atomic<double> last_s = kNever;
std::atomic<std::optional<GivenUp>> input_given_up = std::optional<GivenUp>();

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Why nobody waits any longer, whomever for; nullopt: they do.
std::optional<GivenUp> why_over() {
  const std::atomic<bool>* const is_over = interruption;
  if (is_over != nullptr && *is_over) {
    return GivenUp::Interrupted;
  }
  return now_s() > last_s ? std::optional(GivenUp::Time) : std::nullopt;
}

}  // namespace

void give_up_waiting_when(const std::atomic<bool>& is_over) {
  interruption = &is_over;
}

WaitingLimit::WaitingLimit(double seconds) {
  last_s = now_s() + seconds;
  input_given_up = std::optional<GivenUp>();
}

WaitingLimit::~WaitingLimit() {
  last_s = kNever;
}

std::optional<GivenUp> wait_for_input(int descriptor) {
  pollfd watched{descriptor, POLLIN, 0};
  for (;;) {
    // What is wrong with a descriptor is told by who reads from it.
    const int ready = ::poll(&watched, 1, kBetweenLooksMs);
    if (ready > 0 || (ready < 0 && errno != EINTR)) {
      return std::nullopt;
    }
    if (const auto why = why_over()) {
      input_given_up = why;
      return why;
    }
  }
}

std::optional<GivenUp> given_up_input() {
  return input_given_up;
}

}  // namespace g31::disk

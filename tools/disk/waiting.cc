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
/// Why waiting was given up, as a number: atomic values of odd sizes need a library of their own.
class Reason {
 public:
  void forget() { number_ = kNone; }
  void keep(GivenUp why) { number_ = static_cast<int>(why); }
  [[nodiscard]] std::optional<GivenUp> get() const {
    const int number = number_;
    return number == kNone ? std::nullopt : std::optional(static_cast<GivenUp>(number));
  }

 private:
  static constexpr int kNone = -1;
  std::atomic<int> number_ = kNone;
};

Reason input_given_up;
Reason output_given_up;

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Why nobody waits any longer, whomever for; nullopt: they do.
std::optional<GivenUp> why_over() {
  if (is_interrupted()) {
    return GivenUp::Interrupted;
  }
  return now_s() > last_s ? std::optional(GivenUp::Time) : std::nullopt;
}

/// Waits for one look.  @returns whether there is something to do; what is wrong with a descriptor
/// is told by who does it
bool is_ready(int descriptor, short event) {
  pollfd watched{descriptor, event, 0};
  const int found = ::poll(&watched, 1, kBetweenLooksMs);
  return found > 0 || (found < 0 && errno != EINTR);
}

}  // namespace

void give_up_waiting_when(const std::atomic<bool>& is_over) {
  interruption = &is_over;
}

bool is_interrupted() {
  const std::atomic<bool>* const is_over = interruption;
  return is_over != nullptr && *is_over;
}

WaitingLimit::WaitingLimit(double seconds) {
  last_s = now_s() + seconds;
  input_given_up.forget();
  output_given_up.forget();
}

WaitingLimit::~WaitingLimit() {
  last_s = kNever;
}

std::optional<GivenUp> wait_for_input(int descriptor) {
  while (!is_ready(descriptor, POLLIN)) {
    if (const auto why = why_over()) {
      input_given_up.keep(*why);
      return why;
    }
  }
  return std::nullopt;
}

std::optional<GivenUp> why_give_up_output(double waited_s, double stall_s) {
  auto why = waited_s < kOutputGraceS ? std::nullopt : why_over();
  if (!why && waited_s >= stall_s) {
    why = GivenUp::Stall;
  }
  if (why) {
    output_given_up.keep(*why);
  }
  return why;
}

std::optional<GivenUp> wait_for_output(int descriptor, double stall_s) {
  const double began_s = now_s();
  while (!is_ready(descriptor, POLLOUT)) {
    if (const auto why = why_give_up_output(now_s() - began_s, stall_s)) {
      return why;
    }
  }
  return std::nullopt;
}

void give_up_output(GivenUp why) {
  output_given_up.keep(why);
}

std::optional<GivenUp> given_up_input() {
  return input_given_up.get();
}

std::optional<GivenUp> given_up_output() {
  return output_given_up.get();
}

}  // namespace g31::disk

#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

namespace g31::disk {

/// Why somebody waits no longer for who stands at the other end of a pipe.
enum class GivenUp : std::uint8_t {
  Interrupted,
  Time,   ///< a WaitingLimit is over
  Stall,  ///< the other end has done nothing for too long
};

/// From now on nobody waits any longer when this is true; a signal that is handled ends the waiting
/// at once.  @param is_over  outlives the program's work
void give_up_waiting_when(const std::atomic<bool>& is_over);

/// While it lives nobody waits beyond its time.  There is one at a time.
class WaitingLimit {
 public:
  explicit WaitingLimit(double seconds);
  WaitingLimit(const WaitingLimit&) = delete;
  WaitingLimit& operator=(const WaitingLimit&) = delete;
  ~WaitingLimit();
};

/// Waits for what a pipe brings, or for its end.  @returns nullopt: it is there; else why not
std::optional<GivenUp> wait_for_input(int descriptor);

/// Why waiting for input has been given up since the last WaitingLimit began; nullopt: it has not.
std::optional<GivenUp> given_up_input();

}  // namespace g31::disk

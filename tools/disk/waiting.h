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

/// Whether that is true.
bool is_interrupted();

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

/// Whoever reads what we write is waited for so long at least: a run that is interrupted, or has
/// used up its time, still tells what it came to.
inline constexpr double kOutputGraceS = 1.0;

/// Why whoever reads a pipe is waited for no longer; nullopt: they are.
/// @param waited_s  so long already
/// @param stall_s   the longest
std::optional<GivenUp> why_give_up_output(double waited_s, double stall_s);

/// Waits until a pipe takes something.  @returns nullopt: it does; else why not
std::optional<GivenUp> wait_for_output(int descriptor, double stall_s);

/// Nobody who reads what we write gets the rest of it.
void give_up_output(GivenUp why);

/// Why waiting has been given up since the last WaitingLimit began, for input and for who reads
/// what we write; nullopt: it has not.
std::optional<GivenUp> given_up_input();
std::optional<GivenUp> given_up_output();

}  // namespace g31::disk

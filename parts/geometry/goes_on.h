#pragma once

#include <cstdint>
#include <functional>
#include <utility>

namespace g31::parts {

/// Thrown where long work on a mesh is broken off.  No std::exception: the mesh is not to blame.
struct BrokenOff {};

/// Whether long work on a mesh is to go on; one that is empty is not asked.  Any number of times,
/// in the thread that does the work.
using GoesOn = std::function<bool()>;

/// The steps of long work, a few nanoseconds to a microsecond each.
class Steps {
 public:
  explicit Steps(GoesOn goes_on) : goes_on_(std::move(goes_on)) {}

  /// @throws BrokenOff  asked once in 4096 steps
  void step() {
    constexpr std::uint32_t kStepsPerAsking = 4096;
    if (++steps_ % kStepsPerAsking == 0) {
      ask();
    }
  }

  /// @throws BrokenOff
  void ask() const {
    if (goes_on_ && !goes_on_()) {
      throw BrokenOff();
    }
  }

 private:
  GoesOn goes_on_;
  std::uint32_t steps_ = 0;
};

}  // namespace g31::parts

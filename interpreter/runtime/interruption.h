#pragma once

#include <atomic>

namespace g31::runtime {

/// Set from outside, by another thread or a signal handler: work ends at its next look at it.
using Interruption = std::atomic<bool>;
static_assert(Interruption::is_always_lock_free, "a signal handler may set it");

/// @param interruption  nullptr: nobody interrupts
inline bool is_interrupted(const Interruption* interruption) {
  return interruption != nullptr && interruption->load(std::memory_order_relaxed);
}

}  // namespace g31::runtime

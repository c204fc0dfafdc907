#pragma once

#include <functional>
#include <string>

#include "parts/geometry/goes_on.h"

namespace g31::parts {

/// What came of work in another process.
struct WorkApart {
  std::string bytes;  ///< that the work returned
  /// How the process ended before it was done: by which signal, out of time or memory; "": it was.
  std::string why_not;
};

/// A process that works apart gets so much processor time.
inline constexpr int kMostSecondsApart = 300;

/// Does work in a copy of this process, so that a library that breaks off at a file takes nothing
/// else with it.  What it prints is thrown away.  Under the sanitizers, a process with several
/// threads does the work itself.
/// @param goes_on  asked ten times a second
/// @throws BrokenOff  when the process that does the work is killed
WorkApart done_apart(const std::function<std::string()>& work, const GoesOn& goes_on = {});

}  // namespace g31::parts

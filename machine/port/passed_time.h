#pragma once

namespace g31::machine {

/// Whether a moment has come, both in s since the start of the program.  Sums of waiting times that
/// are meant to reach a time reach it: a nanosecond is given.
constexpr bool has_come(double at_s, double now_s) {
  constexpr double kGuard_s = 1e-9;
  return now_s + kGuard_s >= at_s;
}

}  // namespace g31::machine

#pragma once

#include "machine/port/machine_port.h"

namespace g31::runtime {

/// Machine time for a program that does nothing but look at a clock or an input: it waits, and
/// statements take time on a control.  After a hundred looks in which no time has passed each
/// takes a millisecond.
class BusyWait {
 public:
  /// @returns the machine time, s
  double look(machine::MachinePort& port) {
    constexpr int kLooksBeforeWaiting = 100;
    constexpr double kSecondsOfLook = 0.001;
    const double now_s = port.time_s();
    if (now_s != since_s_) {
      since_s_ = now_s;
      looks_ = 0;
    }
    if (++looks_ > kLooksBeforeWaiting) {
      port.dwell(kSecondsOfLook);
      since_s_ = port.time_s();
    }
    return since_s_;
  }

  bool operator==(const BusyWait&) const = default;

 private:
  double since_s_ = -1.0;  ///< machine time of the first look
  int looks_ = 0;
};

}  // namespace g31::runtime

#pragma once

#include "machine/sim/servo_motion.h"
#include "machine/sim/true_position.h"

namespace g31::machine {

/// One motion as it was carried out.
struct ExecutedMotion {
  double start_s = 0.0;     ///< simulated time
  double duration_s = 0.0;  ///< how long it lasted, waiting at its end included
  const ServoMotion& servo;
  const TruePosition& before;  ///< the state of the axes at its beginning
};

/// Hears of all motion in the order of time: moves that pass on into each other once nothing that
/// comes can change them any more.
class MotionListener {
 public:
  MotionListener() = default;
  MotionListener(const MotionListener&) = delete;
  MotionListener& operator=(const MotionListener&) = delete;
  virtual ~MotionListener() = default;

  virtual void on_motion(const ExecutedMotion& motion) = 0;
};

}  // namespace g31::machine

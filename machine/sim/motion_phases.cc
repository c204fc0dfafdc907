#include "machine/sim/motion_phases.h"

#include <algorithm>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

MotionState state_after(const MotionPhase& phase, double t) {
  return {phase.distance_after(t), phase.speed_after(t), phase.acceleration_after(t)};
}

}  // namespace

void MotionPhases::append(double duration_s, double jerk) {
  append(duration_s, end_.acceleration, jerk);
}

void MotionPhases::append(double duration_s, double acceleration, double jerk) {
  G31_EXPECTS(duration_s >= 0.0);
  if (duration_s > 0.0) {
    phases_.push_back({duration_s, jerk, end_.distance, end_.speed, acceleration});
    duration_s_ += duration_s;
    end_ = state_after(phases_.back(), duration_s);
  }
}

MotionPhases MotionPhases::between(double from_s, double to_s) const {
  G31_EXPECTS(from_s >= 0.0 && to_s >= from_s);
  if (from_s == 0.0) {
    MotionPhases begin = *this;
    begin.cut_at(to_s);
    return begin;
  }
  MotionPhases part(MotionState{0.0, at(from_s).speed, 0.0});
  double begin_s = 0.0;
  for (const MotionPhase& phase : phases_) {
    const double first_s = std::max(begin_s, from_s);
    const double last_s = std::min(begin_s + phase.duration_s, to_s);
    if (last_s > first_s) {
      part.append(last_s - first_s, phase.acceleration_after(first_s - begin_s), phase.jerk);
    }
    begin_s += phase.duration_s;
  }
  return part;
}

void MotionPhases::cut_at(double time_s) {
  G31_EXPECTS(time_s >= 0.0);
  while (!phases_.empty() && duration_s_ - phases_.back().duration_s >= time_s) {
    duration_s_ -= phases_.back().duration_s;
    phases_.pop_back();
  }
  if (phases_.empty()) {
    duration_s_ = 0.0;
    end_ = start_;
    return;
  }
  MotionPhase& last = phases_.back();
  if (time_s < duration_s_) {
    last.duration_s -= duration_s_ - time_s;
    duration_s_ = time_s;
  }
  end_ = state_after(last, last.duration_s);
}

MotionState MotionPhases::at(double time_s) const {
  G31_EXPECTS(time_s >= 0.0);
  double begin_s = 0.0;
  for (const MotionPhase& phase : phases_) {
    if (time_s < begin_s + phase.duration_s) {
      return state_after(phase, time_s - begin_s);
    }
    begin_s += phase.duration_s;
  }
  return {end_.distance, 0.0, 0.0};
}

double MotionPhases::time_at(double distance) const {
  G31_EXPECTS(distance >= 0.0);
  double begin_s = 0.0;
  for (const MotionPhase& phase : phases_) {
    if (phase.distance_after(phase.duration_s) >= distance) {
      double low = 0.0;
      double high = phase.duration_s;
      for (double middle = 0.5 * high; low < middle && middle < high; middle = 0.5 * (low + high)) {
        (phase.distance_after(middle) < distance ? low : high) = middle;
      }
      return begin_s + high;
    }
    begin_s += phase.duration_s;
  }
  return duration_s_;
}

}  // namespace g31::machine

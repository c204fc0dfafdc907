#include "machine/sim/motion_sampler.h"

#include <cmath>
#include <vector>

#include "machine/base/contract.h"

namespace g31::machine {

MotionSampler::MotionSampler(double period_s, TraceSink& sink) : period_s_(period_s), sink_(sink) {
  G31_EXPECTS(period_s > 0.0 && std::isfinite(period_s));
}

void MotionSampler::show(const ExecutedMotion& motion, const AxisPositions& resolution) {
  const double end_s = motion.start_s + motion.duration_s;
  TruePosition truth = motion.before;
  std::vector<double> steps;
  if (truth.has_play()) {
    steps = motion.servo.steps_until(motion.duration_s);
  }
  std::size_t step = 0;
  const auto sample_at = [&](double time_s) {
    TraceSample sample;
    sample.time_s = time_s;
    const double after_s = std::max(0.0, time_s - motion.start_s);
    for (; step < steps.size() && steps[step] <= after_s; ++step) {
      truth.go_to(motion.servo.encoder_at(steps[step]));
    }
    const AxisPositions q_M_encoder = motion.servo.encoder_at(after_s);
    sample.q_M_commanded = motion.servo.commanded_at(after_s);
    sample.q_M_encoder = in_steps(q_M_encoder, resolution);
    sample.q_M_true = truth.after(q_M_encoder);
    return sample;
  };
  last_.reset();
  double last_s = static_cast<double>(next_) * period_s_ - period_s_;
  for (; static_cast<double>(next_) * period_s_ <= end_s; ++next_) {
    motion.servo.look();
    last_s = static_cast<double>(next_) * period_s_;
    sink_.on_sample(sample_at(last_s));
  }
  constexpr double kLeastGapS = 1e-6;  // the rounding of positions would be speeds in less
  if (end_s - last_s > kLeastGapS) {
    last_ = sample_at(end_s);
  }
}

void MotionSampler::end() {
  if (last_) {
    sink_.on_end(*last_);
    last_.reset();
  }
}

AxisPositions in_steps(const AxisPositions& q_M, const AxisPositions& resolution) {
  AxisPositions stepped = q_M;
  for (Eigen::Index i = 0; i < stepped.size(); ++i) {
    if (resolution[i] > 0.0) {
      stepped[i] = resolution[i] * std::round(stepped[i] / resolution[i]);
    }
  }
  return stepped;
}

}  // namespace g31::machine

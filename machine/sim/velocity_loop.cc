#include "machine/sim/velocity_loop.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

/// Slower and nearer than this an axis is at rest, mm or deg, s.
constexpr double kRestSpeed = 1e-6;
constexpr double kRestWay = 1e-8;
constexpr double kRestAcceleration = 1e-2;
/// Nothing that a control waits for takes longer.
constexpr double kLongestRestS = 60.0;
/// Of commands with more steps than this not all are kept.
constexpr std::int64_t kMostKeptSteps = 100'000;
constexpr std::int64_t kStepsOfStretch = 4096;

/// Friction runs towards a value, exponentially.
struct Rates {
  double speed, acceleration, missing, friction_aim, friction_per_s;
};

struct Command {
  double place, speed;
};

Command value_of(const CommandCubic& cubic, double t) {
  return {cubic[0] + t * (cubic[1] + t * (cubic[2] + t * cubic[3])),
          cubic[1] + t * (2.0 * cubic[2] + t * 3.0 * cubic[3])};
}

Rates rates(const LoopMotion::Setup& setup, const LoopSample& now, const Command& command) {
  const VelocityLoopSetup& loop = setup.loop;
  const VelocityLoopState& s = now.state;
  const double missing = setup.position_gain_per_s * (command.place - now.position) +
                         setup.feed_forward * command.speed - s.speed;
  const double drive = loop.gain_per_s * (missing + s.integral / loop.reset_s);
  const double opposed = s.speed < 0.0 ? -loop.friction_per_s2 : loop.friction_per_s2;
  return {s.speed, drive - s.friction, missing, opposed, std::abs(s.speed) / loop.friction_way};
}

bool rests(const LoopMotion::Setup& setup, const LoopSample& now, double command) {
  return std::abs(now.state.speed) < kRestSpeed && std::abs(now.position - command) < kRestWay &&
         std::abs(rates(setup, now, {command, 0.0}).acceleration) < kRestAcceleration;
}

LoopSample after(const LoopSample& now, const Rates& by, double h) {
  return {now.time_s + h,
          now.position + h * by.speed,
          {now.state.speed + h * by.acceleration, now.state.integral + h * by.missing,
           by.friction_aim +
               (now.state.friction - by.friction_aim) * std::exp(-h * by.friction_per_s)}};
}

double between(double from, double to, double share) {
  return from + share * (to - from);
}

/// The cubic through both positions with their speeds; the rest straight.
LoopSample between(const LoopSample& from, const LoopSample& to, double time_s) {
  const double h = to.time_s - from.time_s;
  const double u = (time_s - from.time_s) / h;
  const double way = to.position - from.position;
  const double v_from = h * from.state.speed;
  const double v_to = h * to.state.speed;
  return {time_s,
          from.position + u * (v_from + u * (3.0 * way - 2.0 * v_from - v_to +
                                             u * (v_from + v_to - 2.0 * way))),
          {between(from.state.speed, to.state.speed, u),
           between(from.state.integral, to.state.integral, u),
           between(from.state.friction, to.state.friction, u)}};
}

/// What one step of the midpoint rule makes of position, speed and integral, without friction and
/// with a command that rests at 0.
Eigen::Matrix3d step_matrix(const LoopMotion::Setup& setup) {
  const double p = setup.position_gain_per_s;
  const double w = setup.loop.gain_per_s;
  Eigen::Matrix3d rate;
  rate << 0.0, 1.0, 0.0,                   //
      -w * p, -w, w / setup.loop.reset_s,  //
      -p, -1.0, 0.0;
  const Eigen::Matrix3d way = kLoopStepS * rate;
  return Eigen::Matrix3d::Identity() + way + 0.5 * way * way;
}

}  // namespace

bool settles(const LoopMotion::Setup& setup) {
  constexpr int kDoublings = 40;  // of the time: longer than any motion
  constexpr double kSmall = 1e-3;
  Eigen::Matrix3d after = step_matrix(setup);
  for (int i = 0; i < kDoublings && after.norm() > kSmall && after.allFinite(); ++i) {
    after = (after * after).eval();
  }
  return after.norm() <= kSmall;
}

LoopMotion::LoopMotion(const Setup& setup, double position, const VelocityLoopState& state)
    : setup_(setup), rest_(position), samples_{{0.0, position, state}} {
  G31_EXPECTS(setup.loop.is_there() && setup.loop.reset_s > 0.0 && setup.loop.friction_way > 0.0);
  G31_EXPECTS(setup.position_gain_per_s > 0.0);
}

LoopSample LoopMotion::stepped(const LoopSample& now, const CommandCubic& command, double t,
                               double h) const {
  if (setup_.watch != nullptr) {
    setup_.watch->look();
  }
  const LoopSample middle = after(now, rates(setup_, now, value_of(command, t)), 0.5 * h);
  return after(now, rates(setup_, middle, value_of(command, t + 0.5 * h)), h);
}

void LoopMotion::step(const CommandCubic& command, double t, double h) const {
  samples_.push_back(stepped(samples_.back(), command, t, h));
}

void LoopMotion::step_in_stretches(const CommandCubic& command, std::int64_t steps, double h) {
  for (std::int64_t first = 0; first < steps; first += kStepsOfStretch) {
    Stretch stretch{
        samples_.back(), 0.0, command, first, std::min(kStepsOfStretch, steps - first), h};
    LoopSample now = stretch.start;
    for (std::int64_t i = first; i < first + stretch.steps; ++i) {
      now = stepped(now, command, static_cast<double>(i) * h, h);
    }
    samples_.push_back(now);
    stretch.end_s = now.time_s;
    stretches_.push_back(stretch);
  }
}

const std::vector<LoopSample>& LoopMotion::samples_from(double begin_s) const {
  const auto of_start = [](const Stretch& stretch) { return stretch.start.time_s; };
  const auto stretch = std::ranges::lower_bound(stretches_, begin_s, {}, of_start);
  if (stretch == stretches_.end() || stretch->start.time_s != begin_s) {
    return samples_;
  }
  if (in_stretch_.empty() || in_stretch_.front().time_s != begin_s) {
    in_stretch_.assign(1, stretch->start);
    for (std::int64_t i = stretch->first; i < stretch->first + stretch->steps; ++i) {
      in_stretch_.push_back(stepped(in_stretch_.back(), stretch->command,
                                    static_cast<double>(i) * stretch->h, stretch->h));
    }
    in_stretch_.back().time_s = stretch->end_s;
  }
  return in_stretch_;
}

void LoopMotion::follow(const CommandCubic& command, double duration_s) {
  while (samples_.back().time_s > command_end_s_) {
    samples_.pop_back();  // how it would have come to rest
  }
  is_at_rest_ = false;
  if (command[1] == 0.0 && command[2] == 0.0 && command[3] == 0.0 &&
      rests(setup_, samples_.back(), command[0])) {
    command_end_s_ += duration_s;
    samples_.push_back(samples_.back());
    samples_.back().time_s = command_end_s_;
    return;
  }
  const auto steps = static_cast<std::int64_t>(std::ceil(duration_s / kLoopStepS));
  const double h = duration_s / static_cast<double>(steps);
  command_end_s_ += duration_s;
  if (steps > kMostKeptSteps) {
    step_in_stretches(command, steps, h);
    stretches_.back().end_s = command_end_s_;
  } else {
    for (std::int64_t i = 0; i < steps; ++i) {
      step(command, static_cast<double>(i) * h, h);
    }
  }
  samples_.back().time_s = command_end_s_;
  rest_ = value_of(command, duration_s).place;
}

void LoopMotion::rest_until(double time_s) const {
  while (!is_at_rest_ && samples_.back().time_s < time_s) {
    step({rest_, 0.0, 0.0, 0.0}, 0.0, kLoopStepS);
    const LoopSample& now = samples_.back();
    is_at_rest_ = rests(setup_, now, rest_) || now.time_s > command_end_s_ + kLongestRestS;
  }
}

LoopSample LoopMotion::at(double time_s) const {
  G31_EXPECTS(time_s >= 0.0);
  rest_until(time_s);
  if (time_s >= samples_.back().time_s) {
    return samples_.back();
  }
  const auto kept = std::ranges::upper_bound(samples_, time_s, {}, &LoopSample::time_s);
  const auto& samples = samples_from((kept - 1)->time_s);
  const auto to = std::ranges::upper_bound(samples, time_s, {}, &LoopSample::time_s);
  return between(*(to - 1), *to, time_s);
}

double LoopMotion::within_s(double width) const {
  G31_EXPECTS(width > 0.0);
  double time_s = command_end_s_;
  while (std::abs(at(time_s).position - rest_) > width && !is_at_rest_) {
    time_s += kLoopStepS;
  }
  return time_s;
}

}  // namespace g31::machine

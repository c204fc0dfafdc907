#include "machine/sim/real_axes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/base/contract.h"
#include "machine/sim/true_way.h"

namespace g31::machine {
namespace {

ServoLoops loops_of(const MachineSetup& setup) {
  ServoLoops loops;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const AxisSetup& axis = setup.axes[i];
    const auto row = static_cast<Eigen::Index>(i);
    G31_EXPECTS(axis.servo_gain >= 0.0);
    G31_EXPECTS(axis.feed_forward >= 0.0 && axis.feed_forward <= 1.0);
    if (axis.servo_gain > 0.0) {
      loops.time_constants_s[row] = kSecondsAtGainOne / axis.servo_gain;
      loops.velocity[i] = axis.velocity_loop;
    }
    loops.feed_forward[row] = axis.feed_forward;
  }
  return loops;
}

ServoLoops without_feed_forward(ServoLoops loops) {
  loops.feed_forward.setZero();
  return loops;
}

}  // namespace

RealAxes::RealAxes(const MachineSetup& setup)
    : truth_(setup),
      loops_(without_feed_forward(loops_of(setup))),
      loops_ahead_(loops_of(setup)),
      stop_fine_(AxisPositions::Constant(setup.in_position)),
      stop_coarse_(kCoarsePerFine * stop_fine_),
      lags_(!loops_.time_constants_s.isZero(0.0)),
      is_ideal_(truth_.is_ideal() && !truth_.chain().has_rotary_axes() && !lags_),
      follows_at_once_(!lags_ && !truth_.has_play()) {
  G31_EXPECTS(setup.in_position > 0.0);
}

void RealAxes::take(const AxisData& data) {
  G31_EXPECTS((data.stop_fine.array() > 0.0).all() && (data.stop_coarse.array() > 0.0).all());
  stop_fine_ = data.stop_fine;
  stop_coarse_ = data.stop_coarse;
  G31_EXPECTS((data.filter_s.array() >= 0.0).all() && data.filter_s.allFinite());
  filter_ = CommandFilter(data.feed_filter, data.filter_s);
  look_whether_ideal();
}

void RealAxes::correct_by(AxisCorrections corrections, const AxisPositions& q_M) {
  truth_.correct_by(std::move(corrections), q_M);
  look_whether_ideal();
}

void RealAxes::look_whether_ideal() {
  is_ideal_ = truth_.is_ideal() && !truth_.chain().has_rotary_axes() && !lag();
  follows_at_once_ = !lag() && !truth_.has_play();
}

ServoMotion RealAxes::motion(const CommandedPath& path, const MotionPhases& phases,
                             ContourControl contour_control) const {
  return ServoMotion(path, phases, state_,
                     contour_control == ContourControl::FeedForward ? loops_ahead_ : loops_);
}

ServoMotion RealAxes::smoothed_motion(const CommandedPath& path, const MotionPhases& phases,
                                      bool comes_to_rest) const {
  ServoState state = state_;
  if (!state.filter.is_there()) {
    state.filter = filter_;
  }
  if (!state.filter.is_there()) {
    return motion(path, phases);
  }
  ServoLoops loops = loops_;
  loops.smoothing = comes_to_rest ? Smoothing::ToRest : Smoothing::On;
  return ServoMotion(path, phases, state, loops);
}

double RealAxes::done_s(const ServoMotion& motion, BlockEnd end) const {
  switch (end) {
    case BlockEnd::ExactStop:
      return motion.in_position_s(stop_fine_);
    case BlockEnd::CoarseStop:
      return motion.in_position_s(stop_coarse_);
    case BlockEnd::CommandStop:
    case BlockEnd::PassOn:
      break;
  }
  return motion.duration_s();
}

std::optional<Timed<SkipTrigger>> RealAxes::first_signal(const ServoMotion& motion,
                                                         const Listening& to,
                                                         Surroundings& world) const {
  const double until_s = done_s(motion, BlockEnd::ExactStop);
  const TrueWay way(truth_, motion, until_s, {kTouchWayErrorMm, world.tool_extent().signal_mm});
  Listening timed_to = to;
  timed_to.time_s_at = [&way](double fraction) { return way.time_s(std::min(1.0, fraction)); };
  if (truth_.chain().has_rotary_axes()) {
    timed_to.axes_at = [&way](double fraction) { return way.axes_at(std::min(1.0, fraction)); };
  }
  auto trigger = world.first_signal(Way(way.points()), timed_to);
  if (!trigger) {
    return std::nullopt;
  }
  Timed<SkipTrigger> timed{*std::move(trigger), 0.0};
  timed.time_s = way.time_s(timed.event.fraction);
  if (timed.event.contact) {
    timed.event.contact = in_machine(motion.encoder_at(timed.time_s), *timed.event.contact);
  }
  return timed;
}

Listening RealAxes::listening_at(const AxisPositions& q_M, int input) const {
  Listening to{input};
  if (truth_.chain().has_rotary_axes()) {
    to.axes_at = [q_M_true = truth_.after(q_M)](double /*fraction*/) { return q_M_true; };
  }
  return to;
}

std::optional<Timed<Obstacle>> RealAxes::first_obstacle(const ServoMotion& motion, Travel travel,
                                                        double until_s, Surroundings& world) const {
  const TrueWay way(truth_, motion, until_s, {kMoveWayErrorMm, world.tool_extent().body_mm});
  auto obstacle = world.first_obstacle(Way(way.points()), travel);
  if (!obstacle) {
    return std::nullopt;
  }
  Timed<Obstacle> timed{*std::move(obstacle), 0.0};
  timed.time_s = way.time_s(timed.event.fraction);
  timed.event.contact = in_machine(motion.encoder_at(timed.time_s), timed.event.contact);
  return timed;
}

Waypoint RealAxes::tip(const AxisPositions& q_M) const {
  if (is_ideal_) {
    return {0.0, q_M};
  }
  const ToolPlace place = truth_.place_after(q_M);
  return {0.0, place.q, place.tilt, place.lean_rad};
}

Waypoint RealAxes::place_of(const Point& p_T, const AxisPositions& q_M) const {
  RealAxes with_tip_there = *this;
  with_tip_there.take_tool(p_T);
  return with_tip_there.tip(q_M);
}

std::vector<Waypoint> RealAxes::way_taken(const Waypoint& tip_from, const Encoders& went) const {
  const double turned_deg = rotary_axes(went(1.0) - went(0.0)).cwiseAbs().maxCoeff();
  const int pieces = truth_.chain().has_rotary_axes()
                         ? std::max(1, static_cast<int>(std::ceil(turned_deg / kSkipTurnDeg)))
                         : 1;
  std::vector<Waypoint> way = {tip_from};
  for (int i = 1; i <= pieces; ++i) {
    const double fraction = static_cast<double>(i) / pieces;
    way.push_back(tip(went(fraction)));
    way.back().fraction = fraction;
  }
  return way;
}

Contact RealAxes::in_machine(const AxisPositions& q_M, const Contact& of_part) const {
  if (is_ideal_ || !truth_.chain().is_turned(q_M)) {
    return of_part;
  }
  const Eigen::Isometry3d machine_from_part = truth_.chain().part_from_machine(q_M).inverse();
  return {machine_from_part * of_part.p_M_point, machine_from_part.linear() * of_part.n_M,
          of_part.part, machine_from_part.linear() * of_part.n_M_smooth};
}

void RealAxes::follow(const ServoMotion& motion, double until_s) {
  if (truth_.has_play()) {
    for (const double step_s : motion.steps_until(until_s)) {
      truth_.go_to(motion.encoder_at(step_s));
    }
  }
  state_ = motion.state_at(until_s);
}

void RealAxes::take_tool(const Point& p_T_tip) {
  truth_.take_tool(p_T_tip);
}

void RealAxes::stop_at(const AxisPositions& q_M) {
  truth_.go_to(q_M);
  state_ = {};
}

}  // namespace g31::machine

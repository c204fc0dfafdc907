#include "machine/sim/machining_centre.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "machine/base/contract.h"
#include "machine/sim/arc_path.h"
#include "machine/sim/independent_path.h"
#include "machine/sim/motion_profile.h"
#include "machine/sim/straight_path.h"

namespace g31::machine {
namespace {

AxisPositions resolutions(const MachineSetup& setup) {
  AxisPositions steps;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    steps[static_cast<Eigen::Index>(i)] = setup.axes[i].scale_resolution;
  }
  return steps;
}

/// The way from start to end of an arc without it.
LinearMove straight(const ArcMove& arc) {
  LinearMove move{arc.q_M_end, Traverse::Feed, arc.feed_mm_min, arc.ends};
  move.contour_control = arc.contour_control;
  move.tag = arc.tag;
  move.transform = arc.transform;
  move.smoothness = arc.smoothness;
  return move;
}

/// Whether the whole circle of an arc lies within all travel: quicker to know than where it ends.
bool contain_circle(const TravelLimits& limits, const ArcPath& path) {
  const double reach = path.largest_radius();
  return limits.contain(path.from()) && limits.contain(path.to()) &&
         limits.contain(path.first_axis(), path.centre_first(), reach) &&
         limits.contain(path.second_axis(), path.centre_second(), reach);
}

}  // namespace

[[gnu::hot]] void MachiningCentre::expect_legal(const LinearMove& move) {
  G31_EXPECTS(all_finite(move.q_M_end));
  G31_EXPECTS(move.traverse == Traverse::Rapid ||
              (move.feed_mm_min > 0.0 && std::isfinite(move.feed_mm_min)));
}

[[gnu::hot]] void MachiningCentre::expect_legal(const ArcMove& arc) {
  G31_EXPECTS(all_finite(arc.q_M_end));
  G31_EXPECTS(std::isfinite(arc.centre_first) && std::isfinite(arc.centre_second));
  G31_EXPECTS(arc.feed_mm_min > 0.0 && std::isfinite(arc.feed_mm_min));
}

bool MachiningCentre::is_fraction(double number) {
  return number >= 0.0 && number <= 1.0;
}

MachiningCentre::MachiningCentre(const MachineSetup& setup, Surroundings* surroundings)
    : limits_(setup),
      dynamics_(setup),
      stopping_(setup.stopping),
      stop_delay_s_(setup.stop_delay_s),
      wires_(setup.wires),
      surroundings_(surroundings),
      q_M_(setup.q_M_start),
      resolution_(resolutions(setup)),
      real_(setup) {
  G31_EXPECTS(all_finite(q_M_));
  axis_data_.stop_fine = AxisPositions::Constant(setup.in_position);
  axis_data_.stop_coarse = kCoarsePerFine * axis_data_.stop_fine;
  axis_data_.jerk_per_s3 = dynamics_.jerks();
  axis_data_.travel_min = limits_.lower();
  axis_data_.travel_max = limits_.upper();
  keep_what_follows();
}

[[gnu::hot]] Result<AxisPositions, MachineFault> MachiningCentre::move(const LinearMove& move) {
  expect_legal(move);
  if (!limits_.contain(move.q_M_end)) {
    return soft_limit_fault(move.q_M_end);
  }
  if (const auto led = led_path(q_M_, move)) {
    return move_led(*led, move);
  }
  const StraightPath path(q_M_, move.q_M_end, move.mm_per_degree);
  if (path.moves()) {
    const Passing passing{move.ends, move.contour_control, move.tag,
                          move.smoothness.corner_tolerance};
    if (auto fault = move.traverse == Traverse::Feed || passes_on(move)
                         ? feed(path, dynamics_.limits(path, move), passing)
                         : carry_out(path, move)) {
      return *std::move(fault);
    }
  }
  arrive(move.q_M_end, move.tag);
  return q_M_;
}

/// A rapid passes on where the control plans it ahead, as one of the moves of a path.
bool MachiningCentre::passes_on(const LinearMove& rapid) const {
  return rapid.ends == BlockEnd::PassOn && rapid.rapid_path == RapidPath::Straight &&
         joins({rapid.ends, rapid.contour_control, rapid.tag});
}

MaybeFault MachiningCentre::fault_on(const LedPath& path) const {
  if (!path.leads()) {
    return MachineFault{FaultKind::SoftLimit,
                        "the linear axes do not lead along the way as the rotary axes turn", q_M_,
                        std::nullopt};
  }
  const int pieces = path.piece_count();
  for (int i = 1; i <= pieces; ++i) {
    const AxisPositions q_M = path.at(static_cast<double>(i) / pieces);
    if (!limits_.contain(q_M)) {
      return soft_limit_fault(q_M);
    }
  }
  return std::nullopt;
}

Result<AxisPositions, MachineFault> MachiningCentre::move_led(const LedPath& path,
                                                              const LinearMove& move) {
  if (auto fault = fault_on(path)) {
    return *std::move(fault);
  }
  const PathLimits limits = dynamics_.limits(path, move);
  const Travel travel = move.traverse == Traverse::Rapid ? Travel::Rapid : Travel::Feed;
  auto fault =
      travel == Travel::Feed
          ? feed(path, limits, {move.ends, move.contour_control, move.tag})
          : carry_out(path,
                      MotionProfile(path.length(), limits.speed, limits.acceleration, limits.jerk),
                      {travel, move.ends});
  if (fault) {
    return *std::move(fault);
  }
  arrive(move.q_M_end, move.tag);
  return q_M_;
}

[[gnu::hot]] Result<AxisPositions, MachineFault> MachiningCentre::move(const ArcMove& arc) {
  expect_legal(arc);
  if (const auto led = led_path(q_M_, arc)) {
    return led->length() < kFullCircleGapMm ? move(straight(arc)) : move_led(*led, straight(arc));
  }
  const ArcPath path(q_M_, arc);
  if (path.length() < kFullCircleGapMm) {
    return move(straight(arc));
  }
  if (!contain_circle(limits_, path)) {
    const AxisBox box = path.bounds();
    for (const AxisPositions& q_M_corner : {box.q_M_min, box.q_M_max}) {
      if (!limits_.contain(q_M_corner)) {
        return soft_limit_fault(q_M_corner);
      }
    }
  }
  const PathLimits limits =
      dynamics_.limits(path, arc.feed_mm_min, arc.contour_control, arc.smoothness);
  if (auto fault =
          feed(path, limits,
               {arc.ends, arc.contour_control, arc.tag, arc.smoothness.corner_tolerance})) {
    return *std::move(fault);
  }
  arrive(arc.q_M_end, arc.tag);
  return q_M_;
}

bool MachiningCentre::skip_signal(int input) const {
  tell_time();
  return surroundings_ != nullptr &&
         surroundings_->signals_at(real_.tip(q_M_), real_.listening_at(q_M_, input));
}

std::string MachiningCentre::stands_inside() const {
  return surroundings_ != nullptr ? surroundings_->stands_inside(real_.tip(q_M_)) : std::string();
}

std::optional<SensorState> MachiningCentre::sensor_state(int input) const {
  tell_time();
  return surroundings_ != nullptr ? surroundings_->sensor_state(input) : std::nullopt;
}

std::optional<bool> MachiningCentre::digital_input(int number) const {
  const auto wire = std::ranges::find(wires_, number, &InputWire::number);
  if (wire == wires_.end()) {
    return std::nullopt;
  }
  if (wire->source == InputWire::Source::Signal) {
    return skip_signal(wire->measuring_input);
  }
  const auto state = sensor_state(wire->measuring_input);
  return state && state->is_ready();
}

std::optional<double> MachiningCentre::displacement(int input) const {
  const auto p_T =
      surroundings_ != nullptr ? surroundings_->displacement_sensor(input) : std::optional<Point>();
  if (!p_T) {
    return std::nullopt;
  }
  tell_time();
  return surroundings_->displacement(real_.place_of(*p_T, q_M_), input);
}

void MachiningCentre::change_tool(const ToolChange& change) {
  G31_EXPECTS(change.tool.number >= 0 && std::isfinite(change.tool.length_mm));
  tell(change);
}

void MachiningCentre::turn_spindle(const SpindleTurn& turn) {
  G31_EXPECTS(turn.speed_rev_min >= 0.0);
  G31_EXPECTS(!turn.angle_deg ||
              (std::isfinite(*turn.angle_deg) && turn.rotation == Rotation::Stopped));
  tell(turn);
}

void MachiningCentre::auxiliary_code(const AuxiliaryCode& code) {
  tell(code);
}

void MachiningCentre::digital_output(const DigitalOutput& output) {
  tell(output);
}

void MachiningCentre::tell_time() const {
  if (surroundings_ != nullptr) {
    told_s_ = std::max(told_s_, time_s());
    surroundings_->time_is(told_s_);
  }
}

void MachiningCentre::tell(const MachineEvent& event) {
  stand_still();
  if (surroundings_ == nullptr || late_) {
    return;
  }
  tell_time();
  surroundings_->take(event);
  if (const auto p_T_tip = surroundings_->tool_extent().p_T_tip) {
    real_.take_tool(*p_T_tip);
  }
}

void MachiningCentre::dwell(double seconds) {
  G31_EXPECTS(seconds >= 0.0 && std::isfinite(seconds));
  stand_still();
  if (late_) {
    return;
  }
  if (!real_.are_ideal()) {
    find_late(wait_really(seconds));
    return;
  }
  if (is_watched()) {
    show(StraightPath(q_M_, q_M_), {}, seconds);
  }
  clock_.advance(seconds);
}

void MachiningCentre::keep_what_follows() {
  if (!real_.follow_at_once()) {
    continuous_.keep_few_ways();
  }
}

void MachiningCentre::set_axis_data(const AxisData& data) {
  dynamics_.set_jerks(data.jerk_per_s3);
  dynamics_.set_corner_jumps(data.corner_jump_per_s);
  limits_.set(data.travel_min, data.travel_max);
  if (data.feed_filter != axis_data_.feed_filter || data.filter_s != axis_data_.filter_s) {
    stand_still();
    real_.take(data);
    keep_what_follows();
  }
  axis_data_ = data;
  real_.take(data);
}

void MachiningCentre::compensate(const std::vector<CompensationTable>& tables) {
  stand_still();
  if (!late_) {
    real_.correct_by(AxisCorrections(tables), q_M_);
    keep_what_follows();
  }
}

void MachiningCentre::trace(double period_s, TraceSink& sink) {
  continuous_.keep_ways();
  sampler_.emplace(period_s, sink);
}

void MachiningCentre::end_trace() {
  if (sampler_) {
    sampler_->end();
  }
}

void MachiningCentre::tell_motions_to(MotionListener& listener) {
  continuous_.keep_ways();
  listener_ = &listener;
}

MachineFault MachiningCentre::soft_limit_fault(const AxisPositions& q_M_end) const {
  const FaultKind kind =
      limits_.is_without_axis(q_M_end) ? FaultKind::NoAxis : FaultKind::SoftLimit;
  return {kind, limits_.violation(q_M_end), q_M_, std::nullopt};
}

MachineFault MachiningCentre::stop_at(Obstacle obstacle, const AxisPositions& q_M_stop,
                                      double seconds) {
  clock_.advance(seconds);
  q_M_ = q_M_stop;
  return {FaultKind::Collision, std::move(obstacle.what), q_M_, std::move(obstacle.contact)};
}

std::optional<Obstacle> MachiningCentre::obstacle_on(const StraightPath& path, Travel travel) {
  const Waypoint ends[] = {{0.0, path.from()}, {1.0, path.to()}};
  auto obstacle = surroundings_->first_obstacle(Way(ends), travel);
  G31_EXPECTS(!obstacle || is_fraction(obstacle->fraction));
  return obstacle;
}

template <typename Curve>
std::optional<Obstacle> MachiningCentre::obstacle_on(const Curve& path, Travel travel) {
  const auto place = [&](double fraction) {
    real_.look();  // a slow curve beside a part is halved very often
    return path.at(fraction);
  };
  const CurvedWay curve{place, path.bend(), path.chord_count()};
  auto obstacle = surroundings_->first_obstacle(Way(curve), travel);
  G31_EXPECTS(!obstacle || is_fraction(obstacle->fraction));
  return obstacle;
}
template std::optional<Obstacle> MachiningCentre::obstacle_on(const ArcPath&, Travel);

MaybeFault MachiningCentre::carry_out(const StraightPath& path, const LinearMove& move) {
  const Travel travel = move.traverse == Traverse::Rapid ? Travel::Rapid : Travel::Feed;
  const Carriage how{travel, move.ends};
  if (const auto independent = dynamics_.independent_path(path, move)) {
    return carry_out(*independent, PassingTime(*independent), how);
  }
  return carry_out(path, dynamics_.profile(path, move), how);
}

template <typename Path, typename Profile>
MaybeFault MachiningCentre::carry_out(const Path& path, const Profile& profile,
                                      const Carriage& how) {
  stand_still();
  if (late_) {
    return take_late_fault();
  }
  if constexpr (std::is_same_v<Path, LedPath>) {
    return carry_out_really(real_.motion(path, profile.phases(), how.contour_control), how);
  } else {
    return real_.are_ideal()
               ? carry_out_ideally(path, profile, how)
               : carry_out_really(real_.motion(path, profile.phases(), how.contour_control), how);
  }
}

template <typename Path, typename Profile>
MaybeFault MachiningCentre::carry_out_ideally(const Path& path, const Profile& profile,
                                              const Carriage& how) {
  if (surroundings_ != nullptr) {
    auto obstacle = obstacle_on(path, how.travel);
    if (obstacle) {
      const double seconds = profile.time_at(obstacle->fraction * profile.length());
      if (is_watched()) {
        MotionPhases phases = profile.phases();
        phases.cut_at(seconds);
        show(path, phases, seconds);
      }
      const AxisPositions q_M_stop = path.at(obstacle->fraction);
      return stop_at(*std::move(obstacle), q_M_stop, seconds);
    }
  }
  if (is_watched()) {
    show(path, profile.phases(), profile.duration_s());
  }
  clock_.advance(profile.duration_s());
  return std::nullopt;
}

template MaybeFault MachiningCentre::carry_out(const StraightPath&, const MotionProfile&,
                                               const Carriage&);
template MaybeFault MachiningCentre::carry_out(const ArcPath&, const MotionProfile&,
                                               const Carriage&);
template MaybeFault MachiningCentre::carry_out(const LedPath&, const MotionProfile&,
                                               const Carriage&);

MaybeFault MachiningCentre::carry_out_really(const ServoMotion& motion, const Carriage& how) {
  if (surroundings_ != nullptr) {
    auto obstacle = real_.first_obstacle(motion, how, *surroundings_);
    if (obstacle) {
      return break_off(motion, *std::move(obstacle));
    }
  }
  follow(motion, real_.done_s(motion, how.ends));
  return std::nullopt;
}

MaybeFault MachiningCentre::break_off(const ServoMotion& motion, Timed<Obstacle> obstacle) {
  const AxisPositions q_M_stop = motion.encoder_at(obstacle.time_s);
  follow(motion, obstacle.time_s);
  real_.stop_at(q_M_stop);
  return stop_at(std::move(obstacle.event), q_M_stop, 0.0);
}

MaybeFault MachiningCentre::wait_really(double seconds) {
  const ServoMotion motion = real_.motion(StraightPath(q_M_, q_M_), {});
  const double moves_s = std::min(seconds, RealAxes::rests_s(motion));
  if (surroundings_ != nullptr && moves_s > 0.0) {
    if (auto obstacle = real_.first_obstacle(motion, Travel::Feed, moves_s, *surroundings_)) {
      return break_off(motion, *std::move(obstacle));
    }
  }
  follow(motion, seconds);
  return std::nullopt;
}

void MachiningCentre::show(const ExecutedMotion& motion) {
  if (sampler_) {
    sampler_->show(motion, resolution_);
  }
  if (listener_ != nullptr) {
    listener_->on_motion(motion);
  }
}

void MachiningCentre::show(const CommandedPath& path, const MotionPhases& phases,
                           double duration_s) {
  show({clock_.now_s(), duration_s, real_.motion(path, phases), real_.truth()});
}

void MachiningCentre::follow(const ServoMotion& motion, double duration_s) {
  show({clock_.now_s(), duration_s, motion, real_.truth()});
  real_.follow(motion, duration_s);
  clock_.advance(duration_s);
}

}  // namespace g31::machine

#include "tools/picture/way_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "parts/geometry/placement.h"
#include "probe/tooling/spindle.h"
#include "tools/picture/on_part.h"
#include "tools/picture/stylus_shape.h"
#include "tools/picture/tip.h"

namespace g31::picture {
namespace {

/// A chord: two points, as many bytes as the two forms of a scene and memory take.
constexpr std::uint64_t kChordBytes = 128;
/// A knot of the track: seven numbers, of which a page has most many times and packs them.
constexpr std::uint64_t kKnotBytes = 32;
/// A mark has names and a place in lists.
constexpr std::uint64_t kMarkBytes = 256;

/// No chord is of more: of an arc, of a rotary axis.
constexpr double kChordDeg = 5.0;

const std::optional<machine::Contact>& contact_of(const machine::SkipOutcome& outcome) {
  static const std::optional<machine::Contact> kNone;
  if (const auto* touched = std::get_if<machine::Touched>(&outcome)) {
    return touched->contact;
  }
  const auto* already = std::get_if<machine::NoEdge>(&outcome);
  return already != nullptr ? already->contact : kNone;
}

/// Into how many chords of kChordDeg rotary axes turn.
int turning_chords(const AxisPositions& q_M_from, const AxisPositions& q_M_to) {
  const double turned_deg =
      (q_M_to - q_M_from).segment<kRotaryAxisCount>(kLinearAxisCount).cwiseAbs().maxCoeff();
  return 1 + static_cast<int>(turned_deg / kChordDeg);
}

}  // namespace

WayRecorder::WayRecorder(machine::MachinePort& machine, const machine::MachineSetup& setup,
                         const Point& p_S_tip, runtime::OutputBudget& budget)
    : ForwardingMachine(machine),
      dynamics_(setup),
      p_S_tip_(p_S_tip),
      chain_(setup.chain, p_S_tip),
      budget_(budget) {}

WayRecorder::WayRecorder(machine::MachinePort& machine, const setup::Job& job,
                         runtime::OutputBudget& budget)
    : WayRecorder(machine, job.machine, tip_of(job), budget) {
  job_ = &job;
}

Result<AxisPositions, machine::MachineFault> WayRecorder::move(const machine::LinearMove& move) {
  const Beginning from = beginning();
  auto outcome = machine_.move(move);
  const PathKind kind =
      move.traverse == machine::Traverse::Rapid ? PathKind::Rapid : PathKind::Feed;
  const auto led = machine::led_path(from.q_M, move);
  const auto independent =
      led ? std::nullopt
          : dynamics_.independent_path(machine::StraightPath(from.q_M, move.q_M_end), move);
  if (led && machine_.position() != from.q_M) {
    keep_curve(kind, from, *led, turning_chords(from.q_M, move.q_M_end));
  } else if (independent && machine_.position() != from.q_M) {
    constexpr int kRapidChords = 48;
    keep_curve(kind, from, *independent, kRapidChords);
  } else {
    keep(kind, from);
  }
  if (!outcome) {
    mark(outcome.error());
  }
  return outcome;
}

Result<AxisPositions, machine::MachineFault> WayRecorder::move(const machine::ArcMove& arc) {
  const Beginning from = beginning();
  auto outcome = machine_.move(arc);
  if (machine_.position() != from.q_M || outcome) {
    constexpr double kChordRad = kChordDeg * std::numbers::pi / 180.0;
    if (const auto led = machine::led_path(from.q_M, arc)) {
      keep_curve(PathKind::Feed, from, *led, 2 * led->piece_count());
    } else {
      const machine::ArcPath path(from.q_M, arc);
      keep_curve(PathKind::Feed, from, path,
                 1 + static_cast<int>(std::fabs(path.turned_rad()) / kChordRad));
    }
  }
  if (!outcome) {
    mark(outcome.error());
  }
  return outcome;
}

Result<machine::SkipOutcome, machine::MachineFault> WayRecorder::move_until_skip(
    const machine::SkipMove& move) {
  const Beginning from = beginning();
  auto outcome = machine_.move_until_skip(move);
  ++skips_;
  keep(PathKind::Skip, from);
  if (!outcome) {
    mark(outcome.error());
  } else if (const auto& contact = contact_of(outcome.value());
             contact && budget_.charge(runtime::Output::Scene, kMarkBytes)) {
    const auto* touched = std::get_if<machine::Touched>(&outcome.value());
    contacts_.push_back(
        mark_of(*contact, touched != nullptr ? touched->q_M_latched : machine_.position()));
    contacts_.back().touch = skips_;
  }
  return outcome;
}

void WayRecorder::change_tool(const machine::ToolChange& change) {
  machine_.change_tool(change);
  if (job_ == nullptr || change.spindle != probe::kToolSpindle) {
    return;
  }
  const auto tool = std::ranges::find(job_->tools, change.tool.number, &probe::ToolSetup::number);
  const bool is_drawn = tool != job_->tools.end() && tool->kind != probe::ToolKind::Probe;
  tool_ = is_drawn ? tool->number : 0;
  p_S_tip_ = is_drawn ? tip_of(*tool) : p_S_probe_;
  chain_.take_tool(p_S_tip_);
}

void WayRecorder::turn_spindle(const machine::SpindleTurn& turn) {
  machine_.turn_spindle(turn);
  const bool turns_it = turn.spindle == probe::kToolSpindle &&
                        (job_ == nullptr || !job_->probe || !job_->probe->in_turret);
  if (turn.angle_deg && turns_it) {
    R_MS_ = parts::rotation_to_machine({Point::Zero(), {0.0, 0.0, *turn.angle_deg}});
  }
}

machine::MaybeFault WayRecorder::take_late_fault() {
  auto fault = machine_.take_late_fault();
  if (fault) {
    mark(*fault);
  }
  return fault;
}

/// Rapids of each axis on its own are drawn as the machine makes them from now on.
void WayRecorder::set_axis_data(const machine::AxisData& data) {
  machine_.set_axis_data(data);
  dynamics_.set_jerks(data.jerk_per_s3);
}

StylusPlace WayRecorder::shown() const {
  if (!collisions_.empty()) {
    return collisions_.back().stylus;
  }
  return contacts_.empty() ? stylus() : contacts_.back().stylus;
}

StylusPlace WayRecorder::stylus_at(const AxisPositions& q_M) const {
  if (!chain_.has_rotary_axes()) {
    return {linear_axes(q_M) + R_MS_ * p_S_tip_, Eigen::Quaterniond(R_MS_), tool_, q_M};
  }
  // As the touch probe sees itself: the axes carry the tip as it is without the spindle's turn.
  const machine::ToolPlace place = chain_.for_part(q_M);
  return {linear_axes(place.q) + p_S_tip_ + place.tilt * (R_MS_ * p_S_tip_ - p_S_tip_),
          place.tilt * Eigen::Quaterniond(R_MS_), tool_, q_M};
}

void WayRecorder::keep(PathKind kind, const Beginning& from) {
  const AxisPositions q_M_to = machine_.position();
  const int chords = chain_.has_rotary_axes() ? turning_chords(from.q_M, q_M_to) : 1;
  std::vector<AxisPositions> q_M;
  const machine::StraightPath path(from.q_M, q_M_to);
  for (int i = 0; i <= chords; ++i) {
    q_M.push_back(path.at(static_cast<double>(i) / chords));
  }
  keep({kind, from.time_s, machine_.time_s(), {}}, q_M);
}

template <typename Path>
void WayRecorder::keep_curve(PathKind kind, const Beginning& from, const Path& path, int chords) {
  const AxisPositions q_M_stop = machine_.position();
  // A move that was broken off is kept up to the chord in which it ended.
  int last = chords;
  if (q_M_stop != path.to()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 1; i <= chords; ++i) {
      const double gap = (path.at((i - 0.5) / chords) - q_M_stop).norm();
      last = gap < nearest ? i : last;
      nearest = std::min(nearest, gap);
    }
  }
  std::vector<AxisPositions> q_M = {from.q_M};
  for (int i = 1; i < last; ++i) {
    q_M.push_back(path.at(static_cast<double>(i) / chords));
  }
  q_M.push_back(q_M_stop);
  keep({kind, from.time_s, machine_.time_s(), {}}, q_M);
}

void WayRecorder::keep(Way way, const std::vector<AxisPositions>& q_M) {
  charge_track();
  std::vector<Point> points;
  points.reserve(q_M.size());
  for (const AxisPositions& q : q_M) {
    points.push_back(stylus_at(q).p_M);
  }
  way.turns = {stylus_at(q_M.front()).turn, stylus_at(q_M.back()).turn};
  const auto is_at_start = [&](const Point& p) { return p == points.front(); };
  if (std::ranges::all_of(points, is_at_start) ||
      !budget_.charge(runtime::Output::Scene, kChordBytes * (points.size() - 1))) {
    return;
  }
  // The end of a move that passes on is told as if the axes came to rest there.
  way.time_to_s = std::max(way.time_from_s, way.time_to_s);
  way.points = std::move(points);
  ways_.push_back(std::move(way));
}

void WayRecorder::on_motion(const machine::ExecutedMotion& motion) {
  const double end_s = motion.start_s + motion.duration_s;
  std::vector<double> ends_s = {motion.start_s, end_s};
  for (const machine::MotionPhases& drive : motion.servo.drives()) {
    double time_s = motion.start_s;
    for (const machine::MotionPhase& phase : drive.phases()) {
      ends_s.push_back(std::min(time_s += phase.duration_s, end_s));
    }
  }
  std::ranges::sort(ends_s);
  track_.go(ends_s, [&](double time_s) {
    const double after_s = std::max(0.0, time_s - motion.start_s);
    return stylus_at(motion.servo.encoder_at(after_s)).p_M;
  });
}

void WayRecorder::charge_track() {
  const std::size_t knots = track_.knots().size();
  if (knots > charged_knots_) {
    budget_.charge(runtime::Output::Scene, kKnotBytes * (knots - charged_knots_));
    charged_knots_ = knots;
  }
}

void WayRecorder::mark(const machine::MachineFault& fault) {
  if (!track_.knots().empty()) {
    track_.stand(machine_.time_s(), stylus().p_M);
  }
  if (fault.contact) {
    collisions_.push_back(mark_of(*fault.contact, fault.q_M_at));
    collisions_.back().what = fault.what;
  }
}

Mark WayRecorder::mark_of(const machine::Contact& contact, const AxisPositions& q_M) const {
  const SurfacePlace place = on_part(chain_, q_M, {contact.p_M_point, contact.n_M});
  Mark mark = {place.p, place.n, contact.part, {}, 0, stylus_at(q_M), {}, {}};
  if (place.p != contact.p_M_point) {
    mark.p_machine = contact.p_M_point;
  }
  if (job_ != nullptr) {
    mark.ball = touching_ball(*job_, mark);
  }
  return mark;
}

}  // namespace g31::picture

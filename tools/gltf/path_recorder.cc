#include "tools/gltf/path_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "parts/geometry/placement.h"

namespace g31::gltf {
namespace {

/// A line of a scene: two points, as many bytes as the two forms of a scene and memory take.
constexpr std::uint64_t kLineBytes = 64;
/// A mark has names and a place in lists.
constexpr std::uint64_t kMarkBytes = 256;

Mark mark_of(const machine::Contact& contact, const std::string& what) {
  return {contact.p_M_point, contact.n_M, contact.part, what};
}

const std::optional<machine::Contact>& contact_of(const machine::SkipOutcome& outcome) {
  static const std::optional<machine::Contact> kNone;
  if (const auto* touched = std::get_if<machine::Touched>(&outcome)) {
    return touched->contact;
  }
  const auto* already = std::get_if<machine::NoEdge>(&outcome);
  return already != nullptr ? already->contact : kNone;
}

}  // namespace

PathRecorder::PathRecorder(machine::MachinePort& machine, const machine::MachineSetup& setup,
                           const Point& p_S_tip, runtime::OutputBudget& budget)
    : machine_(machine), dynamics_(setup), p_S_tip_(p_S_tip), budget_(budget) {}

Result<AxisPositions, machine::MachineFault> PathRecorder::move(const machine::LinearMove& move) {
  const AxisPositions q_M_from = machine_.position();
  auto outcome = machine_.move(move);
  const PathKind kind =
      move.traverse == machine::Traverse::Rapid ? PathKind::Rapid : PathKind::Feed;
  const auto independent =
      dynamics_.independent_path(machine::StraightPath(q_M_from, move.q_M_end), move);
  if (independent && machine_.position() != q_M_from) {
    constexpr int kRapidChords = 48;
    draw_curve(kind, *independent, kRapidChords);
  } else {
    draw(kind, q_M_from, machine_.position());
  }
  if (!outcome) {
    mark(outcome.error());
  }
  return outcome;
}

Result<AxisPositions, machine::MachineFault> PathRecorder::move(const machine::ArcMove& arc) {
  const AxisPositions q_M_from = machine_.position();
  auto outcome = machine_.move(arc);
  if (machine_.position() != q_M_from || outcome) {
    constexpr double kChordRad = std::numbers::pi / 36.0;
    const machine::ArcPath path(q_M_from, arc);
    draw_curve(PathKind::Feed, path,
               1 + static_cast<int>(std::fabs(path.turned_rad()) / kChordRad));
  }
  if (!outcome) {
    mark(outcome.error());
  }
  return outcome;
}

Result<machine::SkipOutcome, machine::MachineFault> PathRecorder::move_until_skip(
    const machine::SkipMove& move) {
  const AxisPositions q_M_from = machine_.position();
  auto outcome = machine_.move_until_skip(move);
  draw(PathKind::Skip, q_M_from, machine_.position());
  if (!outcome) {
    mark(outcome.error());
  } else if (const auto& contact = contact_of(outcome.value());
             contact && budget_.charge(runtime::Output::Scene, kMarkBytes)) {
    trace_.contacts.push_back(mark_of(*contact, {}));
  }
  return outcome;
}

void PathRecorder::turn_spindle(const machine::SpindleTurn& turn) {
  machine_.turn_spindle(turn);
  if (turn.angle_deg) {
    R_MS_ = parts::rotation_to_machine({Point::Zero(), {0.0, 0.0, *turn.angle_deg}});
  }
}

Point PathRecorder::tip_at(const AxisPositions& q_M) const {
  return linear_axes(q_M) + R_MS_ * p_S_tip_;
}

void PathRecorder::draw(PathKind kind, const AxisPositions& q_M_from, const AxisPositions& q_M_to) {
  if (linear_axes(q_M_from) == linear_axes(q_M_to)) {
    return;
  }
  if (!budget_.charge(runtime::Output::Scene, kLineBytes)) {
    return;
  }
  Segments& segments = trace_.paths[static_cast<std::size_t>(kind)];
  segments.push_back(tip_at(q_M_from));
  segments.push_back(tip_at(q_M_to));
}

template <typename Path>
void PathRecorder::draw_curve(PathKind kind, const Path& path, int chords) {
  const AxisPositions q_M_stop = machine_.position();
  // A move that was broken off is drawn up to the chord in which it ended.
  int last = chords;
  if (q_M_stop != path.to()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 1; i <= chords; ++i) {
      const double gap = (path.at((i - 0.5) / chords) - q_M_stop).norm();
      last = gap < nearest ? i : last;
      nearest = std::min(nearest, gap);
    }
  }
  AxisPositions q_M_here = path.from();
  for (int i = 1; i <= last; ++i) {
    const AxisPositions q_M_next = i == last ? q_M_stop : path.at(static_cast<double>(i) / chords);
    draw(kind, q_M_here, q_M_next);
    q_M_here = q_M_next;
  }
}

void PathRecorder::mark(const machine::MachineFault& fault) {
  if (fault.contact) {
    trace_.collisions.push_back(mark_of(*fault.contact, fault.what));
  }
}

}  // namespace g31::gltf

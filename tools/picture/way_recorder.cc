#include "tools/picture/way_recorder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <variant>

#include "parts/geometry/placement.h"

namespace g31::picture {
namespace {

/// A chord: two points, as many bytes as the two forms of a scene and memory take.
constexpr std::uint64_t kChordBytes = 64;
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

WayRecorder::WayRecorder(machine::MachinePort& machine, const machine::MachineSetup& setup,
                         const Point& p_S_tip, runtime::OutputBudget& budget)
    : machine_(machine), dynamics_(setup), p_S_tip_(p_S_tip), budget_(budget) {}

Result<AxisPositions, machine::MachineFault> WayRecorder::move(const machine::LinearMove& move) {
  const Beginning from = beginning();
  auto outcome = machine_.move(move);
  const PathKind kind =
      move.traverse == machine::Traverse::Rapid ? PathKind::Rapid : PathKind::Feed;
  const auto independent =
      dynamics_.independent_path(machine::StraightPath(from.q_M, move.q_M_end), move);
  if (independent && machine_.position() != from.q_M) {
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
    constexpr double kChordRad = std::numbers::pi / 36.0;
    const machine::ArcPath path(from.q_M, arc);
    keep_curve(PathKind::Feed, from, path,
               1 + static_cast<int>(std::fabs(path.turned_rad()) / kChordRad));
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
  keep(PathKind::Skip, from);
  if (!outcome) {
    mark(outcome.error());
  } else if (const auto& contact = contact_of(outcome.value());
             contact && budget_.charge(runtime::Output::Scene, kMarkBytes)) {
    contacts_.push_back(mark_of(*contact, {}));
  }
  return outcome;
}

void WayRecorder::turn_spindle(const machine::SpindleTurn& turn) {
  machine_.turn_spindle(turn);
  if (turn.angle_deg) {
    R_MS_ = parts::rotation_to_machine({Point::Zero(), {0.0, 0.0, *turn.angle_deg}});
  }
}

Point WayRecorder::tip_at(const AxisPositions& q_M) const {
  return linear_axes(q_M) + R_MS_ * p_S_tip_;
}

void WayRecorder::keep(PathKind kind, const Beginning& from) {
  keep({kind, from.time_s, machine_.time_s(), {}}, {from.q_M, machine_.position()});
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
  const auto is_at_start = [&](const AxisPositions& q) {
    return linear_axes(q) == linear_axes(q_M.front());
  };
  if (std::ranges::all_of(q_M, is_at_start) ||
      !budget_.charge(runtime::Output::Scene, kChordBytes * (q_M.size() - 1))) {
    return;
  }
  // The end of a move that passes on is told as if the axes came to rest there.
  way.time_to_s = std::max(way.time_from_s, way.time_to_s);
  for (const AxisPositions& q : q_M) {
    way.points.push_back(tip_at(q));
  }
  ways_.push_back(std::move(way));
}

void WayRecorder::mark(const machine::MachineFault& fault) {
  if (fault.contact) {
    collisions_.push_back(mark_of(*fault.contact, fault.what));
  }
}

}  // namespace g31::picture

#include "interpreter/path/cutter_compensation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/base/contract.h"

namespace g31::path {
namespace {

using State = CompensationCommand::State;
using Fault = std::optional<CompensationFault>;

/// How much further an offset arc may turn than the programmed one; more is all the way round.
constexpr double kSweepErrorRad = 1e-3;

bool same_point(const PlanePoint& a, const PlanePoint& b) {
  return (a - b).norm() < kOnePointMm;
}

/// The offset of the block behind a corner, at the corner: as large as that of the block in front
/// of it; a new D takes effect at the end of its block.
double offset_at_corner(double before, double behind) {
  return std::copysign(before, behind == 0.0 ? before : behind);
}

/// The tool centre goes from s to e against the programmed way.
bool goes_backwards(const PlaneWay& way, const PlanePoint& s, const PlanePoint& e) {
  if (!way.arc) {
    return direction_at_start(way).dot(e - s) < -kOnePointMm;
  }
  return !same_point(s, e) && sweep_rad({s, e, way.arc}) > sweep_rad(way) + kSweepErrorRad;
}

/// Why an arc cannot be compensated, whatever comes before and behind it.
std::optional<CompensationError> refusal(const PlaneWay& way, double offset) {
  const double radius =
      std::min(offset_radius(*way.arc, way.from, offset), offset_radius(*way.arc, way.to, offset));
  if (radius > kOnePointMm) {
    return std::nullopt;
  }
  return radius < -kOnePointMm ? CompensationError::Interference
                               : CompensationError::ArcWithoutRadius;
}

}  // namespace

void CutterCompensation::engage(const AxisPositions& q_M, OffsetPlane plane) {
  mode_ = Mode::Starting;
  plane_ = plane;
  q_M_path_ = q_M;
  q_M_tool_ = q_M;
  idle_ = 0;
  corner_.clear();
  corner_arc_.reset();
}

CompensationResult CutterCompensation::given(const Fault& fault) {
  PathItems items = std::exchange(given_, {});
  if (fault) {
    return *fault;
  }
  return items;
}

bool CutterCompensation::plane_changed(const CompensationCommand& command) const {
  return (mode_ == Mode::On || mode_ == Mode::Leaving) && command.plane != plane_;
}

CompensationResult CutterCompensation::take(const PathBlock& block,
                                            const CompensationCommand& command) {
  G31_EXPECTS(engaged());
  if (plane_changed(command)) {
    return CompensationFault{CompensationError::PlaneChanged, command.where};
  }
  plane_ = command.plane;
  if (block.arc || !same_point(plane_.of(block.q_M_end), plane_.of(q_M_path_))) {
    return given(take_in_plane(block, command));
  }
  if ((block.q_M_end - q_M_path_).norm() < kOnePointMm) {
    // A motion of no length breaks the read-ahead as two idle blocks do.
    idle_ = rules_.idle_limit;
  }
  q_M_path_ = plane_.moved(block.q_M_end, plane_.of(q_M_path_));
  return given(idle(block, command));
}

CompensationResult CutterCompensation::pass(std::optional<Pause> pause,
                                            const CompensationCommand& command) {
  G31_EXPECTS(engaged());
  if (plane_changed(command)) {
    return CompensationFault{CompensationError::PlaneChanged, command.where};
  }
  return given(pause ? idle(PathItem(*pause), command) : idle(std::nullopt, command));
}

CompensationResult CutterCompensation::flush() {
  return given(end_beside());
}

AxisPositions CutterCompensation::position() const {
  return plane_.moved(q_M_path_,
                      held_ ? beside_end(held_->way, held_->offset) : plane_.of(q_M_tool_));
}

Fault CutterCompensation::idle(std::optional<PathItem> item, const CompensationCommand& command) {
  const bool on = command.state == State::On;
  if (mode_ == Mode::Starting && !on) {
    mode_ = Mode::Off;
  } else if (mode_ == Mode::Leaving && on) {
    mode_ = Mode::Starting;
  } else if (mode_ == Mode::On) {
    const auto* const block = item ? std::get_if<PathBlock>(&*item) : nullptr;
    idle_ += block != nullptr && block->goes_on ? 0 : 1;
    const bool renewed = command.written == CompensationCommand::Written::Here;
    if (!on || renewed || idle_ > rules_.idle_limit) {
      if (const Fault fault = end_beside()) {
        return fault;
      }
    }
    mode_ = on ? Mode::On : Mode::Leaving;
  }
  if (item && held_) {
    between_.push_back(*item);
  } else if (item) {
    give_at_tool(*item);
  }
  return std::nullopt;
}

CutterCompensation::Held CutterCompensation::prepared(const PathBlock& block,
                                                      const CompensationCommand& command) const {
  Held next;
  next.block = block;
  next.way = {plane_.of(q_M_path_), plane_.of(block.q_M_end), block.arc};
  next.offset = command.offset;
  if (command.state == State::Off) {
    next.role = Role::Cancel;
  } else if (mode_ != Mode::On) {
    next.role = Role::StartUp;
  }
  return next;
}

Fault CutterCompensation::take_in_plane(const PathBlock& block,
                                        const CompensationCommand& command) {
  Held next = prepared(block, command);
  if (block.arc && next.role != Role::Normal) {
    return CompensationFault{CompensationError::ArcAtStartOrEnd, block.where, block.calls};
  }
  if (const auto refused = block.arc ? refusal(next.way, next.offset) : std::nullopt) {
    return CompensationFault{*refused, block.where, block.calls};
  }
  if (held_) {
    const auto end = join(next);
    if (!end) {
      return CompensationFault{end.error(), block.where, block.calls};
    }
    if (const Fault fault = finish_held(end.value())) {
      return fault;
    }
  } else if (block.arc) {
    // Nothing was read ahead: the tool need not stand where the offset arc begins.
    corner_.assign(1, beside_start(next.way, next.offset));
  }
  next.start = std::exchange(corner_, {});
  next.start_arc = std::exchange(corner_arc_, std::nullopt);
  const Role role = next.role;
  q_M_path_ = block.q_M_end;
  idle_ = 0;
  held_ = std::move(next);
  mode_ = Mode::On;
  if (role != Role::Cancel) {
    return std::nullopt;
  }
  const Fault fault = finish_held({{held_->way.to}, std::nullopt});
  mode_ = Mode::Off;
  return fault;
}

/// The corner between the block that waits and the next one.
Result<CutterCompensation::Join, CompensationError> CutterCompensation::join(
    const Held& behind) const {
  const Held& before = *held_;
  const bool rapid = before.block.g == 0 || behind.block.g == 0;
  // There is no arc at rapid: lines lead round the corner farther off.
  Corner corner{before.way,       behind.way,
                before.offset,    offset_at_corner(before.offset, behind.offset),
                rules_.minute_mm, rapid ? OutsideCorner::Lines : rules_.outside};
  if (behind.role == Role::Cancel && before.role == Role::StartUp) {
    return Join{{before.way.to}, std::nullopt};
  }
  Join result;
  if (behind.role == Role::Cancel) {
    corner.offset_behind = before.offset;
    result.points = cancel_points(corner, rules_.start_up);
  } else if (before.role == Role::StartUp) {
    result.points = start_up_points(corner, rules_.start_up);
  } else if (auto points = corner_points(corner)) {
    result.points = *std::move(points);
  } else {
    return CompensationError::NoIntersection;
  }
  if (result.points.empty()) {
    return CompensationError::StartOrEndWithinArc;
  }
  result.arc = result.points.size() == 2 ? corner_arc(corner) : std::nullopt;
  return result;
}

/// Gives out the block that waits, up to the first point of the corner behind it, and what waits
/// between it and the next one.
Fault CutterCompensation::finish_held(Join end) {
  if (held_->role == Role::Normal && rules_.check == CompensationRules::InterferenceCheck::On) {
    if (const Fault fault = clear_interference(end)) {
      return fault;
    }
  }
  give_corner_lines();
  give_path(end.points.front());
  held_.reset();
  for (PathItem& item : std::exchange(between_, {})) {
    give_at_tool(std::move(item));
  }
  corner_.assign(end.points.begin() + 1, end.points.end());
  corner_arc_ = end.arc;
  return std::nullopt;
}

/// Leaves out points of the corners at both ends of a straight block, from its middle outwards,
/// until it leads forward; interference when no more can be left out.
Fault CutterCompensation::clear_interference(Join& end) {
  CornerPoints& start = held_->start;
  const bool has_arcs = held_->way.arc || held_->start_arc || end.arc;
  const auto begin = [&] { return start.empty() ? plane_.of(q_M_tool_) : start.back(); };
  while (goes_backwards(held_->way, begin(), end.points.front())) {
    if (has_arcs || (start.empty() && end.points.size() == 1)) {
      return CompensationFault{CompensationError::Interference, held_->block.where,
                               held_->block.calls};
    }
    if (!start.empty()) {
      start.pop_back();
    }
    if (end.points.size() > 1) {
      end.points.erase(end.points.begin());
    }
  }
  return std::nullopt;
}

Fault CutterCompensation::end_beside() {
  if (!held_) {
    return std::nullopt;
  }
  idle_ = 0;
  return finish_held({{beside_end(held_->way, held_->offset)}, std::nullopt});
}

void CutterCompensation::give_corner_lines() {
  for (const PlanePoint& p : held_->start) {
    PathBlock line = held_->block;
    line.arc = held_->start_arc;
    const int g_arc = line.arc && line.arc->turn == machine::Turn::Clockwise ? 2 : 3;
    line.g = line.arc ? g_arc : std::min(line.g, 1);
    line.q_M_end = plane_.moved(q_M_tool_, p);
    if (!same_point(p, plane_.of(q_M_tool_))) {
      q_M_tool_ = line.q_M_end;
      given_.emplace_back(line);
    }
  }
}

/// The feed of the tool centre along an arc that keeps the programmed one at the contour.
double CutterCompensation::contour_feed() const {
  const Held& held = *held_;
  const double contour = (held.way.from - held.way.arc->centre).norm();
  const double tool = offset_radius(*held.way.arc, held.way.from, held.offset);
  const double ratio = tool / contour;
  const bool inside_only = rules_.arc_feed == CompensationRules::ArcFeed::AtContourInside;
  return held.block.feed_mm_min * (inside_only ? std::min(1.0, ratio) : ratio);
}

void CutterCompensation::give_path(const PlanePoint& end) {
  given_.emplace_back(held_->block);
  PathBlock& path = std::get<PathBlock>(given_.back());
  path.q_M_end = plane_.moved(path.q_M_end, end);
  if (path.arc && (path.feed_at_contour || rules_.arc_feed != CompensationRules::ArcFeed::AtTool)) {
    path.feed_mm_min = contour_feed();
  }
  if (path.arc && same_point(end, plane_.of(q_M_tool_))) {
    if (same_point(held_->way.from, held_->way.to)) {
      path.q_M_end = plane_.moved(path.q_M_end, plane_.of(q_M_tool_));
    } else {
      path.arc.reset();
      path.g = 1;
    }
  }
  q_M_tool_ = path.q_M_end;
}

/// A motion of other axes, or a pause, where the tool stands in the plane.
void CutterCompensation::give_at_tool(PathItem item) {
  if (auto* const block = std::get_if<PathBlock>(&item)) {
    block->q_M_end = plane_.moved(block->q_M_end, plane_.of(q_M_tool_));
    q_M_tool_ = block->q_M_end;
  }
  given_.push_back(std::move(item));
}

}  // namespace g31::path

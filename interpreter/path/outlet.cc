#include "interpreter/path/outlet.h"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <utility>

namespace g31::path {
namespace {

/// What a move's tag says: how many came before it, and its block.
struct Tag {
  std::uint64_t number = 0;
  source::Location where;
};

/// Part by part: a whole tag would wait for its parts.
machine::MoveTag tag_of(std::uint64_t number, source::Location where) {
  const auto place = std::bit_cast<std::array<std::uint64_t, 2>>(where);
  return {number, place[0], place[1]};
}

const machine::AxisTransformPtr kUnled;

/// mm/min; the machine clamps it.
constexpr double kAsFastAsAxesGo = 1e9;

machine::MachineFault unreachable(const AxisPositions& q_M) {
  return {machine::FaultKind::SoftLimit,
          "the linear axes do not lead to the place as the rotary axes stand", q_M, std::nullopt};
}

}  // namespace

Outlet::Outlet(machine::MachinePort& port, runtime::Observer& observer)
    : port_(port), observer_(observer), transform_(&kUnled) {}

source::Location Outlet::place_of(const machine::MachineFault& fault) {
  return fault.tag ? std::bit_cast<Tag>(*fault.tag).where : source::Location();
}

runtime::ProgramView Outlet::view_of(const AxisPositions& q_M,
                                     const AxisPositions& q_M_commanded) const {
  return view_ ? view_(q_M, q_M_commanded) : runtime::ProgramView();
}

/// What came behind a move that ended in a fault did not take place.
/// @param move  that was asked for; the fault may be of an earlier one
machine::MaybeFault Outlet::told(machine::MaybeFault fault,
                                 const std::optional<runtime::MoveEvent>& move) {
  if (!fault) {
    return fault;
  }
  if (fault->tag) {
    const std::uint64_t number = std::bit_cast<Tag>(*fault->tag).number;
    observer_.on_moves_undone(moves_ - number);
    moves_ = number;
    look_up_levels(number);
  }
  runtime::FaultEvent event;
  event.what = fault->what;
  event.q_M_at = fault->q_M_at;
  event.move = fault->tag ? std::nullopt : move;
  event.where = fault->tag ? place_of(*fault) : move ? move->where : source::Location();
  event.contact = fault->contact;
  event.view = view_of(fault->q_M_at, event.move ? event.move->q_M_to : fault->q_M_at);
  if (fault_levels_) {
    event.view.calls = runtime::calls_behind(*fault_levels_);
  }
  observer_.on_fault(event);
  return fault;
}

// Control looks far fewer moves ahead.
constexpr std::size_t kMostRemembered = 4096;

void Outlet::remember_levels() {
  calls_are_old_ = false;
  ++levels_number_;
  remembered_.push_back(levels_ ? levels_() : std::vector<runtime::CallLevel>());
  if (remembered_.size() > kMostRemembered) {
    remembered_.pop_front();
  }
}

void Outlet::begin_calls(std::uint64_t number) {
  if (!calls_.empty() && calls_.back().number == number) {
    return;
  }
  calls_.push_back({moves_, number});
  if (calls_.size() > kMostRemembered) {
    calls_.pop_front();
  }
}

/// @param move  its number
void Outlet::look_up_levels(std::uint64_t move) {
  const auto later =
      std::ranges::find_if(calls_, [&](const CallsFrom& from) { return from.move > move; });
  const std::uint64_t number = later == calls_.begin() ? 0 : std::prev(later)->number;
  fault_levels_ = levels_of(number);
}

std::optional<std::vector<runtime::CallLevel>> Outlet::levels_of(std::uint64_t number) const {
  const std::uint64_t age = levels_number_ - number;
  return number > 0 && age < remembered_.size()
             ? std::optional(remembered_[remembered_.size() - 1 - age])
             : std::nullopt;
}

machine::MaybeFault Outlet::stand_still() {
  port_.stand_still();
  return told(port_.take_late_fault());
}

machine::MaybeFault Outlet::come_to_rest() {
  port_.come_to_rest();
  return told(port_.take_late_fault());
}

template <typename Move>
machine::MaybeFault Outlet::carry_out(const Move& move, const PathBlock& block) {
  block.feed_mm_min == 0.0 || block.g == 0 ? stop_cutting() : cut();
  const auto reached = port_.move(move);
  const runtime::MoveEvent event{block.g, move.q_M_end, block.feed_mm_min, 0.0, block.where};
  if (!reached) {
    look_up_levels(moves_);
    return told(reached.error(), event);
  }
  ++moves_;
  observer_.on_move(event);
  return std::nullopt;
}

[[gnu::hot]] machine::MaybeFault Outlet::move(const PathBlock& block, const OffsetPlane& plane) {
  begin_calls(block.calls > 0 ? block.calls : calls_now());
  const machine::MoveTag tag = tag_of(moves_, block.where);
  const machine::AxisTransformPtr& transform = block.of_axes ? kUnled
                                               : block.leads ? block.leads
                                                             : *transform_;
  const auto q_M_end = transform ? transform->axes_at(block.q_M_end) : std::optional(block.q_M_end);
  if (!q_M_end) {
    look_up_levels(moves_);
    return told(unreachable(port_.position()));
  }
  if (!block.arc) {
    const auto traverse = block.g == 0 ? machine::Traverse::Rapid : machine::Traverse::Feed;
    return carry_out(machine::LinearMove{*q_M_end, traverse, block.feed_mm_min, block.ends,
                                         block.mm_per_degree, block.rapid_path,
                                         block.contour_control, tag, transform, block.smoothness},
                     block);
  }
  machine::ArcMove move;
  move.q_M_end = *q_M_end;
  move.first_axis = plane.first;
  move.second_axis = plane.second;
  move.centre_first = block.arc->centre.x();
  move.centre_second = block.arc->centre.y();
  move.turn = block.arc->turn;
  move.feed_mm_min = block.feed_mm_min > 0.0 ? block.feed_mm_min : kAsFastAsAxesGo;
  move.ends = block.ends;
  move.contour_control = block.contour_control;
  move.tag = tag;
  move.transform = transform;
  move.smoothness = block.smoothness;
  return carry_out(move, block);
}

void Outlet::cut() {
  if (!cuts_since_s_) {
    cuts_since_s_ = port_.time_s();
  }
}

machine::MaybeFault Outlet::pause(const Pause& pause) {
  stop_cutting();
  if (auto late = stand_still()) {
    return late;
  }
  port_.dwell(pause.seconds);
  if (auto met = told(port_.take_late_fault())) {
    return met;
  }
  observer_.on_move({4, port_.position(), 0.0, pause.seconds, pause.where});
  return std::nullopt;
}

Result<machine::SkipOutcome, machine::MachineFault> Outlet::move_until_skip(
    const machine::SkipMove& move, source::Location where) {
  constexpr int kSkip = 31;
  cut();
  if (auto late = stand_still()) {
    return *std::move(late);
  }
  auto outcome = port_.move_until_skip(move);
  if (!outcome) {
    fault_levels_.reset();
    told(outcome.error(),
         runtime::MoveEvent{kSkip, move.way.q_M_end, move.way.feed_mm_min, 0.0, where});
  }
  return outcome;
}

void Outlet::touched(runtime::TouchEvent event) {
  observer_.on_move({31, event.q_M_stopped, event.feed_mm_min, 0.0, event.where});
  touched_as_well(std::move(event));
}

void Outlet::touched_as_well(runtime::TouchEvent event) {
  event.time_s = port_.time_s();
  event.view = view_of(event.q_M_latched, event.q_M_commanded);
  observer_.on_touch(event);
}

}  // namespace g31::path

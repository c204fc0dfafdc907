#include "interpreter/path/outlet.h"

namespace g31::path {

template <typename Move>
std::optional<machine::MachineFault> Outlet::carry_out(const Move& move, const PathBlock& block) {
  block.g == 0 ? stop_cutting() : cut();
  const auto reached = port_.move(move);
  if (!reached) {
    return reached.error();
  }
  observer_.on_move({block.g, block.q_M_end, block.feed_mm_min, 0.0, block.where});
  return std::nullopt;
}

std::optional<machine::MachineFault> Outlet::move(const PathBlock& block,
                                                  const OffsetPlane& plane) {
  if (!block.arc) {
    const auto traverse = block.g == 0 ? machine::Traverse::Rapid : machine::Traverse::Feed;
    return carry_out(machine::LinearMove{block.q_M_end, traverse, block.feed_mm_min, block.ends,
                                         block.mm_per_degree, block.rapid_path},
                     block);
  }
  machine::ArcMove move;
  move.q_M_end = block.q_M_end;
  move.first_axis = plane.first;
  move.second_axis = plane.second;
  move.centre_first = block.arc->centre.x();
  move.centre_second = block.arc->centre.y();
  move.turn = block.arc->turn;
  move.feed_mm_min = block.feed_mm_min;
  move.ends = block.ends;
  return carry_out(move, block);
}

void Outlet::cut() {
  if (!cuts_since_s_) {
    cuts_since_s_ = port_.time_s();
  }
}

void Outlet::pause(const Pause& pause) {
  stop_cutting();
  port_.dwell(pause.seconds);
  observer_.on_move({4, port_.position(), 0.0, pause.seconds, pause.where});
}

Result<machine::SkipOutcome, machine::MachineFault> Outlet::move_until_skip(
    const machine::SkipMove& move) {
  cut();
  return port_.move_until_skip(move);
}

void Outlet::touched(const runtime::TouchEvent& event) {
  observer_.on_move({31, event.q_M_stopped, event.feed_mm_min, 0.0, event.where});
  observer_.on_touch(event);
}

}  // namespace g31::path

#include <cstddef>
#include <optional>
#include <vector>

#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/measuring.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "interpreter/runtime/touch_event.h"

namespace g31::sinumerik {
namespace {

/// Of two probes the one that has switched; nullptr: both have, none has, or one was asked.
const machine::NoTouch::Alone* alone_of(const machine::SkipOutcome& outcome) {
  const auto* const none = std::get_if<machine::NoTouch>(&outcome);
  return none != nullptr && none->alone ? &*none->alone : nullptr;
}

/// A way that the probe may end.
struct MeasuredWay {
  AxisPositions q_W_end = AxisPositions::Zero();
  /// FA of the positioning axis that goes alone, 0: rapid; nullopt: the path goes.
  std::optional<double> axis_feed_per_min;
};

Result<machine::LinearMove, Failure> measuring_move(Channel& channel, const Block& block,
                                                    const MeasuredWay& way) {
  const AxisPositions& q_W_end = way.q_W_end;
  machine::LinearMove move;
  move.smoothness.limits_jerk = limits_jerk(channel);
  move.q_M_end = coupled_end(channel, channel.port.position(), channel.to_machine(q_W_end));
  if (MaybeFailure wrong = cannot_follow(channel, move.q_M_end - channel.port.position())) {
    return *wrong;
  }
  move.transform = channel.leads();
  if (way.axis_feed_per_min) {
    if (*way.axis_feed_per_min > 0.0) {
      move.traverse = machine::Traverse::Feed;
      move.feed_mm_min = *way.axis_feed_per_min;
    }
    return move;
  }
  if (channel.group[Group::Motion] == number_in_group("G0")) {
    return move;
  }
  if (channel.group[Group::Motion] != number_in_group("G1")) {
    return failure(measured_circle());
  }
  const double length = feed_length(channel.path_position(), channel.machine_to_path(move.q_M_end));
  const auto feed = feed_in_force(channel, block, feed_way(channel, block, q_W_end, length));
  if (!feed) {
    return feed.error();
  }
  move.traverse = machine::Traverse::Feed;
  move.feed_mm_min = feed.value();
  return move;
}

void latch_first(Channel& channel, const AxisPositions& q_M_latched, int probe) {
  channel.measured[static_cast<std::size_t>(probe)] = true;
  channel.q_M_measured = q_M_latched;
  channel.q_W_measured = channel.to_work(q_M_latched);
}

void latch_second(Channel& channel, const AxisPositions& q_M_latched, int probe) {
  channel.measured[static_cast<std::size_t>(probe)] = true;
  channel.q_M_second = q_M_latched;
  channel.q_W_second = channel.to_work(q_M_latched);
}

/// What the move has left in $AA_MM1, $AA_MM2 and $AC_MEA: of two triggers each its own.
void latch(Channel& channel, const machine::SkipOutcome& outcome, const Measuring& measuring) {
  if (measuring.by_action) {
    return;
  }
  if (const auto* const touched = std::get_if<machine::Touched>(&outcome)) {
    latch_first(channel, touched->q_M_latched, measuring.probe);
    if (touched->further) {
      latch_second(channel, touched->further->q_M_latched, measuring.further);
    }
  } else if (const auto* const one = alone_of(outcome)) {
    one->is_main ? latch_first(channel, one->touch.q_M_latched, measuring.probe)
                 : latch_second(channel, one->touch.q_M_latched, measuring.further);
  }
}

/// Where the program goes on after the move: behind one of two triggers it may end on its way.
void settle(Channel& channel, const runtime::TouchEvent& event, const Measuring& measuring,
            const AxisPositions& q_W_end) {
  const bool stops =
      (event.triggered || measuring.further != 0) && measuring.after == machine::AfterSignal::Stop;
  if (stops || !channel.couplings.empty()) {
    channel.arrived_at_machine();
  } else {
    channel.arrived_at_programmed(q_W_end, channel.machine_to_path(event.q_M_commanded));
  }
}

/// The move that listens to what the words of the block name.
Result<machine::SkipMove, Failure> listening_move(const Channel& channel,
                                                  const machine::LinearMove& way,
                                                  const Measuring& measuring) {
  machine::SkipMove move(way);
  move.input = measuring.probe;
  move.edge = measuring.edge;
  move.after = measuring.after;
  if (measuring.further == 0) {
    return move;
  }
  if (way.transform != nullptr) {
    return failure(AlarmId::NotImplemented, "MEASA with two triggers while a transformation leads");
  }
  move.further.emplace();
  move.further->input = measuring.further;
  move.further->comes_second = measuring.mode != MeasuringMode::AnyOrder;
  move.further->within_mm = channel.simultaneous_limit().value_or(move.further->within_mm);
  return move;
}

/// What another probe has latched beside what the event of the move says; nullptr: none has.
const machine::FurtherTouch* further_of(const machine::SkipOutcome& outcome) {
  if (const auto* const one = alone_of(outcome)) {
    return &one->touch;
  }
  const auto* const touched = std::get_if<machine::Touched>(&outcome);
  return touched != nullptr && touched->further ? &*touched->further : nullptr;
}

/// What the move has come to, for the program and for those who watch it.
/// @param state  of the probe, before the move
void report(Channel& channel, const Measuring& measuring, runtime::TouchEvent event,
            const machine::SkipOutcome& outcome, const std::optional<machine::SensorState>& state) {
  if (event.triggered) {
    channel.touches.missed.touched();
  } else if (!measuring.by_action) {
    channel.touches.missed.missed(event.where,
                                  {runtime::MissedTouches::Result::Former, channel.mm_per_datum(),
                                   measuring.further == 0 ? measuring.probe : 0});
  }
  channel.touches.touched(event, state);
  channel.outlet.touched(event);
  if (const machine::FurtherTouch* const further = further_of(outcome)) {
    event.q_M_latched = further->q_M_latched;
    event.contact = further->contact;
    event.triggered = true;
    channel.outlet.touched_as_well(event);
  }
}

/// Where the ways of a measuring block end: along a great circle they are several.
Result<std::vector<AxisPositions>, Failure> ends_of(Channel& channel, const Block& block,
                                                    const Measuring& measuring,
                                                    const AxisPositions& q_W_end) {
  if (!has_direction(block)) {
    return std::vector<AxisPositions>{q_W_end};
  }
  auto ends = pieces_of_turn(channel, channel.to_machine(q_W_end), q_W_end);
  if (ends && ends.value().size() > 1 && measuring.after == machine::AfterSignal::GoOn) {
    return failure(AlarmId::NotImplemented, "MEAW along a great circle: ORIAXES goes");
  }
  return ends;
}

/// One way of a measuring block, as far as the probe lets it go.
/// @param is_last  the block has no other behind it
/// @returns whether the signal has come
Result<bool, Failure> measure_along(Channel& channel, const Block& block,
                                    const Measuring& measuring, const MeasuredWay& way,
                                    bool is_last) {
  const auto straight = measuring_move(channel, block, way);
  if (!straight) {
    return straight.error();
  }
  if (MaybeFailure outside =
          out_of_reach(channel, channel.machine_to_path(straight.value().q_M_end))) {
    return *outside;
  }
  auto listening = listening_move(channel, straight.value(), measuring);
  if (!listening) {
    return listening.error();
  }
  const machine::SkipMove& move = listening.value();
  const auto state = channel.port.sensor_state(move.input);
  const AxisPositions q_M_from = channel.port.position();
  const auto outcome = channel.outlet.move_until_skip(move, block.where);
  if (!outcome) {
    channel.arrived_at_machine();
    return from_fault(outcome.error());
  }
  const bool no_edge = std::holds_alternative<machine::NoEdge>(outcome.value());
  if (no_edge && measuring.mode == MeasuringMode::InOrderUnasked) {
    return failure(AlarmId::NotImplemented, "MEASA, mode 3, with a probe that has switched before");
  }
  if (no_edge && !measuring.by_action) {
    return failure(measuring.edge == machine::SignalEdge::Rising ? AlarmId::ProbeDeflected
                                                                 : AlarmId::ProbeNotDeflected);
  }
  runtime::TouchEvent event =
      runtime::touch_event(move.way, outcome.value(), q_M_from, channel.port.position());
  move_followers(channel, channel.port.position() - q_M_from);
  event.block = "MEAS";
  event.where = block.where;
  latch(channel, outcome.value(), measuring);
  settle(channel, event, measuring, way.q_W_end);
  if (event.triggered || is_last) {
    report(channel, measuring, event, outcome.value(), state);
  }
  return event.triggered;
}

/// Goes the ways of a block until the signal comes.
MaybeFailure measure_ways(Channel& channel, const Block& block, const Measuring& measuring,
                          const std::vector<MeasuredWay>& ways) {
  if (MaybeFailure wrong = compensate_axes(channel)) {
    return wrong;
  }
  if (!measuring.by_action) {
    channel.measured = {};
  }
  channel.warnings.add_complaints(channel.diagnostics, channel.port.sensor_state(measuring.probe),
                                  block.where);
  if (is_compensation_on(channel)) {
    channel.warnings.add(channel.diagnostics, source::DiagnosticId::MeasuredCompensated,
                         block.where);
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const auto triggered = measure_along(channel, block, measuring, ways[i], i + 1 == ways.size());
    if (!triggered) {
      return triggered.error();
    }
    if (triggered.value()) {
      break;
    }
  }
  return std::nullopt;
}

MaybeFailure measure_path(Channel& channel, const Block& block, const Measuring& measuring) {
  const auto q_W_end = programmed_end(channel, block);
  if (!q_W_end) {
    return q_W_end.error();
  }
  const auto ends = ends_of(channel, block, measuring, q_W_end.value());
  if (!ends) {
    return ends.error();
  }
  std::vector<MeasuredWay> ways;
  for (const AxisPositions& q_W_piece : ends.value()) {
    ways.push_back({q_W_piece, std::nullopt});
  }
  return measure_ways(channel, block, measuring, ways);
}

}  // namespace

MaybeFailure measure(Channel& channel, const Block& block) {
  const auto measuring = measuring_of(channel, block.words);
  channel.skip_action.reset();
  return measuring ? measure_path(channel, block, measuring.value()) : measuring.error();
}

MaybeFailure measure_axis(Channel& channel, const Block& block, const AxisPositions& q_W_end,
                          double feed_per_min) {
  const auto measuring = measuring_of(channel, block.words);
  return measuring ? measure_ways(channel, block, measuring.value(), {{q_W_end, feed_per_min}})
                   : measuring.error();
}

}  // namespace g31::sinumerik

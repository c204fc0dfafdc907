#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/feed.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "interpreter/runtime/overloaded.h"

namespace g31::sinumerik {
namespace {

/// The event of a measuring block; positions default to where the axes stand.
runtime::TouchEvent event_of(const Channel& channel, const Block& block,
                             const machine::SkipOutcome& outcome) {
  runtime::TouchEvent event;
  event.block = "MEAS";
  event.where = block.where;
  event.q_M_latched = channel.port.position();
  event.q_M_stopped = channel.port.position();
  std::visit(
      runtime::Overloaded{
          [&](const machine::Touched& touched) {
            event.triggered = true;
            event.q_M_latched = touched.q_M_latched;
            event.q_M_stopped = touched.q_M_stopped;
            event.contact = touched.contact;
            event.signals = touched.signals;
          },
          [](const machine::NoTouch&) {},
          [&](const machine::AlreadyTouching& touching) { event.contact = touching.contact; },
      },
      outcome);
  return event;
}

/// The probe that MEAS=n names: 1 or 2, rising edge.
Result<std::size_t, Failure> probe_of(double number) {
  if (number == 1.0 || number == 2.0) {
    return static_cast<std::size_t>(number);
  }
  const bool known = std::abs(number) >= 1.0 && std::abs(number) <= 8.0;
  return failure(known ? AlarmId::NotImplemented : AlarmId::ValueOutOfLimits,
                 fmt::format("MEAS={:.0f}: rising edges of probe 1 and 2", number));
}

Result<machine::LinearMove, Failure> measuring_move(Channel& channel, const Block& block,
                                                    const AxisPositions& q_W_end) {
  machine::LinearMove move;
  move.q_M_end = channel.to_machine(q_W_end);
  if (channel.group[1] == 1) {
    return move;
  }
  if (channel.group[1] != 2) {
    return failure(AlarmId::NotImplemented, "MEAS on a circle");
  }
  const double length = feed_length(channel.port.position(), move.q_M_end);
  const auto feed = feed_in_force(channel, block, feed_way(channel, block, q_W_end, length));
  if (!feed) {
    return feed.error();
  }
  move.traverse = machine::Traverse::Feed;
  // Override and dry run leave a measuring feed alone.
  move.feed_mm_min = feed.value();
  return move;
}

}  // namespace

MaybeFailure measure(Channel& channel, const Block& block) {
  const auto probe = probe_of(block.words[Address::Measure].value);
  if (!probe) {
    return probe.error();
  }
  const auto q_W_end = programmed_end(channel, block);
  if (!q_W_end) {
    return q_W_end.error();
  }
  const auto move = measuring_move(channel, block, q_W_end.value());
  if (!move) {
    return move.error();
  }
  if (MaybeFailure outside = outside_working_area(channel, move.value().q_M_end)) {
    return outside;
  }
  channel.measured = {};
  const auto outcome = channel.port.move_until_skip(move.value());
  if (!outcome) {
    channel.arrived_at_machine();
    return from_fault(outcome.error());
  }
  if (std::holds_alternative<machine::AlreadyTouching>(outcome.value())) {
    return failure(AlarmId::ProbeDeflected);
  }
  runtime::TouchEvent event = event_of(channel, block, outcome.value());
  event.q_M_commanded = move.value().q_M_end;
  event.feed_mm_min = move.value().feed_mm_min;
  channel.measured[probe.value()] = event.triggered;
  if (event.triggered) {
    channel.q_M_measured = event.q_M_latched;
    channel.q_W_measured = channel.to_work(event.q_M_latched);
    channel.arrived_at_machine();
  } else {
    channel.arrived_at_programmed(q_W_end.value(), move.value().q_M_end);
  }
  channel.observer.on_move({31, event.q_M_stopped, event.feed_mm_min, 0.0});
  channel.observer.on_touch(event);
  return std::nullopt;
}

}  // namespace g31::sinumerik

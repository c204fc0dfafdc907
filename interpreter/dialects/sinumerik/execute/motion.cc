#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"

namespace g31::sinumerik {
namespace {

constexpr double kTurn = 360.0;

/// The nearest place of a rotary axis at `angle` that the modification allows.
double rotary_end(double now, double angle, Modification modification) {
  const double ahead = std::fmod(std::fmod(angle - now, kTurn) + kTurn, kTurn);
  switch (modification) {
    case Modification::Direct:
      return now + (ahead > kTurn / 2.0 ? ahead - kTurn : ahead);
    case Modification::Plus:
      return now + ahead;
    case Modification::Minus:
      return now + (ahead > 0.0 ? ahead - kTurn : 0.0);
    case Modification::None:
    case Modification::Absolute:
    case Modification::Incremental:
      break;
  }
  return angle;
}

}  // namespace

Result<AxisPositions, Failure> programmed_end(Channel& channel, const Block& block) {
  const AxisPositions q_W_now = channel.present();
  AxisPositions q_W_end = q_W_now;
  const bool incremental = channel.group[14] == 2 && channel.suppression == 0;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    const BlockWords::Word& word = block.words.axis(axis);
    if (!word.present) {
      continue;
    }
    const double value = channel.stored(axis, word.value);
    const bool turns = word.modification == Modification::Direct ||
                       word.modification == Modification::Plus ||
                       word.modification == Modification::Minus;
    if (turns && axis < 3) {
      return failure(AlarmId::BadModification,
                     fmt::format("{} is no rotary axis", kAxisLetters[axis]));
    }
    const bool adds = word.modification == Modification::Incremental ||
                      (word.modification == Modification::None && incremental);
    q_W_end[axis] = turns  ? rotary_end(q_W_now[axis], value, word.modification)
                    : adds ? channel.programmed()[axis] + value
                           : value;
  }
  return q_W_end;
}

Result<double, Failure> feed_in_force(const Channel& channel) {
  const bool by_revolution = channel.group[15] == 3 || channel.group[15] == 5;
  const double feed = channel.feed * channel.mm_per_feed();
  if (feed <= 0.0 || (by_revolution && channel.speed <= 0.0)) {
    return failure(AlarmId::NoFeed, by_revolution ? "G95 needs F and S" : "");
  }
  const double programmed = by_revolution ? feed * channel.speed : feed;
  const runtime::FeedSwitches& switches = channel.feed_switches;
  return switches.dry_run_mm_min > 0.0 ? switches.dry_run_mm_min
                                       : programmed * switches.override_percent / 100.0;
}

machine::BlockEnd block_end(const Channel& channel) {
  const bool stops = channel.group[11] == 1 || channel.group[10] == 1;
  return stops ? machine::BlockEnd::ExactStop : machine::BlockEnd::PassOn;
}

Failure from_fault(const machine::MachineFault& fault) {
  Failure reason = failure(AlarmId::SoftLimit, fault.what);
  reason.status = runtime::Status::Collision;
  reason.number = fault.kind == machine::FaultKind::SoftLimit ? 0 : -1;
  return reason;
}

template <typename Move>
MaybeFailure carry_out(Channel& channel, const Move& move, const AxisPositions& q_W_end, int g) {
  if (channel.budget.is_too_late()) {
    return out_of_time();
  }
  const auto reached = channel.port.move(move);
  if (!reached) {
    channel.arrived_at_machine();
    return from_fault(reached.error());
  }
  channel.arrived_at_programmed(q_W_end);
  channel.observer.on_move({g, move.q_M_end, move.feed_mm_min, 0.0});
  return std::nullopt;
}

template MaybeFailure carry_out(Channel&, const machine::LinearMove&, const AxisPositions&, int);
template MaybeFailure carry_out(Channel&, const machine::ArcMove&, const AxisPositions&, int);

MaybeFailure move_straight(Channel& channel, const Block& block) {
  const auto q_W_end = programmed_end(channel, block);
  if (!q_W_end) {
    return q_W_end.error();
  }
  const bool rapid = channel.group[1] == 1;
  machine::LinearMove move;
  move.q_M_end = channel.to_machine(q_W_end.value());
  move.traverse = rapid ? machine::Traverse::Rapid : machine::Traverse::Feed;
  if (!rapid) {
    const auto feed = feed_in_force(channel);
    if (!feed) {
      return feed.error();
    }
    move.feed_mm_min = feed.value();
    move.ends = block_end(channel);
  }
  return carry_out(channel, move, q_W_end.value(), rapid ? 0 : 1);
}

MaybeFailure dwell(Channel& channel, const Block& block) {
  double seconds = block.words[Address::Feed].value;
  if (block.words.has(Address::Speed)) {
    if (channel.speed <= 0.0) {
      return failure(AlarmId::NoFeed, "G4 S needs a spindle speed");
    }
    seconds = block.words[Address::Speed].value * 60.0 / channel.speed;
  }
  if (!(seconds >= 0.0)) {
    return failure(AlarmId::ValueOutOfLimits, "G4");
  }
  channel.port.dwell(seconds);
  channel.observer.on_move({4, channel.port.position(), 0.0, seconds});
  return std::nullopt;
}

}  // namespace g31::sinumerik
